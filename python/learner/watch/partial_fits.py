"""Fits blocks of known kinds to tops of which something hides a part."""

import math
from dataclasses import dataclass

import numpy as np

from constants import WATCHING as C
from see.covered import smallest_rectangle
from see.eye import onto_plane
from see.faces import fit_face
from things.blocks import Block
from watch.visible_tops import ends_of_rows, faces_with, is_free, is_whole, whole_faces


@dataclass(eq=False)
class Fit:
    """A Block that may have a top of some pixels."""

    block: Block
    kind: object  # Kind
    seen: float  # area of the pixels, relative to that of its top: about 1 if nothing hides any of them
    certainty: int  # 2 if its top is entirely visible, 1 if it is so in both directions, else 0


def fit_visible(row, column, kind, bottom, solid, eye):
    """Fits a block of a kind, whose bottom is at some height, to the visible part of its top. Returns a Fit; None
    if no place fits, or more than one.

    row, column: pixels that show its top
    solid:       mask, HxW, of pixels that show what its top would hide, like the table
    """
    top = bottom + kind.size[2]
    x, y, area = onto_plane(row, column, eye, top)
    seen = area.sum() / (kind.size[0] * kind.size[1])
    if not C.min_top_seen < seen < 1 / (1 - C.max_side_error) ** 2:
        return None
    certainty = 2
    if is_whole(row, column, solid):
        faces = whole_faces(fit_face(x, y, area), kind.size)
    else:
        outline = ends_of_rows(row, column)
        around = smallest_rectangle(x[outline], y[outline], math.sqrt(np.median(area)))
        missing = kind.size[:2] - around.sides
        certainty = int(np.abs(missing).max() < C.max_missing)
        faces = [it for it in faces_with(around, kind.size, seen) if is_free(it, top, solid, eye)]
    if len(faces) != 1:
        return None
    [face] = faces
    position = np.append(face.center, top - kind.size[2] / 2)
    return Fit(Block(kind.color, kind.size, position, face.yaw), kind, seen, certainty)


def best_fit(fits):
    """Returns the Fit of the greatest certainty; None if there is none, or more than one that hides something."""
    fits = list(fits)
    most = max((it.certainty for it in fits), default=0)
    fits = [it for it in fits if it.certainty == most]
    if most == 2:
        return min(fits, key=lambda it: abs(it.seen - 1))
    return fits[0] if len(fits) == 1 else None
