"""The parts by which blocks are held: their knobs, or themselves."""

from dataclasses import replace

import numpy as np

from constants import MOTION_PLANNING as C
from things.areas import rotated
from things.blocks import Block, yaw_difference


def held_part(block):
    """Returns the part by which a block is held: its knob where that is now, or the block."""
    knob = block.knob
    if knob is None:
        return block
    away = np.append(rotated(knob.position[:2], block.yaw), knob.position[2])
    return Block(knob.color, knob.size, block.position + away, block.yaw + knob.yaw)


def with_held_parts(blocks):
    """Returns blocks and their knobs, a list of Blocks."""
    return blocks + [held_part(it) for it in blocks if it.knob]


def held_anyhow(block):
    """Returns a block, and that block held by each other part by which it can be held: a list of Blocks, the best first."""
    return [block, *(replace(block, knob=it, other_knobs=[]) for it in block.other_knobs)]


def is_turned_to(block, goal):
    """Returns true if a block at the place of a goal would look as wanted there, and its held part be where that of the goal is."""
    there = held_part(replace(block, position=goal.position)).position - held_part(goal).position
    return abs(yaw_difference(block, goal.yaw)) < C.same_yaw_rad and np.hypot(*there[:2]) < C.same_held_distance
