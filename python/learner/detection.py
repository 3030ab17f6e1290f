"""Detects the blocks in a picture that look like given ones.

Pictures are HxWx3, 0 to 1; row 0 is the top, column 0 the left.
"""

import numpy as np

from blocks import same_color, same_size
from colors import color_mask, colors_to_detect, table_color
from constants import PERCEPTION as C
from covered import fit_covered
from fitting import fit_blocks
from regions import is_cut, is_level, label_regions
from sight import is_supported


def detect_blocks(picture, eye, like, container=None, heights=None):
    """Detects the blocks in a picture that look like given ones (Blocks or Steps), at any place and
    height; some may lie in a container. Partly occluded blocks are not detected. Returns a list.

    heights: as from height_map: separates tops of one color that meet in the picture; None if the
             eye measures no depth
    """
    table = table_color(picture)
    staying = [it for it in like if getattr(it, "stays", False)]
    blocks = []
    for color in colors_to_detect(picture, like):
        sizes = block_sizes(like, color)
        bottoms = [likely_bottoms(like, color, size, heights) for size in sizes]
        number = label_regions(color_mask(picture, color), heights)
        for region, count in enumerate(np.bincount(number.ravel())):
            if region == 0 or count < C.min_top_pixels:
                continue
            row, column = np.nonzero(number == region)
            top, max_error = None, C.max_side_error
            if heights is not None:
                if not is_level(heights[row, column]):
                    continue
                top = np.median(heights[row, column])
                if is_cut(row, column, top, heights):
                    max_error = C.max_cut_side_error
            found = fit_blocks(row, column, eye, color, sizes, container,
                               lambda block: is_supported(block, picture, eye, table), bottoms,
                               top, max_error)
            # What stays carries others: they hide a part of its top from the start.
            if not found and top is not None:
                found = fit_covered(row, column, eye, color, block_sizes(staying, color), top,
                                    heights)
            blocks += found
    return blocks


def likely_bottoms(like, color, size, heights):
    """Returns the heights at which the bottom of a block of some color and size may be expected
    [units]: on the table, where such blocks are or must go, and, without measured heights, on
    whole layers."""
    bottoms = [it.bottom for it in like if same_color(it.color, color) and same_size(size, it.size)]
    layers = range(C.max_layers) if heights is None else [0]
    return np.unique(np.round(100 * np.array([*layers, *bottoms])) / 100)


def block_sizes(like, color):
    """Returns the distinct sizes of blocks of a color among some, a list."""
    sizes = []
    for it in like:
        if same_color(it.color, color) and not any(same_size(size, it.size) for size in sizes):
            sizes.append(it.size)
    return sizes
