"""Detects open boxes by their rims."""

from dataclasses import replace

import numpy as np

from constants import PERCEPTION as C
from see.colors import color_mask, table_color
from see.eye import onto_plane
from see.faces import Face, fit_face
from see.regions import label_regions
from things.areas import container_at, rotated
from things.blocks import yaw_difference
from things.kinds import same_size


def detect_container(picture, eye, container, others=()):
    """Detects a Container of the demonstration in a picture. Returns it at its new place and its
    rotation from the old one [rad]; None and 0 if it is not visible. others: Containers that are known already."""
    for face in detect_rims(picture, eye, container.color, container.size[2]):
        if same_size(face.sides, container.size[:2]) and not container_at(others, face.center):
            rotation = yaw_difference(container, face.yaw)
            position = np.append(face.center, container.position[2])
            return replace(container, position=position, yaw=container.yaw + rotation), rotation
    return None, 0


def detect_rims(picture, eye, color, height):
    """Detects rectangles of a color at a height [units] that may be the rims of open boxes;
    anything may be inside. Returns a list of Faces, the largest first, each with the longer side
    first."""
    faces = [fit_face(*it) for it in filled_regions(picture, eye, color, height)]
    return sorted((it for it in faces if it.misfit < C.misfit), key=lambda face: -face.sides.prod())


def half_hidden_rims(picture, eye, color, height, center, yaw):
    """Detects rectangles of a color at a height [units] around a center, x y, and at a yaw [rad], of which a part is hidden: three
    sides must be seen. The farther one of two opposite sides tells where both are. Returns a list of Faces, the largest first."""
    faces = []
    if np.abs(color - table_color(picture)).max() < C.table_tolerance:
        return faces
    for x, y, _ in filled_regions(picture, eye, color, height):
        points = rotated([x - center[0], y - center[1]], -yaw)
        ends = np.array([points.max(axis=1), -points.min(axis=1)])
        sides = 2 * ends.max(axis=0)
        if (ends > 0).all() and np.count_nonzero(ends > C.reached_side * sides / 2) > 2:
            faces.append(Face(np.array(center), yaw, sides, 0.0))
    return sorted(faces, key=lambda face: -face.sides.prod())


def filled_regions(picture, eye, color, height):
    """Yields the regions of a color, with what they surround, at a height: x, y and areas of their pixels [units]."""
    number = label_regions(color_mask(picture, color))
    for region in np.flatnonzero(np.bincount(number.ravel()) >= C.min_rim_pixels):
        if region == 0:
            continue
        mask = number == region
        filled = np.logical_or.accumulate(mask, axis=1)
        filled &= np.logical_or.accumulate(mask[:, ::-1], axis=1)[:, ::-1]
        yield onto_plane(*np.nonzero(filled), eye, height)
