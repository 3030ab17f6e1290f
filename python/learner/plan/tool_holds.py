"""How arms can hold a tool."""

from itertools import product
from typing import NamedTuple

import numpy as np

from act.actions import Grasp
from act.arms import Arm
from act.finger_room import grasp_yaws
from act.grippers import grip_depth
from act.segments import at_height
from check.failures import has_failed
from constants import USES as C
from plan.loads import Load, load_of, whole_of
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


def holds(arms, tool, looks, others, failures, sensor):
    """Yields the Holds with which arms can take a tool. looks: visible points of it; others: Blocks around it"""
    whole = whole_of(looks, tool.position[2])
    for arm, across in product(arms, grasp_yaws(tool, others)):
        grasp = Grasp(tool.position, arm.index, across)
        if has_failed(grasp, failures):
            continue
        for grip, lift in product(C.grips, C.lifts):
            start = tool_pose(arm, tool, across, grip, tool.position)
            load = load_of(whole, start)
            above = at_height(start, start[2, 3] + lift)
            poses = [above, start, above]
            postures = []
            for first in arm.starts:
                taken = plan_to_take(arm, poses, first, sensor.arms[arm.index].joints, load.box())
                if not taken:
                    continue
                # From several starts, often almost the same posture is found: what it cannot do, the next one cannot either.
                posture = taken[-1].positions[-1]
                if all(abs(posture - it).max() > C.same_posture_rad for it in postures):
                    postures.append(posture)
                    yield Hold(arm, grasp, grip, poses, taken, load)


def tool_pose(arm, tool, across, grip, position, turn=0):
    """Returns the pose of an arm's tool, 4x4, when it holds a tool (see Hold), which was turned [rad], at a position."""
    along = np.append(rotated([grip, 0], tool.yaw + turn), tool.size[2] / 2 - grip_depth(arm, tool.size[2]))
    return arm.tool_pose(position + along, across + turn, tool.size[1])
