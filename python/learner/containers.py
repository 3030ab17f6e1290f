"""Detects open boxes by their rims."""

from dataclasses import replace

import numpy as np

from appearances import select_frames
from areas import is_inside
from blocks import yaw_difference
from colors import color_mask, frequent_colors
from constants import PERCEPTION as C, TASK_MODEL
from demonstration import read_picture
from eye import onto_plane, pixel_at
from faces import fit_face
from kinds import same_size
from regions import label_regions
from steps import Container


def detect_rims(picture, eye, color, height):
    """Detects rectangles of a color at a height [units] that may be the rims of open boxes;
    anything may be inside. Returns a list of Faces, the largest first, each with the longer side
    first."""
    number = label_regions(color_mask(picture, color))
    faces = []
    for region in np.flatnonzero(np.bincount(number.ravel()) >= C.min_rim_pixels):
        if region == 0:
            continue
        mask = number == region
        filled = np.logical_or.accumulate(mask, axis=1)
        filled &= np.logical_or.accumulate(mask[:, ::-1], axis=1)[:, ::-1]
        face = fit_face(*onto_plane(*np.nonzero(filled), eye, height))
        if face.misfit < C.misfit:
            faces.append(face)
    return sorted(faces, key=lambda face: -face.sides.prod())


def detect_container(picture, eye, container):
    """Detects a Container of the demonstration in a picture. Returns it at its new place and its
    rotation from the old one [rad]; None and 0 if it is not visible."""
    for face in detect_rims(picture, eye, container.color, container.size[2]):
        if same_size(face.sides, container.size[:2]):
            rotation = yaw_difference(container, face.yaw)
            position = np.append(face.center, container.position[2])
            return replace(container, position=position, yaw=container.yaw + rotation), rotation
    return None, 0


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
