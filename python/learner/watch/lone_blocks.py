"""Blocks that stand by themselves on the table, measured by their silhouettes."""

import math

import numpy as np

from constants import PERCEPTION, WATCHING as C
from see.colors import is_darker_shade
from see.eye import onto_plane, pixels_in_view
from see.faces import Face, fit_face
from things.blocks import Block
from watch.silhouettes import area_of, corners_of, hull
from watch.visible_tops import at_border
from watch.watched_pictures import areas_in, colors_of


def lone_blocks(codes, is_background, eye):
    """Yields the Blocks around which only the background is visible, and their pixels. The eye
    sees three faces of a block or fewer, in one color each; the top is the brightest."""
    for row, column in areas_in(~is_background, PERCEPTION.min_unknown_object_pixels):
        shown, often = np.unique(codes[row, column], return_counts=True)
        shown = shown[often > C.max_stray_pixels]
        if not 1 < len(shown) <= C.max_faces or at_border(row, column, codes.shape):
            continue
        colors = colors_of(shown)
        top = colors.sum(axis=1).argmax()
        # A color between two that a pixel can have shows as both.
        is_top = np.abs(colors - colors[top]).max(axis=1) < C.same_top
        if is_top.all() or not is_darker_shade(colors[~is_top], colors[top]).all():
            continue
        own = np.isin(codes[row, column], shown[is_top])
        block = measure_by_silhouette(colors[top], row[own], column[own], len(row), eye)
        if block:
            yield block, (row, column)


def measure_by_silhouette(color, row, column, count, eye):
    """Measures the Block on the table that has a top, by how many pixels show it, with its sides; None if there
    is none. Its sizes are the simplest that agree with the picture: parallel to its rows, an edge may be half a
    pixel off, that is several percent of a side.

    row, column: pixels of the top
    count:       number of pixels of top and sides
    """
    low, high = C.heights
    while high - low > C.height_accuracy:
        middle = (low + high) / 2
        low, high = (middle, high) if area_under(row, column, middle, eye) < count else (low, middle)
    face = fit_face(*onto_plane(row, column, eye, low))
    if face.misfit > PERCEPTION.misfit or face.is_round or low < PERCEPTION.on_table or high == C.heights[1]:
        return None
    # Of the directions of the picture, the one in which a pixel covers most.
    ends = [np.array(onto_plane(row + shift, column, eye, low)[:2]) for shift in (0, 1)]
    pixel = np.median(np.hypot(*(ends[1] - ends[0])))
    growth = area_under(row, column, low + pixel, eye) - area_under(row, column, low, eye)
    width = column.max() + 1 - column.min()
    height = simplest(low, C.edge_pixels * pixel * width / growth)
    face = fit_face(*onto_plane(row, column, eye, height))
    if face.sides[0] < face.sides[1]:
        face = Face(face.center, face.yaw + math.pi / 2, face.sides[::-1], face.misfit)
    sides = [simplest(it, C.edge_pixels * pixel) for it in face.sides]
    return Block(color, np.append(sides, height), np.append(face.center, height / 2), face.yaw)


def area_under(row, column, top, eye):
    """Returns the area [pixels] of the silhouette of a block on the table that has a top of some pixels at a
    height."""
    face = fit_face(*onto_plane(row, column, eye, top))
    block = Block(None, np.append(face.sides, top), np.append(face.center, top / 2), face.yaw)
    return area_of(hull(pixels_in_view(corners_of(block), eye)))


def simplest(length, accuracy):
    """Returns the multiple of the largest units that is a length within some accuracy; the length if none is."""
    for units in C.units:
        multiple = min((it * round(length / it) for it in units), key=lambda it: abs(it - length))
        if multiple > 0 and abs(multiple - length) < accuracy:
            return multiple
    return length
