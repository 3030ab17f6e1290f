"""Which blocks are close to others, on them, or in the place of a step."""

import numpy as np

from act.finger_room import gripper_clearance
from constants import TASK_PLANNING as C
from things.areas import footprint, overlap


def is_close(block, place):
    """Returns true if a block is so close to a place that fingers may touch both."""
    distance = np.linalg.norm(block.position - place.position)
    return distance < C.near_distance + block.size[0] / 2


def is_support_known(block, known):
    """Returns true if a block lies on a known one."""
    below = [it for it in known if abs(it.top - block.bottom) < C.max_sinking]
    return overlap(footprint([block], 0)[0], footprint(below, 0)).any()


def is_obstructing(block, step):
    """Returns true if a block is in the place of a step, or where the fingers need room there."""
    [room] = gripper_clearance([step])
    return overlap(room, footprint([block], 0)).any()


def has_objects_on(block, others):
    """Returns true if one of the others lies on a block."""
    higher = [it for it in others if it.bottom > block.top - C.max_sinking]
    [covered] = footprint([block], 0)
    return overlap(covered, footprint(higher, 0)).any()
