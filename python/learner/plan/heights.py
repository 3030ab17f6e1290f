"""How high an arm holds a block, and carries it over others."""

import math

import numpy as np

from constants import MOTION_PLANNING as C
from things.areas import footprint, overlap


def transfer_height(arm, blocks, bottom, extent):
    """Returns the height of an arm's tool between two places [units]: the held block passes over
    all others, and so do the empty fingers, also over the placed block.

    bottom: height of the goal's bottom [units]
    extent: height of the held block [units]
    """
    highest = max(block.top for block in blocks)
    return max(max(highest, bottom) + extent,
               max(highest, bottom + extent) + arm.reach) + C.clearance


def has_low_way(block, goal, others):
    """Returns true if there is no obstacle higher than a block around the first half of its way to
    a goal."""
    way = (goal.position[:2] - block.position[:2]) / 2
    x, y = block.position[:2] + way / 2
    length = np.hypot(*way) + C.low_way_width
    higher = footprint([it for it in others if it.top > block.top], 0)
    return not overlap([x, y, length, C.low_way_width, math.atan2(way[1], way[0])], higher).any()
