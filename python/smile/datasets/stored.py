"""Datasets that were exported, to be joined: those of which episodes have tables and films."""

from __future__ import annotations

import json
import shutil
from abc import ABC, abstractmethod
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt
import pyarrow as pa
import pyarrow.csv
import pyarrow.parquet as pq

from smile.datasets import csv_films, language, lerobot, statistics
from smile.datasets.doctor import examine
from smile.datasets.episode import Column
from smile.datasets.features import DEFAULTS, Camera, schema_of
from smile.datasets.lerobot import Row, path_of, place

_EPISODES_AT_ONCE = 100
_OWN = ("smile/", "sparse_subtask_", "dense_subtask_")


class Stored(ABC):
    """A dataset."""

    META = "smile.json"

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        try:
            self.about: Row = json.loads((folder / self.META).read_text())
        except (OSError, ValueError):
            raise ValueError(f"{folder}: is no dataset that SMILE exported") from None

    @abstractmethod
    def common(self) -> Row:
        """Returns what all datasets of a merge must agree on."""

    def require_sound(self) -> None:
        """Raises ValueError if something is missing or was changed."""
        errors = [finding for finding in examine(self.folder) if finding.is_error]
        if errors:
            raise self._mend(f"{errors[0].where}: {errors[0].message}")

    @abstractmethod
    def new_writer(self, folder: Path) -> Any:
        """Returns a writer of datasets of this kind."""

    @abstractmethod
    def append_to(self, writer: Any, folder: Path) -> None:
        """Appends all episodes to the dataset that `writer` makes in `folder`, without their extras."""

    def _mend(self, what: str) -> ValueError:
        return ValueError(f"{self.folder}: {what}; mend it, or export it again")


class _StoredPixels(statistics.Pixels):
    """Statistics of the pictures of an episode. Its colors are counted with those of its dataset."""

    def __init__(self, stored: statistics.Statistics, counts: statistics.Pixels) -> None:
        """counts: of no picture"""
        super().__init__()
        self._stored, self.counts = stored, counts.counts

    def statistics(self) -> statistics.Statistics:
        return self._stored


class _Episode(NamedTuple):
    columns: dict[str, Column]
    task: str
    known: dict[str, statistics.Statistics]
    """of features whose numbers remain"""
    more: Row
    row: Row
    """of the list of episodes"""


class _Tables(Stored):
    """A dataset in the manner of LeRobot."""

    INFO = "meta/info.json"
    META = "meta/smile.json"
    WRITER = lerobot.Writer

    def __init__(self, folder: Path) -> None:
        super().__init__(folder)
        try:
            self.info: Row = json.loads((folder / self.INFO).read_text())
        except (OSError, ValueError):
            raise ValueError(f"{folder}: is no dataset that SMILE exported") from None
        if "pixels" not in self.about:
            raise ValueError(f"{folder}: is of an earlier export; export it again")
        films = {key: feature for key, feature in self.info["features"].items() if feature["dtype"] == "video"}
        self.film_keys = list(films)
        self.cameras = [Camera(key.removeprefix("observation.images."), feature["shape"][1], feature["shape"][0],
                               ("depth",) if films.get(f"{key}_depth", feature)["info"]["is_depth_map"] else ())
                        for key, feature in films.items() if not feature["info"]["is_depth_map"]]
        # What stands for words is made again.
        self._kinds = {field.name: field.type for field in schema_of(self.info["features"])
                       if field.name not in (*DEFAULTS, language.ANNOTATION)}

    def common(self) -> Row:
        return {**{name: self.info[name] for name in ("codebase_version", "fps", "robot_type", "features")},
                **{name: self.about[name] for name in ("action", "dropped")}}

    def new_writer(self, folder: Path) -> lerobot.Writer:
        features = self.info["features"]
        columns = {name: Column(_no_rows(features[name]), features[name]["names"]) for name in self._kinds}
        writer = self.WRITER(folder, self.info["fps"], self.cameras, columns, self.info["robot_type"])
        if language.PERSISTENT in features or language.ANNOTATION in features:
            writer.add_language()
        if writer.features != self.info["features"]:
            raise ValueError(f"{self.folder}: has other features than this version writes; export it again")
        return writer

    def append_to(self, writer: lerobot.Writer, folder: Path) -> None:
        keys = self.film_keys
        for episode in self._episodes():
            films = {key: self._film(key, episode, writer.num_episodes, folder) for key in keys}
            pixels = {key: _StoredPixels(episode.known.get(key, {}), writer.films[key].new_pixels()) for key in keys}
            writer.add(episode.columns, episode.task, films, pixels, episode.more, episode.known)
        for key in keys:
            counted = writer.films[key].new_pixels()
            counted.counts = np.array(self.about["pixels"][key]["counts"], np.int64)
            counted.num_pictures = self.about["pixels"][key]["pictures"]
            writer.films[key].pixels.join(counted)

    @abstractmethod
    def _episodes(self) -> Iterator[_Episode]:
        """Yields all episodes in order."""

    def _film(self, key: str, episode: _Episode, number: int, folder: Path) -> Row:
        """Copies the film of an episode; returns its place."""
        copy = folder / path_of(self.WRITER.FILMS, number, key)
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(self.folder / path_of(self.WRITER.FILMS, int(episode.row["episode_index"]), key), copy)
        return {**place(number), "from_timestamp": 0.0, "to_timestamp": int(episode.row["length"]) / self.info["fps"]}

    def _columns_of(self, table: pa.Table) -> dict[str, Column]:
        return {name: Column(_values_of(table[name], kind), None) for name, kind in self._kinds.items()}


