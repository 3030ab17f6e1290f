"""Plans uses of tools: take one, bring it to where it works, close the gripper again, and put it back."""

from dataclasses import replace
from itertools import product

import numpy as np

from actions import Action, Grasp
from alignment import Alignment, agreement
from areas import rotated
from arm_paths import plan_parts
from carrying import belongs_to, load_of, surroundings_of
from constants import MOTION_PLANNING, USES as C
from failures import has_failed
from finger_room import grasp_yaws
from grippers import can_hold, nearest_first
from heights import grip_depth
from kinds import is_same_kind
from pressing import is_changed
from segments import at_height


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


def plan_use(use, alignment, surface, state, arms, sensor):
    """Plans a Use. Returns actions, the Grasp of the tool, and None; or [], None and the reason."""
    found = find_tool(use, state.known, surface, state.shown)
    if not found:
        return [], None, f"{use.tool.name} is not visible"
    block, tool = found
    # Should it fail, the tool is no longer where it was.
    state.known.remove(block)
    others = list(state.known)
    state.known.append(block)
    begin, end = (np.append(rotated(it[:2] - alignment.place, -alignment.angle), it[2])
                  for it in (use.begin, use.pose[:3]))
    turn = use.pose[3] - alignment.angle - tool.yaw
    is_tool = belongs_to(tool, surface.points)
    looks, around = surface.points[is_tool], surface.points[~is_tool]
    # On the straight way to its work, the tool passes as in the demonstration, and may touch what it changes.
    fixed = around[~is_changed(use, alignment, around, state.shown)]
    avoided = surroundings_of(around), surroundings_of(fixed)
    for arm in nearest_first([it for it in arms if can_hold(it, tool.size[1])], tool.position[0]):
        for across in grasp_yaws(tool, others):
            attempt = Grasp(tool.position, arm.index, across)
            if has_failed(attempt, state.failures):
                continue
            actions = plan_arm_use(arm, tool, looks, across, (begin, end), turn, avoided,
                                   sensor.arms[arm.index].joints)
            if actions:
                return actions, attempt, None
    return [], None, "no arm brings it there and back"


def plan_arm_use(arm, tool, looks, across, way, turn, avoided, q):
    """Plans a use with one arm and a yaw of the gripper; [] if that arm cannot.

    looks:   visible points of the tool
    way:     the places where its straight way to its work begins and ends
    turn:    of the tool until then [rad]
    avoided: Surroundings on the way there and back, and on that straight way
    """
    width = tool.size[1]
    opening = min(width + MOTION_PLANNING.opening_margin, arm.opening)
    for grip, lift, is_line in product(C.grips, C.lifts, (True, False)):
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
            return (all(there.avoids(arm, it) for it in (path[0], path[9]))
                    and all(there.avoids(arm, it, load) for it in (path[3], path[6]))
                    and all(at_work.avoids(arm, it) for it in path[4:6]))

        path = plan_parts(arm, [[over, start, over], work, [over, put, over]], is_line, q, is_clear)
        if path:
            moves = [Action("follow", arm, it) for it in path]
            hold = [Action("grasp", arm, width=width) for _ in range(2)]
            return [Action("open", arm, to=opening), *moves[:2], hold[0], *moves[2:5], hold[1], *moves[5:8],
                    Action("open", arm, to=opening), *moves[8:], Action("observe")]
    return []
