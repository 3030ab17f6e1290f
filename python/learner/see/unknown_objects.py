"""Detects objects that look like none of the given ones."""

import numpy as np

from constants import PERCEPTION as C
from see.colors import color_mask, color_of_code, frequent_colors, is_below_brighter, table_color
from see.eye import pixel_at
from see.measuring import measure_block
from see.regions import is_level, label_regions
from things.areas import footprint, overlap
from things.parts import space_of


def detect_unknown_objects(picture, eye, known, heights=None, tops=None):
    """Detects Blocks that are none of the known ones; they belong to no step, but may be in the way. Without heights, as
    from height_map, only those on the table. Returns a list.

    tops: what segment_top_faces found in the picture; None if that is not known yet
    """
    table = table_color(picture)
    known = [space_of(it) for it in known]
    unknown = []
    for color, row, column in segment_top_faces(picture, table, heights) if tops is None else tops:
        if any(is_top_of(row, column, it, picture, eye, heights) for it in known):
            continue
        block = measure_block(color, row, column, picture, eye, table, heights)
        if not block:
            continue
        beside = [it for it in known if it.top > block.bottom + C.on_table and it.bottom < block.top - C.on_table]
        if not overlap([*block.position[:2], 0, 0, 0], footprint(beside, 0)).any():
            unknown.append(block)
    return unknown


def is_top_of(row, column, block, picture, eye, heights=None):
    """Returns true if a segmented top face contains the middle of a block's top."""
    pixel = pixel_at(picture, eye, [*block.position[:2], block.top])
    if pixel is None or not ((row == pixel[0]) & (column == pixel[1])).any():
        return False
    return heights is None or abs(heights[pixel] - block.top) < C.height_step


def segment_top_faces(picture, table, heights=None):
    """Segments the flat areas of a picture that may be tops of blocks: those at one height above the table, or, without
    heights, those that are not, like the sides of blocks, below a brighter area of the same hue. Returns a list of color,
    rows and columns.

    table: color of the table
    """
    codes = np.round(255 * picture).astype(int) @ [65536, 256, 1]
    tops = []
    for color, mask in color_masks(picture, codes, heights is not None):
        if color_mask(color[None, None], table).all():
            continue
        number = label_regions(mask, heights)
        for region, size in enumerate(np.bincount(number.ravel())):
            if region == 0 or size < C.min_unknown_object_pixels:
                continue
            row, column = np.nonzero(number == region)
            if (is_level(heights[row, column]) if heights is not None
                    else not is_below_brighter(color, codes, row, column)):
                tops.append((color, row, column))
    return tops


def color_masks(picture, codes, is_tolerant):
    """Yields the frequent colors of a picture and the masks of their pixels.

    codes:       of the colors of the pixels
    is_tolerant: whether the colors may differ a little; otherwise they are exact, to distinguish
                 tops from sides
    """
    if is_tolerant:
        for color in frequent_colors(picture, C.min_unknown_object_pixels):
            yield color, color_mask(picture, color)
        return
    for code, count in zip(*np.unique(codes, return_counts=True)):
        if code > 0 and count >= C.min_unknown_object_pixels:
            yield color_of_code(code), codes == code
