"""What hides blocks from the eye, and where blocks cannot be because it sees the table there."""

import math

import numpy as np

from constants import PERCEPTION as C
from see.eye import pixel_at
from things.areas import footprint, rotated


def is_top_hidden(block, others, eye):
    """Returns true if others (Blocks or Steps) hide a part of a block's top from the eye: a line of
    sight from its middle or near one of its corners passes through one of them."""
    others = [it for it in others if it.top > block.top + C.on_table]
    if not others:
        return False
    covered = footprint(others, 0)
    tops = np.array([it.top for it in others])
    bottoms = np.maximum([it.bottom for it in others], block.top)
    c, s = np.cos(covered[:, 4]), np.sin(covered[:, 4])
    for point in top_points(block):
        for fraction in np.linspace(0, 1, C.sight_heights):
            z = bottoms + fraction * (tops - bottoms)
            along = (z - block.top) / (eye.pose[2, 3] - block.top)
            x = point[0] + along * (eye.pose[0, 3] - point[0]) - covered[:, 0]
            y = point[1] + along * (eye.pose[1, 3] - point[1]) - covered[:, 1]
            if ((2 * abs(x * c + y * s) < covered[:, 2])
                    & (2 * abs(y * c - x * s) < covered[:, 3])).any():
                return True
    return False


def top_points(block):
    """Returns the middle of a block's top and, unless it is a ball, points near its corners or its
    border, Nx3 [units]; of one with an outline, points inside that."""
    fraction = C.top_fraction / (math.sqrt(2) if block.form == "disc" else 1)
    along = fraction * block.size[0] * np.array([math.cos(block.yaw), math.sin(block.yaw), 0])
    across = fraction * block.size[1] * np.array([-math.sin(block.yaw), math.cos(block.yaw), 0])
    middle = np.array([*block.position[:2], block.top])
    if block.form == "ball":
        return middle[None]
    if block.outline:
        return np.array([[*(block.position[:2] + rotated(it, block.yaw)), block.top] for it in block.outline.inside])
    return np.array([middle, middle + along + across, middle + along - across,
                     middle - along - across, middle - along + across])


def is_supported(block, picture, eye, table):
    """Returns true if a block may be where it appears. If the table is visible right below all of
    the edge that is closest to the eye, the block is not so high up, but larger and closer to the
    table.

    table: color of the table
    """
    below_bottom = block.bottom - C.below_edge
    if below_bottom < C.on_table:
        return True
    direction = eye.pose[:2, 3] - block.position[:2]
    quarter_turns = round((math.atan2(direction[1], direction[0]) - block.yaw) / (math.pi / 2))
    toward = block.yaw + quarter_turns * math.pi / 2  # from the middle to that edge
    far, half = np.roll(block.size[:2], quarter_turns) / 2
    edge = block.position[:2] + far * np.array([math.cos(toward), math.sin(toward)])
    is_table = []
    for fraction in C.edge_fractions:
        x, y = edge + fraction * half * np.array([-math.sin(toward), math.cos(toward)])
        pixel = pixel_at(picture, eye, [x, y, below_bottom])
        if pixel is not None:
            is_table.append(np.abs(picture[pixel] - table).max() < C.table_tolerance)
    return not is_table or not all(is_table)
