"""Plans how an arm carries a block from one place to another."""

import math

import numpy as np

from acting import ARMS, Action
from blocks import is_drawn
from constants import CARRY
from places import finger_turns, footprint, overlap

# The angles of an arm that is turned outwards, beside the table and higher than what is built: out
# of the eye's sight and of the other arm's way. The fingers point straight down. Row 0 is the left
# arm; the right one is the left one in a mirror.
PARKED = np.array(CARRY.parked_left_rad) * [[1] * 7, CARRY.parked_mirror]


def plan_carry(robot, block, goal, others, q):
    """The actions that bring a block to a goal (a Block or Step) and end with a look.

    others: blocks that are not to be touched
    q:      2x7, where the arms are [rad]
    Returns actions and None, or [] and the reason if no arm can.
    """
    takes = finger_turns(block, others)
    puts = finger_turns(goal, others)
    if not takes or not puts:
        return [], "there is no room for the fingers"
    if is_drawn(goal):
        height = block.top + CARRY.drawing_height
    else:
        height = carrying_height([*others, block], goal)
    arms = [1, 0] if block.position[0] + goal.position[0] > 0 else [0, 1]
    for arm in arms:
        for put in puts:
            for take in takes:
                actions = carry_with(robot, arm, block, take, goal, put, height, others, q)
                if actions:
                    return actions, None
    return [], "no arm reaches both where it is and where it shall be"


def carrying_height(blocks, goal):
    """Of the tool [units]: a held block passes over everything, and empty fingers do, also over the
    block once it is placed."""
    highest = max(block.top for block in blocks)
    bottom = goal.position[2] - goal.size[2] / 2
    return max(max(highest, bottom) + goal.size[2],
               max(highest, bottom + goal.size[2]) + CARRY.tip_below_tool) + CARRY.clearance


def carry_with(robot, arm, block, take, goal, put, height, others, q):
    """The actions that carry a block with one arm, the fingers turned as told at either place
    [rad]; [] if that arm cannot.

    height: of the tool on the way [units]
    """
    opening = block.size[1] + CARRY.opening_margin
    # Where the tool holds it, from its centre.
    grip = np.array([0, 0, block.size[2] / 2 - CARRY.grip_below_top])
    start = tool_pose(block.position + grip, take)
    over_start = at_height(start, height)
    end = tool_pose(goal.position + grip + [0, 0, CARRY.put_above], put)
    over_end = at_height(end, height)
    # What is drawn is not lifted.
    way = [end] if is_drawn(goal) else [over_start, over_end, end]
    path = path_through(robot, arm, [over_start, start, *way, over_end], others, q)
    if not path:
        return []
    to_above, down, *with_block, up, to_park = [Action("follow", arm, it) for it in path]
    return [Action("grip", arm, to=opening), to_above, down,
            Action("take", arm, width=block.size[1]), *with_block,
            Action("grip", arm, to=opening), up, to_park, Action("look")]


def path_through(robot, arm, poses, others, q):
    """The paths of an arm to the first of some poses of its tool, straight on from each to the
    next, and to where it parks: a list, [] if it cannot.

    others: blocks that its forearm keeps off where the tool is lower than on the way
    q:      2x7, where the arms are [rad]
    """
    height = max(pose[2, 3] for pose in poses)
    for first in (PARKED[arm], robot.pose(ARMS[arm], "untucked"), robot.pose(ARMS[arm], "neutral")):
        above = reach(robot, arm, poses, first)
        if above is None:
            continue
        path = [move_joints(robot, arm, [q[arm], above])]
        for pose in poses[1:]:
            path.append(move_line(robot, arm, path[-1], pose))
            if not path[-1]:
                break
        if not path[-1]:
            continue
        low = [move for move, pose in zip(path, poses) if pose[2, 3] < height]
        if not all(arm_clears(robot, arm, move.positions[-1], others) for move in low):
            continue
        path.append(move_joints(robot, arm, [path[-1].positions[-1], PARKED[arm]]))
        if all(is_safe(robot, move) for move in path):
            return path
    return []


