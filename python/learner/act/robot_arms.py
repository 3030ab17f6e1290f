"""The arms of a robot, and how far their fingers reach."""

import numpy as np
from smile.motion import robot_of

from act.arms import Arm
from act.postures import posture_aside
from constants import ARMS as C
from see.framing import eye_of_robot


def arms_of(aux):
    """Returns the Arms of a brain's robot."""
    robot = robot_of(aux)
    eye = eye_of_robot(aux)
    arms = []
    for k, arm in enumerate(aux.arms):
        ready = robot.pose(arm.name, "ready")
        if ready is None:
            raise ValueError('the robot has no pose "ready": smile robots add makes one')
        camera = f"{arm.name}_hand"
        opening = 0 if arm.gripper is None else max(arm.gripper)
        arms.append(Arm(robot, arm.name, k, opening, ready, camera=camera if camera in aux.cameraNames else ""))
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
        arm.palm = palm_of(arm)
    parked = [arm.parked for arm in arms]
    has_rows = len(arms) > 1 and len({len(q) for q in parked}) == 1
    for arm in arms:
        arm.all_parked = np.array(parked) if has_rows else np.concatenate(parked)
    return arms


def palm_of(arm):
    """Returns how far above the tool the fingers begin when they point straight down [units]; infinite if they are unknown."""
    try:
        return -arm.robot.finger_bounds(arm.name, 0)[0][2]
    except ValueError:  # no gripper, or one without shapes that move
        return np.inf


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
