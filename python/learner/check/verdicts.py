"""Compares what the learner expects to see with a picture: a verdict on each block that it knows."""

from typing import NamedTuple, Optional

import numpy as np

from constants import BELIEFS as C, BLOCKS, PERCEPTION
from see.colors import table_color
from see.eye import pixel_at
from see.sight import is_top_hidden, top_points
from things.blocks import Block, yaw_difference
from things.kinds import is_same_kind, same_color


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


def is_table_visible(picture, eye, block, table):
    """Returns true if the pixel at the middle of a block's top shows the table, of a color."""
    pixel = pixel_at(picture, eye, [*block.position[:2], block.top])
    return pixel is not None and np.abs(picture[pixel] - table).max() < PERCEPTION.table_tolerance


def is_refuted(block, picture, heights, eye):
    """Returns true if a block cannot be where it was known to be: at some point of its top, the eye
    sees something lower, or in its middle something of another color at the same height, and its own
    color nowhere. What hides a point is higher: lines of sight descend."""
    has_color = []  # for each point at which the eye sees something at the height of the top
    is_middle_level = False
    for k, point in enumerate(top_points(block)):
        pixel = pixel_at(picture, eye, point)
        if pixel is None:
            continue
        above = heights[pixel] - block.top
        if above < -PERCEPTION.height_step:
            return True
        if above < PERCEPTION.height_step:
            has_color.append(same_color(block.color, picture[pixel]))
            is_middle_level |= k == 0
    return is_middle_level and not any(has_color)
