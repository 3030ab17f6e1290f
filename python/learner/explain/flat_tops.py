"""Measures objects by the one flat top that shows them, wherever its height and whatever they stood on."""

import math

import numpy as np

from constants import PARTS, TASK_MODEL as C
from explain.part_measuring import parts_between
from explain.shown_pictures import picture_frames, read_picture
from see.colors import color_mask, is_below_brighter
from see.eye import pixel_at
from see.regions import label_regions
from things.blocks import Block
from things.kinds import same_color, same_size


def measure_flat_top(demo, n, others):
    """Measures a carried object that began inside or on something unknown: its flat top of one color, in the last
    picture before a hand took it and in those in which it was held high. How far it moves in the picture tells its
    height; what stands upright, like a side, seems to be elsewhere in each picture. Returns the object as a Block
    around its center, as high below it as above, at its first place; None if no picture shows it.

    others: Blocks that are measured already
    """
    moves = demo.moves[n]
    taken = [frame for frame, word, fields in demo.events if word == "grasp" and fields[1] == demo.ids[n]]
    earlier = [it for it in picture_frames(demo) if taken and it < taken[0]]
    tops = []
    for row in moves[np.argsort(-moves[:, 3], kind="stable")[:C.num_highest_frames]] if earlier else []:
        later = read_picture(demo, row[0])
        if later is not None:
            # Where it is held high, closer to the eye, its sides have more pixels.
            views = (later, row[1:]), (read_picture(demo, earlier[-1]), moves[0, 1:])
            tops += parts_between(*views, demo.eye, can_be_round=True)
    groups = [[it for it in tops if is_same_top(it, one)] for one in tops]
    if not groups:
        return None
    most = max(len(it) for it in groups)
    group = max((it for it in groups if 2 * len(it) > most), key=lambda it: it[0].position[2])
    size = np.median([[*it.size[:2], 2 * it.position[2]] for it in group], axis=0)
    # Two things that are almost of the same size are alike.
    size = next((it.size.copy() for it in others if same_size(size, it.size)), size)
    return Block(group[0].color, size, moves[0, 1:4], math.radians(moves[0, 6]), form=group[0].form)


def is_same_top(one, other):
    """Returns true if two parts may be one, seen in different pictures."""
    return (same_color(one.color, other.color) and one.form == other.form
            and np.linalg.norm(one.position - other.position) < PARTS.same_place)


def is_side_at(picture, eye, point):
    """Returns true if what a picture shows at a point, x y z, is a side of what rises above it."""
    pixel = pixel_at(picture, eye, point)
    number = label_regions(color_mask(picture, picture[pixel]))
    codes = np.round(255 * picture).astype(int) @ [65536, 256, 1]
    return is_below_brighter(picture[pixel], codes, *np.nonzero(number == number[pixel]))
