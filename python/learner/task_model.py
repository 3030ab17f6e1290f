"""Infers from a demonstration what is to be done."""

import math
from dataclasses import dataclass, replace
from itertools import product
from typing import Optional

import numpy as np

from blocks import Block, same_size
from clearance import footprint, is_inside, overlap
from colors import color_mask, frequent_colors
from constants import BLOCKS, PERCEPTION, TASK_MODEL as C
from containers import detect_rims
from demonstration import read_picture
from eye import onto_plane, pixel_at
from faces import fit_face
from regions import label_regions


@dataclass(eq=False)
class Step(Block):
    """A block at its place in the finished building. Its color is None where that does not
    matter."""

    name: str  # of the object in the demonstration, for messages
    on: list  # numbers of the steps that it stands on; empty for the table
    displacement: Optional[np.ndarray] = None  # x y [units] of a dragged object, whose color and
    #                                            size are those of its handle
    stays: bool = False  # true for an object that the demonstration did not move

    def __str__(self):
        return "%s (%.3g x %.3g x %.3g)" % (self.name, *self.size)


@dataclass(eq=False)
class Container(Block):
    """An open box that blocks were put into."""

    name: str  # of the object in the demonstration, for messages
    floor: float  # height of its floor above the table [units]


def is_dragged(goal):
    """Returns true if a goal (a Step or a Block) is for an object that is dragged there, not
    carried."""
    return getattr(goal, "displacement", None) is not None


def infer_task(demo, attention):
    """Returns a list of Steps in the order shown, one for each object that takes part, and the
    Container that some of them were put into, or None. Objects that were not moved but support
    others come first.

    attention: the properties of objects that matter, if the demonstrator specified some, as in aux
    """
    moved = moved_objects(demo)
    carried = [n for n in moved if not was_dragged(demo.moves[n])]
    appearances = demo.appearances = measure_objects(demo, carried)
    placed = [step_of(demo, n, appearances[n], attention) if n in carried
              else measure_handle(demo, n) for n in moved]
    steps = supports_of(placed, [
        replace(step_of(demo, n, appearances[n], attention), stays=True)
        for n in range(len(demo.ids)) if n in appearances and n not in moved]) + placed
    for k, step in enumerate(steps):
        step.on = [i for i, lower in enumerate(steps[:k]) if stands_on(step, lower)]
    return steps, measure_container(demo, steps)


def moved_objects(demo):
    """Returns the numbers of the objects that hands moved, in the order of their last release."""
    last = {n: when for when, n in enumerate(demo.placed)}
    if not last:
        raise ValueError("in this demonstration no hand moved anything")
    return sorted(last, key=last.get)


def supports_of(steps, others):
    """Returns those of some other steps on which steps stand at the end, directly or on others: a
    list, the lowest first."""
    found = []
    upper = list(steps)
    while upper:
        step = upper.pop()
        below = [it for it in others if it not in found and stands_on(step, it)]
        found += below
        upper += below
    return sorted(found, key=lambda step: (step.position[2], others.index(step)))


def step_of(demo, n, appearance, attention):
    """Returns the Step of a carried object, at its final place; appearance: color and size along
    its own axes."""
    color, size = appearance
    _, x, y, z, _, _, degrees = demo.moves[n][-1]
    yaw = math.radians(degrees)
    if size[1] > BLOCKS.equal_sides * size[0]:
        size = size[[1, 0, 2]]
        yaw += math.pi / 2
    if not color_matters(attention, demo.ids[n]):
        color = None
    return Step(color, size, np.array([x, y, z]), yaw, demo.ids[n], [])


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


def was_dragged(moves):
    """Returns true if an object was only dragged, like a door, and never lifted or rotated."""
    distance = np.hypot(*(moves[-1, 1:3] - moves[0, 1:3]))
    deviation = np.abs(moves[:, 3:] - moves[0, 3:]).max()
    return distance > C.min_drag_distance and deviation < C.max_drag_deviation


def measure_handle(demo, n):
    """Measures the handle by which object n of a demonstration was dragged, as a Step: the highest
    flat top with the same displacement as the object. The closer to the eye a top is, the farther
    it moves in the picture; so its displacement in the picture determines its height."""
    moves = demo.moves[n]
    pictures = [read_picture(demo, moves[i, 0]) for i in (0, -1)]
    displacement = moves[-1, 1:3] - moves[0, 1:3]
    eye_height = demo.eye.pose[2, 3]
    step = None
    has_pictures = all(picture is not None for picture in pictures)
    for color in frequent_colors(pictures[0]) if has_pictures else []:
        masks = [color_mask(picture, color) for picture in pictures]
        for before, after in product(displaced_regions(*masks), displaced_regions(*masks[::-1])):
            def centers(height):
                faces = [fit_face(*onto_plane(*pixels, demo.eye, height))
                         for pixels in (before, after)]
                return faces, faces[1].center - faces[0].center

            _, on_table = centers(0)
            height = eye_height * (1 - (displacement @ displacement) / (displacement @ on_table))
            if not C.min_handle_height < height < eye_height / 2:
                continue
            (face, later), moved = centers(height)
            if (np.hypot(*(moved - displacement)) < C.max_handle_error
                    and face.misfit < PERCEPTION.misfit and same_size(face.sides, later.sides)
                    and (step is None or height > step.top)):
                step = Step(color, np.append(face.sides, height),
                            np.append(face.center, height / 2), face.yaw, demo.ids[n], [],
                            displacement)
    if step is None:
        raise ValueError(f"no picture of the demonstration shows the handle of {demo.ids[n]}")
    return step


def displaced_regions(mask, other):
    """Returns the connected regions of a mask that are mostly outside another mask: a list of rows
    and columns."""
    number = label_regions(mask)
    displaced = []
    for region in np.flatnonzero(np.bincount(number.ravel()) >= PERCEPTION.min_top_pixels):
        if region and other[number == region].mean() < C.max_remaining_fraction:
            displaced.append(np.nonzero(number == region))
    return displaced


def measure_container(demo, steps):
    """Measures the open box that the blocks of steps were put into, in the first picture of the
    demonstration; None if all of them stand on the table or on each other."""
    inside = [step for step in steps
              if step.bottom > C.min_inside_bottom and not step.on and step.displacement is None]
    if not inside:
        return None
    for n, moves in enumerate(demo.moves):
        if n in demo.placed:
            continue
        frame, x, y, z = moves[0, :4]
        height = 2 * z  # it stands on the table
        picture = read_picture(demo, frame)
        pixel = pixel_at(picture, demo.eye, [x, y, height]) if picture is not None else None
        if pixel is None:
            continue
        for face in detect_rims(picture, demo.eye, picture[pixel], height):
            container = Container(picture[pixel], np.append(face.sides, height),
                                  np.append(face.center, z), face.yaw, demo.ids[n],
                                  min(step.bottom for step in inside))
            is_there = np.hypot(*(face.center - [x, y])) < C.max_container_error
            if is_there and all(is_inside(container, step.position) for step in inside):
                return container
    raise ValueError(f"no picture of the demonstration shows the container of {inside[0].name}")


def stands_on(upper, lower):
    """Returns true if the bottom of a block touches the top of another one."""
    gap = upper.bottom - lower.top
    [one] = footprint([upper], 0)
    return abs(gap) < C.max_support_gap and overlap(one, footprint([lower], 0)).any()


def color_matters(attention, name):
    """Returns true unless the demonstrator specified the properties of an object that matter,
    without color."""
    return "color" in (attention.get(name) or ["color"])
