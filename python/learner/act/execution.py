"""Executes actions of the arms, step by step."""

import numpy as np

from act.actions import ticks_within
from act.gripping import grasp, open_fingers
from constants import EXECUTION as C
from see.denoising import without_noise
from see.pictures import noise_of, num_pictures


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


def observe(action, sensor, motor, aux):
    """Waits until the arms rest, then for a picture; if it has noise, for so many that their mean
    has little, which takes the place of the last one, without that."""
    aux.imageSeconds = 0  # with the next step
    if action.time <= C.settle_s or "rgbVision" not in sensor:
        motor.ticks = max(ticks_within(C.settle_s - action.time, aux) + 1, 1)
        return "busy"
    if not action.pictures:
        action.noise = noise_of(sensor.rgbVision / 255)
    action.pictures.append(sensor.rgbVision)
    if len(action.pictures) < num_pictures(action.noise):
        return "busy"
    if action.noise > 0:
        mean = np.mean(action.pictures, axis=0) / 255
        sensor.rgbVision = 255 * without_noise(mean, action.noise, len(action.pictures))
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
    """Follows a path to its end, or until something stops the arm, and back to its start. Each tick has feedback: an
    arm that pushes on slips off what it presses."""
    q = sensor.arms[action.arm.index].joints
    # action.time is the end of this tick.
    time = vars(aux).get("variationSpeed", 1) * np.array([action.time - aux.tickSeconds, action.time])
    (expected, wanted), _ = action.path.at(np.minimum(time, 2 * action.turn - time))
    if action.turn == np.inf and (time[0] > action.path.duration or np.abs(expected - q).max() > C.stall_rad):
        action.turn = time[0]
    motor.arms[action.arm.index].velocities = (wanted - q) / aux.tickSeconds
    delay = time[1] - 2 * action.turn
    if delay > 0 and np.abs(action.path.positions[0] - q).max() < C.joint_tolerance_rad:
        return "done"
    return "an obstacle is in the way of the arm" if delay > C.max_delay_s else "busy"
