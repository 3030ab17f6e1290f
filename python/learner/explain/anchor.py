"""What determines the place of things that stood from the start."""

import math
from dataclasses import replace

import numpy as np

from constants import TASK_MODEL as C
from explain.object_roles import is_same_pose
from things.areas import rotated
from things.blocks import yaw_difference
from things.steps import TABLE, is_dragged


def with_anchor(demo, steps, others):
    """Returns steps with their anchor, if nothing but their place was shown: an object was pushed, put beside another
    one, or exchanged. The anchor is the nearest object that nothing moved, whose step comes last, or the table.

    others: steps of objects that the demonstration did not move
    """
    if not stood_from_the_start(demo, steps):
        return steps
    names = {step.name for step in steps}
    distances = {name: min(np.linalg.norm(step.position - rows[-1, 1:4]) for step in steps)
                 for name, rows in zip(demo.ids, demo.moves)
                 if name not in names and is_same_pose(rows[0, 1:], rows[-1, 1:])}
    anchor = min(distances, key=distances.get, default=TABLE)
    return [replace(step, anchor=anchor) for step in steps] + [it for it in others if it.name == anchor]


def stood_from_the_start(demo, steps):
    """Returns true if steps lead to what stood when the demonstration began, elsewhere: shifted, and rotated about the
    vertical."""
    if not steps or not all(is_free(step) for step in steps):
        return False
    moves = [demo.moves[demo.ids.index(step.name)] for step in steps]
    first, last = (np.array([rows[k, 1:4] for rows in moves]) for k in (0, -1))
    turns = np.radians([rows[-1, 6] - rows[0, 6] for rows in moves])
    before, after = (it[:, :2] - it[:, :2].mean(axis=0) for it in (first, last))
    # The rotation that fits best; what stands on one point, as a single object does, has only its own.
    angle = math.atan2(np.linalg.det(np.stack([before, after], axis=-1)).sum(), (before * after).sum())
    if np.hypot(*before.T).max() < C.same_place:
        angle = turns[0]
    errors = np.hypot(*(rotated(before.T, angle) - after.T))
    return (errors.max() < C.same_place and np.abs(last[:, 2] - first[:, 2]).max() < C.same_place
            and all(abs(yaw_difference(step, step.yaw - turn + angle)) < math.radians(C.same_turn_degrees)
                    for step, turn in zip(steps, turns)))


def is_free(step):
    """Returns true unless the place of a step is determined by what is below it or was there, or it leads to another
    face."""
    return not (step.stays or step.takes_place_of or step.aside or is_dragged(step) or step.start_size is not None)
