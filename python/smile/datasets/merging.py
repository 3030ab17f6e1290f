"""Joins datasets that were exported in parts."""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pyarrow as pa
import pyarrow.parquet as pq

from smile.datasets import statistics
from smile.datasets.doctor import examine
from smile.datasets.episode import Column
from smile.datasets.exporting import META, Report, constant_of, pixels_of
from smile.datasets.features import DEFAULTS, Camera, schema_of
from smile.datasets.lerobot import Row, Writer, path_of, place, write_json
from smile.datasets.target import new_folder, refuse_existing

_OWN = ("smile/", "sparse_subtask_", "dense_subtask_")


class _StoredPixels(statistics.Pixels):
    """Statistics of the pictures of an episode. Its colors are counted with those of its dataset."""

    def __init__(self, row: Row, key: str) -> None:
        super().__init__()
        self._stored = {name: row[f"stats/{key}/{name}"] for name in statistics.NAMES}

    def statistics(self) -> statistics.Statistics:
        return self._stored


class _Part:
    """A dataset that is to be joined."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        try:
            self.info = json.loads((folder / "meta/info.json").read_text())
            self.about = json.loads((folder / META).read_text())
        except (OSError, ValueError):
            raise ValueError(f"{folder}: is no LeRobot dataset that SMILE exported") from None
        if self.info.get("codebase_version") != Writer.VERSION or "pixels" not in self.about:
            raise ValueError(f"{folder}: is of version {self.info.get('codebase_version')} or an earlier export, "
                             f"expected {Writer.VERSION}; export it again")
        self.cameras = [Camera(key.removeprefix("observation.images."), feature["shape"][1], feature["shape"][0])
                        for key, feature in self.info["features"].items() if feature["dtype"] == "video"]

    def common(self) -> Row:
        """Returns what all datasets of a merge must agree on."""
        return {**{name: self.info[name] for name in ("fps", "robot_type", "features")},
                **{name: self.about[name] for name in ("action", "dropped")}}

    def episodes(self) -> list[Row]:
        rows: list[Row] = []
        for path in sorted((self.folder / "meta/episodes").rglob("*.parquet")):
            rows += pq.read_table(path).to_pylist()
        return rows

    def empty_columns(self) -> dict[str, Column]:
        """Returns columns without rows, of which the features are those of this dataset."""
        return {name: Column(_no_rows(feature), feature["names"])
                for name, feature in self.info["features"].items()
                if feature["dtype"] != "video" and name not in DEFAULTS}


def _no_rows(feature: Mapping[str, Any]) -> npt.NDArray[Any]:
    shape = [] if feature["names"] is None else feature["shape"]
    return np.zeros((0, *shape), feature["dtype"])


def merge(datasets: Iterable[str | os.PathLike[str]], folder: str | os.PathLike[str], *,
          progress: Callable[[str], None] | None = None) -> Report:
    """Joins datasets of the format lerobot-v3.0 in a new one, in this order.

    Episodes and tasks are numbered again, and statistics are computed again from all frames: the result
    differs from a single export of all runs only in how many films there are. The datasets remain.

    Raises ValueError if they were exported in different ways, or the doctor finds errors in one;
    FileExistsError if there is such a folder, OSError if it cannot be written. Nothing is left of it
    then.
    """
    say = progress if progress is not None else lambda _: None
    target = Path(folder)
    refuse_existing(target)
    parts = [_Part(Path(dataset)) for dataset in datasets]
    if not parts:
        raise ValueError("there are no datasets, expected one at least")
    for part in parts:
        _require_same_kind(parts[0], part)
        errors = [finding for finding in examine(part.folder) if finding.is_error]
        if errors:
            raise ValueError(f"{errors[0]}; mend {part.folder}, or export it again")
    with new_folder(target) as partial:
        first = parts[0]
        writer = Writer(partial, first.info["fps"], first.cameras, first.empty_columns(),
                        first.info["robot_type"])
        if writer.features != first.info["features"]:
            raise ValueError(f"{first.folder}: has other features than this version writes; export it again")
        try:
            intrinsics: Row = {}
            for number, part in enumerate(parts):
                say(f"dataset {number + 1} of {len(parts)}: {part.folder}")
                _append(part, writer, partial)
                intrinsics.update(part.about["intrinsics"])
            totals = writer.finish()
        except BaseException:
            writer.abandon()
            raise
        constant = constant_of(writer.features, totals)
        write_json(partial / META, {**first.about, "intrinsics": intrinsics, "constant": constant,
                                    "pixels": pixels_of(writer)})
    return Report(target, writer.num_episodes, writer.num_frames, constant)


def _require_same_kind(first: _Part, other: _Part) -> None:
    expected, found = first.common(), other.common()
    for name, value in expected.items():
        if found[name] != value:
            raise ValueError(f"{other.folder}: differs from {first.folder} in {name}, expected datasets of the "
                             "same robot, objects, cameras and options")


def _append(part: _Part, writer: Writer, folder: Path) -> None:
    """Appends all episodes of a dataset to another one."""
    keys = [camera.key for camera in part.cameras]
    moved = {key: _copy_films(part, key, folder) for key in keys}
    schema = schema_of(part.info["features"])
    files: dict[Path, pq.ParquetFile] = {}
    for row in part.episodes():
        path = part.folder / part.info["data_path"].format(chunk_index=row["data/chunk_index"],
                                                           file_index=row["data/file_index"])
        if path not in files:
            files = {path: pq.ParquetFile(path)}
            group = 0
        table = files[path].read_row_group(group)
        group += 1
        columns = {field.name: Column(_values_of(table[field.name], field.type), None)
                   for field in schema if field.name not in DEFAULTS}
        films = {key: {**place(moved[key][row[f"videos/{key}/chunk_index"], row[f"videos/{key}/file_index"]]),
                       **{name: row[f"videos/{key}/{name}"] for name in ("from_timestamp", "to_timestamp")}}
                 for key in keys}
        more = {name: value for name, value in row.items() if name.startswith(_OWN)}
        extras = part.folder / f"extras/episode_{row['episode_index']:06d}"
        if extras.exists():
            copy = folder / f"extras/episode_{writer.num_episodes:06d}"
            shutil.copytree(extras, copy)
            if extras.with_suffix(".result.json").exists():
                shutil.copy(extras.with_suffix(".result.json"), copy.with_suffix(".result.json"))
        writer.add(columns, row["tasks"][0], films, {key: _StoredPixels(row, key) for key in keys}, more)
    for key in keys:
        counted = statistics.Pixels()
        counted.counts = np.array(part.about["pixels"][key]["counts"], np.int64)
        counted.num_pictures = part.about["pixels"][key]["pictures"]
        writer.films[key].pixels.join(counted)


def _values_of(column: pa.ChunkedArray, kind: pa.DataType) -> npt.NDArray[Any]:
    array = column.combine_chunks()
    if pa.types.is_fixed_size_list(kind):
        values: npt.NDArray[Any] = array.flatten().to_numpy(zero_copy_only=False)
        return values.reshape(-1, kind.list_size)
    single: npt.NDArray[Any] = array.to_numpy(zero_copy_only=False)
    return single


def _copy_films(part: _Part, key: str, folder: Path) -> dict[tuple[int, int], int]:
    """Copies the films of a camera behind those that are there; returns their new numbers by their
    places."""
    pattern, moved = Writer.FILMS, {}
    number = sum(1 for _ in (folder / f"videos/{key}").rglob("*.mp4"))
    old = 0
    while (source := part.folder / path_of(pattern, old, key)).exists():
        copy = folder / path_of(pattern, number, key)
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(source, copy)
        where = place(old)
        moved[where["chunk_index"], where["file_index"]] = number
        old, number = old + 1, number + 1
    return moved
