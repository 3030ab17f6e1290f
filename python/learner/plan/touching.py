"""How a block is put against others that it touches at its place."""

import math

import numpy as np

from constants import MOTION_PLANNING as C
from things.areas import footprint, overlap


def beside_touching(goal, others):
    """Returns how far beside its place a block is lowered, x y [units]: away from others that it touches there, if there is
    room. From there it is slid against them. Lowered right beside them, it may catch on their tops, as no place is exact.

    goal: the block at its place, a Block or Step
    """
    level = footprint([it for it in others if it.top > goal.bottom + C.max_touching_gap and it.bottom < goal.top], 0)
    directions = goal.yaw + np.arange(4) * math.pi / 2
    touching = [overlap(strip_beside(goal, k, C.max_touching_gap), level).any() for k in range(4)]
    narrow = [overlap(strip_beside(goal, k, 2 * C.beside_distance), level).any() for k in range(4)]
    away = np.zeros(2)
    for k in range(4):
        if touching[k] and not narrow[(k + 2) % 4]:
            away -= C.beside_distance * np.array([math.cos(directions[k]), math.sin(directions[k])])
    return away


def strip_beside(block, k, width):
    """Returns the area along a side of a block, with a width [units]: see areas.

    k: the side, 0 to 3: at the end of its longer side, then counterclockwise
    """
    across, along = block.size[[k % 2, 1 - k % 2]]
    yaw = block.yaw + k * math.pi / 2
    distance = (across + width) / 2
    return [block.position[0] + distance * math.cos(yaw), block.position[1] + distance * math.sin(yaw),
            width, along - 2 * C.max_touching_gap, yaw]
