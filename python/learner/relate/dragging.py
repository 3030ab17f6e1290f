"""Objects that were dragged, not carried."""

import numpy as np

from constants import TASK_MODEL as C


def was_dragged(demo, n):
    """Returns true if an object of several shapes, like a door with a post, was only dragged, and never lifted or rotated. A
    single block that was pushed over the table may as well be carried."""
    moves = demo.moves[n]
    distance = np.hypot(*(moves[-1, 1:3] - moves[0, 1:3]))
    deviation = np.abs(moves[:, 3:] - moves[0, 3:]).max()
    return has_shape(demo, n, "composite") and distance > C.min_drag_distance and deviation < C.max_drag_deviation


def has_shape(demo, n, shape):
    """Returns true if an object is of a shape, like `block`, or `composite` for several, as the texts of a recording say."""
    created = next(fields for _, word, fields in demo.events if word == "create" and fields[0] == demo.ids[n])
    return shape in created[1:3]
