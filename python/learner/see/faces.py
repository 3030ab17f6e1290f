"""Rectangles and discs in a plane, fitted to pixels by their moments."""

import math
from dataclasses import dataclass

import numpy as np

from constants import PERCEPTION as C


@dataclass
class Face:
    """A rectangle or a disc in a plane."""

    center: np.ndarray  # x y [units]
    yaw: float  # of its first side [rad]
    sides: np.ndarray  # lengths along the direction of yaw, and across it [units]
    misfit: float  # relative difference between the area of its pixels and that of the face
    is_round: bool = False  # true for a disc, whose sides are its diameter, twice


def fit_face(x, y, area, yaw=None):
    """Fits a Face to small pieces of it, by their moments: their positions and areas, N numbers
    each [units, units squared]. Its yaw is estimated unless given [rad]."""
    total = area.sum()
    center = np.array([(x * area).sum(), (y * area).sum()]) / total
    x = x - center[0]
    y = y - center[1]
    if yaw is None:
        yaw = yaw_of(x, y, area)
    along = x * math.cos(yaw) + y * math.sin(yaw)
    across = y * math.cos(yaw) - x * math.sin(yaw)
    variances = np.array([(along**2 * area).sum(), (across**2 * area).sum()]) / total
    # The variance of the points of a disc along a line is the diameter squared, divided by 16.
    if is_round(x, y, area):
        sides = np.sqrt(16 * variances)
        return Face(center, yaw, sides, abs(math.pi / 4 * sides.prod() / total - 1), True)
    # The variance of the points of a rectangle along a side is the side squared, divided by 12.
    sides = np.sqrt(12 * variances)
    return Face(center, yaw, sides, abs(sides.prod() / total - 1))


def is_round(x, y, area):
    """Returns true if neither the squares nor the fourth powers of points around the origin have a
    direction, as complex numbers: see yaw_of. Of a square, the fourth powers keep 3/7 of it."""
    z = x + 1j * y
    return all(abs((area * z**power).sum()) < C.round * (area * abs(z) ** power).sum()
               for power in (2, 4))


def is_polygon(x, y, area):
    """Returns true if the fifth or sixth powers of points have a direction from their middle: those of a regular pentagon keep
    0.31 of it, those of a hexagon 0.24."""
    z = x + 1j * y - (area * (x + 1j * y)).sum() / area.sum()
    return any(abs((area * z**power).sum()) > C.corners * (area * abs(z) ** power).sum() for power in (5, 6))


def yaw_of(x, y, area):
    """Estimates the yaw of a rectangle around the origin [rad].

    Multiplying complex numbers adds their angles: the squares of the points of an elongated
    rectangle point about the same way, at twice its yaw.
    """
    z = x + 1j * y
    direction = (area * z**2).sum()
    spread = (area * abs(z) ** 2).sum()
    if abs(direction) > C.elongated * spread:
        return float(np.angle(direction)) / 2
    # A square has no long side; its fourth powers have a direction. The corners are farthest out
    # and weigh most; at yaw 0 they lie at 45 degrees, and four times that is 180, hence the minus.
    return float(np.angle(-(area * z**4).sum())) / 4
