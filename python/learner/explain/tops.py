"""Measures whole tops and balls in the pictures of a demonstration, at known poses."""

import math

import numpy as np

from constants import OUTLINES, PERCEPTION, TASK_MODEL as C
from explain.object_roles import may_be_ball
from see.balls import ball_color
from see.colors import color_mask
from see.eye import onto_plane, pixel_at
from see.faces import fit_face, is_polygon
from see.regions import label_regions
from things.blocks import Block
from things.kinds import same_color


def measure_top(picture, eye, pose, height):
    """Measures the top of an upright object: its color, and its Face, the sides along the object's x
    and y axes; None if it is not entirely visible, or has another shape.

    pose: x y z of its center [units], angles about x, y, z [degrees]
    """
    top = pose[:3] + [0, 0, height / 2]
    pixel = pixel_at(picture, eye, top) if picture is not None else None
    if pixel is None:
        return None
    color = picture[pixel]
    number = label_regions(color_mask(picture, color))
    row, column = np.nonzero(number == number[pixel])
    pieces = onto_plane(row, column, eye, top[2])
    face = fit_face(*pieces, math.radians(pose[5]))
    off = np.hypot(*(face.center - top[:2]))
    is_whole = off < C.max_center_error and face.misfit < PERCEPTION.misfit
    return (color, face) if is_whole and not (face.is_round and is_polygon(*pieces)) else None


def moves_along(color, pose, frames, height, eye, pictures):
    """Returns true if a picture shows a color also at the top of an object elsewhere.

    pose:   of the object where its top has the color: x y z of its center [units], angles about x, y, z [degrees]
    frames: rows of frame and pose; pictures: of these frames
    """
    for frame, *place in frames:
        is_elsewhere = np.linalg.norm(np.subtract(place[:3], pose[:3])) > OUTLINES.min_distance
        if pictures[frame] is not None and is_elsewhere:
            pixel = pixel_at(pictures[frame], eye, np.array([*place[:2], place[2] + height / 2]))
            if pixel is not None and same_color(color, pictures[frame][pixel]):
                return True
    return False


def measure_ball(demo, n, start, frames, pictures):
    """Measures an object that may be a ball on the table, like measure_object."""
    radius = start[2]
    for frame, *pose in frames if may_be_ball(demo, n) else []:
        picture = pictures[frame]
        color = ball_color(picture, demo.eye, np.array(pose[:3]), radius) if picture is not None else None
        if color is not None:
            return Block(color, np.full(3, 2 * radius), start, 0.0, form="ball")
    return None
