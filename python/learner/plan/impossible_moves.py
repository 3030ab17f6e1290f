"""Moves that cannot be planned, and why: facts that hold until something moves, so that none is tried again before."""

from typing import NamedTuple, Optional

import numpy as np

from check.notes import Note, name_of
from constants import TASK_PLANNING as C
from things.steps import Step


class ImpossibleMove(NamedTuple):
    """A Move for a step that cannot be planned where everything is now."""

    step: int  # its number
    place: np.ndarray  # of the block, x y z [units]
    goal: Optional[Step]  # None: a temporary placement
    turns: tuple
    room: Optional[np.ndarray]  # which it was to make, x y z [units]
    reason: str  # like: there is no room for the fingers

    def is_about(self, step, move):
        """Returns true if this is a Move for a step, by its number."""
        return (step == self.step and move.goal is self.goal and move.turns == self.turns
                and is_near(move.block.position, self.place) and is_same_room(move.room, self.room))


def forget_if_moved(state):
    """Forgets the impossible moves if a block was moved, was found, or is lost since the first of them."""
    before = state.impossible_among
    is_same = len(before) == len(state.known) and all(
        any(is_near(it.position, other.position) for other in before) for it in state.known)
    if not is_same:
        state.impossible_moves.clear()
        state.impossible_among = list(state.known)


def why_impossible(state, k, move):
    """Returns why a move for step k is known to be impossible; None if it is not known."""
    return next((it.reason for it in state.impossible_moves if it.is_about(k, move)), None)


def remember_impossible(state, k, move, reason):
    """Remembers that a move for step k could not be planned, and tells it."""
    name = state.steps[k].name if move.goal else name_of(move.block, state.steps)
    room = move.room.position if move.room else None
    state.impossible_moves.append(ImpossibleMove(k, move.block.position, move.goal, move.turns, room, reason))
    purpose = "" if move.goal else ", to be put aside"
    state.notes.append(Note("saw", f"impossible for now: {name}{purpose}: {reason}"))


def is_same_room(block, place):
    """Returns true if a block is at a place, or both are None."""
    return place is None and block is None or block is not None and place is not None and is_near(block.position, place)


def is_near(position, place):
    """Returns true if two positions are those of something that did not move."""
    return np.linalg.norm(position - place) < C.unmoved_distance
