"""How a hand pushes a block along a way."""

import math
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from act.finger_room import grasp_yaws
from act.grippers import grip_depth, nearest_first
from act.push_ways import push_ways
from act.reach import is_reachable, solve_poses
from act.segments import at_height
from constants import MOTION_PLANNING as C


class PushingHand(NamedTuple):
    """A hand that pushes a block with both fingers."""

    across: float  # direction from finger to finger [rad]
    opening: float  # between them [units]
    poses: list  # of the tool, 4x4: behind the block, at the end of the way, and back from it


def pushing_hands(arm, block, way, others):
    """Returns how the hand of an arm can push a block that is on a PushWay to its end: a list.

    others: obstacles, as Blocks
    """
    depth, width, _ = np.diff(arm.robot.finger_bounds(arm.name, 0), axis=0)[0]
    # So far apart that the block does not turn, but not beyond its sides, where others may touch it.
    opening = min(max(way.width - width - C.push_margin, 0), arm.opening)
    away, up = np.append(way.away, 0), np.array([0, 0, block.size[2] / 2 - grip_depth(arm, block.size[2])])
    first, last = (it.position + away * (way.length + depth) / 2 for it in (block, way.end))
    middles = [first + C.push_margin * away, last, last + C.push_margin * away]
    # The fingers need room as if they held something as wide as they are open, with its sides toward the block.
    held = replace(block, size=np.array([way.width, opening - C.opening_margin, block.size[2]]),
                   yaw=math.atan2(way.away[1], way.away[0]))
    room = [grasp_yaws(replace(held, position=it), others) for it in middles[:2]]
    return [PushingHand(across, opening, [arm.tool_pose(it + up, across, opening) for it in middles])
            for across in room[0] if across in room[1]]


def way_to_push(arms, step, before):
    """Returns the first PushWay to the place of a step on which the nearest arm can push a block: it reaches the start of the way
    and all poses of the push. None if there is none.

    before: what stands there then, as Blocks
    """
    arm = nearest_first(arms, step.position[0])[0]
    for way in push_ways(step, step, before):
        hands = pushing_hands(arm, way.start, way, before)
        over = way.start.top + arm.reach + C.clearance
        if is_reachable(arm, way.start) and any(
                solve_poses(arm, [at_height(it.poses[0], over), *it.poses], arm.parked) for it in hands):
            return way
    return None


def room_to_push(arms, way):
    """Returns what a block at the start of a PushWay and the fingers that the nearest arm brings behind it take up, as one
    Block."""
    arm = nearest_first(arms, way.end.position[0])[0]
    behind = np.diff(arm.robot.finger_bounds(arm.name, 0), axis=0)[0, 0] + C.push_margin
    return replace(way.start, position=way.start.position + behind / 2 * np.append(way.away, 0),
                   size=np.array([way.length + behind, way.width, way.start.size[2]]), yaw=math.atan2(way.away[1], way.away[0]))
