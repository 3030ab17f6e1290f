"""Statistics of features, as LeRobot stores them."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

QUANTILES = {"q01": 0.01, "q10": 0.10, "q50": 0.50, "q90": 0.90, "q99": 0.99}
NAMES = ("min", "max", "mean", "std", "count", *QUANTILES)

# [mm]
DEPTH_LEVELS: npt.NDArray[np.uint16] = np.arange(4096, dtype=np.uint16)

Statistics = dict[str, Any]
"""each of NAMES: a list with one number for each dimension; of pictures nested, (3, 1, 1)"""


def of_rows(rows: npt.NDArray[Any]) -> Statistics:
    """Returns the statistics of a feature, (frames,) or (frames, dimensions)."""
    # In one order, whatever that of `rows`: sums of the same numbers in another order differ.
    values = rows.reshape(len(rows), -1).astype(np.float64, order="C")
    if rows.ndim == 1 and rows.dtype.kind == "i" and rows.min() == rows.max():
        # Numbers of an episode or a task: without rounding.
        same = {name: [float(rows[0])] for name in ("min", "max", "mean", "std", *QUANTILES)}
        return {**same, "std": [0.0], "count": [len(rows)]}
    result: dict[str, npt.NDArray[np.float64]] = {
        "min": values.min(axis=0), "max": values.max(axis=0),
        "mean": values.mean(axis=0), "std": values.std(axis=0)}
    result.update(zip(QUANTILES, np.quantile(values, list(QUANTILES.values()), axis=0)))
    statistics: Statistics = {name: column.tolist() for name, column in result.items()}
    statistics["count"] = [len(rows)]
    return statistics


class Values:
    """Values of a feature of all episodes: those of many are kept in files meanwhile."""

    # Of a feature in memory.
    _LIMIT_BYTES = 16_000_000

    def __init__(self, folder: Path, name: str) -> None:
        """folder: for temporary files `name.DIMENSION`"""
        self._folder, self._name = folder, name
        self._rows: list[npt.NDArray[Any]] = []
        self._bytes = 0
        self._files: list[Path] = []
        self._dtype: np.dtype[Any] = np.dtype(np.float64)

    def add(self, rows: npt.NDArray[Any]) -> None:
        """Appends the frames of an episode, (frames,) or (frames, dimensions)."""
        self._dtype = rows.dtype
        # A copy: rows may be a part of a large table.
        self._rows.append(rows.copy())
        self._bytes += rows.nbytes
        if self._bytes > self._LIMIT_BYTES:
            self._store()

    def _store(self) -> None:
        columns = self._columns_in_memory()
        if not self._files:
            self._files = [self._folder / f"{self._name}.{i}" for i in range(len(columns))]
        # A file for each dimension: its values are needed at once.
        for path, column in zip(self._files, columns, strict=True):
            with path.open("ab") as file:
                file.write(column.tobytes())
        self._rows, self._bytes = [], 0

    def _columns_in_memory(self) -> npt.NDArray[Any]:
        rows = np.concatenate(self._rows)
        return np.ascontiguousarray(rows.reshape(len(rows), -1).T)

    def statistics(self) -> Statistics:
        """Returns the statistics of all frames, and forgets them. The same frames give the same bits,
        whatever the episodes."""
        if self._files and self._rows:
            self._store()
        columns: Iterable[npt.NDArray[Any]]
        columns = (np.fromfile(path, self._dtype) for path in self._files) if self._files else self._columns_in_memory()
        each = [of_rows(column) for column in columns]
        for path in self._files:
            path.unlink()
        joined: Statistics = {name: [one[name][0] for one in each] for name in NAMES if name != "count"}
        joined["count"] = each[0]["count"]
        return {name: joined[name] for name in each[0]}


class Pixels:
    """Colors of pictures, counted: statistics of any number of them are exact. Colors are 0 to 1."""

    def __init__(self, levels: npt.NDArray[Any] = np.arange(256) / 255, channels: int = 3) -> None:
        """levels: what the numbers of pixels stand for"""
        self._levels = levels.astype(float)
        self.counts = np.zeros((channels, len(levels)), np.int64)
        self.num_pictures = 0

    def add(self, picture: npt.NDArray[Any]) -> None:
        """Counts a picture, (height, width, channels); of large ones, each second, third, … pixel."""
        step = max(1, max(picture.shape[:2]) // 150)
        for channel, counts in enumerate(self.counts):
            counts += np.bincount(picture[::step, ::step, channel].ravel(), minlength=len(counts))
        self.num_pictures += 1

    def join(self, other: Pixels) -> None:
        self.counts += other.counts
        self.num_pictures += other.num_pictures

    def statistics(self) -> Statistics:
        levels = self._levels
        total = self.counts.sum(axis=1)
        mean = self.counts @ levels / total
        variance = self.counts @ levels**2 / total - mean**2
        below = np.cumsum(self.counts, axis=1)
        result: dict[str, npt.NDArray[np.float64]] = {
            "min": levels[np.argmax(self.counts > 0, axis=1)],
            "max": levels[len(levels) - 1 - np.argmax(self.counts[:, ::-1] > 0, axis=1)],
            "mean": mean, "std": np.sqrt(np.maximum(variance, 0))}
        for name, share in QUANTILES.items():
            result[name] = levels[np.argmax(below >= share * total[:, None], axis=1)]
        statistics: Statistics = {name: column.reshape(-1, 1, 1).tolist()
                                  for name, column in result.items()}
        statistics["count"] = [self.num_pictures]
        return statistics
