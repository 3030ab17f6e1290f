"""Turns blocks onto other faces: by 90 degrees about the axis on which the fingers hold them.

The tool comes down over an edge of the block, half way between the face that is its top and the one that
will be: so the hand is above the table before and after the turn.
"""

import math
from dataclasses import replace

import numpy as np

from actions import Action, Grasp
from areas import footprint, overlap
from arm_clearance import is_arm_clear
from constants import ARMS, MOTION_PLANNING as C, TASK_PLANNING
from failures import has_failed
from grippers import can_hold, nearest_first
from reach import avoids_torso, can_reach
from resting import turned
from segments import at_height, move_joints, move_line
from temporary_places import free_placements


def plan_turn(arms, eye, block, held, then, others, sites, sensor, failures, unexplained):
    """Plans the actions that turn a block and put it at a free place on the table.

    held: the side by which it is held, as for resting.turned
    then: by which one it must be held for the next turn there; None for none
    others, sites, failures, unexplained: as for plan_temporary_placement
    Returns actions, the block at that place, and None; or [], None and a reason.
    """
    able = [arm for arm in arms if can_hold(arm, block.size[held])]
    if not able:
        return [], None, "it is wider than the gripper opens"
    reason = "no arm can hold it so that it can be turned"
    # Close to the limits of its joints, the hand of an arm may be folded to it: only if necessary.
    grasps = [grasp for margin in (C.tilted_limit_rad, 0)
              for arm in nearest_first(able, block.position[0])
              for grasp in tilted_grasps(arm, block, held, others, margin)
              if not has_failed(grasp.attempt, failures)]
    like = replace(block, size=turned(block.size, held))
    for site in sites if grasps else []:
        reason = "there is no free place on the table where an arm can turn it"
        num_tried = 0
        for place in free_placements(arms, eye, like, others + site, None, unexplained):
            if not (can_reach(arms, place) if then is None else can_turn(arms, place, then, others)):
                continue
            num_tried += 1
            if num_tried > TASK_PLANNING.max_place_attempts:
                break
            for grasp in grasps:
                actions = plan_turn_to(grasp, block, held, place, others, sensor)
                if actions:
                    return actions, place, None
    return [], None, reason


def can_turn(arms, block, held, others):
    """Returns true if an arm can turn a block where it is."""
    like = replace(block, size=turned(block.size, held))
    like.position = np.append(block.position[:2], block.bottom + like.size[2] / 2)
    height = turn_height(block, others)
    grasps = [grasp for arm in arms if can_hold(arm, block.size[held])
              for grasp in tilted_grasps(arm, block, held, others, C.tilted_limit_rad)]
    return any(solve(grasp.arm, end, grasp.q[0], grasp.margin)
               for yaw in np.arange(4) * math.pi / 4 for grasp in grasps
               for end in grasp.ends(replace(like, yaw=yaw), height))


class TiltedGrasp:
    """A way to hold a block for a turn: an arm, the pose of its tool in the frame of the block, 4x4, and
    joint angles over and at the block. The axes of that frame are u, which will be vertical, the axis on
    which the fingers hold it, and z; its origin is the middle of the block."""

    def __init__(self, arm, block, held, sign, across, height, margin):
        # The edge over which the tool comes: toward which end along u, and its place from the middle.
        sides = np.array([block.size[1 - held], block.size[held], block.size[2]])
        middle = arm.robot.gripper_middle(arm.name, sides[1])
        axis = -np.array([sign, 0, 1]) / math.sqrt(2)
        y = np.array([0, across, 0])
        low = lowest_tilted_tool(arm)
        out, _, up = np.maximum(sides / 2 - C.tilted_grip, low - sides / 2)
        self.arm, self.sides, self.sign, self.margin = arm, sides, sign, margin
        self.q = []  # joint angles over and at the block, once they are found
        self.in_block = np.eye(4)
        self.in_block[:3, :3] = np.column_stack([np.cross(y, axis), y, axis])
        self.in_block[:3, 3] = [sign * out, -across * middle, up]
        u = block.yaw + (0 if held == 1 else math.pi / 2)
        self.attempt = Grasp(block.position, arm.index, u + across * math.pi / 2)
        self.start = pose_at(block.position, u) @ self.in_block
        self.over_start = at_height(self.start, height_over(arm, block, height))

    def ends(self, place, height):
        """Returns the poses of the tool over and at a place of the turned block, for each of its yaws
        that look alike."""
        # Which of its sides is now along u: the axis of the fingers, or the former height.
        along = place.yaw + (0 if self.sides[1] >= self.sides[2] else math.pi / 2)
        for yaw in (along, along + math.pi):
            u, y = np.array([0, 0, self.sign]), np.array([math.cos(yaw), math.sin(yaw), 0])
            pose = np.eye(4)
            pose[:3, :3] = np.column_stack([u, y, np.cross(u, y)])
            pose[:3, 3] = place.position + [0, 0, C.place_height_margin]
            end = pose @ self.in_block
            yield at_height(end, height_over(self.arm, place, height)), end

    def corners(self, q):
        """Returns the corners of the held block at joint angles, 8x3."""
        signs = np.array([[a, b, c] for a in (1, -1) for b in (1, -1) for c in (1, -1)])
        pose = self.arm.forward(q) @ np.linalg.inv(self.in_block)
        return signs * self.sides / 2 @ pose[:3, :3].T + pose[:3, 3]


