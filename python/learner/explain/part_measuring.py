"""Measures the parts of things of several colors in the pictures of a demonstration: see parts."""

import math
from itertools import product

import numpy as np

from constants import PARTS as C, PERCEPTION, TASK_MODEL
from explain.handles import displaced_regions
from explain.shown_pictures import read_picture
from see.colors import color_mask, frequent_colors, is_color_near
from see.eye import onto_plane, pixel_at
from see.faces import fit_face
from things.areas import rotated
from things.blocks import Block
from things.kinds import same_size
from things.parts import whole_of


def measure_parts(demo, n):
    """Measures the parts of object n of a demonstration in two pictures, before and while it was moved: the
    closer to the eye a part is, the farther it moves in the picture, which determines its height. Returns the
    object as a Block at its first place, or None if fewer than two parts are found."""
    moves = demo.moves[n]
    first = read_picture(demo, moves[0, 0])
    highest = moves[np.argsort(-moves[:, 3], kind="stable")[:TASK_MODEL.num_highest_frames]]
    for row in highest if first is not None and n in demo.placed else []:
        later = read_picture(demo, row[0])
        if later is not None and row[0] != moves[0, 0]:
            parts = parts_between((first, moves[0, 1:]), (later, row[1:]), demo.eye)
            if len(parts) > 1:
                return whole_of(parts, moves)
    return None


def parts_between(before, after, eye, can_be_round=False):
    """Returns the parts that two views of an object show, a list. A view: picture, and pose of the object."""
    parts = []
    for color in frequent_colors(before[0], PERCEPTION.min_rim_pixels):
        middles = [pixel_at(picture, eye, pose[:3]) for picture, pose in (before, after)]
        if not all(is_color_near(picture, color, it) for (picture, _), it in zip((before, after), middles)):
            continue
        masks = [color_mask(picture, color) for picture, _ in (before, after)]
        for pixels in product(displaced_regions(*masks), displaced_regions(*masks[::-1])):
            color = np.median(before[0][pixels[0]], axis=0)
            part = part_of(color, pixels, (before[1], after[1]), eye, can_be_round)
            if part and all(np.linalg.norm(it.position - part.position) > C.max_error for it in parts):
                parts.append(part)
    return parts


def part_of(color, pixels, poses, eye, can_be_round):
    """Returns the part that two regions of pixels show in two views, or None. Its place in the frame of the
    object grows in proportion to its height, differently in each view; at its height both agree."""
    above = []
    for height in (0, 1):
        found = [face_at(height, *it, eye) for it in zip(pixels, poses)]
        above.append(found[0][0] - found[1][0])
    growth = above[1] - above[0]
    height = -(above[0] @ growth) / (growth @ growth) if growth.any() else 0
    if not 0 < height < C.max_height:
        return None
    (place, face), (other, later) = [face_at(height, *it, eye) for it in zip(pixels, poses)]
    is_part = (np.hypot(*(place - other)) < C.max_error and same_size(face.sides, later.sides)
               and max(face.misfit, later.misfit) < PERCEPTION.misfit and (can_be_round or not face.is_round)
               and min(face.sides) > C.min_side)
    form = "disc" if face.is_round else "block"
    return Block(color, np.append(face.sides, 0), np.append(place, height), 0.0, form=form) if is_part else None


def face_at(height, pixels, pose, eye):
    """Returns where pixels are in the frame of an object at a pose, if they are at a height above its center,
    and their Face."""
    yaw = math.radians(pose[5])
    face = fit_face(*onto_plane(*pixels, eye, pose[2] + height), yaw)
    return rotated(face.center - pose[:2], -yaw), face
