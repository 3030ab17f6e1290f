"""Measures the objects of a demonstration in its pictures."""

import math

import numpy as np

from blocks import Block
from colors import color_mask
from constants import PERCEPTION, TASK_MODEL as C
from demonstration import read_picture
from eye import onto_plane, pixel_at
from faces import fit_face
from regions import label_regions
from steps import stands_on


def measure_objects(demo, needed):
    """Measures the appearance of the objects of a demonstration in its pictures: the texts contain
    the pose of each object in each picture, so its top can be found there. An object began on the
    table or on a lower one; its height is twice the distance of its middle from there.

    Returns a dict: number -> color, 3 numbers from 0 to 1, and size along its own x, y and z axes
    [units]. Objects that are not among the needed ones are left out if no picture shows them.
    """
    appearances = {}
    at_start = []  # those measured so far, as Blocks at their first places
    pictures = {}  # cache
    for n in sorted(range(len(demo.ids)), key=lambda n: demo.moves[n][0, 3]):
        found = measure_object(demo, n, at_start, pictures)
        if found:
            appearances[n] = found.color, found.size
            at_start.append(found)
        elif n in needed:
            raise ValueError(f"no picture of the demonstration shows {demo.ids[n]} entirely")
    return appearances


def measure_object(demo, n, lower, pictures):
    """Measures an object in the first frame that shows it entirely. Returns it as a Block at its
    first place, or None.

    lower:    Blocks that it may have stood on at the start
    pictures: cache
    """
    _, *start, degrees = demo.moves[n][0][[0, 1, 2, 3, 6]]
    frames = select_frames(demo, n)
    # A lower block may be below: of a stack, the top of the whole could be that of a high block.
    for bottom in sorted({0.0, *(it.top for it in lower if it.top < start[2])}, reverse=True):
        height = 2 * (start[2] - bottom)
        for frame, *pose in frames:
            if frame not in pictures:
                pictures[frame] = read_picture(demo, frame)
            top = measure_top(pictures[frame], demo.eye, np.array(pose), height)
            if not top:
                continue
            color, sides = top
            block = Block(color, np.append(sides, height), np.array(start), math.radians(degrees))
            if bottom == 0 or any(stands_on(block, it) for it in lower):
                return block
    return None


def select_frames(demo, n):
    """Returns the frames in which an object may be entirely visible, with its pose, in rows as of
    demo.moves: its first, those where it was highest, and some in which others were moved, which
    may have covered it before."""
    moves = demo.moves[n]
    highest = np.argsort(-moves[:, 3], kind="stable")[:C.num_highest_frames]
    frames = np.unique(np.concatenate([rows[:, 0] for rows in demo.moves]))
    chosen = np.arange(C.num_other_frames) * (len(frames) - 1) // (C.num_other_frames - 1)
    others = [[frame, *moves[moves[:, 0] <= frame][-1, 1:]] for frame in frames[chosen]
              if frame >= moves[0, 0]]
    return np.array([moves[0], *moves[highest], *others])


def measure_top(picture, eye, pose, height):
    """Measures the top of an upright object: its color, and its sides along the object's x and y
    axes [units]; None if it is not entirely visible.

    pose: x y z of its center [units], angles about x, y, z [degrees]
    """
    top = pose[:3] + [0, 0, height / 2]
    pixel = pixel_at(picture, eye, top) if picture is not None else None
    if pixel is None:
        return None
    color = picture[pixel]
    number = label_regions(color_mask(picture, color))
    row, column = np.nonzero(number == number[pixel])
    face = fit_face(*onto_plane(row, column, eye, top[2]), math.radians(pose[5]))
    off = np.hypot(*(face.center - top[:2]))
    is_whole = off < C.max_center_error and face.misfit < PERCEPTION.misfit
    return (color, face.sides) if is_whole else None
