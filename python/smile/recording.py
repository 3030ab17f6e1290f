"""Recordings as arrays."""

from __future__ import annotations

import base64
import html
import json
import math
import os
import tempfile
from collections.abc import Sequence
from functools import cached_property
from itertools import zip_longest
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, overload

import numpy as np
import numpy.typing as npt

from smile.native import load
from smile.picture import Picture
from smile.simulation import TICKS_PER_SECOND, Event, Floats, Model, channel_flags, picture_size

if TYPE_CHECKING:
    import pandas

    from smile import smile_simulator_native as _native
else:
    _native = load("smile_simulator_native")

# Bounds of a film in a notebook: its length, and its size in the file of the notebook.
_NOTEBOOK_SECONDS = 20
_NOTEBOOK_BYTES = 2_000_000


class Action(NamedTuple):
    """An action of a demonstration, with what followed from it until the next one."""

    begin: int
    """tick at which it began"""
    end: int
    """tick at which the next one began, or the recording ended"""
    words: str
    """for example `left hand takes RedBlock`"""


class CommandDifference(NamedTuple):
    """The first command in which two recordings differ."""

    line: int
    """of `commands.jsonl`, the first is 1"""
    command: dict[str, Any] | None
    """with its `tick`, in units of the scene; None if the recording has no more commands"""
    other: dict[str, Any] | None
    """the same of the other recording"""


class Moment:
    """A recorded tick."""

    def __init__(self, recording: Recording, index: int) -> None:
        self._recording, self.index = recording, index

    @property
    def tick(self) -> int:
        """Ticks of the simulation's clock."""
        return int(self._recording.ticks[self.index])

    @property
    def poses(self) -> Floats:
        """(objects, 7), see Recording.poses"""
        return self._recording.poses[self.index]

    @property
    def joints(self) -> Floats:
        """(joints,) of the robot [rad; m of a sliding joint]"""
        return self._recording.joints[self.index]

    def render(self, camera: str = "eye", size: tuple[int, int] = (640, 480),
               channels: tuple[str, ...] = ("rgb",)) -> Picture:
        """Renders what a camera sees, as Simulation.render() does."""
        return Picture(*self._recording._native.render(
            self.tick, camera, *picture_size(size), *channel_flags(channels)))

    def _repr_png_(self) -> bytes:
        return self.render("close", (480, 360)).to_png()


class Frames(Sequence[npt.NDArray[np.uint8]]):
    """What the robot's eye recorded, a picture (height, width, 3) in each frame.

    Pictures are files of the recording, and are read when asked for. A frame in which no object has
    changed has none of its own: there the one before is still valid, in which only the robot can be
    elsewhere. (`Moment.render()` draws any moment exactly.)
    """

    def __init__(self, directory: Path, frames: list[tuple[int, str]], start_tick: int) -> None:
        self._directory = directory
        self.ticks = np.array([tick for tick, _ in frames], np.uint64)
        """(F,) ticks of the simulation's clock"""
        self.times = (self.ticks.astype(float) - start_tick) / TICKS_PER_SECOND
        """(F,) since the recording began [s]"""
        # Of each frame, the file that is valid.
        self._files: list[str] = []
        for _, file in frames:
            self._files.append(file or (self._files[-1] if self._files else ""))

    def __len__(self) -> int:
        return len(self._files)

    @overload
    def __getitem__(self, index: int) -> npt.NDArray[np.uint8]: ...

    @overload
    def __getitem__(self, index: slice) -> list[npt.NDArray[np.uint8]]: ...

    def __getitem__(self, index: int | slice) -> npt.NDArray[np.uint8] | list[npt.NDArray[np.uint8]]:
        if isinstance(index, slice):
            return [self[i] for i in range(*index.indices(len(self)))]
        if not -len(self) <= index < len(self):
            raise IndexError(f"index is {index}, expected less than {len(self)} frames")
        if not self._files[index]:
            raise ValueError(f"{self._directory}: was recorded without pictures")
        return _native.read_picture(self._directory / self._files[index])


