"""Blocks on the table that nobody wants, but that may be in the way."""

import numpy as np

from blocks import Block
from constants import SEE, numbers_of
from looking import (describe_face, is_color, label_regions, onto_plane, pixel_at, table_color,
                     to_pixel, unpacked)
from places import footprint, overlap


def find_strangers(picture, eye, known):
    """Blocks on the table that are none of those known: a list."""
    table = table_color(picture)
    strangers = []
    for color, row, column in tops_in(picture, table):
        if any(is_top_of(row, column, it, picture, eye) for it in known):
            continue
        block = measure_block(color, row, column, picture, eye, table)
        if block and not overlap([*block.position[:2], 0, 0, 0], footprint(known, 0)).any():
            strangers.append(block)
    return strangers


def is_top_of(row, column, block, picture, eye):
    spot = pixel_at(picture, eye, [*block.position[:2], block.top])
    return spot is not None and ((row == spot[0]) & (column == spot[1])).any()


def tops_in(picture, table):
    """The flat areas of a picture that may be tops of blocks: those that are not seen below
    something of the same color, but brighter, as their sides are. A list of color, rows and
    columns."""
    codes = np.round(255 * picture).astype(int) @ [65536, 256, 1]
    tops = []
    for code, count in zip(*np.unique(codes, return_counts=True)):
        color = unpacked(code)
        if code == 0 or count < SEE.stranger_pixels or is_color(color[None, None], table).all():
            continue
        number = label_regions(codes == code)
        for region, size in enumerate(np.bincount(number.ravel())):
            if region == 0 or size < SEE.stranger_pixels:
                continue
            row, column = np.nonzero(number == region)
            above = codes[np.maximum(row - 1, 0), column]
            colors, often = np.unique(above[(above != code) & (row > 0)], return_counts=True)
            if not len(colors) or not is_shade(color, unpacked(colors[often.argmax()])):
                tops.append((color, row, column))
    return tops


def is_shade(color, bright):
    """Whether a color is a darker one of the same hue: that of a side of a block with a bright
    top."""
    share = (color * bright).sum() / max((bright**2).sum(), np.finfo(float).eps)
    least, most = SEE.shade
    return least < share < most and np.abs(color - share * bright).max() < SEE.shade_tolerance


def measure_block(color, row, column, picture, eye, table):
    """The Block on the table that has this top, of whatever size; None if it is not seen whole."""
    height = height_of(color, row, column, picture, eye, table)
    if height is None:
        return None
    face = describe_face(*onto_plane(row, column, eye, height))
    if face.misfit > SEE.misfit:
        return None
    return Block(color, np.append(face.sides, height), np.append(face.center, height / 2), face.yaw)


def height_of(color, row, column, picture, eye, table):
    """How high a block is [units]: below the edge of its top one of its sides is seen, down to
    where the table begins. None if something else is there."""
    u, v = edge_below(row, column, eye)
    for trial in numbers_of(*SEE.height_trials):
        x, y, _ = onto_plane(np.array([v - 0.5]), np.array([u - 0.5]), eye, trial)
        spot = pixel_at(picture, eye, [x[0], y[0], 0])
        if spot is None or not is_shade(picture[spot], color):
            break
    height = round(SEE.heights_per_unit * trial) / SEE.heights_per_unit  # pixels cannot tell it finer
    is_table = spot is not None and np.abs(picture[spot] - table).max() < SEE.table_tolerance
    return height if is_table and height > 0 else None


def edge_below(row, column, eye):
    """Where a top ends, in the picture, straight below its middle: towards where whoever looks
    straight down would look. u, v from the top left corner [pixels]."""
    nadir = to_pixel(eye.pose[:3, 3] - [0, 0, 1], eye)
    point = np.array([column.mean(), row.mean()]) + 0.5
    way = 0.5 * (nadir - point) / np.linalg.norm(nadir - point)
    pixels = set(zip(column.tolist(), row.tolist()))
    while tuple(np.floor(point).astype(int).tolist()) in pixels:
        point = point + way
    return point
