"""Rims of containers in a picture."""

import numpy as np

from appearances import select_frames
from colors import color_mask, frequent_colors
from constants import PERCEPTION as C
from eye import onto_plane, pixel_at
from faces import fit_face
from regions import label_regions
from shown_pictures import read_picture


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
