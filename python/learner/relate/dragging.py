"""Objects that were dragged, not carried."""

import numpy as np

from constants import TASK_MODEL as C


def was_dragged(moves):
    """Returns true if an object was only dragged, like a door, and never lifted or rotated."""
    distance = np.hypot(*(moves[-1, 1:3] - moves[0, 1:3]))
    deviation = np.abs(moves[:, 3:] - moves[0, 3:]).max()
    return distance > C.min_drag_distance and deviation < C.max_drag_deviation
