"""Balls: their outline in a picture, and their surface in depth."""

import numpy as np

from constants import BALLS as C, PERCEPTION
from see.eye import onto_plane, pixel_at
from see.regions import label_regions
from see.spheres import fit_sphere, ray_distances
from things.blocks import Block


def shade_mask(picture, color):
    """Returns the mask, HxW bool, of the pixels of a color in any shade: a round surface is bright where
    it faces the light."""
    fraction = (picture @ color) / max(color @ color, np.finfo(float).eps)
    difference = np.abs(picture - fraction[..., None] * color).max(axis=-1)
    least, greatest = C.shade
    return (least < fraction) & (fraction < greatest) & (difference < C.shade_tolerance)


def ball_color(picture, eye, center, radius):
    """Returns the color of a ball, where it faces the eye, if a picture shows it entirely and nothing of its
    color around it; otherwise None.

    center: x y z [units]
    """
    toward = eye.pose[:3, 3] - center
    pixel = pixel_at(picture, eye, center + radius * toward / np.linalg.norm(toward))
    if pixel is None:
        return None
    color = picture[pixel]
    mask = shade_mask(picture, color)
    away = ray_distances(mask.shape, eye, center) / radius
    around = (C.around[0] < away) & (away < C.around[1])
    is_whole = mask[away < C.within].mean() > C.min_inside and mask[around].mean() < C.max_around
    return color if is_whole else None


def detect_balls(picture, eye, kinds, heights):
    """Detects balls of some kinds, Blocks: a list. A part of each may be hidden.

    heights: as from height_map
    """
    balls = []
    for kind in kinds:
        number = label_regions(shade_mask(picture, kind.color), heights)
        for region in np.flatnonzero(np.bincount(number.ravel()) >= PERCEPTION.min_top_pixels):
            row, column = np.nonzero(number == region)
            if region == 0 or heights[row, column].max() < PERCEPTION.on_table:
                continue
            z = heights[row, column]
            x, y, _ = onto_plane(row, column, eye, z)
            center, radius, misfit = fit_sphere(np.column_stack([x, y, z]))
            error = abs(2 * radius / kind.size[0] - 1)
            if error < PERCEPTION.max_side_error and misfit < C.misfit:
                balls.append(Block(kind.color, kind.size, center, 0.0, form="ball"))
    return balls