class Recording:
    """A recording: the path that its history took in the end, without what was undone.

    It is read when first needed. T is the number of its ticks.
    """

    def __init__(self, native: Any) -> None:
        self._native = native

    @property
    def directory(self) -> Path:
        """Its folder."""
        return self._native.directory

    @property
    def title(self) -> str:
        """Title, by which people find it."""
        return self._native.title

    @property
    def notes(self) -> str:
        """Notes of people."""
        return self._native.notes

    @property
    def cuts(self) -> list[str]:
        """What is missing because the program that recorded it ended abruptly."""
        return self._native.cuts

    @property
    def model(self) -> Model:
        """Scene and robot, with all objects that were added."""
        return self._native.model

    @property
    def object_ids(self) -> list[str]:
        """Ids of the objects, in the order of the scene."""
        return self.model.object_ids

    @cached_property
    def joint_names(self) -> list[str]:
        """Names of the robot's joints; empty without one."""
        return self._native.joint_names

    @cached_property
    def _arrays(self) -> tuple[npt.NDArray[np.uint64], npt.NDArray[np.uint64], Floats, Floats]:
        arrays = self._native.arrays()
        for array in arrays:
            array.flags.writeable = False
        return arrays

    @property
    def ticks(self) -> npt.NDArray[np.uint64]:
        """(T,) ticks of the simulation's clock"""
        return self._arrays[0]

    @property
    def times(self) -> Floats:
        """(T,) since the recording began [s]"""
        return (self.ticks.astype(float) - self._native.start_tick) / TICKS_PER_SECOND

    @property
    def hashes(self) -> npt.NDArray[np.uint64]:
        """(T,) hashes of the state"""
        return self._arrays[1]

    @property
    def poses(self) -> Floats:
        """(T, objects, 7) in the order of `object_ids`: x, y, z [m] and quaternion w, x, y, z in the
        world; NaN for objects that are not there (yet, or any longer)"""
        return self._arrays[2]

    @property
    def joints(self) -> Floats:
        """(T, joints) in the order of `joint_names` [rad; m of a sliding joint]"""
        return self._arrays[3]

    @cached_property
    def events(self) -> list[Event]:
        """Events as dicts with `tick` and `kind`, as Simulation.events."""
        return self._native.events()

    @cached_property
    def actions(self) -> list[Action]:
        """What the demonstrator did, in order."""
        return [Action(*one) for one in self._native.actions()]

    @cached_property
    def frames(self) -> Frames:
        """The pictures that the robot's eye recorded, read when asked for."""
        return Frames(self.directory, self._native.frames(), self._native.start_tick)

    @property
    def video(self) -> npt.NDArray[np.uint8]:
        """(F, height, width, 3): all `frames`, read at once"""
        frames = self.frames
        video = np.empty((len(frames), *(frames[0].shape if len(frames) > 0 else (0, 0, 3))), np.uint8)
        for i, picture in enumerate(frames):
            video[i] = picture
        return video

    def table(self) -> pandas.DataFrame:
        """Returns `times`, `poses` and `joints` as a table with a row for each tick. Needs pandas.

        Columns are `time` [s], `Red1.x` and so on for `y`, `z`, `qw`, `qx`, `qy`, `qz`, and the
        names of joints; `tick` is the index.
        """
        import pandas
        names = [f"{id}.{number}" for id in self.object_ids
                 for number in ("x", "y", "z", "qw", "qx", "qy", "qz")]
        numbers = np.column_stack([self.times, self.poses.reshape(len(self), len(names)), self.joints])
        return pandas.DataFrame(numbers, columns=["time", *names, *self.joint_names],
                                index=pandas.Index(self.ticks, name="tick"))

    def at(self, seconds: float) -> Moment:
        """Returns the tick nearest to a time since the recording began [s]."""
        last = float(self.times[-1])
        if not (math.isfinite(seconds) and 0 <= seconds <= last):
            raise ValueError(f"seconds is {seconds!r}, expected a number from 0 to {last:.2f}")
        return Moment(self, int(np.argmin(np.abs(self.times - seconds))))

    def __len__(self) -> int:
        return len(self.ticks)

    def __getitem__(self, index: int) -> Moment:
        if not -len(self) <= index < len(self):
            raise IndexError(f"index is {index}, expected less than {len(self)} ticks")
        return Moment(self, index % len(self))

    def film(self, path: str | os.PathLike[str], camera: str = "close",
             size: tuple[int, int] = (640, 480), rate: float = 30, speed: float = 1) -> None:
        """Writes a film (mp4, H.264) of what a camera sees, as Simulation.render() does.

        rate   pictures per second of the film, from 1 to 1000
        speed  from 0.01 to 1000; 2 shows two seconds of the recording in one
        """
        for name, value, least in (("rate", rate, 1), ("speed", speed, 0.01)):
            if not (math.isfinite(value) and least <= value <= 1000):
                raise ValueError(f"{name} is {value!r}, expected a number from {least} to 1000")
        _native.film(self._native, os.fspath(path), camera, *picture_size(size), float(rate), float(speed))

    def _repr_html_(self) -> str:
        """The film; of a long recording in quick motion, so that a notebook stays small."""
        seconds = float(self.times[-1]) if len(self) > 0 else 0.0
        words = html.escape(f"{self.title or self.directory.name}: {seconds:.1f} s")
        if len(self) == 0 or seconds > 1000 * _NOTEBOOK_SECONDS:
            return f"<p>{words}</p>"
        speed = max(1.0, seconds / _NOTEBOOK_SECONDS)
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "film.mp4"
            self.film(path, size=(400, 300), rate=10, speed=speed)
            data = path.read_bytes()
        if len(data) > _NOTEBOOK_BYTES:
            return f"<p>{words}. The film is {len(data)} bytes, too large to show here: film() writes it.</p>"
        if speed > 1:
            words += f", shown {speed:.1f} times as fast"
        return (f'<video controls muted width="400" height="300" src="data:video/mp4;base64,'
                f'{base64.b64encode(data).decode()}"></video><p>{words}</p>')

    def verify(self) -> None:
        """Runs the recording again, and compares each tick. Raises AssertionError with the first
        difference if one is not the same to the last bit."""
        difference = self._native.first_difference()
        if difference is not None:
            raise AssertionError(f"{self.directory}: {difference}")

    def first_difference(self, other: Recording) -> CommandDifference | None:
        """Returns the first command in which another recording differs; None if all are equal.

        A simulation does the same everywhere. A policy may not, where its arithmetic depends on the
        machine: of two runs of it, this is the first action that differs.
        """
        with (self.directory / "commands.jsonl").open() as mine, \
                (other.directory / "commands.jsonl").open() as others:
            for number, (line, theirs) in enumerate(zip_longest(mine, others), 1):
                if line != theirs:
                    return CommandDifference(number, *(None if text is None else json.loads(text)
                                                       for text in (line, theirs)))
        return None

    def __repr__(self) -> str:
        return f"<Recording {self.directory}>"


def open(directory: str | os.PathLike[str]) -> Recording:
    """Opens a recording. Raises SceneError with all findings if it is not a valid one."""
    return Recording(_native.open(os.fspath(directory)))
