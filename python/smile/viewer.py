"""Viewer: the studio's page on a simulation."""

from __future__ import annotations

import atexit
import html
import math
import os
import subprocess
import sys
from types import TracebackType
from typing import TYPE_CHECKING
from weakref import WeakKeyDictionary, WeakSet

from smile.native import load
from smile.simulation import Simulation, data_file

if TYPE_CHECKING:
    from smile import smile_simulator_native as _native
else:
    _native = load("smile_simulator_native")


class Studio:
    """The studio's page, which shows a simulation while the program goes on.

    Any number of browsers may watch it, at any frame rate: the simulation computes the same bits as
    without. Nothing on the page changes the simulation. A notebook shows the page in the cell.
    """

    def __init__(self, simulation: Simulation, *, port: int = 0, speed: float = 0,
                 height: int = 480) -> None:
        """Starts to serve the page at 127.0.0.1, to this machine only.

        port    of the page; 0 for the first free one from 8470 on
        speed   greatest ratio of simulated to real time, at least 0.01: 1 shows motion as it is; 0
                for no limit
        height  of the page in a notebook [px]

        Raises RuntimeError if the page is not built, or the port is taken.
        """
        for name, value, most in (("port", port, 65535), ("height", height, 100_000)):
            if isinstance(value, bool) or not isinstance(value, int) or not 0 <= value <= most:
                raise ValueError(f"{name} is {value!r}, expected a whole number from 0 to {most}")
        if not (speed == 0 or (math.isfinite(speed) and 0.01 <= speed <= 1000)):
            raise ValueError(f"speed is {speed!r}, expected 0 or a number from 0.01 to 1000")
        self.height = height
        self._native = _native.Viewer(_native_of(simulation), page_folder(), port, float(speed))
        _open.add(self)

    @property
    def url(self) -> str:
        """Link of the page."""
        return self._native.link

    @property
    def is_closed(self) -> bool:
        """True after close()."""
        return self._native.is_closed

    def show(self, simulation: Simulation) -> None:
        """Shows another simulation, at the same link."""
        self._native.show(_native_of(simulation))

    def open(self) -> None:
        """Opens the page in the browser, if there is a screen."""
        if sys.platform == "darwin" or os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"):
            program = "open" if sys.platform == "darwin" else "xdg-open"
            subprocess.Popen([program, self.url], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                             stderr=subprocess.DEVNULL)

    def close(self) -> None:
        """Ends the page; the simulation goes on."""
        self._native.close()

    def __enter__(self) -> Studio:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None,
                 trace: TracebackType | None) -> None:
        self.close()

    def __repr__(self) -> str:
        return "<Studio: closed>" if self.is_closed else f"<Studio at {self.url}>"

    def _repr_html_(self) -> str:
        if self.is_closed:
            return html.escape(repr(self))
        return (f'<iframe src="{html.escape(self.url)}" title="SMILE studio" width="100%" '
                f'height="{self.height}" style="border: 0"></iframe>')


# Their threads end before the interpreter does.
_open: WeakSet[Studio] = WeakSet()


@atexit.register
def _close_all() -> None:
    for studio in list(_open):
        studio.close()


# The page of a simulation is the same each time that a cell asks for it.
_studios: WeakKeyDictionary[Simulation, tuple[Studio, tuple[int, float, int]]] = WeakKeyDictionary()


def studio(simulation: Simulation, *, port: int = 0, speed: float = 0, height: int = 480,
           open: bool = False) -> Studio:
    """Shows a simulation in the studio's page, see Studio; in a notebook, in the cell.

    The page of a simulation remains until `close()` or the end of the simulation. A second call
    with the same arguments returns the same one, a call with other arguments ends it.

    open    opens the page in the browser, if there is a screen
    """
    arguments = port, speed, height
    shown, how = _studios.get(simulation, (None, None))
    if shown is None or shown.is_closed or how != arguments:
        if shown is not None:
            shown.close()
        shown = Studio(simulation, port=port, speed=speed, height=height)
        _studios[simulation] = shown, arguments
    if open:
        shown.open()
    return shown


def _native_of(simulation: Simulation) -> _native.Simulation:
    if not isinstance(simulation, Simulation):
        raise TypeError(f"simulation is {type(simulation).__name__}, expected a smile.Simulation")
    return simulation._native


def page_folder() -> str:
    """Returns the folder of the studio's page. Raises RuntimeError if it is not built."""
    try:
        return os.fspath(data_file("build/page"))
    except RuntimeError:
        raise RuntimeError("the studio's page is not built; run ./run studio in SMILE's folder to "
                           "build it") from None