def reach(robot, arm, poses, q):
    """The angles for the first of some poses, if all of them can be reached one from the other;
    else None."""
    found = []
    for pose in poses:
        q = robot.inverse(ARMS[arm], pose, q, max_iterations=CARRY.ik_iterations)
        if q is None or not keeps_off_chest(robot, ARMS[arm], q):
            return None
        found.append(q)
    return found[0]


def is_within_reach(robot, arm, place):
    """Whether an arm gets its tool to a block's place, and 2 units above it."""
    x, y, z = place.position

    def poses(across):
        return [tool_pose([x, y, z + height], across) for height in CARRY.reach_heights]

    return any(reach(robot, arm, poses(across), PARKED[arm]) is not None
               for across in finger_turns(place, []))


def arm_clears(robot, arm, q, blocks):
    """Whether the forearm of an arm that holds its tool straight down keeps off blocks. (What the
    hand itself needs, finger_turns knows.)"""
    radius = CARRY.forearm_radius
    wrist = robot.forward(ARMS[arm], q)[:3, 3] + [0, 0, CARRY.wrist_above_tool]
    along = -CARRY.forearm_length * robot.jacobian(ARMS[arm], q)[3:, 4]  # joint W0 turns about the forearm
    for share in np.arange(CARRY.forearm_steps + 1) / CARRY.forearm_steps:
        x, y, z = wrist + share * along
        below = footprint([block for block in blocks if block.top > z - radius], radius)
        if overlap([x, y, 0, 0, 0], below).any():
            return False
    return True


def is_safe(robot, path):
    """Whether an arm can go along a path while the other one is parked."""
    return (keeps_off_chest(robot, path.arm, path.positions)
            and robot.first_invalid(path, q_both=PARKED) is None)


def keeps_off_chest(robot, arm, q):
    """Whether angles of an arm, Nx7 or 7, keep its upper arm off the chest, which it would touch
    with S0 turned farthest to the other side."""
    margin = CARRY.chest_margin_rad
    lower, upper = robot.limits(arm)
    turn = np.atleast_2d(q)[:, 0]
    return bool((turn > lower[0] + margin if arm == "left" else turn < upper[0] - margin).all())


def tool_pose(point, across):
    """The tool, fingers straight down, at a point (x y z [units]); across is the direction from
    finger to finger, seen from above [rad]. 4x4."""
    c, s = math.cos(across), math.sin(across)
    x, y, z = point
    return np.array([[-s, c, 0, x], [c, s, 0, y], [0, 0, -1, z], [0, 0, 0, 1]])


def at_height(pose, height):
    """A pose, moved straight up or down [units]."""
    pose = pose.copy()
    pose[2, 3] = height
    return pose


def move_joints(robot, arm, waypoints):
    return robot.move_joints(ARMS[arm], waypoints, speed=CARRY.speed)


def move_line(robot, arm, before, goal):
    """A straight way from the end of another path to a pose; None if there is none, or if it takes
    too long."""
    path, _ = robot.move_line(ARMS[arm], before.positions[-1], goal, speed=CARRY.speed)
    return path if path and path.duration <= CARRY.longest_line_s else None


def retreat(robot, arm, q):
    """The actions of an arm that was stopped: it lets go, goes up as far as possible, parks and
    looks again. q: 2x7, where the arms are [rad]."""
    actions = [Action("grip", arm, to=CARRY.retreat_opening)]
    here = robot.forward(ARMS[arm], q[arm])
    q = q[arm]
    for height in np.arange(CARRY.retreat_height, here[2, 3] + CARRY.retreat_step, -CARRY.retreat_step):
        path, _ = robot.move_line(ARMS[arm], q, at_height(here, height),
                                  speed=CARRY.retreat_speed)
        if path:
            actions.append(Action("follow", arm, path))
            q = path.positions[-1]
            break
    to_park = move_joints(robot, arm, [q, PARKED[arm]])
    return [*actions, Action("follow", arm, to_park), Action("look")]
