"""The arms of the robot: how they hold blocks, where they wait, and what they can reach.

Lengths are in units, angles in radians.
"""

import math
from dataclasses import dataclass, field

import numpy as np
from smile.motion import robot_of

from constants import ARMS as C, numbers_of
from eye import Eye, to_pixel


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
    foot: np.ndarray = None  # x y of its first joint [units]
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
        Jacobian: a joint with axis w moves the tool by v = w x r, r from the axis to the tool."""
        tool = self.forward(q)[:3, 3]
        points = [tool]
        for column in self.robot.jacobian(self.name, q).T[::-1]:
            v, w = column[:3], column[3:]
            if w.any():
                on_axis = tool - np.cross(v, w)
                points.append(on_axis + w * (w @ (points[-1] - on_axis)))
        return np.array(points)

    def is_valid_at(self, q):
        """Returns true if the arm touches neither the robot nor the table."""
        still = self.robot.move_joints(self.name, [q])
        return self.robot.first_invalid(still, table=C.table) is None


def arms_for(steps, arms):
    """Returns the arms whose grippers can hold the blocks of all steps except those that stay.

    Raises ValueError if there are none.
    """
    width = max((step.size[1] for step in steps if not (step.stays or step.has_knob)), default=0)
    able = [arm for arm in arms if can_hold(arm, width)]
    if not able:
        found = ", ".join(f"{arm.name}: " + (f"{arm.opening:.2f} units" if arm.opening else "none")
                          for arm in arms)
        raise ValueError(f"the robot has no gripper for blocks that are {width:.2f} units wide: "
                         f"found {found}; expected one that opens at least "
                         f"{width + C.opening_margin:.2f} units")
    return able


def can_hold(arm, width):
    """Returns true if the gripper of an arm opens far enough for a width [units]."""
    return arm.opening >= width + C.opening_margin


def nearest_first(arms, x):
    """Returns arms in the order in which they are tried at a place to the right of the middle (x >
    0) or to the left of it: a list."""
    return sorted(arms, key=lambda arm: -arm.foot[0] if x > 0 else arm.foot[0])


def arms_of(aux):
    """Returns the Arms of a brain's robot."""
    robot = robot_of(aux)
    eye = Eye(aux.cameraIntrinsics, aux.cameraPose)
    arms = []
    for k, arm in enumerate(aux.arms):
        ready = robot.pose(arm.name, "ready")
        if ready is None:
            raise ValueError('the robot has no pose "ready": smile robots add makes one')
        opening = 0 if arm.gripper is None else max(arm.gripper)
        arms.append(Arm(robot, arm.name, k, opening, ready))
    for arm in arms:
        arm.foot = arm.points(arm.ready)[-1, :2]
        arm.has_torso = len(arms) > 1
    middle = np.mean([arm.foot[0] for arm in arms])
    for arm in arms:
        named = [robot.pose(arm.name, name) for name in ("parked", "ready", "neutral")]
        arm.parked = named[0]
        if arm.parked is None:
            arm.parked = posture_aside(arm, eye, is_left=arm.foot[0] <= middle)
        arm.starts = [arm.parked] + [q for q in named[1:] if q is not None]
        arm.reach = finger_reach(arm)
    parked = [arm.parked for arm in arms]
    has_rows = len(arms) > 1 and len({len(q) for q in parked}) == 1
    for arm in arms:
        arm.all_parked = np.array(parked) if has_rows else np.concatenate(parked)
    return arms


def finger_reach(arm):
    """Returns how far the fingers reach below the tool when they point straight down: the height
    of the tool at which they touch the table, found by bisection."""
    over = arm.forward(arm.ready)[:3, 3]
    touching, free = 0, over[2]
    while free - touching > C.reach_accuracy / 4:
        height = (touching + free) / 2
        q = arm.inverse(arm.tool_pose([*over[:2], height], 0), arm.ready, any_turn=True)
        if q is not None and arm.is_valid_at(q):
            free = height
        else:
            touching = height
    return round(free / C.reach_accuracy) * C.reach_accuracy


def posture_aside(arm, eye, is_left):
    """Returns joint angles of an arm beside the table: its hand as high as possible, its first
    joint turned until the eye sees least of it, outward beside other arms."""
    q_high = raised(arm)
    lower, upper = (limit[0] * C.parked_limit for limit in arm.robot.limits(arm.name))
    best = None
    for angle in numbers_of(lower, C.parked_turn_rad, upper):
        q = np.append(angle, q_high[1:])
        is_outward = (angle > q_high[0]) == is_left
        if not arm.is_valid_at(q) or arm.has_torso and not is_outward:
            continue
        cost = visible_extent(arm.points(q), eye), not is_outward, abs(angle - q_high[0])
        if best is None or cost < best[0]:
            best = cost, q
    return best[1] if best else q_high


def raised(arm):
    """Returns joint angles with the tool above the place of the pose `ready`, or closer to the
    robot, as high as possible."""
    over = arm.forward(arm.ready)[:2, 3]
    for height in numbers_of(*C.parked_heights):
        for fraction in C.parked_distances:
            place = arm.foot + fraction * (over - arm.foot)
            q = arm.inverse(arm.tool_pose([*place, height], 0), arm.ready, any_turn=True)
            if q is not None and arm.is_valid_at(q):
                return q
    return arm.ready


def visible_extent(points, eye):
    """Returns how much of the lines between points is in the eye's picture: the sum of the
    distances of points on them from its border [pixels]. Beyond the border, thick links may still
    be visible."""
    fractions = np.linspace(0, 1, C.points_per_link)[:, None]
    size = 2 * eye.intrinsics[:2, 2]
    margin = C.parked_margin * size
    extent = 0
    for one, other in zip(points, points[1:]):
        for at in one + fractions * (other - one):
            if (at - eye.pose[:3, 3]) @ eye.pose[:3, 2] > 0:  # in front of the eye
                pixel = to_pixel(at, eye)
                extent += max(0, min(*(pixel + margin), *(size + margin - pixel)))
    return round(extent)
