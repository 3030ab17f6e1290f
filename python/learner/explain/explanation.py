"""Explains a demonstration: what was done, what of it is the goal, and what was only a means."""

import math
from dataclasses import dataclass

from explain.keyframes import EFFECTS, Keyframe, apply, deed_of
from relate.facts import facts_at


@dataclass
class Explanation:
    keyframes: list
    goal: list  # facts that were made and kept


def explain(demo, containers):
    """Explains a demonstration by facts at the start and after each of its deeds."""
    keyframes = []
    held, others = {}, {}  # others: fact without its last word -> last word
    deed = ""  # the last one, whose effects follow; then none until the next
    for frame, word, fields in [*demo.events, (math.inf, "end", [])]:
        if deed is not None and word not in EFFECTS:
            add(keyframes, deed, demo, containers, frame, held, others)
            deed = None
        deed = deed_of(word, fields, held) or deed
        apply(word, fields, held, others)
    last, first = keyframes[-1].facts, keyframes[0].facts
    goal = [it for it in last if it not in first and not it.startswith("held ")]
    for it in keyframes[1:]:
        it.is_means = bool(it.made) and not any(fact in goal for fact in it.made)
    return Explanation(keyframes, goal)


def add(keyframes, deed, demo, containers, frame, held, others):
    """Adds a keyframe with the facts before an action of a frame."""
    names = {name: hand for hand, name in held.items()}
    rows = [" ".join(it).strip() for it in others.items()]
    facts = facts_at(demo, containers, frame, names, rows)
    before = keyframes[-1].facts if keyframes else []
    carried = [it for it in facts if it.startswith("held ")]
    keyframes.append(Keyframe(deed, facts, [it for it in facts if it not in [*before, *carried]]))
