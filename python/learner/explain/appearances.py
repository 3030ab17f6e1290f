"""Measures the objects of a demonstration in its pictures."""

import math
from itertools import product

import numpy as np

from explain.covered_tops import measure_covered_top, measure_top_with_knob
from explain.flat_tops import is_side_at
from explain.limits import NotUnderstood
from explain.object_roles import carried_along
from explain.other_tops import measure_other_top
from explain.part_measuring import measure_parts
from explain.shown_pictures import read_picture, select_frames
from explain.tops import measure_ball, measure_top, moves_along
from relate.dragging import has_shape
from things.blocks import Block
from things.kinds import has_parts_of
from things.standing import stands_on


def measure_objects(demo, needed):
    """Measures the appearance of the objects of a demonstration in its pictures: the texts contain the pose of each
    object in each picture, so its top can be found there. An object began on the table or on a lower one; its height
    is twice the distance of its middle from there.

    Returns a dict: number -> Block at its first place, its sides along its own axes. Objects that are not among the
    needed ones are left out if no picture shows them.
    """
    appearances = {}
    pictures = {}  # cache
    measured = [n for n in range(len(demo.ids)) if n not in carried_along(demo)]
    for n in sorted(measured, key=lambda n: demo.moves[n][0, 3]):
        found = measure_object(demo, n, list(appearances.values()), pictures)
        if found:
            appearances[n] = found
        elif n in needed:
            raise NotUnderstood(f"no picture of the demonstration shows {demo.ids[n]} entirely")
    for it in appearances.values():  # what has the same layout is as high, whatever it stood on
        it.size[2] = min(other.size[2] for other in appearances.values()
                         if other is it or has_parts_of(it, other, False))
    return appearances


def measure_object(demo, n, lower, pictures):
    """Measures an object in the first frame that shows it entirely. Returns it as a Block at its first place, or None.

    lower:    Blocks that it may have stood on at the start
    pictures: cache
    """
    _, *start, degrees = demo.moves[n][0][[0, 1, 2, 3, 6]]
    frames = select_frames(demo, n)
    for frame, *_ in frames:
        if frame not in pictures:
            pictures[frame] = read_picture(demo, frame)
    if has_shape(demo, n, "ring"):  # in its middle, its side is seen
        return measure_other_top(demo, n, lower, frames, pictures)
    # A lower block may be below: of a stack, the top of the whole could be that of a high block.
    bottoms = sorted({0.0, *(it.top for it in lower if it.top < start[2])}, reverse=True)
    # What is seen elsewhere, too, comes first: an arm at the top of what it hides stays there.
    uncertain = None
    for bottom, (frame, *pose) in product(bottoms, frames):
        height = 2 * (start[2] - bottom)
        top = measure_top(pictures[frame], demo.eye, np.array(pose), height)
        if not top:
            continue
        color, face = top
        block = Block(color, np.append(face.sides, height), np.array(start), math.radians(degrees),
                      form="disc" if face.is_round else "block")
        is_on = any(stands_on(block, it) for it in lower)
        if bottom == 0 or is_on and not is_side_at(pictures[frame], demo.eye, [*pose[:2], pose[2] + height / 2]):
            if moves_along(color, pose, frames, height, demo.eye, pictures):
                return block
            uncertain = uncertain or block
    return (uncertain or measure_ball(demo, n, np.array(start), frames, pictures)
            or measure_top_with_knob(demo, n, np.array(start), math.radians(degrees), frames, pictures)
            or measure_covered_top(demo, n, np.array(start), math.radians(degrees), pictures)
            or measure_parts(demo, n) or measure_other_top(demo, n, lower, frames, pictures))
