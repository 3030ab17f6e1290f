"""Steps of a task: blocks at their places in the finished building, and open boxes around them."""

from dataclasses import dataclass, field
from typing import NamedTuple, Optional

import numpy as np

from constants import BLOCKS
from things.blocks import Block

TABLE = "the table"  # the anchor of steps whose place on the table was shown


class StartSupport(NamedTuple):
    """What an object stood on at the start of the demonstration."""

    like: Optional[Block]  # a Step for what looks like it; None: the table
    name: str  # of it in the demonstration, for messages
    away: np.ndarray  # x y of it, from the middle of all objects that look like it [units]


@dataclass(eq=False)
class Step(Block):
    """A block at its place in the finished building. Its color is None where that does not
    matter."""

    name: str  # of the object in the demonstration, for messages
    on: list  # numbers of the steps that it stands on; empty for the table
    displacement: Optional[np.ndarray] = None  # x y [units] of a dragged object, whose color and
    #                                            size are those of its handle
    stays: bool = False  # true for an object that the demonstration did not move
    begins_there: bool = False  # true for an object that began where it ends
    after: list = field(default_factory=list)  # numbers of steps that must be done before it, also if
    #                                            it does not stand on them
    takes_place_of: str = ""  # name of the object that began at the place of this step
    start: Optional[np.ndarray] = None  # x y z of its center at the start of the demonstration [units]
    start_size: Optional[np.ndarray] = None  # as size, of an object that began on another face
    aside: Optional[object] = None  # where it was put before it came back: an Aside
    tolerance: float = BLOCKS.position_tolerance  # of its position [units]
    anchor: str = ""  # name of the object, or TABLE, relative to which its place was shown; empty if it may
    #                   stand anywhere
    began_on: Optional[StartSupport] = None  # where that tells it from others that look the same

    def __str__(self):
        return "%s (%.3g x %.3g x %.3g)" % (self.name, *self.size)


@dataclass(eq=False)
class Container(Block):
    """An open box that blocks were put into."""

    name: str  # of the object in the demonstration, for messages
    floor: float  # height of its floor above the table [units]


def is_dragged(goal):
    """Returns true if a goal (a Step or a Block) is for an object that is dragged there, not
    carried."""
    return getattr(goal, "displacement", None) is not None


def start_supports_of(steps):
    """Returns what tells the objects of steps from others by being below them at the start: Steps."""
    return [step.began_on.like for step in steps if step.began_on and step.began_on.like]
