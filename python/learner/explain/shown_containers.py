"""Measures the container into which a demonstration puts blocks."""

import numpy as np

from constants import PERCEPTION as C, TASK_MODEL
from explain.appearances import select_frames
from explain.limits import NotUnderstood
from explain.shown_pictures import read_picture
from see.colors import frequent_colors
from see.containers import detect_rims
from see.eye import pixel_at
from things.areas import is_inside
from things.steps import Container


def measure_container(demo, steps):
    """Measures the open box that the blocks of steps were put into, in the first picture of the
    demonstration; None if all of them stand on the table or on each other."""
    inside = [step for step in steps
              if step.bottom > TASK_MODEL.min_inside_bottom and not step.on
              and step.displacement is None and not step.takes_place_of]
    if not inside:
        return None
    left_out = None  # a container of some of the steps, and one of the others
    still = [n for n in range(len(demo.ids)) if n not in demo.placed]
    for n in sorted(still, key=lambda n: np.hypot(*(demo.moves[n][0, 1:3] - inside[0].position[:2]))):
        x, y, z = demo.moves[n][0, 1:4]
        for color, face in rims_at(demo, n, [x, y, 2 * z]):
            container = Container(color, np.append(face.sides, 2 * z), np.append(face.center, z),
                                  0.0 if face.is_round else face.yaw, demo.ids[n],
                                  min(step.bottom for step in inside),
                                  form="disc" if face.is_round else "block")
            is_there = np.hypot(*(face.center - [x, y])) < TASK_MODEL.max_center_error
            outside = [step for step in inside if not is_inside(container, step.position)]
            if is_there and not outside:
                return container
            if is_there and len(outside) < len(inside):
                left_out = container.name, outside[0].name
    if left_out:
        raise NotUnderstood("something was put into {}, but {} on or into something else: one container is understood".format(*left_out))
    raise NotUnderstood(f"no picture of the demonstration shows on or in what {inside[0].name} was put; an arm may hide it")


def rims_at(demo, n, top):
    """Yields the colors and Faces of what may be the rim of object n of a demonstration, which stands on
    the table; top: the middle of its rim, x y z [units]. The first picture and the color in the middle,
    usually that of its floor, come first: later something else may cover it, or no longer."""
    for frame, *_ in select_frames(demo, n):
        picture = read_picture(demo, frame)
        pixel = pixel_at(picture, demo.eye, top) if picture is not None else None
        if pixel is None:
            continue
        for color in [picture[pixel], *frequent_colors(picture, C.min_rim_pixels)]:
            for face in detect_rims(picture, demo.eye, color, top[2]):
                yield color, face
