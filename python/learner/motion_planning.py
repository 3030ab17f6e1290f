"""Plans how an arm brings a block from one place to another."""

import math
from dataclasses import replace
from itertools import product

import numpy as np

from actions import Action, Grasp
from areas import footprint, overlap
from blocks import yaw_difference
from constants import MOTION_PLANNING as C
from failures import has_failed
from finger_room import grasp_yaws
from grippers import can_hold, nearest_first
from held_parts import held_part
from steps import is_dragged


def plan_pick_and_place(arms, block, goal, others, sensor, failures=()):
    """Plans the actions that bring a block to a goal (a Block or Step) and end with an observation.

    arms:     the Arms that may do it
    others:   obstacles, as Blocks
    failures: Grasps that failed and are not to be repeated
    Returns actions and None, or [] and the reason if no arm can do it.
    """
    goal = replace(goal, knob=block.knob)
    held, target = held_part(block), held_part(goal)
    at_start = grasp_yaws(block, others)
    at_goal = grasp_yaws(goal, others)
    if not at_start or not at_goal:
        return [], "there is no room for the fingers"
    able = [arm for arm in arms if can_hold(arm, held.size[1])]
    if not able:
        return [], "it is wider than the gripper opens"
    can_be_low = not is_dragged(goal) and not block.knob and has_low_way(block, goal, others)
    for is_low, arm in product([False, True] if can_be_low else [False],
                               nearest_first(able, block.position[0] + goal.position[0])):
        if is_dragged(goal):
            height = block.top + C.drag_tool_height
        else:
            height = transfer_height(arm, [*others, held], goal.bottom, target.top - goal.bottom)
        # What cannot be lifted high enough to pass over all others is lifted less on a low way.
        lift = block.position[2] + block.size[2] + C.clearance if is_low else height
        q = sensor.arms[arm.index].joints
        yaws = [yaw for yaw in at_start
                if not has_failed(Grasp(held.position, arm.index, yaw), failures)]
        for place_yaw, grasp_yaw in product(at_goal, yaws):
            # The object turns with the hand; it may look the same after some turns.
            turned = replace(block, yaw=block.yaw + place_yaw - grasp_yaw)
            if (block.knob or block.parts) and abs(yaw_difference(turned, goal.yaw)) > C.same_yaw_rad:
                continue
            actions = plan_arm_pick_and_place(arm, held, grasp_yaw, target, place_yaw, height, lift,
                                              others, q, is_dragged(goal))
            if actions:
                return actions, None
    return [], "no arm reaches both its place and its goal"


def transfer_height(arm, blocks, bottom, extent):
    """Returns the height of an arm's tool between two places [units]: the held block passes over
    all others, and so do the empty fingers, also over the placed block.

    bottom: height of the goal's bottom [units]
    extent: height of the held block [units]
    """
    highest = max(block.top for block in blocks)
    return max(max(highest, bottom) + extent,
               max(highest, bottom + extent) + arm.reach) + C.clearance


def has_low_way(block, goal, others):
    """Returns true if there is no obstacle higher than a block around the first half of its way to
    a goal."""
    way = (goal.position[:2] - block.position[:2]) / 2
    x, y = block.position[:2] + way / 2
    length = np.hypot(*way) + C.low_way_width
    higher = footprint([it for it in others if it.top > block.top], 0)
    return not overlap([x, y, length, C.low_way_width, math.atan2(way[1], way[0])], higher).any()


def plan_arm_pick_and_place(arm, block, grasp_yaw, goal, place_yaw, height, lift, others, q,
                            is_goal_dragged):
    """Plans to bring a block to a goal with one arm and given yaws of the gripper; [] if that arm
    cannot.

    grasp_yaw, place_yaw: directions from finger to finger [rad]
    height:               of the tool between both places [units]
    lift:                 of the tool over the block; below `height`, the way leads over the middle
                          between both places [units]
    others:               obstacles, as Blocks
    q:                    its joint angles [rad]
    is_goal_dragged:      whether it is dragged there, not lifted
    """
    width = block.size[1]
    opening = min(width + C.opening_margin, arm.opening)
    # Of the tool, from the block's center.
    offset = np.array([0, 0, block.size[2] / 2 - grip_depth(arm, block.size[2])])
    start = arm.tool_pose(block.position + offset, grasp_yaw, width)
    over_start = at_height(start, lift)
    end = arm.tool_pose(goal.position + offset + [0, 0, C.place_height_margin], place_yaw, width)
    over_end = at_height(end, height)
    via = []
    if lift < height:
        via = [at_height(start, height)]
        via[0][:2, 3] = (start[:2, 3] + end[:2, 3]) / 2
    # A dragged object is not lifted.
    transfer = [end] if is_goal_dragged else [over_start, *via, over_end, end]
    to_block = [*via, over_start, start]
    path = plan_path_through(arm, [*to_block, *transfer, over_end], others, q)
    if not path:
        return []
    moves = [Action("follow", arm, it) for it in path]
    return [Action("open", arm, to=opening), *moves[:len(to_block)],
            Action("grasp", arm, width=width, grasp=Grasp(block.position, arm.index, grasp_yaw)),
            *moves[len(to_block):-2],
            Action("open", arm, to=opening), *moves[-2:], Action("observe")]


def grip_depth(arm, height):
    """Returns how far the tool of an arm is below the top of a block of some height when it grasps
    it [units]; negative above the top. The fingers reach still lower, but not to what the block
    stands on."""
    return min(max(C.grip_below_top, C.fingers_below_top - arm.reach),
               height - C.fingers_above_bottom - arm.reach)


