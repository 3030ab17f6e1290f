"""The kinds of the blocks in the pictures of a demonstration."""

from dataclasses import dataclass

import numpy as np

from constants import WATCHING as C
from watch.palette import BACKGROUND
from things.kinds import same_color
from watch.known_sizes import kinds_of_known_size
from watch.lone_blocks import lone_blocks
from watch.watched_pictures import codes_in


@dataclass(eq=False)
class Kind:
    """Blocks that look alike."""

    color: np.ndarray  # red green blue, 3 numbers from 0 to 1
    size: np.ndarray  # its longer side, the shorter one, and its height [units]


def learn_kinds(files, palette, eye):
    """Returns the Kinds of the blocks that stand by themselves on the table in some pictures, a list, and adds
    their colors to a Palette.

    files: of the pictures, the first one of the demonstration first: there no hand holds anything
    """
    kinds = []
    free = None  # pixels that showed the background in some picture
    for file in files:
        codes = codes_in(file)
        is_background = palette.classes(codes) == BACKGROUND
        for block, pixels in lone_blocks(codes, is_background, eye):
            was_there = free is None or free[pixels].mean() < C.max_free
            if is_new(block, kinds, was_there):
                kinds.append(Kind(block.color, known_size(block.size, kinds, was_there)))
                palette.add(block.color)
        free = is_background if free is None else free | is_background
    tried = set()
    for file in files if kinds else []:
        for color, size in kinds_of_known_size(codes_in(file), palette, kinds, tried, eye):
            kinds.append(Kind(color, size))
            palette.add(color)
    return kinds


def is_new(block, kinds, was_there):
    """Returns true if a block shows a kind that is not known yet. What was put somewhere may be several blocks
    together, or be in a hand, so it does not show another size of a known color."""
    alike = [it for it in kinds if same_color(it.color, block.color)]
    return not alike or was_there and not any(
        np.abs(block.size / it.size - 1).max() < C.same_kind for it in alike)


def known_size(size, kinds, was_there):
    """Returns the size of a block that seems to stand on the table; in a hand it seems larger than it is, in all
    directions alike, and then has the size of a known kind."""
    for it in [] if was_there else kinds:
        ratios = size / it.size
        if ratios.min() > 1 - C.same_kind and ratios.max() / ratios.min() < 1 + C.same_kind:
            return it.size
    return size
