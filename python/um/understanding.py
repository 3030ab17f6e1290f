"""From a recording to the steps of what was done in it."""

import math
from itertools import product

import numpy as np

from blocks import Container, Step, same_size
from constants import BLOCKS, SEE, UNDERSTAND
from demonstration import read_picture
from looking import (colors_of, describe_face, find_outlines, is_color, label_regions, onto_plane,
                     pixel_at)
from places import footprint, is_inside, overlap


def understand(demo, attention):
    """What was done, as a list of steps in the order shown, one for each object that takes part,
    and the Container that some of them were put into, or None.

    attention: which properties of objects the demonstrator said to matter, as in aux.
    """
    steps = []
    pictures = {}  # those already read
    for n in taking_part(demo):
        name = demo.ids[n]
        if was_drawn(demo.moves[n]):
            steps.append(measure_handle(demo, n))
            continue
        color, size = measure_object(demo, n, pictures)
        if not color_matters(attention, name):
            color = None
        _, x, y, z, _, _, degrees = demo.moves[n][-1]
        yaw = math.radians(degrees)
        if size[1] > BLOCKS.equal_sides * size[0]:
            size = size[[1, 0, 2]]
            yaw += math.pi / 2
        step = Step(color, size, np.array([x, y, z]), yaw, name, [])
        step.on = [k for k, lower in enumerate(steps) if stands_on(step, lower)]
        steps.append(step)
    return steps, measure_container(demo, steps)


def taking_part(demo):
    """Numbers of the objects that take part, in the order of building: first what was not moved but
    has something on it, then what was, in the order in which it was let go for the last time."""
    last = {n: when for when, n in enumerate(demo.placed)}
    moved = sorted(last, key=last.get)
    if not moved:
        raise ValueError("in this demonstration no hand moved anything")
    final = np.array([rows[-1, 1:4] for rows in demo.moves])
    below = []
    for n in range(len(demo.ids)):
        gap = final[moved] - final[n]
        least, most = UNDERSTAND.carried_heights
        is_above = np.hypot(gap[:, 0], gap[:, 1]) < UNDERSTAND.carried_distance
        carries = (gap[:, 2] > least) & (gap[:, 2] < most) & is_above
        if n not in moved and carries.any():
            below.append(n)
    return below + moved


def measure_object(demo, n, pictures):
    """What an object of the demonstration looks like, from its pictures: the log tells where each
    object is in each picture, so its top can be found there.

    Returns its color, 3 numbers from 0 to 1, and its size along its own x, y and z axes [units].
    """
    height = 2 * demo.moves[n][0, 3]  # it began on the table
    for frame, *pose in worth_looking(demo.moves[n]):
        if frame not in pictures:
            pictures[frame] = read_picture(demo, frame)
        top = measure_top(pictures[frame], demo.eye, np.array(pose), height)
        if top:
            color, sides = top
            return color, np.append(sides, height)
    raise ValueError(f"no picture of the demonstration shows {demo.ids[n]} well enough to tell "
                     "what it is")


def worth_looking(moves):
    """Moves of an object after which it may be seen as a whole: at the beginning, and where it was
    highest."""
    highest = np.argsort(-moves[:, 3], kind="stable")[:UNDERSTAND.highest_frames]
    return moves[[0, *highest]]


def measure_top(picture, eye, pose, height):
    """The color of the top of an upright object, and how long it is along the object's x and y
    axes; None if it is not seen as a whole.

    pose: x y z of its centre [units], angles about x, y, z [degrees]
    """
    top = pose[:3] + [0, 0, height / 2]
    spot = pixel_at(picture, eye, top) if picture is not None else None
    if spot is None:
        return None
    color = picture[spot]
    number = label_regions(is_color(picture, color))
    row, column = np.nonzero(number == number[spot])
    face = describe_face(*onto_plane(row, column, eye, top[2]), math.radians(pose[5]))
    off = np.hypot(*(face.center - top[:2]))
    is_whole = off < UNDERSTAND.center_error and face.misfit < SEE.misfit
    return (color, face.sides) if is_whole else None


