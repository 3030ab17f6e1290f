"""Ways to hold a block for a turn, with a tilted tool."""

import math

import numpy as np

from act.actions import Grasp
from act.arm_clearance import is_hand_clear
from act.reach import solve_poses
from act.segments import at_height
from constants import MOTION_PLANNING as C
from plan.tilt import height_over, lowest_tilted_tool, pose_at, turn_height


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


def tilted_grasps(arm, block, held, others, margin):
    """Returns the TiltedGrasps of a block that an arm reaches, with a margin from the limits of its joints
    [rad]: a list."""
    height = turn_height(block, others)
    found = []
    for sign in (1, -1):
        for across in (1, -1):
            grasp = TiltedGrasp(arm, block, held, sign, across, height, margin)
            for first in arm.starts:
                grasp.q = solve_poses(arm, [grasp.over_start, grasp.start], first, margin)
                if grasp.q and is_hand_clear(arm, grasp.q, others, block):
                    found.append(grasp)
                    break
    return found
