"""Where a flat piece of any outline is held: a place across which its sides are about parallel."""

import math

import numpy as np

from constants import OUTLINES as C
from things.blocks import Block


def grip_of(x, y, pixel, color, height):
    """Returns the part by which a piece is held, as a Block in its frame: between the fingers all of the piece, within their
    width, ends on both sides. Flat ends, narrow places and those close to the center are preferred.

    x, y:  points of its top in its frame, N numbers each [units]
    pixel: side of the small square that each point stands for [units]
    """
    best, grip = math.inf, None
    for yaw in np.arange(C.num_directions) * math.pi / C.num_directions:
        along, across = x * math.cos(yaw) + y * math.sin(yaw), y * math.cos(yaw) - x * math.sin(yaw)
        for place in C.cell * np.arange(math.ceil(along.min() / C.cell), math.floor(along.max() / C.cell) + 1):
            lows, highs = ends_at(along - place, across)
            if lows is None:
                continue
            width, middle = max(highs) - min(lows) + pixel, (max(highs) + min(lows)) / 2
            uneven = max(highs) - min(highs) + max(lows) - min(lows)
            cost = width + C.uneven_cost * uneven + math.hypot(place, middle)
            if cost < best - C.equal:
                best = cost
                at = [place * math.cos(yaw) - middle * math.sin(yaw), place * math.sin(yaw) + middle * math.cos(yaw), 0]
                # So long that it is held across its width only.
                grip = Block(color, np.array([C.bar * width, width, height]), np.array(at), yaw)
    return grip


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
