"""Beliefs about the scene: where blocks are, also those that the eye does not see."""

from dataclasses import replace

import numpy as np

from blocks import is_same_kind, same_color
from colors import table_color
from constants import BELIEFS as C, PERCEPTION
from eye import pixel_at
from sight import is_top_hidden, top_points


def update_beliefs(known, seen, picture, eye, heights=None):
    """Returns the known blocks after an observation, a list: those seen, and those that were known
    before and may be occluded now. A block whose top is partly hidden cannot be measured again: it
    is where it was known to be. Without heights, as from height_map, a block is forgotten where the
    table is visible."""
    table = table_color(picture)
    now = list(seen)
    for block in known:
        # What is entirely below or above it is another block.
        distances = [np.linalg.norm(it.position - block.position)
                     if it.bottom < block.position[2] < it.top else np.inf for it in seen]
        if distances and min(distances) < C.same_block_distance:
            nearest = int(np.argmin(distances))
            is_same = is_same_kind(seen[nearest], block)
            if (is_same and distances[nearest] < C.half_hidden_distance
                    and is_top_hidden(seen[nearest], seen, eye)):
                now[nearest] = block
        elif not (is_table_visible(picture, eye, block, table) if heights is None
                  else is_refuted(block, picture, heights, eye)):
            now.append(block)
    return now


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


def assumed_support(block):
    """Returns the support of a block that does not stand on the table, as one Block from the table
    to its bottom: something must carry it, even if it is hidden. A list, empty for a block on the
    table."""
    if block.bottom < C.min_support_height:
        return []
    x, y, _ = block.position
    return [replace(block, size=np.append(block.size[:2], block.bottom),
                    position=np.array([x, y, block.bottom / 2]))]
