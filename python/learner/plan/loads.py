"""What a hand carries: all that is joined to what it holds."""

from dataclasses import dataclass

import numpy as np

from constants import SKYLINE as C
from plan.skyline import cells_of
from things.areas import footprint, overlap, rotated


@dataclass
class Load:
    """What a hand carries: points on it in the frame of the tool, Nx3 [units]."""

    points: np.ndarray

    def at(self, tool):
        """Returns the points where the tool has a pose, 4x4."""
        return self.points @ tool[:3, :3].T + tool[:3, 3]

    def box(self):
        """Returns the lower and the upper corner of a box around it, in the frame of the tool, 2x3 [units]."""
        return np.array([self.points.min(axis=0), self.points.max(axis=0)]) + [[-C.cell / 2], [C.cell / 2]]


def whole_of(points, middle):
    """Returns points on an object of which some points are visible, one in each cell, Nx3 [units]. Below the height of its
    middle [units], which is not visible, it is taken to be as above."""
    _, first = np.unique(cells_of(points, np.zeros(2)), axis=0, return_index=True)
    return np.concatenate([points[first], points[first] * [1, 1, -1] + [0, 0, 2 * middle]])


def load_of(whole, tool):
    """Returns the Load that an object becomes when it is taken with a tool at a pose, 4x4. whole: points on it, Nx3 [units]"""
    return Load((whole - tool[:3, 3]) @ tool[:3, :3])


def moved_to(points, block, place, turn):
    """Returns points on a block, Nx3 [units], where it is moved to a place, x y z, and turned [rad]."""
    from_middle = points - block.position
    return np.column_stack([rotated(from_middle[:, :2].T, turn).T, from_middle[:, 2]]) + place


def belongs_to(block, points):
    """Returns which of N visible points belong to a block or stick out of it, like the blades of scissors: those no
    higher than its top that are joined to it without a gap, N bool."""
    low = np.flatnonzero(points[:, 2] < block.top + C.margin)
    [covered] = footprint([block], 0)
    cells, index = np.unique(cells_of(points[low], np.zeros(2)), axis=0, return_inverse=True)
    is_part = overlap(covered, np.column_stack([(cells + 0.5) * C.cell, np.full((len(cells), 2), C.cell),
                                                np.zeros(len(cells))]))
    # From cell to cell, until no other one touches them.
    newest = is_part
    while newest.any():
        near = (np.abs(cells[:, None] - cells[newest]).max(axis=2) <= C.max_gap_cells).any(axis=1)
        newest = near & ~is_part
        is_part = is_part | near
    mask = np.zeros(len(points), bool)
    mask[low] = is_part[index.ravel()]
    return mask
