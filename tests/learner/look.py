"""Looks at a scene like the learner does, arms parked: writes what it sees into the folder LOOK, for
decisions_test.py: look.png, and look.depth, numbers of 8 bytes, row by row."""

import os
from pathlib import Path

from PIL import Image

from act.robot_arms import arms_of


def init(aux):
    aux.channels = ["rgb", "depth"]
    aux.imageSeconds = 0
    for arm in arms_of(aux):
        aux.arms[arm.index].initJoints = arm.parked


def step(sensor, motor, aux):
    if "rgbVision" in sensor:
        folder = Path(os.environ["LOOK"])
        Image.fromarray(sensor.rgbVision).save(folder / "look.png")
        sensor.depthVision.astype("<f8").tofile(folder / "look.depth")
        aux.exit = True
