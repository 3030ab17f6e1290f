"""Actions of the arms, executed step by step."""

from dataclasses import dataclass, field

import numpy as np
from smile.motion import Trajectory

from constants import EXECUTION as C

ARMS = ("left", "right")


@dataclass
class Action:
    """An action, with the values that are needed in its next step."""

    kind: str  # 'observe': waits for a picture of the arms at rest
    #            'follow': follows a path with an arm
    #            'open': brings the fingers of an arm to an opening
    #            'grasp': closes the fingers on a block of a width
    arm: int = 0  # 0 is the left one
    path: Trajectory = None
    to: float = 0  # [units]
    width: float = 0  # [units]

    time: float = 0  # since its start [s]
    opening: float = np.inf  # at which the fingers came to rest [units]
    still_time: float = 0  # since then [s]
    errors: list = field(default_factory=list)  # of the joints after the end of the path [rad]


def execute_action(action, sensor, motor):
    """Executes one time step of an action. Returns 'busy', 'done', or a description of the
    failure."""
    motor.jointVelocities[:] = 0
    motor.gripperVelocities[:] = 0
    action.time += sensor.timeElapsed
    execute = {"observe": observe, "follow": follow, "open": open_fingers, "grasp": grasp}
    return execute[action.kind](action, sensor, motor)


def observe(action, sensor, motor):
    """Waits for a picture of the arms at rest. Pictures are not taken every step; the first may
    show the moving arm."""
    return "done" if "rgbVision" in sensor and action.time > C.settle_s else "busy"


def follow(action, sensor, motor):
    """Follows a path until the measured joints have arrived, not until a fixed time."""
    q = sensor.jointAngles[action.arm]
    delay = action.time - action.path.duration
    if delay > 0:
        action.errors = [*action.errors[1 - C.num_averaged:], action.path.positions[-1] - q]
        if have_arrived(action.errors):
            return "done"
    wanted, _ = action.path.at(action.time)
    motor.jointVelocities[action.arm] = (wanted - q) / sensor.timeElapsed
    return "an obstacle is in the way of the arm" if delay > C.max_delay_s else "busy"


def have_arrived(errors):
    """Returns true if the last joint error, or the mean of the last ones [rad], is small. Averaging
    suppresses the noise of the measurements."""
    if np.abs(errors[-1]).max() < C.joint_tolerance_rad:
        return True
    mean = np.abs(np.mean(errors, axis=0)).max()
    return len(errors) == C.num_averaged and mean < C.joint_tolerance_rad


def open_fingers(action, sensor, motor):
    """Brings the fingers to an opening."""
    remaining = action.to - gripper_opening(action, sensor)
    if abs(remaining) < C.opening_tolerance:
        return "done"
    speed = remaining / sensor.timeElapsed
    motor.gripperVelocities[action.arm] = np.clip(speed, -C.opening_speed, C.opening_speed)
    is_late = action.time > C.opening_timeout_s
    return "an obstacle keeps the fingers from opening" if is_late else "busy"


def grasp(action, sensor, motor):
    """Closes the fingers until they stop. They must then be at the width of the block."""
    opening = gripper_opening(action, sensor)
    if abs(opening - action.opening) > C.still_opening:
        action.opening = opening
        action.still_time = 0
    action.still_time += sensor.timeElapsed
    if action.still_time < C.still_s:
        motor.gripperVelocities[action.arm] = -C.closing_speed
        return "busy"
    if abs(opening - action.width) < C.width_tolerance:
        return "done"
    return "the fingers closed to %.2f units without a block" % opening


def gripper_opening(action, sensor):
    """Returns the measured opening of the arm's gripper [units]."""
    return sensor.gripperOpening.ravel()[action.arm]
