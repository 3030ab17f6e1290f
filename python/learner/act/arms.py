"""An arm of the robot: its hand, its joints, and points along it.

Lengths are in units, angles in radians.
"""

import math
from dataclasses import dataclass, field

import numpy as np

from constants import ARMS as C


@dataclass(eq=False)
class Arm:
    """An arm of the robot, of n joints."""

    robot: object  # a smile.motion.Robot
    name: str
    index: int  # among the arms of the robot, the first is 0
    opening: float  # largest opening of its gripper [units]; 0 without a gripper
    ready: np.ndarray  # n joint angles: its hand over the table, fingers straight down
    parked: np.ndarray = None  # n joint angles: where it waits
    all_parked: np.ndarray = None  # joint angles of all arms, as smile.motion takes those of `both`
    starts: list = field(default_factory=list)  # joint angles from which to search for others
    reach: float = 0  # of the fingers below the tool, when they point straight down [units]
    palm: float = math.inf  # how far above the tool the fingers begin then [units]
    foot: np.ndarray = None  # x y of its first joint [units]
    camera: str = ""  # of its hand; empty if it has none
    has_torso: bool = False  # true beside other arms

    def tool_pose(self, point, across, opening=0):
        """Returns the pose of the tool, 4x4, with the fingers straight down on both sides of a
        point (x y z [units]).

        across: direction from finger to finger, seen from above [rad]
        """
        c, s = math.cos(across), math.sin(across)
        x, y, z = point
        middle = self.robot.gripper_middle(self.name, opening) if self.opening else 0
        return np.array([[-s, c, 0, x - c * middle], [c, s, 0, y - s * middle], [0, 0, -1, z],
                         [0, 0, 0, 1]])

    def inverse(self, pose, q, **options):
        """Returns joint angles that bring the tool to a pose, searched from q; None if there are
        none. Arms of fewer than six joints cannot make up for a rounded description."""
        if len(self.ready) < 6:
            options |= {"position_tolerance": C.tolerance, "angle_tolerance": C.tolerance}
        return self.robot.inverse(self.name, pose, q, **options)

    def forward(self, q):
        """Returns the pose of the tool, 4x4."""
        return self.robot.forward(self.name, q)

    def points(self, q):
        """Returns points along the arm from its tool to its first joint, Mx3: on the axis of each
        joint that turns, the point that is closest to the one before. They follow from the
        Jacobian: a joint with axis w moves the tool by v = w x r, r from the axis to the tool.

        q: joint angles; for several rows of them, the points are NxMx3
        """
        if np.ndim(q) == 1:
            return self.points(q[None])[0]
        tool = np.array([self.forward(it)[:3, 3] for it in q])
        v, w = np.split(np.array([self.robot.jacobian(self.name, it).T[::-1] for it in q]), 2, axis=2)
        on_axes = tool[:, None] - np.cross(v, w)
        points = [tool]
        for k in np.flatnonzero(w[0].any(axis=1)):
            axis, on_axis = w[:, k], on_axes[:, k]
            points.append(on_axis + axis * ((points[-1] - on_axis) * axis).sum(axis=1, keepdims=True))
        return np.stack(points, axis=1)

    def is_valid_at(self, q):
        """Returns true if the arm touches neither the robot nor the table."""
        still = self.robot.move_joints(self.name, [q])
        return self.robot.first_invalid(still, table=C.table) is None