class Version3(_Tables):
    """A dataset of LeRobot 3.0."""

    def append_to(self, writer: lerobot.Writer, folder: Path) -> None:
        self._moved = {key: self._copy_films(key, folder) for key in self.film_keys}
        super().append_to(writer, folder)

    def _episodes(self) -> Iterator[_Episode]:
        # Numbers of episodes, frames and tasks change.
        remain = [name for name, feature in self.info["features"].items()
                  if name not in ("episode_index", "index", "task_index") and feature["dtype"] != language.DTYPE]
        tables = self._frames()
        for path in sorted((self.folder / "meta/episodes").rglob("*.parquet")):
            for rows in pq.read_table(path).to_batches(max_chunksize=_EPISODES_AT_ONCE):
                for row in rows.to_pylist():
                    known = {name: {word: row[f"stats/{name}/{word}"] for word in statistics.NAMES}
                             for name in remain}
                    more = {name: value for name, value in row.items() if name.startswith(_OWN)}
                    yield _Episode(self._columns_of(next(tables)), row["tasks"][0], known, more, row)

    def _frames(self) -> Iterator[pa.Table]:
        """Yields the frames of each episode, which are a row group."""
        file = 0
        while (path := self.folder / path_of(self.WRITER.DATA, file)).exists():
            groups = pq.ParquetFile(path)
            lengths = [groups.metadata.row_group(i).num_rows for i in range(groups.num_row_groups)]
            for first in range(0, len(lengths), _EPISODES_AT_ONCE):
                some = range(first, min(first + _EPISODES_AT_ONCE, len(lengths)))
                table = groups.read_row_groups(list(some), use_threads=False).combine_chunks()
                begin = 0
                for group in some:
                    yield table.slice(begin, lengths[group])
                    begin += lengths[group]
            file += 1

    def _copy_films(self, key: str, folder: Path) -> dict[tuple[int, int], int]:
        """Copies the films of a camera behind those that are there; returns their new numbers by their
        places."""
        pattern, moved = self.WRITER.FILMS, {}
        number = sum(1 for _ in (folder / f"videos/{key}").rglob("*.mp4"))
        old = 0
        while (source := self.folder / path_of(pattern, old, key)).exists():
            copy = folder / path_of(pattern, number, key)
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(source, copy)
            where = place(old)
            moved[where["chunk_index"], where["file_index"]] = number
            old, number = old + 1, number + 1
        return moved

    def _film(self, key: str, episode: _Episode, number: int, folder: Path) -> Row:
        row = {name: episode.row[f"videos/{key}/{name}"]
               for name in ("chunk_index", "file_index", "from_timestamp", "to_timestamp")}
        return {**row, **place(self._moved[key][row["chunk_index"], row["file_index"]])}


