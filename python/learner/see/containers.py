"""Detects open boxes by their rims."""

from dataclasses import replace

import numpy as np

from constants import PERCEPTION as C
from see.colors import color_mask
from see.eye import onto_plane
from see.faces import fit_face
from see.regions import label_regions
from things.areas import container_at
from things.blocks import yaw_difference
from things.kinds import same_size


def detect_container(picture, eye, container, others=()):
    """Detects a Container of the demonstration in a picture. Returns it at its new place and its
    rotation from the old one [rad]; None and 0 if it is not visible. others: Containers that are known already"""
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
