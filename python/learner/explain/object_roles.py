"""What objects do in a demonstration: moved, used as tools, replaced by others."""

import numpy as np

from constants import TASK_MODEL as C
from explain.limits import NotUnderstood
from relate.dragging import has_shape


def moved_objects(demo):
    """Returns the numbers of the objects that hands moved and do not hold at the end, in the order of their last release; none
    where they only pressed switches."""
    last = {n: when for when, n in enumerate(demo.placed) if n not in demo.held}
    if not last and not any(word in ("trigger", "press") for _, word, _ in demo.events):
        raise NotUnderstood("in this demonstration no hand moved anything to a place")
    return sorted(last, key=last.get)


def tools_of(demo):
    """Returns the numbers of the objects that were used as tools and put back where they began."""
    used = {demo.ids.index(fields[1]) for _, word, fields in demo.events if word == "use"}
    return {n for n in used if is_same_pose(demo.moves[n][0, 1:], demo.moves[n][-1, 1:])}


def carried_along(demo):
    """Returns the numbers of the objects that were never held, but lifted on or in others."""
    return {n for n, moves in enumerate(demo.moves)
            if n not in demo.placed and moves[:, 3].max() > moves[0, 3] + C.min_carried}


def may_be_ball(demo, n):
    """Returns true unless an object was lower than at the start, where a ball lies on the table, or is of several shapes."""
    is_lower = demo.moves[n][:, 3].min() < demo.moves[n][0, 3] - C.max_rest_error
    return not is_lower and not has_shape(demo, n, "composite")


def former_owner(demo, step):
    """Returns the name of another moved object that began at the place of a step; empty if there is none."""
    end = demo.moves[demo.ids.index(step.name)][-1, 1:]
    for n in moved_objects(demo):
        if demo.ids[n] != step.name and is_same_pose(demo.moves[n][0, 1:], end):
            return demo.ids[n]
    return ""


def is_same_pose(one, other):
    """Returns true if two poses, x y z [units] and three angles [degrees], are almost equal."""
    away = np.abs(one - other)
    return away[:3].max() < C.max_rest_error and away[3:].max() < C.max_rest_degrees
