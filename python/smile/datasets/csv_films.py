"""Writer of plain files: tables as CSV, and films."""

from __future__ import annotations

import csv
import json
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from smile.datasets import lerobot, statistics
from smile.datasets.lerobot import Row, path_of, write_json


EPISODES = "episodes.csv"


def header_of(features: Mapping[str, Any]) -> list[str]:
    """Returns the names of the columns: a column for each dimension of the features."""
    header: list[str] = []
    for name, feature in features.items():
        if feature["dtype"] != "video":
            names = feature["names"]
            header += [name] if names is None else [f"{name}.{one}" for one in names]
    return header


class Writer(lerobot.Writer):
    """A folder with a table and films for each episode in the making."""

    VERSION = "csv"
    DATA = "episode_{episode_index:06d}.csv"
    FILMS = "episode_{episode_index:06d}.{video_key}.mp4"
    # Each episode begins a file.
    DATA_MEGABYTES, FILM_MEGABYTES = 0, 0

    def _write_frames(self, values: Mapping[str, npt.NDArray[Any]], more: Row) -> Row:
        blocks = []
        for name, feature in self.features.items():
            if feature["dtype"] == "video":
                continue
            numbers = values[name].reshape(len(values[name]), -1)
            # The shortest text that reads back as the same number.
            blocks.append((numbers.astype(int) if numbers.dtype == bool else numbers).astype(str))
        _write_table(self._folder / path_of(self.DATA, self.num_episodes), header_of(self.features),
                     np.hstack(blocks).tolist())
        return {}

    def _list(self, row: Row) -> None:
        self._episodes.append({
            name: value for name, value in row.items()
            if name == "episode_index" or name != "stats" and "/from_" not in name
            and not name.endswith(("_index", "/to_timestamp"))})

    def _write_meta(self, totals: dict[str, statistics.Statistics]) -> None:
        header = list(self._episodes[0])
        _write_table(self._folder / EPISODES, header,
                     ([_text_of(row[name]) for name in header] for row in self._episodes))
        write_json(self._folder / "info.json", self._info())
        write_json(self._folder / "stats.json", totals)


def _text_of(value: Any) -> str:
    if value is None:
        return ""
    return value if isinstance(value, str) else json.dumps(value)


def _write_table(path: Path, header: list[str], rows: Iterable[list[str]]) -> None:
    with path.open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(header)
        writer.writerows(rows)
