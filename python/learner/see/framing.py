"""Which blocks the picture contains as a whole."""

import math

import numpy as np

from constants import TASK_PLANNING as C
from see.eye import to_pixel


def is_in_view(block, eye):
    """Returns true if the whole top of a block is in the eye's picture, whether or not something hides it."""
    along = block.size[0] / 2 * np.array([math.cos(block.yaw), math.sin(block.yaw), 0])
    across = block.size[1] / 2 * np.array([-math.sin(block.yaw), math.cos(block.yaw), 0])
    middle = np.array([*block.position[:2], block.top])
    corners = [middle + a * along + b * across for a in (1, -1) for b in (1, -1)]
    pixels = np.array([to_pixel(corner, eye) for corner in corners])
    margin = C.picture_margin_pixels
    return ((pixels > margin) & (pixels < 2 * eye.intrinsics[:2, 2] - margin)).all()
