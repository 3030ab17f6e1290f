"""Measures pieces of one color with tops of any outline in the pictures of a demonstration: see outlines."""

import math
from dataclasses import replace

import numpy as np

from constants import OUTLINES as C, PERCEPTION
from see.colors import color_mask, frequent_colors, is_color_near, is_darker_shade, table_color
from see.eye import onto_plane, pixel_at
from see.regions import label_regions
from things.areas import rotated
from things.blocks import Block
from things.grips import grips_of
from things.kinds import same_color
from things.outlines import outline_of, points_inside, same_outline


def measure_outlined(demo, n, frames, pictures):
    """Measures an object by its top in two pictures that show it at different places, like measure_object. Around the first,
    only the table and the object's own sides may be visible, and both must show the same outline."""
    height = 2 * demo.moves[n][:, 3].min()
    for frame, *pose in frames if n in demo.placed else []:
        elsewhere = [it for it in frames if np.abs(it[1:4] - pose[:3]).max() > C.min_distance]
        for x, y, area, color in tops_at(pictures[frame], demo.eye, pose, height, True):
            outline = outline_of(x, y, area)
            if not is_seen_at(outline, color, elsewhere, height, demo.eye, pictures):
                continue
            pixel = math.sqrt(np.median(area))
            size = np.array([2 * abs(x).max() + pixel, 2 * abs(y).max() + pixel, height])
            grips = grips_of(x, y, pixel, color, height) or [None]
            return Block(color, size, demo.moves[n][0, 1:4], math.radians(demo.moves[n][0, 6]),
                         outline=replace(outline, inside=points_inside(x, y)), knob=grips[0], other_knobs=grips[1:])
    return None


def is_seen_at(outline, color, frames, height, eye, pictures):
    """Returns true if one of some pictures shows an outline of a color at its place."""
    return any(same_outline(outline, outline_of(*it[:3])) for frame, *pose in frames
               for it in tops_at(pictures[frame], eye, pose, height, False) if same_color(color, it[3]))


def tops_at(picture, eye, pose, height, is_alone):
    """Yields what may be the top of an upright object at a pose: x and y in its frame and the areas of the pixels, and the color.

    is_alone: whether only the table and its own sides may be visible around it
    """
    middle = None if picture is None else pixel_at(picture, eye, pose[:3])
    table = None if picture is None else table_color(picture)
    for color in [] if picture is None else frequent_colors(picture, PERCEPTION.min_rim_pixels):
        if not is_color_near(picture, color, middle) or np.abs(color - table).max() < PERCEPTION.table_tolerance:
            continue
        number = label_regions(color_mask(picture, color))
        for region in np.flatnonzero(np.bincount(number.ravel()) >= PERCEPTION.min_rim_pixels):
            if region == 0:
                continue
            row, column = np.nonzero(number == region)
            x, y, area = onto_plane(row, column, eye, pose[2] + height / 2)
            x, y = rotated([x - pose[0], y - pose[1]], -math.radians(pose[5]))
            if np.hypot(x, y).min() < C.max_distance and not (
                    is_alone and not stands_alone(picture, number == region, color, table)):
                yield x, y, area, np.median(picture[row, column], axis=0)


def stands_alone(picture, mask, color, table):
    """Returns true if, around a top of a color, only the table and darker shades of the color are visible."""
    around = np.pad(mask, 1)
    for axis in (0, 1):
        around = around | np.roll(around, 1, axis) | np.roll(around, -1, axis)
    beside = picture[around[1:-1, 1:-1] & ~mask]
    own = (np.abs(beside - table).max(axis=1) < PERCEPTION.table_tolerance) | is_darker_shade(beside, color)
    return own.mean() > C.min_alone
