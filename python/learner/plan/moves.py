"""Moves of blocks, as values."""

from typing import NamedTuple, Optional

from things.blocks import Block
from things.steps import Step


class Move(NamedTuple):
    """A move that may come next."""

    block: Block  # a known one
    goal: Optional[Step] = None  # None: a temporary placement
    turns: tuple = ()  # how it has to be turned there, and again after that: as turns_between
    room: Optional[Block] = None  # another block, at the place that this move makes free for it


def distinct(blocks):
    """Returns blocks without repetitions, a list."""
    return list(dict.fromkeys(blocks))
