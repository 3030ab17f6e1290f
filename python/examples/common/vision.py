"""Finds colored faces in the pictures of a robot's eye. Lengths are in units."""
import numpy as np


class Place:
    """A place on the table: its middle (x, y), and the directions of its width and its depth."""

    def __init__(self, middle, depth_axis):
        self.middle = np.asarray(middle, float)
        self.y = np.append(depth_axis, 0)
        self.x = np.array([self.y[1], -self.y[0], 0])

    def at(self, x, y, z):
        """Returns the point of the world at x, y from the middle and at the height z."""
        return np.append(self.middle, z) + x * self.x + y * self.y

    def moved(self, x, y):
        """Returns the place at x, y from the middle, in the same directions."""
        return Place(self.at(x, y, 0)[:2], self.y[:2])

    def inside(self, points):
        """Returns x, y of points of the world, seen from the middle."""
        return (points[:, :2] - self.middle) @ np.column_stack([self.x, self.y])[:2]


def points_of(color, sensor, aux, tolerance=12, is_shaded=False):
    """Returns the visible points (Nx3) of this color, (red, green, blue) from 0 to 255.

    Upper faces and lamps have the color of the object in the picture; other faces are darker, and
    count if `is_shaded`.
    """
    color, picture = np.array(color, float), sensor.rgbVision.astype(float)
    brightness = np.clip(picture @ color / (color @ color), 0.3, 1) if is_shaded else 1.0
    difference = np.abs(picture - np.multiply.outer(brightness, color)).max(axis=2)
    row, column = np.nonzero((difference <= tolerance * brightness) & (sensor.depthVision > 0))
    # From pixels to points: along the ray of each pixel, as far as its depth.
    ray = np.linalg.solve(aux.cameraIntrinsics, [column + 0.5, row + 0.5, np.ones(len(row))])
    points = sensor.cameraPose[:3, :3] @ (ray * sensor.depthVision[row, column])
    return points.T + sensor.cameraPose[:3, 3]


def between(points, low, high):
    """Returns the points at heights from low to high."""
    return points[(points[:, 2] > low) & (points[:, 2] < high)]


def rectangle_around(points):
    """Returns the smallest upright rectangle around points, as seen from above: its center (x, y),
    the directions of its sides (2x2, one in each row, the long one first), and their lengths."""
    xy = points[:, :2]
    best = None
    for angle in np.radians(np.arange(0, 90, 0.5)):
        axes = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
        along = xy @ axes.T
        low, high = along.min(axis=0), along.max(axis=0)
        if best is None or np.prod(high - low) < best[0]:
            best = np.prod(high - low), axes, (low + high) / 2, high - low
    _, axes, middle, lengths = best
    order = np.argsort(-lengths)
    return middle @ axes, axes[order], lengths[order]
