"""Single segments of the path of an arm: between joint angles, and along a line."""

from act.reach import avoids_torso
from constants import MOTION_PLANNING as C


def move_joints(arm, waypoints):
    """Plans a path through joint waypoints, Nxn [rad]."""
    return arm.robot.move_joints(arm.name, waypoints, speed=C.speed)


def move_line(arm, before, goal):
    """Plans a straight line from the end of another path to a pose, 4x4; None if there is none, or
    if it passes a stretched arm, where it would take too long."""
    path, _ = arm.robot.move_line(arm.name, before.positions[-1], goal, speed=C.speed)
    return path if path and path.duration <= C.max_line_s else None


def is_path_valid(arm, path, held=None):
    """Returns true if an arm can follow a path while the others are parked.

    held: box around what it holds, in the frame of its tool: lower and upper corner, 2x3 [units]
    """
    return (avoids_torso(arm, path.positions)
            and arm.robot.first_invalid(path, q_both=arm.all_parked, held=held) is None)


def at_height(pose, height):
    """Returns a pose at another height [units]."""
    pose = pose.copy()
    pose[2, 3] = height
    return pose