class Version2(_Tables):
    """A dataset of LeRobot 2.1."""

    WRITER = lerobot.WriterOfVersion2

    def _episodes(self) -> Iterator[_Episode]:
        meta = self.folder / "meta"
        with (meta / "episodes.jsonl").open() as episodes, (meta / "episodes_stats.jsonl").open() as stats:
            for row, its_stats in zip(map(json.loads, episodes), map(json.loads, stats), strict=True):
                known = {name: values for name, values in its_stats["stats"].items()
                         if name not in ("episode_index", "index", "task_index", language.ANNOTATION)}
                more = {name: value for name, value in row.items() if name.startswith(_OWN)}
                table = pq.read_table(self.folder / path_of(self.WRITER.DATA, row["episode_index"]))
                yield _Episode(self._columns_of(table), row["tasks"][0], known, more, row)


class Csv(_Tables):
    """A folder of tables and films."""

    INFO = "info.json"
    META = "smile.json"
    WRITER = csv_films.Writer

    def _rows(self) -> list[Row]:
        path = self.folder / csv_films.EPISODES
        with path.open("rb") as file:
            names = file.readline().decode().strip().split(",")
        text = pa.csv.ConvertOptions(column_types=dict.fromkeys(names, pa.string()))
        lines = pa.csv.ParseOptions(newlines_in_values=True)
        rows: list[Row] = pa.csv.read_csv(self.folder / csv_films.EPISODES, convert_options=text,
                                          parse_options=lines).to_pylist()
        return rows

    def _episodes(self) -> Iterator[_Episode]:
        features = self.info["features"]
        kinds = {}
        for name, kind in self._kinds.items():
            number = kind.value_type if pa.types.is_fixed_size_list(kind) else kind
            each = csv_films.header_of({name: features[name]})
            kinds.update(dict.fromkeys(each, pa.int64() if pa.types.is_boolean(number) else number))
        for row in self._rows():
            path = path_of(self.WRITER.DATA, int(row["episode_index"]))
            try:
                table = pa.csv.read_csv(self.folder / path, convert_options=pa.csv.ConvertOptions(
                    column_types=kinds, include_columns=list(kinds)))
            except (pa.ArrowInvalid, pa.ArrowKeyError) as error:
                raise self._mend(f"{path} cannot be read ({error})") from None
            if len(table) != int(row["length"]):
                raise self._mend(f"{path} has {len(table)} frames, but is listed with {row['length']}")
            columns = {}
            for name in self._kinds:
                each = csv_films.header_of({name: features[name]})
                values = np.stack([table[one].to_numpy() for one in each], axis=1)
                columns[name] = Column(values.astype(features[name]["dtype"]).reshape(
                    len(table), *_shape_of(features[name])), None)
            more = {name: value for name, value in row.items() if name.startswith(_OWN)}
            yield _Episode(columns, json.loads(row["tasks"])[0], {}, more, row)


def _shape_of(feature: Mapping[str, Any]) -> list[int]:
    shape: list[int] = [] if feature["names"] is None else feature["shape"]
    return shape


def _no_rows(feature: Mapping[str, Any]) -> npt.NDArray[Any]:
    return np.zeros((0, *_shape_of(feature)), feature["dtype"])


def _values_of(column: pa.ChunkedArray, kind: pa.DataType) -> npt.NDArray[Any]:
    array = column.combine_chunks()
    if pa.types.is_fixed_size_list(kind):
        values: npt.NDArray[Any] = array.flatten().to_numpy(zero_copy_only=False)
        return values.reshape(-1, kind.list_size)
    single: npt.NDArray[Any] = array.to_numpy(zero_copy_only=False)
    return single