def plan_path_through(arm, poses, others, q):
    """Plans the paths of an arm to the first of some tool poses, along straight lines through the
    others, and to its parking pose: a list; [] if there is none.

    poses:  list of 4x4 [units]
    others: obstacles for the forearm, as Blocks, where the tool is lower than the highest pose
    q:      its joint angles [rad]
    """
    height = max(pose[2, 3] for pose in poses)
    for first in arm.starts:
        above = solve_pose_sequence(arm, poses, first)
        if above is None:
            continue
        path = [move_joints(arm, [q, above])]
        for pose in poses[1:]:
            path.append(move_line(arm, path[-1], pose))
            if not path[-1]:
                break
        if not path[-1]:
            continue
        low = [move for move, pose in zip(path, poses) if pose[2, 3] < height]
        if not all(is_arm_clear(arm, move.positions[-1], others) for move in low):
            continue
        path.append(move_joints(arm, [path[-1].positions[-1], arm.parked]))
        if all(is_path_valid(arm, move) for move in path):
            return path
    return []


def plan_parts(arm, parts, is_line, q, is_clear):
    """Plans the paths of an arm along straight lines through the tool poses of each part, from part to part on a
    straight line or any way, and to its parking pose: a list; [] if there is none.

    parts:    lists of 4x4 [units]
    q:        its joint angles [rad]
    is_clear: function of that list: whether nothing is in the way
    """
    for first in arm.starts:
        path = []
        for poses in parts:
            here = path[-1].positions[-1] if path else first
            if not path or not is_line:
                above = solve_pose_sequence(arm, poses, here)
                path.append(above is not None and move_joints(arm, [here if path else q, above]))
                poses = poses[1:]
            for pose in poses:
                path.append(path[-1] and move_line(arm, path[-1], pose))
            if not path[-1]:
                break
        if path[-1]:
            path.append(move_joints(arm, [path[-1].positions[-1], arm.parked]))
            if all(is_path_valid(arm, move) for move in path) and is_clear(path):
                return path
    return []


def solve_pose_sequence(arm, poses, q):
    """Solves inverse kinematics for a sequence of tool poses, each from the solution before, the
    first from q. Returns the first solution; None if some pose has none."""
    found = []
    for pose in poses:
        q = arm.inverse(pose, q, max_iterations=C.ik_iterations)
        if q is None or not avoids_torso(arm, q):
            return None
        found.append(q)
    return found[0]


def is_reachable(arm, place):
    """Returns true if an arm can bring its tool to a block's place, and 2 units above it."""
    held = held_part(place)
    x, y, z = held.position

    def poses(across):
        return [arm.tool_pose([x, y, z + height], across, held.size[1])
                for height in C.reach_heights]

    return any(solve_pose_sequence(arm, poses(across), arm.parked) is not None
               for across in grasp_yaws(place, []))


def is_arm_clear(arm, q, blocks):
    """Returns true if an arm that holds its tool straight down avoids blocks from its wrist on.
    (grasp_yaws checks the hand.)

    q: its joint angles [rad]
    """
    radius = C.arm_radius
    points = arm.points(q)
    from_tool = np.linalg.norm(points - points[0], axis=1)
    points = points[np.argmax(from_tool > C.min_wrist_distance):]
    fractions = np.linspace(0, 1, C.points_per_link)[:, None]
    for one, other in zip(points, points[1:]):
        for x, y, z in one + fractions * (other - one):
            below = footprint([block for block in blocks if block.top > z - radius], radius)
            if overlap([x, y, 0, 0, 0], below).any():
                return False
    return True


def is_path_valid(arm, path):
    """Returns true if an arm can follow a path while the others are parked."""
    return (avoids_torso(arm, path.positions)
            and arm.robot.first_invalid(path, q_both=arm.all_parked) is None)


def avoids_torso(arm, q):
    """Returns true if joint angles of an arm, Nxn or n [rad], keep its upper arm away from the
    torso between the arms, which it would touch with its first joint at the limit that is farther
    from its parked angle."""
    if not arm.has_torso:
        return True
    lower, upper = (limit[0] for limit in arm.robot.limits(arm.name))
    first = np.atleast_2d(q)[:, 0]
    if arm.parked[0] - lower > upper - arm.parked[0]:
        return bool((first > lower + C.torso_margin_rad).all())
    return bool((first < upper - C.torso_margin_rad).all())


def at_height(pose, height):
    """Returns a pose at another height [units]."""
    pose = pose.copy()
    pose[2, 3] = height
    return pose


def move_joints(arm, waypoints):
    """Plans a path through joint waypoints, Nxn [rad]."""
    return arm.robot.move_joints(arm.name, waypoints, speed=C.speed)


def move_line(arm, before, goal):
    """Plans a straight line from the end of another path to a pose, 4x4; None if there is none, or
    if it passes a stretched arm, where it would take too long."""
    path, _ = arm.robot.move_line(arm.name, before.positions[-1], goal, speed=C.speed)
    return path if path and path.duration <= C.max_line_s else None


def retreat(arm, q, can_rise):
    """Returns the actions of an arm that was stopped: opens the gripper, rises as far as possible,
    parks, and observes.

    q:        its joint angles [rad]
    can_rise: false if it was stopped while rising: then it parks directly
    """
    actions = [Action("open", arm, to=min(C.retreat_opening, arm.opening))]
    here = arm.forward(q)
    heights = np.arange(C.retreat_height, here[2, 3] + C.retreat_step, -C.retreat_step)
    for height in heights if can_rise else []:
        path, _ = arm.robot.move_line(arm.name, q, at_height(here, height), speed=C.retreat_speed)
        if path:
            actions.append(Action("follow", arm, path))
            q = path.positions[-1]
            break
    to_park = move_joints(arm, [q, arm.parked])
    return [*actions, Action("follow", arm, to_park), Action("observe")]
