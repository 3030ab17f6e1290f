"""Fits blocks to a top face."""

import numpy as np

from constants import PERCEPTION as C
from see.eye import onto_plane
from see.faces import fit_face
from see.rows_of_tops import block_grid, candidate_tops
from things.areas import container_at


def fit_blocks(row, column, eye, color, kinds, containers, is_possible, bottoms, top=None,
               max_side_error=C.max_side_error):
    """Fits blocks to the pixels of a top face: one block of a color and one of some kinds, or equal
    blocks that touch in a row or a grid. Returns a list, empty if nothing fits.

    row, column: pixels, N numbers each
    containers:  in which they may lie
    is_possible: predicate: returns true if there can be such a Block at its place
    bottoms:     for each kind, the heights where the bottom is expected [units]
    top:         measured height of the face [units], or None
    max_side_error: greatest relative error of the sides

    On a lower plane the same pixels would be a larger top, on a higher one a smaller. Without a
    measured height, the plane is the one of the expected ones at which the size of the top is
    right. Inside a container, all planes are higher by its floor. With a measured height, blocks
    whose bottom would be where it is expected are preferred: the size of the top alone does not
    distinguish a high block from a low one on a support.
    """
    best = max_side_error
    blocks = []
    for max_count, is_expected in ((1, True), (1, False), (C.max_abreast, True),
                                   (C.max_abreast, False)):  # blocks side by side
        for kind, expected in zip(kinds, bottoms):
            size = kind.size
            for plane in candidate_tops(size, expected, top, is_expected):
                face = fit_face(*onto_plane(row, column, eye, plane))
                around = container_at(containers, face.center) if top is None else None
                if around:
                    plane += around.floor
                    face = fit_face(*onto_plane(row, column, eye, plane))
                if face.is_round != kind.is_round:
                    continue
                most = 1 if face.is_round else max_count
                count = np.clip(np.round(face.sides / size[:2]), 1, most)
                max_error = max(*np.abs(face.sides / (count * size[:2]) - 1), face.misfit)
                if max_error >= best:
                    continue
                found = block_grid(face, count.astype(int), plane, color, kind)
                if top is not None and is_expected or all(map(is_possible, found)):
                    best = max_error
                    blocks = found
        if blocks:
            break
    return blocks
