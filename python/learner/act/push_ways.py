"""Straight ways along which blocks can be pushed to their places."""

import math
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from act.finger_room import grasp_yaws
from constants import BLOCKS, MOTION_PLANNING as C, PERCEPTION
from things.areas import footprint, overlap
from things.blocks import Block, yaw_difference
from things.standing import stands_on
from things.steps import is_dragged


class PushWay(NamedTuple):
    """A straight way along which a block is pushed to its place."""

    start: Block  # where it begins
    end: Block  # at its place
    away: np.ndarray  # from its end to its start, x y, of length 1
    length: float  # of the block along the way [units]
    width: float  # of the block across the way [units]


def push_ways(block, goal, others):
    """Returns the ways along which a block can be pushed to a goal (a Block or Step): a list of up to four, one for each side.
    At their starts, fingers have room between the block and what it touches at the goal.

    others: obstacles and supports, as Blocks
    """
    if block.is_round or block.has_knob or block.parts or block.outline or is_dragged(goal):
        return []
    end = replace(block, position=goal.position, yaw=goal.yaw)
    level = [it for it in others if it.top > end.bottom + C.max_touching_gap and it.bottom < end.top]
    taken = footprint(level, -C.max_touching_gap)
    ways = []
    for k in range(4):
        yaw = goal.yaw + k * math.pi / 2
        away = np.array([math.cos(yaw), math.sin(yaw)])
        start = replace(end, position=end.position + C.push_distance * np.append(away, 0))
        is_free = not overlap(footprint([start], 0)[0], taken).any()
        # Its middle is carried, also if it is a bit farther away.
        middle = start.position[:2] + C.max_push_deviation * away
        if is_free and is_carried(start, middle, others) and grasp_yaws(start, others):
            ways.append(PushWay(start, end, away, *block.size[[k % 2, 1 - k % 2]]))
    return ways


def is_carried(block, point, others):
    """Returns true if the table or another block is below a point of a block's bottom, x y [units]."""
    below = [it for it in others if stands_on(block, it)]
    return block.bottom < PERCEPTION.on_table or overlap([*point, 0, 0, 0], footprint(below, 0)).any()


def is_on_way(block, way):
    """Returns true if a block is so close to a way that it comes to its place when it is pushed there."""
    x, y, z = block.position - way.end.position
    along = np.array([x, y]) @ way.away
    across = np.array([y, -x]) @ way.away
    return (0 < along < C.push_distance + C.max_push_deviation and max(abs(across), abs(z)) < C.max_push_deviation
            and abs(yaw_difference(block, way.end.yaw)) < BLOCKS.yaw_tolerance_rad)
