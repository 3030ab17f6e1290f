"""Rectangles in a plane, fitted to pixels by their moments."""

import math
from dataclasses import dataclass

import numpy as np

from constants import PERCEPTION as C


@dataclass
class Face:
    """A rectangle in a plane."""

    center: np.ndarray  # x y [units]
    yaw: float  # of its first side [rad]
    sides: np.ndarray  # lengths along the direction of yaw, and across it [units]
    misfit: float  # relative difference between the area of its pixels and that of the rectangle


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
    # The variance of the points of a rectangle along a side is the side squared, divided by 12.
    sides = np.sqrt(12 * np.array([(along**2 * area).sum(), (across**2 * area).sum()]) / total)
    return Face(center, yaw, sides, abs(sides.prod() / total - 1))


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
