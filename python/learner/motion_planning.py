"""Plans how an arm brings a block from one place to another."""

import math

import numpy as np

from clearance import footprint, grasp_yaws, overlap
from constants import MOTION_PLANNING as C
from execution import ARMS, Action
from task_model import is_dragged

# Joint angles of parked arms, 2x7 [rad]: turned outward, beside the table and above the building,
# outside the eye's view and each other's way. The fingers point straight down. Row 0 is the left
# arm; the right arm mirrors the left.
PARKED = np.array(C.parked_left_rad) * [[1] * 7, C.parked_mirror]


def plan_pick_and_place(robot, block, goal, others, q):
    """Plans the actions that bring a block to a goal (a Block or Step) and end with an observation.

    others: obstacles, as Blocks
    q:      2x7, joint angles of the arms [rad]
    Returns actions and None, or [] and the reason if no arm can do it.
    """
    at_start = grasp_yaws(block, others)
    at_goal = grasp_yaws(goal, others)
    if not at_start or not at_goal:
        return [], "there is no room for the fingers"
    if is_dragged(goal):
        height = block.top + C.drag_tool_height
    else:
        height = transfer_height([*others, block], goal)
    arms = [1, 0] if block.position[0] + goal.position[0] > 0 else [0, 1]
    for arm in arms:
        for place_yaw in at_goal:
            for grasp_yaw in at_start:
                actions = plan_arm_pick_and_place(robot, arm, block, grasp_yaw, goal, place_yaw,
                                                  height, others, q)
                if actions:
                    return actions, None
    return [], "no arm reaches both its place and its goal"


def transfer_height(blocks, goal):
    """Returns the height of the tool between two places [units]: the held block passes over all
    others, and so do the empty fingers, also over the placed block."""
    highest = max(block.top for block in blocks)
    bottom = goal.position[2] - goal.size[2] / 2
    return max(max(highest, bottom) + goal.size[2],
               max(highest, bottom + goal.size[2]) + C.tip_below_tool) + C.clearance


def plan_arm_pick_and_place(robot, arm, block, grasp_yaw, goal, place_yaw, height, others, q):
    """Plans to bring a block to a goal with one arm and given yaws of the gripper; [] if that arm
    cannot.

    grasp_yaw, place_yaw: directions from finger to finger [rad]
    height:               of the tool between both places [units]
    others:               obstacles, as Blocks
    q:                    2x7, joint angles of the arms [rad]
    """
    opening = block.size[1] + C.opening_margin
    # Of the tool, from the block's center.
    offset = np.array([0, 0, block.size[2] / 2 - C.grip_below_top])
    start = tool_pose(block.position + offset, grasp_yaw)
    over_start = at_height(start, height)
    end = tool_pose(goal.position + offset + [0, 0, C.place_height_margin], place_yaw)
    over_end = at_height(end, height)
    # A dragged object is not lifted.
    transfer = [end] if is_dragged(goal) else [over_start, over_end, end]
    path = plan_path_through(robot, arm, [over_start, start, *transfer, over_end], others, q)
    if not path:
        return []
    to_above, down, *with_block, up, to_park = [Action("follow", arm, it) for it in path]
    return [Action("open", arm, to=opening), to_above, down,
            Action("grasp", arm, width=block.size[1]), *with_block,
            Action("open", arm, to=opening), up, to_park, Action("observe")]


def plan_path_through(robot, arm, poses, others, q):
    """Plans the paths of an arm to the first of some tool poses, along straight lines through the
    others, and to its parking pose: a list; [] if there is none.

    poses:  list of 4x4 [units]
    others: obstacles for the forearm, as Blocks, where the tool is lower than the highest pose
    q:      2x7, joint angles of the arms [rad]
    """
    height = max(pose[2, 3] for pose in poses)
    for first in (PARKED[arm], robot.pose(ARMS[arm], "untucked"), robot.pose(ARMS[arm], "neutral")):
        above = solve_pose_sequence(robot, arm, poses, first)
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
        if not all(is_forearm_clear(robot, arm, move.positions[-1], others) for move in low):
            continue
        path.append(move_joints(robot, arm, [path[-1].positions[-1], PARKED[arm]]))
        if all(is_path_valid(robot, move) for move in path):
            return path
    return []


