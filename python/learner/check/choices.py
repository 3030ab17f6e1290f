"""What a run does in a way of its own, where there are several good ways."""

from dataclasses import dataclass
from typing import Optional

import numpy as np

from constants import MOTION_PLANNING as C


@dataclass(frozen=True)
class Way:
    """How one block is held and carried."""

    grasp: Optional[np.random.Generator] = None  # draws the order in which grasps are tried; None: as they are found
    rise: float = 0.0  # by how much higher than necessary it is carried [units]

    def ranked(self, grasps):
        """Returns grasps in the order in which they are tried."""
        return [grasps[k] for k in self.grasp.permutation(len(grasps))] if self.grasp else grasps

    def rises(self):
        """Returns by how much higher it is carried, the best first [units]."""
        return [self.rise, 0.0] if self.rise else [0.0]


@dataclass(frozen=True)
class Choices:
    """Seeds of what may be done in several ways; None: in the way that was demonstrated, or is found first."""

    order: Optional[float] = None  # of steps that may be next
    grasp: Optional[float] = None  # of the ways to hold a block
    path: Optional[float] = None  # of how high it is carried

    def ordered(self, steps, count):
        """Returns the numbers of steps, of `count`, in the order in which they are tried."""
        if self.order is None:
            return steps
        rank = np.random.default_rng(int(self.order)).permutation(count)
        return sorted(steps, key=lambda k: rank[k])

    def way(self, move):
        """Returns the Way of a move; move: the number of moves before it."""
        grasp = None if self.grasp is None else np.random.default_rng([int(self.grasp), move])
        rise = 0.0 if self.path is None else np.random.default_rng([int(self.path), move]).uniform(0, C.max_rise)
        return Way(grasp, rise)


def choices_of(aux):
    """Returns the Choices that the simulator asks for."""
    return Choices(*(vars(aux).get(f"variation{of}") for of in ("Order", "Grasp", "Path")))
