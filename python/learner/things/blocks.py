"""Blocks as the learner sees them."""

import math
from dataclasses import dataclass, field
from typing import Optional

import numpy as np

from constants import BLOCKS


@dataclass(eq=False)
class Block:
    """A detected block."""

    color: np.ndarray  # red green blue, 3 numbers from 0 to 1
    size: np.ndarray  # its longer side, the shorter one, and its height [units]
    position: np.ndarray  # of its center, x y z [units]
    yaw: float  # of its longer side [rad]
    form: str = field(default="block", kw_only=True)  # or "disc", "ball": its sides are its diameter
    has_knob: bool = field(default=False, kw_only=True)  # whether it is held by a part on its top,
    knob: Optional["Block"] = field(default=None, kw_only=True)  # this one: see knobs
    other_knobs: list = field(default_factory=list, kw_only=True)  # or one of these, where that is out of reach
    parts: list = field(default_factory=list, kw_only=True)  # of a thing of several colors: see parts
    outline: Optional[object] = field(default=None, kw_only=True)  # of a top of another shape: see outlines
    depth: float = field(default=math.inf, kw_only=True)  # how far below its top the fingers may reach [units]

    @property
    def is_round(self):
        """True for a disc or a ball."""
        return self.form != "block"

    @property
    def top(self):
        """Height of its top [units]."""
        return self.position[2] + self.size[2] / 2

    @property
    def bottom(self):
        """Height of its bottom [units]."""
        return self.position[2] - self.size[2] / 2


def has_equal_sides(block):
    """Returns true if the sides of a block's top are equal within the accuracy of pictures: then it
    looks the same every 90 degrees, and can be held either way."""
    return block.size[0] < BLOCKS.equal_sides * block.size[1]


def yaw_difference(block, yaw):
    """Returns the smallest rotation of a block to a yaw [rad]: a block with four equal sides looks
    the same every 90 degrees, any other every 180, round ones always, and things of several colors never."""
    if block.is_round:
        return 0.0
    if block.outline and not block.outline.fold:
        return 0.0
    period = math.pi / 2 if has_equal_sides(block) else math.pi
    if block.parts:
        period = 2 * math.pi
    if block.outline:
        period = 2 * math.pi / block.outline.fold
    rotation = yaw - block.yaw
    return rotation - period * round(rotation / period)
