"""Statistics of features, as LeRobot stores them."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

QUANTILES = {"q01": 0.01, "q10": 0.10, "q50": 0.50, "q90": 0.90, "q99": 0.99}
NAMES = ("min", "max", "mean", "std", "count", *QUANTILES)

Statistics = dict[str, Any]
"""each of NAMES: a list with one number for each dimension; of pictures nested, (3, 1, 1)"""


def of_rows(rows: npt.NDArray[Any]) -> Statistics:
    """Returns the statistics of a feature, (frames,) or (frames, dimensions)."""
    # In one order, whatever that of `rows`: sums of the same numbers in another order differ.
    values = rows.reshape(len(rows), -1).astype(np.float64, order="C")
    result: dict[str, npt.NDArray[np.float64]] = {
        "min": values.min(axis=0), "max": values.max(axis=0),
        "mean": values.mean(axis=0), "std": values.std(axis=0)}
    for name, share in QUANTILES.items():
        result[name] = np.quantile(values, share, axis=0)
    statistics: Statistics = {name: column.tolist() for name, column in result.items()}
    statistics["count"] = [len(rows)]
    return statistics


class Pixels:
    """Colors of pictures, counted: statistics of any number of them are exact."""

    def __init__(self) -> None:
        self.counts = np.zeros((3, 256), np.int64)
        self.num_pictures = 0

    def add(self, rgb: npt.NDArray[np.uint8]) -> None:
        """Counts a picture, (height, width, 3); of large ones, each second, third, … pixel."""
        step = max(1, max(rgb.shape[:2]) // 150)
        for channel in range(3):
            self.counts[channel] += np.bincount(rgb[::step, ::step, channel].ravel(), minlength=256)
        self.num_pictures += 1

    def join(self, other: Pixels) -> None:
        self.counts += other.counts
        self.num_pictures += other.num_pictures

    def statistics(self) -> Statistics:
        """Colors are 0 to 1."""
        levels = np.arange(256) / 255
        total = self.counts.sum(axis=1)
        mean = self.counts @ levels / total
        variance = self.counts @ levels**2 / total - mean**2
        below = np.cumsum(self.counts, axis=1)
        result: dict[str, npt.NDArray[np.float64]] = {
            "min": levels[np.argmax(self.counts > 0, axis=1)],
            "max": levels[255 - np.argmax(self.counts[:, ::-1] > 0, axis=1)],
            "mean": mean, "std": np.sqrt(np.maximum(variance, 0))}
        for name, share in QUANTILES.items():
            result[name] = levels[np.argmax(below >= share * total[:, None], axis=1)]
        statistics: Statistics = {name: column.reshape(3, 1, 1).tolist()
                                  for name, column in result.items()}
        statistics["count"] = [self.num_pictures]
        return statistics
