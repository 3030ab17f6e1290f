"""Whether a picture refutes that a block is where it was known to be."""

import numpy as np

from constants import PERCEPTION
from see.eye import pixel_at
from see.sight import top_points
from things.kinds import same_color


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
