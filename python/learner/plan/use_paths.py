"""Paths on which an arm uses a tool."""

from itertools import product

import numpy as np

from act.actions import Action
from act.segments import at_height
from constants import MOTION_PLANNING, USES as C
from plan.heights import grip_depth
from plan.loads import load_of
from plan.ways import plan_there_and_back
from things.areas import rotated


def plan_arm_use(arm, tool, looks, across, way, turn, avoided, ways, q):
    """Plans a use with one arm and a yaw of the gripper; [] if that arm cannot.

    looks:   visible points of the tool
    way:     the places where its straight way to its work begins and ends
    turn:    of the tool until then [rad]
    avoided: Surroundings on the way there and back, and on that straight way
    ways:    Ways there and back, in the order in which they are tried
    """
    width = tool.size[1]
    opening = min(width + MOTION_PLANNING.opening_margin, arm.opening)
    for grip, lift in product(C.grips, C.lifts):
        # It is held at some distance from its middle, along it.
        along = np.append(rotated([grip, 0], tool.yaw), tool.size[2] / 2 - grip_depth(arm, tool.size[2]))
        there = np.append(rotated([grip, 0], tool.yaw + turn), along[2])
        start = arm.tool_pose(tool.position + along, across, width)
        put = at_height(start, start[2, 3] + MOTION_PLANNING.place_height_margin)
        over = at_height(start, start[2, 3] + lift)
        work = [arm.tool_pose(it + there, across + turn, width) for it in (*way, way[0])]
        load = load_of(looks, tool.position[2], start)

        def is_clear(path):
            there, at_work = avoided
            return (all(there.avoids(arm, it, load) for it in (path[3], path[6]))
                    and all(at_work.avoids(arm, it) for it in path[4:6])
                    and all(there.avoids(arm, it) for it in (path[0], path[9])))

        path = plan_there_and_back(arm, [over, start, over], work, [over, put, over], ways, q, load.box(), is_clear)
        if path:
            moves = [Action("follow", arm, it) for it in path]
            hold = [Action("grasp", arm, width=width) for _ in range(2)]
            return [Action("open", arm, to=opening), *moves[:2], hold[0], *moves[2:5], hold[1], *moves[5:8],
                    Action("open", arm, to=opening), *moves[8:], Action("observe")]
    return []
