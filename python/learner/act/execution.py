"""Executes actions of the arms, step by step."""

import numpy as np

from act.actions import ticks_within
from act.gripping import grasp, open_fingers
from act.path_following import follow, lift, press
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
    aux.cameras = []  # pictures of the hands take time
    action.time += sensor.timeElapsed
    execute = {"observe": observe, "look": look, "follow": follow, "push": follow, "lift": lift, "press": press, "open": open_fingers, "grasp": grasp}
    return execute[action.kind](action, sensor, motor, aux)


def look(action, sensor, motor, aux):
    """Waits until the arms rest, then for a picture of the camera of a hand."""
    aux.cameras = [action.arm.camera]
    aux.imageSeconds = 0  # with the next step
    if action.time <= C.settle_s or "cameras" not in sensor:
        motor.ticks = max(ticks_within(C.settle_s - action.time, aux) + 1, 1)
        return "busy"
    aux.imageSeconds = C.no_image_s
    return "done"


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
