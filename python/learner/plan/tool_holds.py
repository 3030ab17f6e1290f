"""How arms can hold a tool."""

from itertools import product
from typing import NamedTuple

import numpy as np

from act.actions import Grasp
from act.arms import Arm
from act.finger_room import grasp_yaws
from act.grippers import grip_depth
from act.reach import solve_poses
from act.segments import at_height
from check.failures import has_failed
from constants import USES as C
from plan.loads import Load, load_of
from plan.there_and_back import plan_to_take
from things.areas import rotated


class Hold(NamedTuple):
    """How an arm holds a tool."""

    arm: Arm
    grasp: Grasp
    grip: float  # where: distance from its middle, along it [units]
    poses: list  # of the arm's tool when it takes it: above, at it, and above again, 4x4
    taken: list  # paths through them
    load: Load


def holds(arms, tool, whole, others, failures, sensor):
    """Yields the Holds with which arms can take a tool. whole: points on it, Nx3 [units]; others: Blocks around it"""
    for arm, across in product(arms, grasp_yaws(tool, others)):
        grasp = Grasp(tool.position, arm.index, across)
        if has_failed(grasp, failures):
            continue
        for grip, lift in product(C.grips, C.lifts):
            start = tool_pose(arm, tool, across, grip, tool.position)
            load = load_of(whole, start)
            above = at_height(start, start[2, 3] + lift)
            poses = [above, start, above]
            for posture in postures(arm, poses):
                taken = plan_to_take(arm, poses, posture, sensor.arms[arm.index].joints, load.box())
                if taken:
                    yield Hold(arm, grasp, grip, poses, taken, load)


def postures(arm, poses):
    """Yields the joint angles [rad] at the first of a sequence of tool poses, 4x4 [units], that are found from the starts of an arm. From several
    starts, often almost the same posture is found: what an arm cannot do in one, it cannot do in the next one either."""
    found = []
    for start in arm.starts:
        for posture in solve_poses(arm, poses, start)[:1]:
            if all(abs(posture - it).max() > C.same_posture_rad for it in found):
                found.append(posture)
                yield posture


def tool_pose(arm, tool, across, grip, position, turn=0):
    """Returns the pose of an arm's tool, 4x4, when it holds a tool (see Hold), which was turned [rad], at a position."""
    along = np.append(rotated([grip, 0], tool.yaw + turn), tool.size[2] / 2 - grip_depth(arm, tool.size[2]))
    return arm.tool_pose(position + along, across + turn, tool.size[1])
