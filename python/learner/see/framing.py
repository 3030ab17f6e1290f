"""Which blocks the picture contains as a whole, and which are entirely over the table."""

import math

import numpy as np

from constants import TASK_PLANNING as C
from see.eye import Eye, to_pixel


def eye_of_robot(aux):
    """Returns the Eye of a brain."""
    return Eye(aux.cameraIntrinsics, aux.cameraPose, np.ravel(aux.tableSize))


def is_on_table(block, eye):
    """Returns true if no part of a block is beyond the edges of the table."""
    return (np.abs(corners_of(block)[:, :2]) <= np.asarray(eye.table) / 2).all()


def is_in_view(block, eye):
    """Returns true if the whole top of a block is in the eye's picture, whether or not something hides it."""
    pixels = np.array([to_pixel(corner, eye) for corner in corners_of(block)])
    margin = C.picture_margin_pixels
    return ((pixels > margin) & (pixels < 2 * eye.intrinsics[:2, 2] - margin)).all()


def corners_of(block):
    """Returns the corners of the top of a block, 4x3 [units]."""
    along = block.size[0] / 2 * np.array([math.cos(block.yaw), math.sin(block.yaw), 0])
    across = block.size[1] / 2 * np.array([-math.sin(block.yaw), math.cos(block.yaw), 0])
    middle = np.array([*block.position[:2], block.top])
    return np.array([middle + a * along + b * across for a in (1, -1) for b in (1, -1)])
