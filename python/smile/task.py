"""Tasks: what a demonstration achieved, and how much of it a simulation has achieved."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from smile.native import load
from smile.recording import Recording
from smile.simulation import Simulation

if TYPE_CHECKING:
    from smile import smile_simulator_native as _native
else:
    _native = load("smile_simulator_native")


class ObjectError(NamedTuple):
    """How far an object is from its place."""

    distance: float
    """[m]"""
    angle: float
    """visible rotation [rad]: a cube looks the same after a quarter turn"""
    is_placed: bool
    """within tolerance, released, and right beside its neighbors"""


class Comparison(NamedTuple):
    """A simulation compared with a demonstration (docs/results.md)."""

    score: float
    """fraction, 0 to 1, of objects in place and effects achieved"""
    errors: dict[str, ObjectError]
    """by the id of the demonstrated object"""
    match: dict[str, str]
    """object of the scene for each demonstrated one; objects that look alike may be exchanged"""
    intruders: list[str]
    """objects that touch the structure without belonging to it"""

    @property
    def is_achieved(self) -> bool:
        """True if everything is in its place."""
        return self.score == 1


class Task:
    """The task of a demonstration in the scene of a simulation.

    The structure may stand anywhere on the table, unless the demonstration determines its place.
    Make it at the beginning of an episode: what hands and grippers do counts from then on.

    Raises SceneError if the task is impossible in this scene, or done before anything happens.
    """

    def __init__(self, demonstration: Recording, simulation: Simulation) -> None:
        self._native = _native.Task(demonstration._native, simulation._native)

    @property
    def object_ids(self) -> list[str]:
        """Ids of the demonstrated objects that have a place."""
        return self._native.object_ids

    def compare(self) -> Comparison:
        """Compares the present state with the demonstration; takes some milliseconds."""
        result = self._native.compare()
        errors = {id: ObjectError(*error) for id, error in result["errors"].items()}
        return Comparison(result["score"], errors, result["match"], result["intruders"])
