"""Actions of the arms, executed step by step."""

from dataclasses import dataclass, field
from typing import Optional

import numpy as np
from smile.motion import Trajectory

from arms import Arm
from constants import EXECUTION as C
from pictures import num_pictures


@dataclass
class Grasp:
    """An attempt to take a block."""

    position: np.ndarray  # of the block's center [units]
    arm: int  # number of the arm
    yaw: float  # direction from finger to finger [rad]


@dataclass
class Action:
    """An action, with the values that are needed in its next step."""

    kind: str  # 'observe': waits for a picture of the arms at rest
    #            'follow': follows a path with an arm
    #            'press': likewise, until something stops it
    #            'open': brings the fingers of an arm to an opening
    #            'grasp': closes the fingers on a block of a width
    arm: Arm = None
    path: Trajectory = None
    to: float = 0  # [units]
    width: float = 0  # [units]
    grasp: Optional[Grasp] = None  # which one it attempts

    time: float = 0  # since its start [s]
    opening: float = np.inf  # at which the fingers came to rest [units]
    still_time: float = 0  # since then [s]
    pictures: list = field(default_factory=list)  # of the arms at rest
    num_pictures: int = 0  # wanted


def execute_action(action, sensor, motor, aux):
    """Executes one step of an action: sets `motor` for one tick, or for several where no feedback is
    needed. Returns 'busy', 'done', or a description of the failure."""
    for arm, of_arm in zip(sensor.arms, motor.arms):
        of_arm.velocities = np.zeros(len(arm.joints))
        of_arm.gripperVelocity = 0
    motor.ticks = 1
    aux.imageSeconds = C.no_image_s
    action.time += sensor.timeElapsed
    execute = {"observe": observe, "follow": follow, "press": press, "open": open_fingers, "grasp": grasp}
    return execute[action.kind](action, sensor, motor, aux)


def ticks_within(seconds, aux):
    """Returns the number of whole ticks in some time, as far as a step can last that long."""
    return int(min(max(seconds // aux.tickSeconds, 0), aux.maxTicks))


def observe(action, sensor, motor, aux):
    """Waits until the arms rest, then for a picture; if it has noise, for so many that their mean
    has little, which takes the place of the last one."""
    aux.imageSeconds = 0  # with the next step
    if action.time <= C.settle_s or "rgbVision" not in sensor:
        motor.ticks = max(ticks_within(C.settle_s - action.time, aux) + 1, 1)
        return "busy"
    if not action.pictures:
        action.num_pictures = num_pictures(sensor.rgbVision)
    action.pictures.append(sensor.rgbVision)
    if len(action.pictures) < action.num_pictures:
        return "busy"
    if len(action.pictures) > 1:
        sensor.rgbVision = np.mean(action.pictures, axis=0)
    aux.imageSeconds = C.no_image_s
    return "done"


def follow(action, sensor, motor, aux):
    """Follows a path until the measured joints have arrived, not until a fixed time. The velocities
    along the path are chunks of some ticks. After its end, each tick has feedback."""
    q = sensor.arms[action.arm.index].joints
    speed = vars(aux).get("variationSpeed", 1)
    delay = action.time - action.path.duration / speed
    if delay > 0 and np.abs(action.path.positions[-1] - q).max() < C.joint_tolerance_rad:
        return "done"
    num_ticks = min(ticks_within(-delay, aux) + 1, C.chunk_ticks)
    # action.time is the end of the first of these ticks.
    wanted, _ = action.path.at(speed * (action.time + aux.tickSeconds * np.arange(num_ticks)))
    motor.ticks = num_ticks
    velocities = np.diff([q, *wanted], axis=0).T / aux.tickSeconds
    motor.arms[action.arm.index].velocities = velocities
    return "an obstacle is in the way of the arm" if delay > C.max_delay_s else "busy"


def press(action, sensor, motor, aux):
    """Follows a path to its end, or until something stops the arm."""
    return "busy" if follow(action, sensor, motor, aux) == "busy" else "done"


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
