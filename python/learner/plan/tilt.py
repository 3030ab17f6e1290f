"""Heights and poses of a tool that is tilted by 45 degrees."""

import math

import numpy as np

from constants import MOTION_PLANNING as C


def lowest_tilted_tool(arm):
    """Returns how high the tool of an arm must be for its tilted fingers to stay above the table."""
    return (arm.reach + C.tilted_finger) / math.sqrt(2) + C.fingers_above_bottom


def height_over(arm, place, height):
    """Returns the height of the tool at which its tilted fingers pass over a block at a place; at least
    some height."""
    return max(height, place.top + lowest_tilted_tool(arm) + C.clearance)


def turn_height(block, others):
    """Returns the height of the tool at which a block turns above all others."""
    return (max((it.top for it in others), default=0) + np.linalg.norm(block.size[[0, 2]])
            + C.clearance)


def pose_at(position, yaw):
    """Returns the pose of an upright object, 4x4."""
    c, s = math.cos(yaw), math.sin(yaw)
    return np.array([[c, -s, 0, position[0]], [s, c, 0, position[1]], [0, 0, 1, position[2]],
                     [0, 0, 0, 1]])
