"""Where a flat piece of any outline is held: at places across which its sides are about parallel."""

import math
from typing import NamedTuple

import numpy as np

from constants import OUTLINES as C
from things.blocks import Block


class Grip(NamedTuple):
    """A place where the fingers may close on a piece, in its frame."""

    at: np.ndarray  # x y [units]
    yaw: float  # across the direction from finger to finger [rad]
    width: float  # between the fingers [units]
    cost: float


def grips_of(x, y, pixel, color, height):
    """Returns the parts by which a piece can be held, the best first, as Blocks in its frame: between the fingers all of the
    piece, within their width, ends on both sides. Flat ends, narrow places and those close to the center are preferred; each
    further part is elsewhere, or held from another direction.

    x, y:  points of its top in its frame, N numbers each [units]
    pixel: side of the small square that each point stands for [units]
    """
    found, grips = list(possible_grips(x, y, pixel)), []
    while found and len(grips) < C.num_grips:
        lowest = min(it.cost for it in found)
        # Of those that are equal within the accuracy of pictures, the first.
        best = next(it for it in found if it.cost < lowest + C.equal)
        grips.append(best)
        found = [it for it in found if is_other(it, best)]
    # So long that it is held across its width only.
    return [Block(color, np.array([C.bar * it.width, it.width, height]), np.append(it.at, 0), it.yaw) for it in grips]


def possible_grips(x, y, pixel):
    """Yields all Grips of a piece, see grips_of."""
    for yaw in np.arange(C.num_directions) * math.pi / C.num_directions:
        along, across = x * math.cos(yaw) + y * math.sin(yaw), y * math.cos(yaw) - x * math.sin(yaw)
        for place in C.cell * np.arange(math.ceil(along.min() / C.cell), math.floor(along.max() / C.cell) + 1):
            lows, highs = ends_at(along - place, across)
            if lows is None:
                continue
            width, middle = max(highs) - min(lows) + pixel, (max(highs) + min(lows)) / 2
            uneven = max(highs) - min(highs) + max(lows) - min(lows)
            at = [place * math.cos(yaw) - middle * math.sin(yaw), place * math.sin(yaw) + middle * math.cos(yaw)]
            yield Grip(np.array(at), yaw, width, width + C.uneven_cost * uneven + math.hypot(place, middle))


def is_other(grip, than):
    """Returns true if a Grip is at another place than another one, or from another direction."""
    turn = abs(math.remainder(grip.yaw - than.yaw, math.pi))
    return np.hypot(*(grip.at - than.at)) > C.other_place or turn > C.other_direction_rad


def ends_at(along, across):
    """Returns the lowest and the highest points across, in each third of the width of the fingers; None if one has none."""
    lows, highs = [], []
    for third in (-1, 0, 1):
        points = across[np.abs(along - third * C.finger / 3) <= C.finger / 6]
        if not len(points):
            return None, None
        lows.append(points.min())
        highs.append(points.max())
    return lows, highs
