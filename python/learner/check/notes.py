"""Notes about its work, which the learner tells people: its plan and its actions."""

from typing import NamedTuple

import numpy as np

from things.kinds import is_same_kind
from things.steps import is_dragged


class Note(NamedTuple):
    """A note: a word that docs/brains.md defines, and a text about Blocks."""

    word: str
    text: str
    expected: list = []  # Blocks where it expects or expected to see them
    found: list = []  # Blocks where it saw them
    camera: str = ""  # in whose picture it saw them; empty: the eye

    def __str__(self):
        return f"{self.word}: {self.text}"


def tops_of(notes):
    """Returns the tops of the Blocks of notes, as aux.noteTops: Nx9."""
    rows = []
    for k, note in enumerate(notes):
        for is_found, blocks in enumerate((note.expected, note.found)):
            rows += [[k + 1, is_found, *it.position[:2], it.top, *it.size[:2], it.yaw, it.is_round]
                     for it in blocks]
    return np.array(rows, float).reshape(-1, 9)


def plan_notes(steps):
    """Returns a note about each step: where its block goes in this scene."""
    return [Note("plan", "%s at (%.2f, %.2f), on %s" % (
        step, *step.position[:2], ", ".join(steps[lower].name for lower in step.on) or "the table"),
        [step]) for step in steps]


def action_note(name, move, place, why, held):
    """Returns a note about an action that makes a Move of a block, of a name, to a place.

    why:  it is brought there, else ""
    held: the Action that takes it, or pushes it
    """
    verb = "drags" if is_dragged(move.goal) else "turns" if move.turns else "pushes" if held.kind == "push" else "carries"
    reason = f", {why}" if why else ""
    return Note("action", "%s %s from (%.2f, %.2f) to (%.2f, %.2f)%s, with arm %s" % (
        verb, name, *move.block.position[:2], *place.position[:2], reason, held.arm.name), [place])


def name_of(block, steps):
    """Returns a name for a block that has none: that of the first step of its kind."""
    like = [step.name for step in steps if is_same_kind(block, step)]
    return f"one like {like[0]}" if like else "an unknown object"
