"""Tops of blocks, of which something may hide a part."""

import math
from itertools import product

import numpy as np

from constants import PERCEPTION, WATCHING as C
from see.eye import pixels_in_view
from see.faces import Face
from things.blocks import Block
from watch.silhouettes import corners_of, fill


def is_whole(row, column, solid):
    """Returns true if pixels are surrounded by what they hide, so that nothing hides any of them."""
    if at_border(row, column, solid.shape):
        return False
    top, left = row.min() - 1, column.min() - 1
    own = np.zeros((row.max() + 2 - top, column.max() + 2 - left), bool)
    own[row - top, column - left] = True
    around = np.zeros(own.shape, bool)
    around[1:] |= own[:-1]
    around[:-1] |= own[1:]
    around[:, 1:] |= own[:, :-1]
    around[:, :-1] |= own[:, 1:]
    solid = solid[top:row.max() + 2, left:column.max() + 2]
    return np.count_nonzero(around & ~own & ~solid) < PERCEPTION.min_cut_pixels


def at_border(row, column, shape):
    """Returns true if pixels reach the border of the picture."""
    return min(row.min(), column.min()) == 0 or row.max() + 1 == shape[0] or column.max() + 1 == shape[1]


def whole_faces(face, size):
    """Returns a Face with the sides of a size, the longer one first, in a list; none if it has others."""
    if face.sides[0] < face.sides[1]:
        face = Face(face.center, face.yaw + math.pi / 2, face.sides[::-1], face.misfit, face.is_round)
    error = max(*np.abs(face.sides / size[:2] - 1), face.misfit)
    return [face] if error < C.max_side_error and not face.is_round else []


def ends_of_rows(row, column):
    """Returns the numbers of the pixels at the ends of their rows and columns."""
    ends = []
    for one, other in ((row, column), (column, row)):
        order = np.lexsort((other, one))
        first = np.flatnonzero(np.diff(one[order], prepend=-1))
        ends += [order[first], order[np.append(first[1:] - 1, len(order) - 1)]]
    return np.unique(np.concatenate(ends))


def faces_with(around, size, seen):
    """Returns the Faces of a size that contain a smaller one and share a border with it in each direction.

    seen: how much of the top is visible: if it is little, one side must be visible entirely
    """
    faces = []
    for quarter in (0, 1) if size[0] / size[1] > 1 + C.same_kind else (0,):
        sides = np.roll(size[:2], quarter)
        missing = sides - around.sides
        is_long = (missing < C.max_missing).any()
        if (missing < -C.max_side_error * sides).any() or not is_long and seen < C.min_seen_edge:
            continue
        shifts = [[0.0] if abs(it) < C.max_missing else [-it / 2, it / 2] for it in missing]
        c, s = math.cos(around.yaw), math.sin(around.yaw)
        for along, across in product(*shifts):
            center = around.center + [along * c - across * s, along * s + across * c]
            faces.append(Face(center, around.yaw + quarter * math.pi / 2, size[:2], 0.0))
    return faces


def is_free(face, top, solid, eye):
    """Returns true if almost no pixel of a face at a height shows what it would hide."""
    block = Block(None, np.append(face.sides, 0.0), np.append(face.center, top), face.yaw)
    row, column = fill(pixels_in_view(corners_of(block)[:4], eye), solid.shape)
    return len(row) > 0 and solid[row, column].mean() < C.max_solid
