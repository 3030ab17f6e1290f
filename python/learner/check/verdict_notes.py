"""Notes about verdicts: what the learner expected to see after an action, and what it saw."""

import math

import numpy as np

from check.notes import Note, name_of
from things.blocks import yaw_difference
from things.kinds import is_same_kind


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
