"""How deep fingers may reach beside a block that stands on or in something unknown."""

from dataclasses import replace

import numpy as np

from constants import CLEARANCE, MOTION_PLANNING, PERCEPTION
from things.areas import footprint, overlap


def with_depth(block, surface):
    """Returns a block whose fingers stay above all that a Surface shows lower beside it; unchanged without one."""
    if surface is None:
        return block
    points = surface.points
    near = np.column_stack([points[:, :2], np.zeros((len(points), 3))])
    beside = footprint([block], CLEARANCE.open_fingers / 2 + CLEARANCE.margin)
    is_beside = overlap(near, beside)[0] & ~overlap(near, footprint([block], PERCEPTION.on_table))[0]
    lower = points[is_beside & (points[:, 2] < block.top - PERCEPTION.height_step), 2]
    if not len(lower):
        return block
    return replace(block, depth=block.top - lower.max() - MOTION_PLANNING.fingers_above_bottom)
