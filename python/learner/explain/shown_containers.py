"""Measures the containers into which a demonstration puts blocks."""

import math
from dataclasses import replace

import numpy as np

from constants import PERCEPTION as C, TASK_MODEL
from explain.appearances import select_frames
from explain.limits import NotUnderstood
from explain.shown_pictures import read_picture
from relate.dragging import has_shape
from see.colors import frequent_colors
from see.containers import detect_rims, half_hidden_rims
from see.eye import pixel_at
from things.areas import is_inside
from things.steps import Container


def measure_containers(demo, steps):
    """Measures the open boxes that the blocks of steps were put into, in the first picture of the
    demonstration: a list of Containers, empty if all of them stand on the table or on each other."""
    inside = [step for step in steps
              if step.bottom > TASK_MODEL.min_inside_bottom and not step.on
              and step.displacement is None and not step.takes_place_of]
    containers = []
    while inside:
        container = container_of(demo, inside)
        containers.append(container)
        inside = [step for step in inside if not is_inside(container, step.position)]
    return containers


def container_of(demo, inside):
    """Measures the Container of the first of some steps: of what may be one, that which most of them are in. If something hides
    a part of a box in all pictures, like an arm, its place and its yaw are those of the texts.
    """
    best = best_container(demo, inside, detect_rims) or best_container(demo, inside, half_hidden_rims)
    if not best:
        raise NotUnderstood(f"no picture of the demonstration shows on or in what {inside[0].name} was put; an arm may hide it")
    return best


def best_container(demo, inside, detect):
    """Returns the Container that the first of some steps and most others are in, or None. detect: see rims_at"""
    best, most = None, 0
    still = [n for n in range(len(demo.ids)) if n not in demo.placed]
    for n in sorted(still, key=lambda n: np.hypot(*(demo.moves[n][0, 1:3] - inside[0].position[:2]))):
        x, y, z = demo.moves[n][0, 1:4]
        for color, face in rims_at(demo, n, detect):
            container = Container(color, np.append(face.sides, 2 * z), np.append(face.center, z),
                                  0.0 if face.is_round else face.yaw, demo.ids[n], 0.0,
                                  form="disc" if face.is_round else "block")
            content = [step for step in inside if is_inside(container, step.position)]
            is_it = np.hypot(*(face.center - [x, y])) < TASK_MODEL.max_center_error and inside[0] in content
            if is_it and len(content) > most:
                best, most = replace(container, floor=min(step.bottom for step in content)), len(content)
            if most == len(inside):
                return best
    return best


def rims_at(demo, n, detect):
    """Yields the colors and Faces of what may be the rim of object n of a demonstration, which stands on the table. The first picture
    and the color in the middle, usually that of its floor, come first: later something else may cover it, or no longer.

    detect: detect_rims or half_hidden_rims
    """
    x, y, z, _, _, degrees = demo.moves[n][0, 1:]
    pose = [[x, y], math.radians(degrees)] if detect is half_hidden_rims else []
    for frame, *_ in select_frames(demo, n) if not pose or has_shape(demo, n, "box") else []:
        picture = read_picture(demo, frame)
        pixel = pixel_at(picture, demo.eye, [x, y, 2 * z]) if picture is not None else None
        if pixel is None:
            continue
        for color in [picture[pixel], *frequent_colors(picture, C.min_rim_pixels)]:
            for face in detect(picture, demo.eye, color, 2 * z, *pose):
                yield color, face
