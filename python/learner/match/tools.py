"""Finds the tool of a demonstrated use in the scene."""

from dataclasses import replace

import numpy as np

from constants import USES as C
from match.alignment import Alignment, agreement
from things.areas import rotated
from things.kinds import is_same_kind


def find_tool(use, known, surface, shown):
    """Returns the known block that is the tool of a Use, turned so that its surroundings look as in the
    demonstration: a bar looks the same after half a turn, what is at its ends does not. None if there is none."""
    best = None
    for block in [it for it in known if is_same_kind(it, use.tool)]:
        for turn in (0, np.pi):
            angle = use.tool.yaw - block.yaw - turn
            at = Alignment(angle, use.tool.position[:2] - rotated(block.position[:2], angle))
            near = surface.around(block.position, C.tool_radius, C.num_points)
            score = agreement(near, at, use.before, shown)
            if best is None or score > best[0]:
                best = score, block, replace(block, yaw=block.yaw + turn)
    return best[1:] if best else None
