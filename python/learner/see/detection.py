"""Detects the blocks in a picture that look like given ones.

Pictures are HxWx3, 0 to 1; row 0 is the top, column 0 the left.
"""

import numpy as np

from constants import PERCEPTION as C
from see.balls import detect_balls
from see.colors import color_mask, colors_to_detect, table_color
from see.covered import fit_covered
from see.fitting import fit_blocks
from see.layouts import detect_layouts
from see.outlined import detect_outlined
from see.regions import is_cut, is_level, label_regions
from see.sight import is_supported
from things.kinds import same_color, same_form


def detect_blocks(picture, eye, like, containers=(), heights=None):
    """Detects the blocks in a picture that look like given ones (Blocks or Steps), at any place and
    height; some may lie in containers. Partly occluded blocks are not detected. Returns a list.

    heights: as from height_map: separates tops of one color that meet in the picture; None if the
             eye measures no depth
    """
    table = table_color(picture)
    layouts, outlined = [it for it in like if it.parts], [it for it in like if it.outline]
    like = [it for it in like if not it.parts and not it.outline]
    # Those on whose tops others stand, or a knob.
    staying = [it for it in like if getattr(it, "stays", False) or it.has_knob]
    blocks = []
    for color in colors_to_detect(picture, like):
        kinds = [kind for kind in kinds_of(like, color) if kind.form != "ball"]
        bottoms = [likely_bottoms(like, color, kind, heights) for kind in kinds]
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
            found = fit_blocks(row, column, eye, color, kinds, containers,
                               lambda block: is_supported(block, picture, eye, table), bottoms,
                               top, max_error)
            # What stays carries others: they hide a part of its top from the start.
            if not found and top is not None:
                found = fit_covered(row, column, eye, color, kinds_of(staying, color), top,
                                    heights)
            blocks += found
    if heights is not None:
        blocks += detect_balls(picture, eye, [it for it in like if it.form == "ball"], heights)
        blocks += detect_layouts(picture, eye, layouts, heights)
        for color in colors_to_detect(picture, outlined):
            blocks += detect_outlined(picture, eye, color, kinds_of(outlined, color), heights)
    return blocks


def likely_bottoms(like, color, kind, heights):
    """Returns the heights at which the bottom of a block of some color and kind may be expected
    [units]: on the table, where such blocks are or must go, and, without measured heights, on
    whole layers."""
    bottoms = [it.bottom for it in like if same_color(it.color, color) and same_form(kind, it)]
    layers = range(C.max_layers) if heights is None else [0]
    return np.unique(np.round(100 * np.array([*layers, *bottoms])) / 100)


def kinds_of(like, color):
    """Returns a block of each form and size among those of a color, a list."""
    kinds = []
    for it in like:
        if same_color(it.color, color) and not any(same_form(kind, it) for kind in kinds):
            kinds.append(it)
    return kinds
