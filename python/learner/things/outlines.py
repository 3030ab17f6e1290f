"""Outlines: tops of any one shape, such as triangles, crosses, rings and Ls, described by complex moments.

Multiplying complex numbers adds their angles: the k-th powers of points around their middle have a direction, which turns
k times as fast as the shape. See J. Flusser, "On the independence of rotation moment invariants" (2000).
"""

import math
from dataclasses import dataclass

import numpy as np

from constants import OUTLINES as C


@dataclass(eq=False)
class Outline:
    """The shape of a top, in the frame of its object: x and y from the object's center [units]."""

    center: np.ndarray  # x y of its middle [units]
    area: float  # [units squared]
    spread: float  # root of the mean squared distance from its middle [units]
    moments: np.ndarray  # means of the powers C.powers, relative to those of the distances, complex
    inside: np.ndarray = None  # some points well inside, Nx2 [units]

    @property
    def fold(self):
        """Number of turns after which it looks the same in one full turn; 0 for all of them."""
        strong = [k for k, it in zip(C.powers, self.moments) if abs(it) > C.symmetric]
        return math.gcd(*strong)


def outline_of(x, y, area):
    """Returns the Outline of small pieces of a top: their places in the frame of the object and their areas, N numbers each
    [units, units squared]."""
    total = area.sum()
    center = np.array([(x * area).sum(), (y * area).sum()]) / total
    z = x - center[0] + 1j * (y - center[1])
    moments = np.array([(area * z**k).sum() / (area * abs(z) ** k).sum() for k in C.powers])
    return Outline(center, total, math.sqrt((area * abs(z) ** 2).sum() / total), moments)


def outline_fit(outline, found):
    """Returns the rotation of an outline that makes another one of it [rad], and how much they differ then, as a fraction."""
    size = max(abs(found.spread / outline.spread - 1), abs(math.sqrt(found.area / outline.area) - 1))
    turns, powers = [0.0], np.array(C.powers)
    if outline.fold:
        strongest = int(np.argmax(abs(outline.moments)))
        k = C.powers[strongest]
        first = np.angle(found.moments[strongest] / outline.moments[strongest]) / k
        turns = [math.remainder(first + 2 * math.pi * j / k, 2 * math.pi) for j in range(k)]
    misfits = [max(size, *abs(found.moments * np.exp(-1j * powers * turn) - outline.moments)) for turn in turns]
    # Of those that are equal within the accuracy of pictures, the first.
    best = next(j for j, it in enumerate(misfits) if it < min(misfits) + C.equal)
    return turns[best], misfits[best]


def same_outline(one, other):
    """Returns true if two outlines, or None, are equal in the frames of their objects."""
    if one is None or other is None or one is other:
        return one is other
    is_there = np.hypot(*(one.center - other.center)) < C.max_center_error
    turn, misfit = outline_fit(one, other)
    turn = math.remainder(turn, 2 * math.pi / one.fold) if one.fold else 0
    return is_there and misfit < C.misfit and abs(turn) < C.max_turn_rad


def points_inside(x, y):
    """Returns some points, Nx2, that are well inside a shape: of the cells that its points fill, some of those with all neighbors
    filled, if there are any.

    x, y: points of the shape, N numbers each [units]
    """
    cells = np.unique(np.floor(np.column_stack([x, y]) / C.cell).astype(int), axis=0)
    filled = set(map(tuple, cells.tolist()))
    inner = [(i, j) for i, j in filled
             if all((i + a, j + b) in filled for a in (-1, 0, 1) for b in (-1, 0, 1))]
    chosen = sorted(inner or filled)
    order = [math.floor(it * (len(chosen) - 1) + 0.5) for it in C.fractions]
    return (np.array(chosen)[order] + 0.5) * C.cell
