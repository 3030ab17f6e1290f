"""Measures tops of which something in the middle hides a part: a knob, or another object."""

import math

import numpy as np

from constants import PERCEPTION, TASK_MODEL as C
from relate.dragging import has_shape
from see.colors import color_mask, frequent_colors, is_color_near
from see.covered import smallest_rectangle
from see.eye import onto_plane, pixel_at
from see.regions import label_regions
from things.blocks import Block


def measure_covered_top(demo, n, start, yaw, pictures):
    """Measures an object that stood on the table all the time, below another one, like measure_object."""
    picture = pictures[demo.moves[n][0, 0]]
    is_still = n not in demo.placed and has_shape(demo, n, "block")
    if picture is None or not is_still or not any(is_below(start, rows[0, 1:4]) for rows in demo.moves):
        return None
    height, pose = 2 * start[2], np.array([*start, 0, 0, math.degrees(yaw)])
    for color in frequent_colors(picture, PERCEPTION.min_rim_pixels):
        sides = sides_around(picture, demo.eye, color, pose, height, C.min_covered_seen)
        if sides is not None:
            return Block(color, np.append(sides, height), start, yaw)
    return None


def is_below(center, other):
    """Returns true if the center of another object is over one."""
    return other[2] > center[2] and np.hypot(*(other - center)[:2]) < C.same_place


def measure_top_with_knob(demo, n, start, yaw, frames, pictures):
    """Measures an object with a part in the middle of its top, like measure_object. Its height is twice that of its
    middle where a hand put it lowest, on the table."""
    height = 2 * demo.moves[n][:, 3].min()
    for frame, *pose in frames if n in demo.placed else []:
        picture = pictures[frame]
        for color in frequent_colors(picture, PERCEPTION.min_rim_pixels) if picture is not None else []:
            sides = sides_around(picture, demo.eye, color, pose, height, C.min_top_seen)
            if sides is not None:
                return Block(color, np.append(sides, height), start, yaw, has_knob=True)
    return None


def sides_around(picture, eye, color, pose, height, min_seen):
    """Returns the sides of a top of a color at a pose, if its middle is not visible, but this fraction of it; or None."""
    top = pose[:3] + np.array([0, 0, height / 2])
    middle = pixel_at(picture, eye, top)
    if not is_color_near(picture, color, middle):
        return None
    mask = color_mask(picture, color)
    number = label_regions(mask)
    row, column = np.nonzero(mask)
    regions = number[row, column]
    for region in np.flatnonzero(np.bincount(regions) >= PERCEPTION.min_rim_pixels):
        if number[middle] == region:
            continue
        inside = regions == region
        x, y, area = onto_plane(row[inside], column[inside], eye, top[2])
        pixel = np.sqrt(np.median(area))
        face = smallest_rectangle(x, y, pixel, math.radians(pose[5]))
        is_there = np.hypot(*(face.center - top[:2])) < C.max_container_error
        if is_there and area.sum() > min_seen * face.sides.prod():
            return face.sides
    return None
