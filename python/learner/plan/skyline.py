"""The skyline: how high what the eye sees rises above each place of the table. What lies below is taken to be filled."""

from dataclasses import dataclass

import numpy as np

from constants import SKYLINE as C


@dataclass
class Skyline:
    """The height of the highest visible point in each square cell of a grid; 0 where nothing is seen."""

    heights: np.ndarray  # rows along x [units]
    corner: np.ndarray  # x y of the corner of the first cell [units]

    def widened(self, margin):
        """Returns the skyline of the same things with a margin on all sides [units]."""
        n = int(np.ceil(margin / C.cell))
        rows, columns = self.heights.shape
        around = np.pad(self.heights, 2 * n)
        wide = np.zeros((rows + 2 * n, columns + 2 * n))
        for i in range(-n, n + 1):
            for j in range(-n, n + 1):
                if np.hypot(i, j) * C.cell <= margin:
                    wide = np.maximum(wide, around[n + i:n + i + wide.shape[0], n + j:n + j + wide.shape[1]])
        return Skyline(wide, self.corner - n * C.cell)

    def is_below(self, points):
        """Returns true if all of some points are above the skyline, or beside it: Nx3 [units]."""
        row, column = cells_of(points, self.corner).T
        inside = (row >= 0) & (row < self.heights.shape[0]) & (column >= 0) & (column < self.heights.shape[1])
        return bool((self.heights[row[inside], column[inside]] < points[inside, 2]).all())


def skyline_of(points):
    """Returns the Skyline of visible points, Nx3 [units]."""
    if not len(points):
        return Skyline(np.zeros((0, 0)), np.zeros(2))
    corner = points[:, :2].min(axis=0)
    cells = cells_of(points, corner)
    heights = np.zeros(cells.max(axis=0) + 1)
    np.maximum.at(heights, tuple(cells.T), points[:, 2])
    return Skyline(heights, corner)


def cells_of(points, corner):
    """Returns row and column of the cells in which points are, Nx2."""
    return np.floor((points[:, :2] - corner) / C.cell).astype(int)
