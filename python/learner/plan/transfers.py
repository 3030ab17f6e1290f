"""Plans how one arm brings a block from one place to another, held in a given way."""

from dataclasses import replace

import numpy as np

from act.actions import Action, Grasp
from act.grippers import grip_depth
from act.reach import solve_poses
from act.segments import at_height
from constants import MOTION_PLANNING as C
from plan.arm_paths import plan_path_through


def plan_arm_pick_and_place(arm, block, grasp_yaw, goal, place_yaw, height, lift, away, others, q):
    """Plans to bring a block to a goal with one arm and given yaws of the gripper. Returns actions, or [] if that arm
    cannot; and whether it finds no joint angles at the block with that yaw, lift and height, or else none at the goal with
    that yaw and height.

    grasp_yaw, place_yaw: directions from finger to finger [rad]
    height:               of the tool between both places [units]
    lift:                 of the tool over the block; below `height`, the way leads over the middle
                          between both places [units]
    away:                 how far beside its place it is lowered first, x y [units]; None if it is dragged there, not
                          lifted
    others:               obstacles, as Blocks
    q:                    its joint angles [rad]
    """
    width = block.size[1]
    opening = min(width + C.opening_margin, arm.opening)
    depth = min(grip_depth(arm, block.size[2]), block.depth - arm.reach, goal.depth - arm.reach)
    # Of the tool, from the block's center.
    offset = np.array([0, 0, block.size[2] / 2 - depth])
    start = arm.tool_pose(block.position + offset, grasp_yaw, width)
    over_start = at_height(start, lift)
    end = arm.tool_pose(goal.position + offset + [0, 0, C.place_height_margin], place_yaw, width)
    over_end = at_height(end, height)
    via = []
    if lift < height:
        via = [at_height(start, height)]
        via[0][:2, 3] = (start[:2, 3] + end[:2, 3]) / 2
    transfer = [end]
    if away is not None:
        beside = [shifted(end, away)] if any(away) else []
        transfer = [over_start, *via, shifted(over_end, away), *beside, end]
    to_block = [*via, over_start, start]
    # Without a way to the block, none is looked for that goes on to the goal.
    if is_beyond(arm, to_block):
        return [], True, False
    taken = [] if away is None else [block]
    path = plan_path_through(arm, [*to_block, *transfer, over_end], others, q, [goal], taken)
    if not path:
        # From another posture, it may avoid the torso at the goal.
        return [], False, is_beyond(replace(arm, has_torso=False), [over_end, end])
    moves = [Action("follow", arm, it) for it in path]
    if away is not None:
        moves[len(to_block)].kind = "lift"
    actions = [Action("open", arm, to=opening), *moves[:len(to_block)],
               Action("grasp", arm, width=width, grasp=Grasp(block.position, arm.index, grasp_yaw)),
               *moves[len(to_block):-2],
               Action("open", arm, to=opening), *moves[-2:], Action("observe")]
    return actions, False, False


def is_beyond(arm, poses):
    """Returns true if joint angles for a sequence of tool poses are found from none of an arm's starts."""
    return not any(solve_poses(arm, poses, q) for q in arm.starts)


def shifted(pose, displacement):
    """Returns a pose displaced by x, y [units]."""
    pose = pose.copy()
    pose[:2, 3] += displacement
    return pose
