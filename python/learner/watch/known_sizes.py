"""Colors of blocks that never stand by themselves: those of tops that have a known size."""

import numpy as np

from constants import PERCEPTION, WATCHING as C
from watch.palette import UNKNOWN
from see.colors import is_darker_shade
from see.eye import onto_plane
from see.faces import fit_face
from watch.watched_pictures import areas_in, colors_of


def kinds_of_known_size(codes, palette, kinds, tried, eye):
    """Yields the color and the size of each area of another color that may be the top of a block of a known size, at
    a height at which such blocks may be.

    tried: what previous pictures showed, which grows: most does not change
    """
    for code, row, column in unknown_areas(codes, palette.classes(codes) == UNKNOWN, tried):
        color = colors_of(code)
        if has_side_below(color, row, column, codes):
            size = known_size_of(row, column, kinds, eye)
            if size is not None:
                yield color, size


def unknown_areas(codes, mask, tried):
    """Yields the connected areas of one color in a mask that may be tops: code, rows and columns."""
    row, column = np.nonzero(mask)
    order = np.argsort(codes[row, column], kind="stable")
    row, column = row[order], column[order]
    shown, begin, often = np.unique(codes[row, column], return_index=True, return_counts=True)
    for code, first, count in zip(shown, begin, often):
        seen = int(code), int(count), int(row[first]), int(column[first])
        if count < PERCEPTION.min_unknown_object_pixels or seen in tried:
            continue
        tried.add(seen)
        own = np.s_[first:first + count]
        low = row[own].min(), column[own].min()
        part = np.zeros((row[own].max() + 1 - low[0], column[own].max() + 1 - low[1]), bool)
        part[row[own] - low[0], column[own] - low[1]] = True
        for pixels in areas_in(part, PERCEPTION.min_unknown_object_pixels):
            yield code, pixels[0] + low[0], pixels[1] + low[1]


def has_side_below(color, row, column, codes):
    """Returns true if a darker shade of a color is visible below most of an area."""
    lowest = np.full(codes.shape[1], -1)
    np.maximum.at(lowest, column, row)
    below = np.flatnonzero((lowest >= 0) & (lowest + 1 < codes.shape[0]))
    shades = colors_of(codes[lowest[below] + 1, below])
    return len(below) > 0 and is_darker_shade(shades, color).mean() > C.min_shaded


def known_size_of(row, column, kinds, eye):
    """Returns the known size that a top has at one of the heights at which it may be; None if it has none."""
    layers = np.arange(PERCEPTION.max_layers)
    best, size = C.max_side_error, None
    for kind in kinds:
        for bottom in np.unique([k * it.size[2] for k in layers for it in kinds]):
            face = fit_face(*onto_plane(row, column, eye, bottom + kind.size[2]))
            sides = np.sort(face.sides)[::-1]
            error = max(*np.abs(sides / kind.size[:2] - 1), face.misfit)
            if error < best and not face.is_round:
                best, size = error, kind.size
    return size
