"""What a hand carries: all that is joined to what it holds."""

from dataclasses import dataclass

import numpy as np

from constants import SKYLINE as C
from plan.skyline import cells_of
from things.areas import footprint, overlap


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


def load_of(points, middle, tool):
    """Returns the Load that visible points of an object become when it is taken with a tool at a pose, 4x4. Below
    the height of its middle [units], which is not visible, it is taken to be as above."""
    _, first = np.unique(cells_of(points, np.zeros(2)), axis=0, return_index=True)
    whole = np.concatenate([points[first], points[first] * [1, 1, -1] + [0, 0, 2 * middle]])
    return Load((whole - tool[:3, 3]) @ tool[:3, :3])


def belongs_to(block, points):
    """Returns which of N visible points belong to a block or stick out of it, like the blades of scissors: those no
    higher than its top that are joined to it without a gap, N bool."""
    low = np.flatnonzero(points[:, 2] < block.top + C.margin)
    [covered] = footprint([block], 0)
    cells, index = np.unique(cells_of(points[low], np.zeros(2)), axis=0, return_inverse=True)
    is_part = overlap(covered, np.column_stack([(cells + 0.5) * C.cell, np.full((len(cells), 2), C.cell),
                                                np.zeros(len(cells))]))
    # From cell to cell, until no other one touches them.
    grown = False
    while not np.array_equal(grown, is_part):
        grown = is_part
        away = np.abs(cells[:, None] - cells[grown]).max(axis=2)
        is_part = grown | (away.min(axis=1) <= C.max_gap_cells)
    mask = np.zeros(len(points), bool)
    mask[low] = is_part[index.ravel()]
    return mask
