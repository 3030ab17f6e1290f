"""Balls: their outline in a picture, and their surface in depth."""

import numpy as np

from blocks import Block
from constants import BALLS as C, PERCEPTION
from eye import onto_plane, pixel_at
from regions import label_regions


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


def ray_distances(shape, eye, point):
    """Returns the distance of a point from the ray through each pixel, HxW [units]."""
    row, column = np.indices(shape) + 0.5
    K = eye.intrinsics
    ray = np.stack([(column - K[0, 2]) / K[0, 0], (row - K[1, 2]) / K[1, 1],
                    np.ones(shape)], axis=-1) @ eye.pose[:3, :3].T
    ray /= np.linalg.norm(ray, axis=-1, keepdims=True)
    to_point = point - eye.pose[:3, 3]
    along = ray @ to_point
    return np.linalg.norm(to_point - along[..., None] * ray, axis=-1)


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


def fit_sphere(points):
    """Fits a sphere to points of its surface, Nx3. Returns its center, its radius, and the mean distance
    of the points from it.

    |p - c| = r is linear in the unknowns c and r^2 - |c|^2: 2 p c + (r^2 - |c|^2) = |p|^2.
    """
    rows = np.column_stack([2 * points, np.ones(len(points))])
    *center, rest = np.linalg.lstsq(rows, (points**2).sum(axis=1), rcond=None)[0]
    center = np.array(center)
    radius = np.sqrt(max(rest + center @ center, 0))
    return center, radius, np.abs(np.linalg.norm(points - center, axis=1) - radius).mean()
