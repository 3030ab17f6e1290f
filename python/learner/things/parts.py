"""Things of several colors: their parts, the flat tops of one color that move with them.

A part is a Block in the frame of the object: its position is that of the middle of its top from the object's
center, its yaw is from the object's.
"""

import math
from dataclasses import replace

import numpy as np

from constants import PARTS as C
from things.areas import rotated
from things.blocks import Block


def whole_of(parts, moves):
    """Returns the object that parts belong to, as a Block at its first place: as wide as they are on both sides
    of its center, and as high below it as above, unless it was lower than that."""
    sides = np.max([2 * np.abs(it.position[:2]) + it.size[:2] for it in parts], axis=0)
    height = 2 * min(max(it.position[2] for it in parts), moves[:, 3].min())
    largest = max(parts, key=lambda it: it.size[:2].prod())
    return Block(largest.color, np.append(sides, height), moves[0, 1:4], math.radians(moves[0, 6]),
                 parts=parts)


def turned(parts, angle):
    """Returns parts in the frame of an object that is turned by an angle [rad] from the present one."""
    return [replace(it, position=np.append(rotated(it.position[:2], -angle), it.position[2]),
                    yaw=it.yaw - angle) for it in parts]


def space_of(block):
    """Returns the space that a thing of several colors may fill, as a Block: its parts are only what is known of
    it. Any other block is returned as it is."""
    if not block.parts:
        return block
    top = block.position[2] + max(it.position[2] for it in block.parts) + C.around
    size = np.append(block.size[:2] + 2 * C.around, top - block.bottom)
    return replace(block, size=size, position=np.append(block.position[:2], top - size[2] / 2))
