"""Recordings as arrays."""

from __future__ import annotations

import math
import os
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
import numpy.typing as npt

from smile.native import load
from smile.picture import Picture
from smile.simulation import TICKS_PER_SECOND, Event, Floats, Model, channel_flags, picture_size

if TYPE_CHECKING:
    from smile import smile_simulator_native as _native
else:
    _native = load("smile_simulator_native")


class Action(NamedTuple):
    """An action of a demonstration, with what followed from it until the next one."""

    begin: int
    """tick at which it began"""
    end: int
    """tick at which the next one began, or the recording ended"""
    words: str
    """for example `left hand takes RedBlock`"""


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


class Recording:
    """A recording: the path that its history took in the end, without what was undone.

    It is read when first needed. T is the number of its ticks.
    """

    def __init__(self, native: Any) -> None:
        self._native = native

    @property
    def directory(self) -> Path:
        return self._native.directory

    @property
    def title(self) -> str:
        return self._native.title

    @property
    def notes(self) -> str:
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

    def verify(self) -> None:
        """Runs the recording again, and compares each tick. Raises AssertionError with the first
        difference if one is not the same to the last bit."""
        difference = self._native.first_difference()
        if difference is not None:
            raise AssertionError(f"{self.directory}: {difference}")

    def __repr__(self) -> str:
        return f"<Recording {self.directory}>"


def open(directory: str | os.PathLike[str]) -> Recording:
    """Opens a recording. Raises SceneError with all findings if it is not a valid one."""
    return Recording(_native.open(os.fspath(directory)))
