"""Spheres that depth shows."""

import numpy as np


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
