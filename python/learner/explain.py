"""Explains a demonstration: what was done, what of it is the goal, and what was only a means."""

import math
from dataclasses import dataclass

from relate import facts_at

DEEDS = {"release": "carries", "trigger": "triggers", "use": "uses", "fasten": "fastens",
         "loosen": "loosens", "destroy": "destroys", "press": "presses"}
# Lines that are no actions.
EFFECTS = {"create", "initializeControl", "changeControlState", "delete", "attend"}


@dataclass
class Keyframe:
    """A moment of rest after a deed."""

    deed: str  # one line: who did what; empty at the start
    facts: list  # as from relate.facts_at
    made: list  # those of the facts that were not true before, without what hands hold
    is_means: bool = False  # true if the deed made something, and nothing of it is kept


@dataclass
class Explanation:
    keyframes: list
    goal: list  # facts that were made and kept


def explain(demo, container):
    """Explains a demonstration by facts at the start and after each of its deeds."""
    keyframes = []
    held, others = {}, {}  # others: fact without its last word -> last word
    deed = ""  # the last one, whose effects follow; then none until the next
    for frame, word, fields in [*demo.events, (math.inf, "end", [])]:
        if deed is not None and word not in EFFECTS:
            add(keyframes, deed, demo, container, frame, held, others)
            deed = None
        deed = deed_of(word, fields, held) or deed
        apply(word, fields, held, others)
    last, first = keyframes[-1].facts, keyframes[0].facts
    goal = [it for it in last if it not in first and not it.startswith("held ")]
    for it in keyframes[1:]:
        it.is_means = bool(it.made) and not any(fact in goal for fact in it.made)
    return Explanation(keyframes, goal)


def add(keyframes, deed, demo, container, frame, held, others):
    """Adds a keyframe with the facts before an action of a frame."""
    names = {name: hand for hand, name in held.items()}
    rows = [" ".join(it).strip() for it in others.items()]
    facts = facts_at(demo, container, frame, names, rows)
    before = keyframes[-1].facts if keyframes else []
    carried = [it for it in facts if it.startswith("held ")]
    keyframes.append(Keyframe(deed, facts, [it for it in facts if it not in [*before, *carried]]))


def deed_of(word, fields, held):
    """Returns what an action ends, in words; empty if it ends nothing, like a grasp."""
    if word not in DEEDS:
        return ""
    objects = [held.get(fields[0], "")] if word in ("release", "destroy") else fields[1:2]
    return " ".join([fields[0] or "something", DEEDS[word], *objects])


def apply(word, fields, held, others):
    """Updates what hands hold, and the facts about controls and joints, after an action."""
    if word == "grasp":
        held[fields[0]] = fields[1]
    elif word in ("release", "destroy"):
        held.pop(fields[0], None)
    elif word == "delete":
        others[f"gone {fields[0]}"] = ""
    elif word == "initializeControl":
        others[f"state {fields[0]}"] = fields[-1]
    elif word == "changeControlState":
        others[f"state {fields[0]}"] = fields[1]
    elif word == "use" and fields[2] == "cut":
        others[f"cut {fields[3].split()[0]}"] = fields[1]
    elif word == "fasten":
        others[f"fastened {fields[2]} {fields[4]}"] = ""
    elif word == "loosen" and float(fields[5]) == 0:
        others.pop(f"fastened {fields[2]} {fields[4]}", None)
