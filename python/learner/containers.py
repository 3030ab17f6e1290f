"""Detects open boxes by their rims."""

from dataclasses import replace

import numpy as np

from areas import is_inside
from blocks import yaw_difference
from constants import TASK_MODEL
from kinds import same_size
from rims import detect_rims, rims_at
from steps import Container


def detect_container(picture, eye, container):
    """Detects a Container of the demonstration in a picture. Returns it at its new place and its
    rotation from the old one [rad]; None and 0 if it is not visible."""
    for face in detect_rims(picture, eye, container.color, container.size[2]):
        if same_size(face.sides, container.size[:2]):
            rotation = yaw_difference(container, face.yaw)
            position = np.append(face.center, container.position[2])
            return replace(container, position=position, yaw=container.yaw + rotation), rotation
    return None, 0


def measure_container(demo, steps):
    """Measures the open box that the blocks of steps were put into, in the first picture of the
    demonstration; None if all of them stand on the table or on each other."""
    inside = [step for step in steps
              if step.bottom > TASK_MODEL.min_inside_bottom and not step.on
              and step.displacement is None and not step.takes_place_of]
    if not inside:
        return None
    for n in range(len(demo.ids)):
        if n in demo.placed:
            continue
        x, y, z = demo.moves[n][0, 1:4]
        for color, face in rims_at(demo, n, [x, y, 2 * z]):
            container = Container(color, np.append(face.sides, 2 * z), np.append(face.center, z),
                                  0.0 if face.is_round else face.yaw, demo.ids[n],
                                  min(step.bottom for step in inside),
                                  form="disc" if face.is_round else "block")
            is_there = np.hypot(*(face.center - [x, y])) < TASK_MODEL.max_center_error
            if is_there and all(is_inside(container, step.position) for step in inside):
                return container
    raise ValueError(f"no picture of the demonstration shows the container of {inside[0].name}")
