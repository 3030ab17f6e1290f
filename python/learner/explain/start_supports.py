"""What objects stood on at the start, where this tells them from others that look the same: "the red one on the left base"."""

from dataclasses import replace

import numpy as np

from constants import TASK_MODEL as C
from explain.placed_steps import step_of
from things.kinds import is_same_kind
from things.standing import stands_on
from things.steps import TABLE, StartSupport


def with_start_supports(demo, steps):
    """Returns steps with what their objects began on, where others that look the same began on something else."""
    numbers = [demo.ids.index(step.name) for step in steps]
    return [replace(step, began_on=start_support(demo, n, step)) for n, step in zip(numbers, steps)]


def start_support(demo, n, step):
    """Returns the StartSupport of object n, of a step; None if it tells nothing, or was not seen."""
    looks = demo.appearances
    if step.stays or n not in looks:
        return None
    wanted = replace(looks[n], color=step.color)
    below = supports_of(demo, n)
    others = [supports_of(demo, m) for m in looks if m != n and is_same_kind(looks[m], wanted)]
    if not below or all(it == below for it in others):
        return None
    name = below[0]
    if name == TABLE:
        return StartSupport(None, TABLE, np.zeros(2))
    support = looks[demo.ids.index(name)]
    middle = np.mean([it.position[:2] for it in looks.values() if is_same_kind(it, support)], axis=0)
    # What carries others has a top that they hide in part, as that of what stays.
    like = replace(step_of(demo, demo.ids.index(name), support, {}), stays=True)
    return StartSupport(like, name, support.position[:2] - middle)


def supports_of(demo, n):
    """Returns the names of what object n stood on at the start, or TABLE: a list, empty if it is not known."""
    looks = demo.appearances
    below = [demo.ids[m] for m in sorted(looks) if m != n and stands_on(looks[n], looks[m])]
    return below or ([TABLE] if looks[n].bottom < C.max_support_gap else [])
