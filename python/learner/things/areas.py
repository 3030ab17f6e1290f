"""Areas on the table, seen from above: footprints and overlaps.

Rectangles are rows of x and y of the center, both sides [units], and the yaw of the first side
[rad]: 5 numbers, Nx5 for many.
"""

import math

import numpy as np


def footprint(blocks, margin):
    """Returns the areas that blocks cover, with a margin on all sides [units]: Nx5."""
    rows = [[*block.position[:2], *(block.size[:2] + 2 * margin), block.yaw] for block in blocks]
    return np.array(rows).reshape(-1, 5)


def overlap(some, many):
    """Returns which of N rectangles overlap with which of M others: NxM bool. If some
    is a single rectangle of 5 numbers, N bool. Separating axes: two rectangles are apart if there
    is a gap between them in the direction of a side.

    some: the M others, Mx5, or 5 numbers
    many: the N rectangles, Nx5
    """
    some = np.asarray(some, float)
    many = np.asarray(many, float)
    if not len(many):
        return np.ones((0, *some.shape[:-1]), bool)
    if some.ndim == 2:
        many = many[:, None, :]
    # The offsets of the centers, and the extents of one rectangle along the sides of the other.
    x, y = many[..., 0] - some[..., 0], many[..., 1] - some[..., 1]
    angle = many[..., 4] - some[..., 4]
    c, s = np.abs(np.cos(angle)), np.abs(np.sin(angle))
    yes = np.ones(angle.shape, bool)
    # In the frames of `some`, then in those of `many`.
    for one, other in ((some, many), (many, some)):
        cos, sin = np.cos(one[..., 4]), np.sin(one[..., 4])
        yes &= 2 * np.abs(x * cos + y * sin) < one[..., 2] + other[..., 2] * c + other[..., 3] * s
        yes &= 2 * np.abs(y * cos - x * sin) < one[..., 3] + other[..., 2] * s + other[..., 3] * c
    return yes


def is_inside(container, position):
    """Returns true if a position is between the sides of a Container."""
    return overlap([*position[:2], 0, 0, 0], footprint([container], 0)).all()


def container_at(containers, position):
    """Returns the one of some Containers that a position is in, or None."""
    return next((it for it in containers if is_inside(it, position)), None)


def rotated(v, angle):
    """Returns a vector, x y, rotated by an angle [rad]."""
    c, s = math.cos(angle), math.sin(angle)
    return np.array([v[0] * c - v[1] * s, v[0] * s + v[1] * c])
