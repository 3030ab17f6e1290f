"""Free places for blocks on the table."""

import math
from dataclasses import replace
from itertools import islice

import numpy as np

from act.finger_room import gripper_clearance
from constants import CLEARANCE, TASK_PLANNING as C, numbers_of
from see.framing import is_in_view, is_on_table
from see.unexplained import is_unexplained
from things.areas import footprint, overlap
from things.blocks import has_equal_sides


def free_placements(arms, eye, block, taken, goal, unexplained=()):
    """Returns free places for a block on the table, within the eye's view, a list of up to
    max_places, the best first: with room for its fingers and for those of its neighbors, and away
    from the feet of the arms."""
    yaw, depth, x = (it.ravel() for it in np.meshgrid(
        [0, math.pi / 2, math.pi / 4, -math.pi / 4], numbers_of(*C.place_depth),
        numbers_of(*C.place_x), indexing="ij"))
    y = eye.near_edge + depth
    sides = np.ones_like(x)[:, None] * (block.size[:2] + C.place_margin)
    covered = np.column_stack([x, y, sides, yaw])
    free = is_free(covered, taken)
    for arm in arms:
        free &= np.hypot(x - arm.foot[0], y - arm.foot[1]) > C.foot_distance
    free[free] = ~is_unexplained(covered[free], unexplained)

    if goal is None:
        # The middle, where both arms reach, is for handovers.
        cost = np.hypot(x - block.position[0], y - block.position[1])
        cost += np.maximum(C.handover_half_width - np.abs(x), 0)
    else:
        cost = np.abs(x) + C.handover_depth_cost * np.abs(depth - C.handover_depth)
    best = np.argsort(np.where(free, cost, np.inf), kind="stable")[:free.sum()]
    places = (replace(block, position=np.array([x[i], y[i], block.size[2] / 2]), yaw=yaw[i])
              for i in best)
    return list(islice((it for it in places if is_on_table(it, eye) and is_in_view(it, eye)), C.max_places))


def is_free(covered, taken):
    """Returns which of N areas, Nx5, have room between some blocks, with the fingers of both: N bool."""
    with_fingers = covered + [0, 0, 0, C.place_fingers, 0]
    free = np.ones(len(covered), bool)
    for rectangle in footprint(taken, CLEARANCE.site_margin):
        free &= ~overlap(rectangle, with_fingers)
    # Square blocks can also be held across the other sides.
    for rectangle in gripper_clearance([it for it in taken if not has_equal_sides(it)]):
        free &= ~overlap(rectangle, covered)
    return free


def is_near(place, left):
    """Returns true if a place is close to one of some others."""
    return any(np.linalg.norm(it.position - place.position) < C.near_place_distance for it in left)
