"""Blocks, and the steps of a building: what the learner knows of the world."""

import math
from dataclasses import dataclass
from typing import Optional

import numpy as np

from constants import BLOCKS


@dataclass(eq=False)
class Block:
    """A block as it was seen."""

    color: np.ndarray  # red green blue, 3 numbers from 0 to 1
    size: np.ndarray  # its longer side, the shorter one, and its height [units]
    position: np.ndarray  # of its centre, x y z [units]
    yaw: float  # of its longer side [rad]

    @property
    def top(self):
        """Height of its top [units]."""
        return self.position[2] + self.size[2] / 2

    @property
    def bottom(self):
        """Height of what it stands on [units]."""
        return self.position[2] - self.size[2] / 2


@dataclass(eq=False)
class Step(Block):
    """A block as it was built, and shall be again. Its color is None where that does not matter."""

    name: str  # of the object in the demonstration, for people
    on: list  # numbers of the steps that it stands on; none for the table
    way: Optional[np.ndarray] = None  # x y [units] of what was drawn along, from where it was; then
    #                                   color and size are of what it can be drawn by

    def __str__(self):
        return "%s (%.3g x %.3g x %.3g)" % (self.name, *self.size)


@dataclass(eq=False)
class Container(Block):
    """An open box that blocks were put into."""

    name: str  # of the object in the demonstration, for people
    floor: float  # how high its floor is inside [units]


def is_drawn(goal):
    """Whether a goal (a Step, or only a Block) is for something that is drawn there, not carried."""
    return getattr(goal, "way", None) is not None


def is_like(block, step):
    """Whether a block that was seen may play the part of a step's."""
    return same_color(step.color, block.color) and same_size(step.size, block.size)


def same_color(wanted, color):
    """Whether a color is the wanted one; None wants any."""
    return wanted is None or np.abs(wanted - color).max() < BLOCKS.same_color


def same_size(a, b):
    """Whether two blocks are equally large, as far as pictures can tell."""
    return np.abs(a / b - 1).max() < BLOCKS.same_size


def has_equal_sides(block):
    """Whether a quarter of a turn makes no difference to how the block looks."""
    return block.size[0] < BLOCKS.equal_sides * block.size[1]


def turn_between(block, yaw):
    """By how much a block has to turn to have a yaw, as little as possible [rad]: one with four
    equal sides looks the same every 90 degrees, any other every 180."""
    period = math.pi / 2 if has_equal_sides(block) else math.pi
    turn = yaw - block.yaw
    return turn - period * round(turn / period)
