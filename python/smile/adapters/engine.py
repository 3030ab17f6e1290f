"""Engine: what a demonstrator needs of the simulator that moves the bodies."""

from __future__ import annotations

from typing import Protocol

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]


class Engine(Protocol):
    """A simulator in which hands can demonstrate.

    The hands use the same servo and the same rules in each of them (src/demonstrator/engine.h); this is their
    side of it in Python. Bodies have numbers above 0. Lengths are in meters, angles in radians.
    """

    @property
    def name(self) -> str:
        """Name and version. Recordings replay with the same only."""

    @property
    def step_seconds(self) -> float:
        """Duration of a step [s]"""

    @property
    def object_ids(self) -> list[str]:
        """Ids of the objects that hands can carry."""

    def model_hash(self) -> str:
        """Hash of everything that does not change in a simulation."""

    def refuse_to_reach(self, object: str, /) -> str | None:
        """Returns the reason why no hand can reach an object, as when it does not exist."""

    def refuse_to_carry(self, body: int, /) -> str | None:
        """Returns the reason why a hand cannot carry a body that no hand holds."""

    def body_of(self, object: str, /) -> int:
        """Returns the body of an object that can be reached."""

    def object_of(self, body: int, /) -> str:
        """Returns the id of a body's object."""

    def motion_of(self, body: int, /) -> tuple[Floats, Floats]:
        """Returns the pose in the world, (7,) x, y, z, w, qx, qy, qz, and the velocity, (6,) of the origin, then angular."""

    def set_carried(self, body: int, is_carried: bool, /) -> None:
        """Marks a body as carried, so that it weighs nothing, or as no longer carried."""

    def set_velocity(self, body: int, linear: Floats, angular: Floats, /) -> None:
        """Sets the velocity of the origin [m/s] and the angular velocity [rad/s], in the world."""

    def step(self) -> None:
        """Advances by one step. Raises RuntimeError if the simulator cannot."""

    def save(self) -> bytes:
        """Returns the state, from which restore() continues to the same bits."""

    def restore(self, state: bytes, /) -> None:
        """Continues from a state. Raises ValueError if it is not one of this model."""
