"""Baxter at its table. A program imports `init`, with which its brain begins.

Lengths are in units, angles in radians.
"""
from smile.motion import robot_of

from common.arm import Arm

TABLE = (20, 12)  # width and depth
ASIDE = [[1.3, -1, -1.19, 1.94, 0.67, 1.03, -0.5],   # angles of the left arm
         [-1.3, -1, 1.19, 1.94, -0.67, 1.03, 0.5]]   # the right arm mirrors it


def init(aux):
    """Begins with the arms aside, so that the eye sees the table. Pictures come on request only."""
    for arm, angles in zip(aux.arms, ASIDE):
        arm.initJoints = angles
    aux.channels = ["rgb", "depth"]
    aux.imageSeconds = 3600


def arms_of(aux, motor):
    """Returns both arms, which wait aside."""
    robot = robot_of(aux)
    return [Arm(robot, aux, motor, k, ASIDE[k]) for k in range(2)]
