"""Positions of joints over time."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from smile.simulation import Floats

_MOST_POINTS = 100_000


class JointPath:
    """Positions of joints at increasing times; cubics with the velocities of the points lie between them.

    names       (n,) of the joints
    times       (k,) from 0 on [s]
    positions   (k, n) [rad]
    velocities  (k, n) [rad/s]; None: central differences
    """

    def __init__(self, names: Sequence[str], times: npt.ArrayLike, positions: npt.ArrayLike,
                 velocities: npt.ArrayLike | None = None) -> None:
        self.names = list(names)
        self.times = np.asarray(times, float)
        self.positions = np.asarray(positions, float)
        if not 1 <= len(self.times) <= _MOST_POINTS:
            raise ValueError(f"the path has {len(self.times)} points, expected 1 to {_MOST_POINTS}")
        if self.positions.shape != (len(self.times), len(self.names)):
            raise ValueError(f"the positions have shape {self.positions.shape}, expected "
                             f"{(len(self.times), len(self.names))}")
        if not (np.isfinite(self.times).all() and np.isfinite(self.positions).all()):
            raise ValueError("the path contains numbers that are not finite")
        if self.times[0] < 0 or (np.diff(self.times) <= 0).any():
            raise ValueError("the times of the path do not increase from 0 on")
        if velocities is None:
            slopes = np.gradient(self.positions, self.times, axis=0) if len(self.times) > 1 else np.zeros_like(self.positions)
        else:
            slopes = np.asarray(velocities, float)
            if slopes.shape != self.positions.shape or not np.isfinite(slopes).all():
                raise ValueError("the velocities of the path are not finite numbers, one for each position")
        self.velocities: Floats = slopes

    @property
    def duration(self) -> float:
        """Time of the last point [s]."""
        return float(self.times[-1])

    def at(self, time: float) -> tuple[Floats, Floats]:
        """Returns positions and velocities at a time [s]; before and after the path, it rests at its ends."""
        i = int(np.searchsorted(self.times, time, side="right")) - 1
        if i < 0 or i + 1 >= len(self.times):
            return self.positions[max(i, 0)], np.zeros(len(self.names))
        # Cubic Hermite basis.
        span = self.times[i + 1] - self.times[i]
        s = (time - self.times[i]) / span
        p0, p1, m0, m1 = self.positions[i], self.positions[i + 1], self.velocities[i] * span, self.velocities[i + 1] * span
        positions = ((2 * s**3 - 3 * s**2 + 1) * p0 + (s**3 - 2 * s**2 + s) * m0
                     + (3 * s**2 - 2 * s**3) * p1 + (s**3 - s**2) * m1)
        velocities = ((6 * s**2 - 6 * s) * (p0 - p1) + (3 * s**2 - 4 * s + 1) * m0 + (3 * s**2 - 2 * s) * m1) / span
        return positions, velocities

    def ordered(self, names: Sequence[str]) -> JointPath:
        """Returns the path with its joints in another order."""
        columns = [self.names.index(name) for name in names]
        return JointPath(names, self.times, self.positions[:, columns], self.velocities[:, columns])
