"""A brain's side of the exchange with the simulator: questions become calls of its functions."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

import numpy as np

from smile.brain_values import (
    Fields, Motor, Sensor, Values, aux_of, in_one_line, lines_from, sensor_of, text_of, wish_of, wishes_of)
from smile.messages import FINAL_MOTOR, INIT, INIT_DONE, MOTOR

Step = Callable[[Sensor, Motor, Fields], object]
Init = Callable[[Fields], object]

_NO_MARKERS = np.zeros((0, 3))


class Brain(Protocol):
    """An object that is a brain; it may also have `init(aux)`. docs/brains.md describes both."""

    def step(self, sensor: Sensor, motor: Motor, aux: Fields, /) -> object:
        """Reads what the robot senses, and sets its commands."""


class Exchange:
    """Functions of a brain with their state: aux, motor and the markers sent last."""

    def __init__(self, step: Step, init: Init | None = None) -> None:
        self._step, self._init = step, init

    def answer(self, kind: int, values: Values) -> tuple[int, Values]:
        """Returns kind and values of the answer to a question, INIT or STEP."""
        return self.start(values) if kind == INIT else self.step(values)

    def start(self, values: Values) -> tuple[int, Values]:
        """INIT -> INIT_DONE"""
        self.aux = aux_of(values)
        self.arms = list(self.aux.__dict__.get("arms", []))
        self.motor = Motor(self.aux)
        if self._init is not None:
            self._init(self.aux)
        wishes = wishes_of(self.aux)
        self.markers = np.array(wishes.get("drawMarkers", _NO_MARKERS))
        self.image_seconds = self.aux.__dict__.get("imageSeconds")
        self.cameras = wishes.get("cameras", "")
        return INIT_DONE, wishes | self._new_notes()

    def step(self, values: Values) -> tuple[int, Values]:
        """STEP -> MOTOR or FINAL_MOTOR"""
        self._step(sensor_of(values, self.arms), self.motor, self.aux)
        is_last = "exit" in self.aux and bool(np.any(self.aux.exit))
        values = self.motor.values() | self._new_markers() | self._new_image_seconds() | self._new_cameras()
        if "notes" in self.aux:
            values |= self._new_notes()
        if is_last and "claim" in self.aux:
            values["claim"] = text_of("aux.claim", self.aux.claim)
        return FINAL_MOTOR if is_last else MOTOR, values

    def _new_markers(self) -> Values:
        """Returns aux.drawMarkers if they differ from those sent last."""
        if "drawMarkers" not in self.aux and not len(self.markers):
            return {}  # most programs have none, and array_equal is slow
        markers = wish_of(self.aux, "drawMarkers") if "drawMarkers" in self.aux else _NO_MARKERS
        if np.array_equal(markers, self.markers):
            return {}
        self.markers = np.array(markers)
        return {"drawMarkers": self.markers}

    def _new_notes(self) -> Values:
        """Returns aux.notes, aux.noteTops and aux.noteCameras, which are told once, and removes them."""
        told: Values = {}
        if notes := self.aux.__dict__.pop("notes", None):
            told["notes"] = notes if isinstance(notes, str) else lines_from("aux.notes", notes)
            if "noteTops" in self.aux:
                told["noteTops"] = wish_of(self.aux, "noteTops")
            if "noteCameras" in self.aux:
                told["noteCameras"] = lines_from("aux.noteCameras", self.aux.noteCameras)
        self.aux.__dict__.pop("noteTops", None)
        self.aux.__dict__.pop("noteCameras", None)
        return told

    def _new_image_seconds(self) -> Values:
        """Returns aux.imageSeconds if it differs from the one sent last."""
        seconds = self.aux.__dict__.get("imageSeconds")
        if seconds is None or seconds is self.image_seconds:
            return {}
        self.image_seconds = seconds
        return {"imageSeconds": wish_of(self.aux, "imageSeconds")}

    def _new_cameras(self) -> Values:
        """Returns aux.cameras if they differ from those sent last."""
        if "cameras" not in self.aux:
            return {}
        cameras = in_one_line("aux.cameras", self.aux.cameras)
        if cameras == self.cameras:
            return {}
        self.cameras = cameras
        return {"cameras": cameras}


def exchange_of(brain: object) -> Exchange:
    """Returns the exchange of an object or module with `step`, or of a function."""
    step = getattr(brain, "step", brain)
    if not callable(step):
        raise TypeError(f"brain is {type(brain).__name__}, expected a path, a function "
                        "step(sensor, motor, aux), or an object with this method")
    return Exchange(step, getattr(brain, "init", None))
