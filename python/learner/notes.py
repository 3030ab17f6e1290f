"""Notes about its work, which the learner tells people: its plan, its actions, and after each what it
expected to see and what it saw."""

import math
from typing import NamedTuple

import numpy as np

from blocks import yaw_difference
from kinds import is_same_kind
from steps import is_dragged


class Note(NamedTuple):
    """A note: a word that docs/brains.md defines, and a text about Blocks."""

    word: str
    text: str
    expected: list = []  # Blocks where it expects or expected to see them
    found: list = []  # Blocks where it saw them

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


def action_note(name, move, place, is_temporary, arm):
    """Returns a note about an action that makes a Move of a block, of a name, to a place with an arm: to
    its goal, or, if that is temporary, out of the way, for a handover, or onto another face."""
    verb = "drags" if is_dragged(move.goal) else "carries"
    why = ""
    if is_temporary:
        why = ", for the other arm" if move.goal else ", out of the way"
    if move.turns:
        verb, why = "turns", ", onto another face"
    return Note("action", "%s %s from (%.2f, %.2f) to (%.2f, %.2f)%s, with arm %s" % (
        verb, name, *move.block.position[:2], *place.position[:2], why, arm.name), [place])


def verdict_notes(verdicts, seen, steps, moved):
    """Returns notes about verdicts: on the block that was just moved, the last one; on all others that
    are as expected, and that are hidden; and on each other one that is contradicted. Empty if nothing
    was moved and nothing is contradicted.

    moved: name of the moved block; empty if nothing was moved
    """
    others = verdicts[:-1] if moved else verdicts
    notes = [note_on(verdicts[-1], seen, moved)] if moved else []
    for word in ("as expected", "hidden"):
        those = [it for it in others if it.word == word]
        if those:
            number = f"{len(those)} other object{'s' if len(those) > 1 else ''}"
            notes.append(Note(word, number, *blocks_of(those, seen)))
    wrong = [it for it in others if it.word == "contradicted"]
    notes += [note_on(it, seen, name_of(it.expected, steps)) for it in wrong]
    return notes if moved or wrong else []


def note_on(verdict, seen, name):
    """Returns a note about the verdict on a block of a name."""
    text = "something hides its top"
    if verdict.word != "hidden":
        text = "it is not there"
        if verdict.found is not None:
            it = seen[verdict.found]
            text = "something else is there"
            if is_same_kind(it, verdict.expected):
                text = "off by %.2f units and %.1f degrees" % (
                    np.linalg.norm(it.position - verdict.expected.position),
                    math.degrees(abs(yaw_difference(verdict.expected, it.yaw))))
    return Note(verdict.word, f"{name}: {text}", *blocks_of([verdict], seen))


def blocks_of(verdicts, seen):
    """Returns the expected and the found blocks of verdicts, two lists."""
    return ([it.expected for it in verdicts],
            [seen[it.found] for it in verdicts if it.found is not None])


def name_of(block, steps):
    """Returns a name for a block that has none: that of the first step of its kind."""
    like = [step.name for step in steps if is_same_kind(block, step)]
    return f"one like {like[0]}" if like else "an unknown object"
