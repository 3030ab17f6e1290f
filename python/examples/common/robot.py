"""The robot at its table. A program imports `init`, with which its brain begins.

Lengths are in units, angles in radians.
"""
from smile.motion import robot_of

from common.arm import Arm

TABLE = (20, 12)  # width and depth
BAXTER_ASIDE = [[1.3, -1, -1.19, 1.94, 0.67, 1.03, -0.5],   # angles of the left arm
                [-1.3, -1, 1.19, 1.94, -0.67, 1.03, 0.5]]   # the right arm mirrors it


def init(aux):
    """Begins with the arms aside, so that the eye sees the table. Pictures come on request only."""
    aux.planner = robot_of(aux)
    aux.aside = asides_of(aux.planner, aux.arms)
    for arm, angles in zip(aux.arms, aux.aside):
        arm.initJoints = angles
    aux.channels = ["rgb", "depth"]
    aux.imageSeconds = 3600


def asides_of(robot, arms):
    """Returns a posture for each arm in which it waits."""
    if [len(arm.minJoints) for arm in arms] == [7, 7]:
        return BAXTER_ASIDE
    asides = [pose_of(robot, arm.name, "folded", "ready") for arm in arms]
    if any(angles is None for angles in asides):
        raise RuntimeError("the robot has no pose folded or ready")
    return asides


def pose_of(robot, arm, *names):
    """Returns the angles of an arm in the first of these poses that the robot has, or None."""
    return next((q for q in (robot.pose(arm, name) for name in names) if q is not None), None)


def arms_of(aux, motor):
    """Returns the arms, which wait aside."""
    return [Arm(aux.planner, aux, motor, k, aside) for k, aside in enumerate(aux.aside)]
