"""Compares what the learner expects to see with a picture: a verdict on each block that it knows."""

from typing import NamedTuple, Optional

import numpy as np

from check.refutations import is_refuted, is_table_visible
from constants import BELIEFS as C, BLOCKS
from see.colors import table_color
from see.sight import is_top_hidden
from things.blocks import Block, yaw_difference
from things.kinds import is_same_kind


class Verdict(NamedTuple):
    """What a picture says of a block."""

    word: str  # "as expected", "hidden", or "contradicted"
    expected: Block
    found: Optional[int] = None  # number of the seen block that is in its place


def verdicts_on(known, seen, picture, eye, heights, tolerance=BLOCKS.position_tolerance):
    """Returns a verdict for each of the known blocks, a list. A block whose top is partly hidden
    cannot be measured: it counts as hidden.

    seen: the blocks detected in the picture
    heights: as from height_map; None: a block is contradicted only where the table is visible
    tolerance: of positions [units]
    """
    table = table_color(picture)
    verdicts = []
    for block in known:
        distances = [np.linalg.norm(it.position - block.position) if may_replace(it, block) else np.inf for it in seen]
        if distances and min(distances) < C.same_block_distance:
            nearest = int(np.argmin(distances))
            it = seen[nearest]
            word = "contradicted"
            if is_same_kind(it, block):
                if distances[nearest] < C.half_hidden_distance and is_top_hidden(it, seen, eye):
                    word = "hidden"
                elif (distances[nearest] < tolerance
                      and abs(yaw_difference(block, it.yaw)) < BLOCKS.yaw_tolerance_rad):
                    word = "as expected"
            verdicts.append(Verdict(word, block, nearest))
        else:
            is_gone = (is_table_visible(picture, eye, block, table) if heights is None
                       else is_refuted(block, picture, heights, eye))
            verdicts.append(Verdict("contradicted" if is_gone else "hidden", block))
    return verdicts


def may_replace(found, block):
    """Returns true if what is seen there may be in the place of a block. What is entirely below or above it is another
    block, and so may be what is in a ring, or beside an L."""
    is_level = found.bottom < block.position[2] < found.top
    return is_level and (block.outline is None or is_same_kind(found, block))
