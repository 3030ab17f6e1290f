"""Detects things of several colors by the layout of their parts: see parts."""

import math

import numpy as np

from constants import PARTS, PERCEPTION as C
from see.colors import color_mask
from see.eye import onto_plane, pixel_at
from see.faces import fit_face
from see.regions import is_level, label_regions
from things.areas import rotated
from things.blocks import Block
from things.kinds import is_same_kind, same_color


def detect_layouts(picture, eye, like, heights):
    """Detects the things in a picture whose parts are those of given ones (Blocks or Steps with parts), on
    level ground, at any place and height: a list of Blocks. heights: as from height_map."""
    kinds = []
    for it in like:
        if it.parts and not any(is_same_kind(it, kind) for kind in kinds):
            kinds.append(it)
    found = []
    for kind in kinds:
        key = max(kind.parts, key=lambda it: it.size[:2].prod())
        for face, top in faces_of(key, picture, eye, heights):
            # A rectangle looks the same after half a turn; the other parts tell.
            for yaw in (face.yaw, face.yaw + math.pi):
                block = thing_at(kind, key, face.center, top, yaw - key.yaw)
                if all(is_visible(block, part, picture, eye, heights) for part in kind.parts):
                    found.append(block)
                    break
    return found


def faces_of(part, picture, eye, heights):
    """Yields the Faces in a picture that have the color and the sides of a part, turned as it is, and their
    heights."""
    number = label_regions(color_mask(picture, part.color), heights)
    for region in np.flatnonzero(np.bincount(number.ravel()) >= C.min_top_pixels):
        row, column = np.nonzero(number == region)
        if region == 0 or not is_level(heights[row, column]):
            continue
        top = np.median(heights[row, column])
        points = onto_plane(row, column, eye, top)
        face = fit_face(*points)
        if part.size[0] < part.size[1]:  # the longer side of a face comes first
            face = fit_face(*points, face.yaw - math.pi / 2)
        is_like = np.abs(face.sides / part.size[:2] - 1).max() < C.max_side_error
        if is_like and face.misfit < C.misfit and not face.is_round:
            yield face, top


def thing_at(kind, part, center, top, yaw):
    """Returns a thing of a kind as a Block, with a part of it whose top is at a place and a height."""
    x, y = center - rotated(part.position[:2], yaw)
    z = top - part.position[2]
    # The table's height is known better than that of the part.
    if abs(z - kind.size[2] / 2) < C.on_table:
        z = kind.size[2] / 2
    return Block(kind.color, kind.size, np.array([x, y, z]), yaw, parts=kind.parts)


def is_visible(block, part, picture, eye, heights):
    """Returns true if the eye sees the color of a part of a thing where it should be."""
    center = block.position[:2] + rotated(part.position[:2], block.yaw)
    top = block.position[2] + part.position[2]
    pixel = pixel_at(picture, eye, [*center, top])
    return (pixel is not None and same_color(part.color, picture[pixel])
            and abs(heights[pixel] - top) < PARTS.max_height_error)
