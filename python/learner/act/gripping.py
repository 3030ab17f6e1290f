"""Opens and closes the fingers, step by step."""

import numpy as np

from act.actions import ticks_within
from constants import EXECUTION as C


def open_fingers(action, sensor, motor, aux):
    """Brings the fingers to an opening."""
    remaining = action.to - gripper_opening(action, sensor)
    if abs(remaining) < C.opening_tolerance:
        return "done"
    speed = np.clip(remaining / aux.tickSeconds, -C.opening_speed, C.opening_speed)
    motor.arms[action.arm.index].gripperVelocity = speed
    motor.ticks = max(ticks_within(remaining / speed, aux), 1)
    is_late = action.time > C.opening_timeout_s
    return "an obstacle keeps the fingers from opening" if is_late else "busy"


def grasp(action, sensor, motor, aux):
    """Closes the fingers until they stop. They must then be at the width of the block."""
    opening = gripper_opening(action, sensor)
    if abs(opening - action.opening) > C.still_opening:
        action.opening = opening
        action.still_time = 0
    else:
        action.still_time += sensor.timeElapsed
    if action.still_time < C.still_s:
        motor.arms[action.arm.index].gripperVelocity = -C.closing_speed
        free = opening - action.width - C.width_tolerance
        motor.ticks = max(ticks_within(free / C.closing_speed, aux), 1)
        return "busy"
    if abs(opening - action.width) < C.width_tolerance:
        return "done"
    return "the fingers closed to %.2f units without a block" % opening


def gripper_opening(action, sensor):
    """Returns the measured opening of the arm's gripper [units]."""
    return sensor.arms[action.arm.index].gripper
