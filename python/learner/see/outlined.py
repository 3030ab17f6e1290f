"""Detects pieces of one color with tops of any outline: see outlines."""

import numpy as np

from constants import OUTLINES, PERCEPTION as C
from see.colors import color_mask
from see.eye import onto_plane
from see.regions import is_cut, is_level, label_regions
from things.areas import rotated
from things.blocks import Block
from things.outlines import outline_fit, outline_of


def detect_outlined(picture, eye, color, kinds, heights):
    """Detects the pieces of a color in a picture that look like given ones (Blocks or Steps with an outline), on level ground,
    at any place and height: a list of Blocks. heights: as from height_map."""
    found = []
    number = label_regions(color_mask(picture, color), heights)
    for region in np.flatnonzero(np.bincount(number.ravel()) >= C.min_top_pixels):
        row, column = np.nonzero(number == region)
        top = np.median(heights[row, column])
        if region == 0 or not is_level(heights[row, column]) or is_cut(row, column, top, heights):
            continue
        outline = outline_of(*onto_plane(row, column, eye, top))
        fits = [outline_fit(kind.outline, outline) for kind in kinds]
        for kind, (yaw, misfit) in zip(kinds, fits):
            is_above_table = top - kind.size[2] > -C.on_table
            if misfit < OUTLINES.misfit and misfit == min(it for _, it in fits) and is_above_table:
                center = outline.center - rotated(kind.outline.center, yaw)
                found.append(Block(color, kind.size, np.append(center, top - kind.size[2] / 2), yaw,
                                   outline=kind.outline, knob=kind.knob, other_knobs=kind.other_knobs))
    return found
