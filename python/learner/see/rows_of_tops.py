"""Tops of blocks that touch in rows, within one region of a color."""

import math

import numpy as np

from constants import PERCEPTION as C
from things.blocks import Block


def candidate_tops(size, bottoms, top, is_expected):
    """Returns the heights at which the top of a block may be [units], a list: its measured height,
    or, if there is none, those at which its bottom is expected.

    is_expected: whether to return the heights with an expected bottom, or the others
    """
    if top is None:
        return [size[2] + bottom for bottom in bottoms] if is_expected else []
    error = np.abs(top - size[2] - bottoms).min()
    is_above_table = top - size[2] > -C.on_table
    return [top] if (error < C.on_table) == is_expected and is_above_table else []


def block_grid(face, count, top, color, kind):
    """Returns count[0] x count[1] equal Blocks of a kind that fill a Face at height `top` [units]: a list."""
    along = np.array([math.cos(face.yaw), math.sin(face.yaw)])
    across = np.array([-along[1], along[0]])
    size = kind.size
    blocks = []
    for i in np.arange(count[0]) - (count[0] - 1) / 2:
        for j in np.arange(count[1]) - (count[1] - 1) / 2:
            at = face.center + i * size[0] * along + j * size[1] * across
            blocks.append(Block(color, size, np.append(at, top - size[2] / 2), face.yaw,
                                form=kind.form))
    return blocks
