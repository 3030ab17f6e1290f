"""The blocks of a demonstration, as far as its pictures have shown them."""

from dataclasses import dataclass, field
from typing import Optional

import numpy as np

from constants import WATCHING as C
from watch.palette import BACKGROUND
from things.blocks import Block
from things.standing import stands_on


@dataclass(eq=False)
class Tracked:
    """A block of the demonstration."""

    kind: object  # Kind
    start: Optional[Block]  # where it was at the start; None if that was hidden
    block: Optional[Block]  # where it rests now; None in a hand
    placed: list = field(default_factory=list)  # frames and Blocks, where hands put it
    seen: float = 1.0  # how much of its top was visible when its place was measured, as in Fit
    num_looks: int = 0  # how often its place was measured again
    doubted: Optional[tuple] = None  # frame and Block, where it may rest


def take_away(resting, classes, view, palette):
    """Takes note of the Tracked blocks that are no longer where they rested: what they hid is visible there.

    classes: of the pixels of a picture, as from a Palette
    view:    ExpectedView of all that rest
    """
    for it in list(resting):
        own = palette.top(it.kind.color)
        below = [palette.top(other.kind.color) for other in carriers(it, resting)]
        visible = classes[view.top_of(it.block)]
        is_revealed = np.isin(visible, [BACKGROUND] + [top for top in below if top != own])
        if len(visible) > C.min_visible_pixels and is_revealed.mean() > C.max_revealed:
            resting.remove(it)
            it.block = None


def carriers(it, resting):
    """Returns the blocks among some that rest on which a Tracked block stands, a list."""
    return [other for other in resting
            if other is not it and other.block and stands_on(it.block, other.block)]


def doubt(resting):
    """Sets places aside that were measured by a small part of a top: the next picture may show more."""
    for it in [it for it in resting if it.placed and it.seen < C.min_seen_edge]:
        if not any(it in carriers(other, resting) for other in resting if other.block and other is not it):
            it.doubted, it.block = it.placed.pop(), None


def believe(objects):
    """Returns to the doubted places for which a picture showed no others."""
    for it in objects:
        if it.doubted and not it.block:
            it.placed.append(it.doubted)
            it.block = it.doubted[1]
        it.doubted = None