def was_drawn(moves):
    """Whether an object was only drawn along, like a door, and never lifted or turned."""
    way = np.hypot(*(moves[-1, 1:3] - moves[0, 1:3]))
    wobble = np.abs(moves[:, 3:] - moves[0, 3:]).max()
    return way > UNDERSTAND.drawn_distance and wobble < UNDERSTAND.drawn_wobble


def measure_handle(demo, n):
    """What object n of a demonstration can be drawn by, as a Step: the highest flat top that went
    the same way as the object. The nearer to the eye something is, the farther it goes in the
    picture; so the way in the picture tells how high it is."""
    moves = demo.moves[n]
    pictures = [read_picture(demo, moves[i, 0]) for i in (0, -1)]
    way = moves[-1, 1:3] - moves[0, 1:3]
    eye_height = demo.eye.pose[2, 3]
    step = None
    is_seen = all(picture is not None for picture in pictures)
    for color in colors_of(pictures[0]) if is_seen else []:
        masks = [is_color(picture, color) for picture in pictures]
        for before, after in product(regions_left(*masks), regions_left(*masks[::-1])):
            def centers(height):
                faces = [describe_face(*onto_plane(*pixels, demo.eye, height))
                         for pixels in (before, after)]
                return faces, faces[1].center - faces[0].center

            _, on_table = centers(0)
            height = eye_height * (1 - (way @ way) / (way @ on_table))
            if not UNDERSTAND.handle_height < height < eye_height / 2:
                continue
            (face, later), gone = centers(height)
            if (np.hypot(*(gone - way)) < UNDERSTAND.handle_error and face.misfit < SEE.misfit
                    and same_size(face.sides, later.sides)
                    and (step is None or height > step.top)):
                step = Step(color, np.append(face.sides, height),
                            np.append(face.center, height / 2), face.yaw, demo.ids[n], [], way)
    if step is None:
        raise ValueError(f"no picture of the demonstration shows by what {demo.ids[n]} was drawn")
    return step


def regions_left(mask, other):
    """The connected pixels of a mask that are mostly not in another one: a list of rows and
    columns."""
    number = label_regions(mask)
    left = []
    for region in np.flatnonzero(np.bincount(number.ravel()) >= SEE.top_pixels):
        if region and other[number == region].mean() < UNDERSTAND.left_behind:
            left.append(np.nonzero(number == region))
    return left


def measure_container(demo, steps):
    """The open box that steps' blocks were put into, from the first picture of the demonstration;
    None if all of them stand on the table or on each other."""
    inside = [step for step in steps
              if step.bottom > UNDERSTAND.inside_bottom and not step.on and step.way is None]
    if not inside:
        return None
    for n, moves in enumerate(demo.moves):
        if n in demo.placed:
            continue
        frame, x, y, z = moves[0, :4]
        height = 2 * z  # it stands on the table
        picture = read_picture(demo, frame)
        spot = pixel_at(picture, demo.eye, [x, y, height]) if picture is not None else None
        if spot is None:
            continue
        for face in find_outlines(picture, demo.eye, picture[spot], height):
            container = Container(picture[spot], np.append(face.sides, height),
                                  np.append(face.center, z), face.yaw, demo.ids[n],
                                  min(step.bottom for step in inside))
            is_there = np.hypot(*(face.center - [x, y])) < UNDERSTAND.container_error
            if is_there and all(is_inside(container, step.position) for step in inside):
                return container
    raise ValueError(f"no picture of the demonstration shows what {inside[0].name} was put into")


def stands_on(upper, lower):
    gap = upper.bottom - lower.top
    [one] = footprint([upper], 0)
    return abs(gap) < UNDERSTAND.standing_gap and overlap(one, footprint([lower], 0)).any()


def color_matters(attention, name):
    """The demonstrator may have told which properties of an object matter; who tells nothing means
    all."""
    return "color" in (attention.get(name) or ["color"])