def solve_pose_sequence(robot, arm, poses, q):
    """Solves inverse kinematics for a sequence of tool poses, each from the solution before, the
    first from q. Returns the first solution, 7 numbers [rad]; None if some pose has none."""
    found = []
    for pose in poses:
        q = robot.inverse(ARMS[arm], pose, q, max_iterations=C.ik_iterations)
        if q is None or not avoids_torso(robot, ARMS[arm], q):
            return None
        found.append(q)
    return found[0]


def is_reachable(robot, arm, place):
    """Returns true if an arm can bring its tool to a block's place, and 2 units above it."""
    x, y, z = place.position

    def poses(across):
        return [tool_pose([x, y, z + height], across) for height in C.reach_heights]

    return any(solve_pose_sequence(robot, arm, poses(across), PARKED[arm]) is not None
               for across in grasp_yaws(place, []))


def is_forearm_clear(robot, arm, q, blocks):
    """Returns true if the forearm of an arm that holds its tool straight down avoids blocks.
    (grasp_yaws checks the gripper.)

    q: joint angles of the arm, 7 numbers [rad]
    """
    radius = C.forearm_radius
    wrist = robot.forward(ARMS[arm], q)[:3, 3] + [0, 0, C.wrist_above_tool]
    # Joint W0 turns about the forearm.
    along = -C.forearm_length * robot.jacobian(ARMS[arm], q)[3:, 4]
    for fraction in np.arange(C.forearm_steps + 1) / C.forearm_steps:
        x, y, z = wrist + fraction * along
        below = footprint([block for block in blocks if block.top > z - radius], radius)
        if overlap([x, y, 0, 0, 0], below).any():
            return False
    return True


def is_path_valid(robot, path):
    """Returns true if an arm can follow a path while the other arm is parked."""
    return (avoids_torso(robot, path.arm, path.positions)
            and robot.first_invalid(path, q_both=PARKED) is None)


def avoids_torso(robot, arm, q):
    """Returns true if joint angles of an arm, Nx7 or 7 [rad], keep its upper arm away from the
    torso, which it would touch with S0 at the limit toward the other side."""
    margin = C.torso_margin_rad
    lower, upper = robot.limits(arm)
    s0 = np.atleast_2d(q)[:, 0]
    return bool((s0 > lower[0] + margin if arm == "left" else s0 < upper[0] - margin).all())


def tool_pose(point, across):
    """Returns the pose of the tool, 4x4, with the fingers straight down at a point (x y z [units]).

    across: direction from finger to finger, seen from above [rad]
    """
    c, s = math.cos(across), math.sin(across)
    x, y, z = point
    return np.array([[-s, c, 0, x], [c, s, 0, y], [0, 0, -1, z], [0, 0, 0, 1]])


def at_height(pose, height):
    """Returns a pose at another height [units]."""
    pose = pose.copy()
    pose[2, 3] = height
    return pose


def move_joints(robot, arm, waypoints):
    """Plans a path through joint waypoints, Nx7 [rad]."""
    return robot.move_joints(ARMS[arm], waypoints, speed=C.speed)


def move_line(robot, arm, before, goal):
    """Plans a straight line from the end of another path to a pose, 4x4; None if there is none, or
    if it passes a stretched arm, where it would take too long."""
    path, _ = robot.move_line(ARMS[arm], before.positions[-1], goal, speed=C.speed)
    return path if path and path.duration <= C.max_line_s else None


def retreat(robot, arm, q):
    """Returns the actions of an arm that was stopped: opens the gripper, rises as far as possible,
    parks, and observes.

    q: 2x7, joint angles of the arms [rad]
    """
    actions = [Action("open", arm, to=C.retreat_opening)]
    here = robot.forward(ARMS[arm], q[arm])
    q = q[arm]
    for height in np.arange(C.retreat_height, here[2, 3] + C.retreat_step, -C.retreat_step):
        path, _ = robot.move_line(ARMS[arm], q, at_height(here, height),
                                  speed=C.retreat_speed)
        if path:
            actions.append(Action("follow", arm, path))
            q = path.positions[-1]
            break
    to_park = move_joints(robot, arm, [q, PARKED[arm]])
    return [*actions, Action("follow", arm, to_park), Action("observe")]
