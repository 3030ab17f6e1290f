"""Actions: what the arms do one after the other, each carried out step by step."""

from dataclasses import dataclass, field

import numpy as np
from smile.motion import Trajectory

from constants import ACT

ARMS = ("left", "right")


@dataclass
class Action:
    """Something to do, and what must be remembered of it from step to step."""

    kind: str  # 'look'
    #            'follow' a path, with an arm
    #            'grip': the arm's fingers are brought to an opening
    #            'take': they close on a block of a width
    arm: int = 0  # 0 is the left one
    path: Trajectory = None
    to: float = 0  # [units]
    width: float = 0  # [units]

    time: float = 0  # since it began [s]
    opening: float = np.inf  # where the fingers came to rest [units]
    rest: float = 0  # for how long [s]
    errors: list = field(default_factory=list)  # of the joints after a path's end, the latest last


def carry_out(action, sensor, motor):
    """One step of an action. Returns 'busy', 'done', or what went wrong."""
    motor.jointVelocities[:] = 0
    motor.gripperVelocities[:] = 0
    action.time += sensor.timeElapsed
    return {"look": look, "follow": follow, "grip": grip, "take": take}[action.kind](
        action, sensor, motor)


def look(action, sensor, motor):
    # Images come only now and then; the first may be of a moment when the arm still moved.
    return "done" if "rgbVision" in sensor and action.time > ACT.settle_s else "busy"


def follow(action, sensor, motor):
    q = sensor.jointAngles[action.arm]
    # It is over when the joints have arrived, whatever the clock says.
    late = action.time - action.path.duration
    if late > 0:
        action.errors = [*action.errors[1 - ACT.num_averaged:], action.path.positions[-1] - q]
        if have_arrived(action.errors):
            return "done"
    wanted, _ = action.path.at(action.time)
    motor.jointVelocities[action.arm] = (wanted - q) / sensor.timeElapsed
    return "something is in the way of the arm" if late > ACT.late_s else "busy"


def have_arrived(errors):
    """By the last measurement, or by the mean of the last ones: each has noise of its own."""
    if np.abs(errors[-1]).max() < ACT.arrived_rad:
        return True
    mean = np.abs(np.mean(errors, axis=0)).max()
    return len(errors) == ACT.num_averaged and mean < ACT.arrived_rad


def grip(action, sensor, motor):
    gap = action.to - gripper_opening(action, sensor)
    if abs(gap) < ACT.opening_error:
        return "done"
    speed = gap / sensor.timeElapsed
    motor.gripperVelocities[action.arm] = np.clip(speed, -ACT.opening_speed, ACT.opening_speed)
    late = action.time > ACT.opening_s
    return "something keeps the fingers from opening" if late else "busy"


def take(action, sensor, motor):
    """Closes until the fingers stop. Between them must then be the block."""
    opening = gripper_opening(action, sensor)
    if abs(opening - action.opening) > ACT.still_opening:
        action.opening = opening
        action.rest = 0
    action.rest += sensor.timeElapsed
    if action.rest < ACT.still_s:
        motor.gripperVelocities[action.arm] = -ACT.closing_speed
        return "busy"
    if abs(opening - action.width) < ACT.width_error:
        return "done"
    return "the fingers closed to %.2f units, on no block" % opening


def gripper_opening(action, sensor):
    return sensor.gripperOpening.ravel()[action.arm]
