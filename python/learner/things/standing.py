"""What stands on, around and above what."""

from constants import TASK_MODEL as C
from things.areas import footprint, overlap


def stands_on(upper, lower):
    """Returns true if the bottom of a block touches the top of another one."""
    gap = upper.bottom - lower.top
    [one] = footprint([upper], 0)
    return abs(gap) < C.max_support_gap and overlap(one, footprint([lower], 0)).any()


def is_around(outer, inner):
    """Returns true if a block with an outline, like a ring or an L, has another one in its hole or its corner."""
    is_level = outer.bottom < inner.top - C.max_support_gap and inner.bottom < outer.top - C.max_support_gap
    return outer.outline is not None and is_level and overlap(footprint([outer], 0)[0], footprint([inner], 0)).any()


def is_placed_by(one, other):
    """Returns true if another block tells where one is: it stands on that, or is around it."""
    return stands_on(one, other) or is_around(one, other)


def is_above(upper, lower):
    """Returns true if a block is over another one, at any distance."""
    [one] = footprint([upper], -C.min_above)
    is_higher = upper.bottom > lower.top - C.max_support_gap
    return is_higher and overlap(one, footprint([lower], 0)).any()
