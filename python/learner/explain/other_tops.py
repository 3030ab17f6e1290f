"""Measures objects that only a flat top or the outline of their top shows."""

import numpy as np

from constants import TASK_MODEL as C
from explain.flat_tops import measure_flat_top
from explain.outline_measuring import measure_outlined


def measure_other_top(demo, n, lower, frames, pictures):
    """Measures an object by its flat top; by the outline of its top if there is no such top, or if that may be only a
    part of it: where it is not round and nothing is near that could hide the rest. None if no picture shows either."""
    flat = measure_flat_top(demo, n, lower)
    if flat and (flat.is_round or not stands_alone(demo, n)):
        return flat
    return measure_outlined(demo, n, frames, pictures) or flat


def stands_alone(demo, n):
    """Returns true if an object began away from all others."""
    begin = [rows[0, 1:3] for m, rows in enumerate(demo.moves) if m != n]
    return all(np.hypot(*(it - demo.moves[n][0, 1:3])) > C.alone_distance for it in begin)
