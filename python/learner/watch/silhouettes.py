"""Silhouettes of blocks in a picture."""

import numpy as np


def corners_of(block):
    """Returns the corners of a block, first the four of its top in turn, then those below them: 8x3."""
    along = block.size[0] / 2 * np.array([np.cos(block.yaw), np.sin(block.yaw)])
    across = block.size[1] / 2 * np.array([-np.sin(block.yaw), np.cos(block.yaw)])
    around = np.array([along + across, across - along, -along - across, along - across])
    around = around + block.position[:2]
    return np.vstack([np.column_stack([around, np.full(4, z)]) for z in (block.top, block.bottom)])


def hull(points):
    """Returns the convex hull of points in a plane, in turn. Source: A. M. Andrew, "Another efficient
    algorithm for convex hulls in two dimensions" (1979)."""
    ordered = sorted(map(tuple, points))

    def chain(some):
        found = []
        for p in some:
            while len(found) > 1 and cross(found[-2], found[-1], p) <= 0:
                found.pop()
            found.append(p)
        return found[:-1]

    return np.array(chain(ordered) + chain(ordered[::-1]))


def cross(a, b, c):
    """Returns twice the area of a triangle, positive if its corners turn left."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def area_of(polygon):
    """Returns the area of a polygon."""
    x, y = polygon.T
    return abs(x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2


def fill(polygon, shape):
    """Returns the rows and columns of the pixels in a convex polygon of points u, v from the top left corner."""
    low = np.maximum(np.floor(polygon.min(axis=0)).astype(int), 0)
    high = np.minimum(np.ceil(polygon.max(axis=0)).astype(int), shape[::-1])
    column, row = np.meshgrid(np.arange(low[0], high[0]), np.arange(low[1], high[1]))
    inside = np.ones(row.shape, bool)
    polygon = hull(polygon)
    for a, b in zip(polygon, np.roll(polygon, -1, axis=0)):
        inside &= (b[0] - a[0]) * (row + 0.5 - a[1]) >= (b[1] - a[1]) * (column + 0.5 - a[0])
    return row[inside], column[inside]