def lowest_tilted_tool(arm):
    """Returns how high the tool of an arm must be for its tilted fingers to stay above the table."""
    return (arm.reach + C.tilted_finger) / math.sqrt(2) + C.fingers_above_bottom


def height_over(arm, place, height):
    """Returns the height of the tool at which its tilted fingers pass over a block at a place; at least
    some height."""
    return max(height, place.top + lowest_tilted_tool(arm) + C.clearance)


def turn_height(block, others):
    """Returns the height of the tool at which a block turns above all others."""
    return (max((it.top for it in others), default=0) + np.linalg.norm(block.size[[0, 2]])
            + C.clearance)


def pose_at(position, yaw):
    """Returns the pose of an upright object, 4x4."""
    c, s = math.cos(yaw), math.sin(yaw)
    return np.array([[c, -s, 0, position[0]], [s, c, 0, position[1]], [0, 0, 1, position[2]],
                     [0, 0, 0, 1]])


def tilted_grasps(arm, block, held, others, margin):
    """Returns the TiltedGrasps of a block that an arm reaches, with a margin from the limits of its joints
    [rad]: a list."""
    height = turn_height(block, others)
    found = []
    for sign in (1, -1):
        for across in (1, -1):
            grasp = TiltedGrasp(arm, block, held, sign, across, height, margin)
            for first in arm.starts:
                grasp.q = solve(arm, [grasp.over_start, grasp.start], first, margin)
                if grasp.q and is_hand_clear(arm, grasp.q, others, block):
                    found.append(grasp)
                    break
    return found


def solve(arm, poses, q, margin):
    """Returns the joint angles of a sequence of tool poses, each searched from the one before, with a margin
    from their limits [rad]: a list; [] if one has none."""
    lower, upper = arm.robot.limits(arm.name)
    found = []
    for pose in poses:
        q = arm.inverse(pose, q, max_iterations=C.ik_iterations)
        if (q is None or not avoids_torso(arm, q)
                or np.minimum(q - lower, upper - q).min() < margin):
            return []
        found.append(q)
    return found


def is_hand_clear(arm, found, others, held):
    """Returns true if an arm, over and at a place where it takes or leaves a held block, touches neither the
    robot nor the table; its hand avoids the others there, and its forearm also the block.

    found: its joint angles over and at the place
    """
    if not arm.is_valid_at(found[1]):
        return False
    if not all(is_arm_clear(arm, q, [*others, held]) for q in found):
        return False
    tool = arm.forward(found[1])
    return all(is_point_clear(tool[:3, 3] + along * tool[:3, 2], others, C.arm_radius)
               for along in (arm.reach, 0, -arm.reach, -2 * arm.reach))


def is_point_clear(point, blocks, margin):
    """Returns true if a point is above or beside blocks, with a margin [units]."""
    x, y, z = point
    near = footprint([it for it in blocks if it.top > z - margin], C.arm_radius)
    return not overlap([x, y, 0, 0, 0], near).any()


def are_fingers_clear(arm, path, blocks):
    """Returns true if the fingers and the hand of an arm pass over blocks, or beside them, on a path."""
    for q in samples(path):
        tool = arm.forward(q)
        for along in (arm.reach, 0, -arm.reach):
            if not is_point_clear(tool[:3, 3] + along * tool[:3, 2], blocks, C.clearance):
                return False
    return True


def samples(path):
    """Returns some of the joint angles along a path."""
    return path.positions[::max(len(path.positions) // C.samples_per_path, 1)]


def plan_turn_to(grasp, block, held, place, others, sensor):
    """Plans the actions that turn a block with a grasp and put it at a place; [] if there are none."""
    arm = grasp.arm
    width = block.size[held]
    opening = min(width + C.opening_margin, arm.opening)
    highest = max((it.top for it in others), default=0)
    for over_end, end in grasp.ends(place, turn_height(block, others)):
        found = solve(arm, [over_end, end], grasp.q[0], grasp.margin)
        if not found or not is_hand_clear(arm, found, others, place):
            continue
        to_start = move_joints(arm, [sensor.arms[arm.index].joints, grasp.q[0]])
        down = move_line(arm, to_start, grasp.start)
        up = down and move_line(arm, down, grasp.over_start)
        turn = up and move_joints(arm, [up.positions[-1], found[0]])
        lower = turn and move_line(arm, turn, end)
        leave = lower and move_line(arm, lower, over_end)
        if not leave:
            continue
        path = [to_start, down, up, turn, lower, leave,
                move_joints(arm, [leave.positions[-1], arm.parked])]
        is_high = all(grasp.corners(q)[:, 2].min() > highest for q in samples(turn))
        is_clear = (are_fingers_clear(arm, to_start, [*others, block])
                    and are_fingers_clear(arm, path[-1], [*others, place]))
        is_valid = all(arm.robot.first_invalid(it, q_both=arm.all_parked, table=ARMS.table) is None
                       for it in path)
        if not (is_high and is_clear and is_valid):
            continue
        moves = [Action("follow", arm, it) for it in path]
        return [Action("open", arm, to=opening), *moves[:2],
                Action("grasp", arm, width=width, grasp=grasp.attempt), *moves[2:5],
                Action("open", arm, to=opening), *moves[5:], Action("observe")]
    return []
