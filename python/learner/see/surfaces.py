"""What the eye sees above the table, as points of some colors."""

from dataclasses import dataclass

import numpy as np

from constants import ALIGNMENT as C, PERCEPTION
from see.eye import onto_plane


@dataclass
class Surface:
    """What the eye sees above the table: a point for each pixel."""

    points: np.ndarray  # Nx3 [units]
    colors: np.ndarray  # Nx3

    def part(self, mask):
        """Returns the points of a mask, N bool."""
        return Surface(self.points[mask], self.colors[mask])

    def around(self, center, radius, most):
        """Returns those points that are near a place, x y, and evenly chosen, about as many as wanted."""
        near = np.flatnonzero(np.hypot(*(self.points[:, :2] - center[:2]).T) < radius)
        return self.part(near[::max(1, len(near) // most)])


def surface_of(picture, heights, eye):
    """Returns the Surface that a picture shows. heights: as from height_map."""
    row, column = np.nonzero(heights > C.min_height)
    z = heights[row, column]
    x, y, _ = onto_plane(row, column, eye, z)
    return Surface(np.column_stack([x, y, z]), picture[row, column])


def is_alike(colors, others):
    """Returns which of N colors are equal to others, Nx3, as color_mask compares them."""
    tolerance = PERCEPTION.color_tolerance + PERCEPTION.color_tolerance_bright * others.max(axis=1)
    return np.abs(colors - others).max(axis=1) < tolerance


def references(picture, pixels):
    """Returns one of some pixels for each of their frequent colors, the one in the middle: rows and columns."""
    row, column = pixels
    codes = np.round(picture[row, column] * 255).astype(int) @ [65536, 256, 1]
    chosen = []
    found, counts = np.unique(codes, return_counts=True)
    for code in found[np.argsort(-counts)][:C.num_references]:
        r, c = row[codes == code], column[codes == code]
        k = np.argmin(np.hypot(r - r.mean(), c - c.mean()))
        chosen.append((r[k], c[k]))
    return chosen
