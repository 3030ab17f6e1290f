"""Hands that turn a tool about its axis with the last joint of their arm."""

import math

import numpy as np

from act.segments import move_joints
from constants import MOTION_PLANNING, USES as C


class NoPath(Exception):
    """There is no path to a pose."""


class DrivingHand:
    """An arm that holds an upright tool at a height above its center."""

    def __init__(self, arm, width, grip):
        self.arm, self.width, self.grip = arm, width, grip
        lower, upper = (limit[-1] for limit in arm.robot.limits(arm.name))
        self.middle = (lower + upper) / 2
        # Wrists turn by less than a full turn.
        self.strokes_per_turn = math.ceil(C.turn_rad / (upper - lower - 2 * C.limit_margin_rad))
        axis = arm.robot.jacobian(arm.name, arm.ready)[5, -1]
        self.clockwise = -math.copysign(C.turn_rad / self.strokes_per_turn, axis)  # as seen from above

    def pose(self, place, height):
        """Returns the pose of the arm's tool with the center of what it holds over a place, x y, at a height."""
        return self.arm.tool_pose([*place[:2], height + self.grip], 0, self.width)

    def strokes(self, turns):
        """Returns the angles of the last joint at which a stroke of some Turns begins and ends, and how many there
        are: the tool fits into the head of a fastener only after some turning."""
        stroke = -self.clockwise if turns.is_loosening else self.clockwise
        number = turns.number * self.strokes_per_turn
        return self.middle - stroke / 2, self.middle + stroke / 2, number + (not turns.is_loosening)

    def line(self, q, pose):
        """Returns a straight path, on which the tool may turn about its axis."""
        path, _ = self.arm.robot.move_line(self.arm.name, q, pose, speed=MOTION_PLANNING.speed, any_turn=True)
        if not path or path.duration > MOTION_PLANNING.max_line_s:
            raise NoPath
        return path

    def turned(self, q, last):
        """Returns the path that turns the last joint to an angle."""
        return move_joints(self.arm, [q, np.append(q[:-1], last)])

    def over(self, q, pose):
        """Returns a path over the table: a straight one, or any that the joints can do."""
        try:
            return self.line(q, pose)
        except NoPath:
            goal = self.arm.inverse(pose, q, any_turn=True, max_iterations=MOTION_PLANNING.ik_iterations)
            if goal is None:
                raise
            return move_joints(self.arm, [q, goal])
