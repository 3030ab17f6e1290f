"""Finds blocks on whose tops other things stand."""

import numpy as np

from constants import PERCEPTION as C
from see.eye import onto_plane, to_pixel
from see.faces import Face
from things.blocks import Block


def fit_covered(row, column, eye, color, kinds, top, heights):
    """Fits a block of one of some kinds to the visible part of a top face: the smallest rectangle
    around it has the sides of the block, and what is missing within it is hidden by something
    higher. Returns a list, empty if nothing fits.

    row, column: pixels, N numbers each
    top:         measured height of the face [units]
    heights:     as from height_map
    """
    x, y, area = onto_plane(row, column, eye, top)
    face = smallest_rectangle(x, y, np.sqrt(np.median(area)))
    for size in [it.size for it in kinds if not it.is_round]:
        has_sides = np.abs(face.sides / size[:2] - 1).max() < C.max_cut_side_error
        if has_sides and is_missing_hidden(row, column, face, top, eye, heights):
            return [Block(color, size, np.append(face.center, top - size[2] / 2), face.yaw)]
    return []


def smallest_rectangle(x, y, pixel, yaw=None):
    """Returns the rectangle of the smallest area around points, the longer side first if it has to be found. Hidden corners do
    not change it, as long as each side has visible points.

    pixel: side of the small square that each point stands for [units]
    yaw:   of its first side, if it is known [rad]
    """
    yaws = np.array([yaw]) if yaw is not None else np.arange(0, np.pi / 2, C.rectangle_yaw_step_rad)
    c, s = np.cos(yaws)[:, None], np.sin(yaws)[:, None]
    along, across = x * c + y * s, y * c - x * s
    low, high = [np.array([end(along, axis=1), end(across, axis=1)]) for end in (np.min, np.max)]
    best = np.argmin((high - low + pixel).prod(axis=0))
    angle, sides = yaws[best], (high - low + pixel)[:, best]
    along, across = ((low + high) / 2)[:, best]
    center = np.array([along * np.cos(angle) - across * np.sin(angle),
                       along * np.sin(angle) + across * np.cos(angle)])
    if yaw is None and sides[1] > sides[0]:
        angle, sides = angle + np.pi / 2, sides[::-1]
    return Face(center, angle, sides, 0)


def is_missing_hidden(row, column, face, top, eye, heights):
    """Returns true if the eye sees, almost everywhere in a rectangle, its visible part or something
    higher."""
    is_seen = heights > top + C.height_step
    is_seen[row, column] = True
    fractions = np.linspace(-0.48, 0.48, C.points_per_side)
    c, s = np.cos(face.yaw), np.sin(face.yaw)
    pixels = [to_pixel([*(face.center + [a * c - b * s, a * s + b * c]), top], eye)
              for a in fractions * face.sides[0] for b in fractions * face.sides[1]]
    u, v = np.floor(pixels).astype(int).T
    inside = (v >= 0) & (v < heights.shape[0]) & (u >= 0) & (u < heights.shape[1])
    return inside.all() and np.mean(is_seen[v, u]) > C.min_explained
