"""A LeRobot dataset as it lies in a folder, of version 3.0 or 2.1, for checks."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow.parquet as pq

VERSIONS = ("v3.0", "v2.1")


class LayoutError(ValueError):
    """A dataset that cannot be looked at; `advice` says what to do."""

    def __init__(self, where: str, message: str, advice: str) -> None:
        super().__init__(f"{where}: {message}")
        self.where, self.message, self.advice = where, message, advice


@dataclass(frozen=True)
class FilmPart:
    """The part of a film that belongs to an episode."""

    path: Path
    begin: float
    """[s]"""
    end: float


@dataclass(frozen=True)
class ListedEpisode:
    """An episode as the list of episodes describes it."""

    index: int
    length: int
    data: Path
    begin: int | None
    """number of its first frame in the dataset; None if the list does not say"""
    films: dict[str, FilmPart]
    more: dict[str, Any]


@dataclass
class Layout:
    """A dataset."""

    folder: Path
    info: dict[str, Any]
    episodes: list[ListedEpisode] = field(default_factory=list)
    tasks: dict[int, str] = field(default_factory=dict)
    stats: dict[str, Any] | None = None
    """None if there are none"""

    @property
    def features(self) -> dict[str, dict[str, Any]]:
        features: dict[str, dict[str, Any]] = self.info["features"]
        return features

    @property
    def film_keys(self) -> list[str]:
        return [name for name, feature in self.features.items() if feature.get("dtype") == "video"]


def place_of(path: Path) -> tuple[str, Path]:
    """Returns the format of a dataset, as in FORMATS, and its file or folder. Raises LayoutError if it
    is none of them."""
    if path.is_file() and path.suffix in (".hdf5", ".h5"):
        return "robomimic", path
    if path.is_file() and path.suffix == ".mcap" or any(path.glob("*.mcap")):
        return "mcap", path
    if path.suffix == ".rrd" or any(path.glob("*.rrd")):
        raise LayoutError(path.name, "is for viewers, and no dataset to learn from", "check it with `rerun rrd verify`, "
                          "or export another format")
    if (path / ".zgroup").exists():
        return "zarr", path
    for pattern, format in (("*.hdf5", "robomimic"), ("*.zarr", "zarr")):
        found = sorted(path.glob(pattern))
        if len(found) == 1:
            return format, found[0]
    if (path / "episodes.csv").exists():
        return "csv", path
    version = _read_json(path / "meta/info.json").get("codebase_version")
    if version not in VERSIONS:
        raise LayoutError("meta/info.json", f"codebase_version is {version!r}, expected {' or '.join(VERSIONS)}",
                          "convert the dataset with LeRobot's own scripts")
    return f"lerobot-{version}", path


def read_layout(folder: Path) -> Layout:
    """Reads the meta data. Raises LayoutError if that is not possible."""
    info = _read_json(folder / "meta/info.json")
    for name, kind in (("fps", (int, float)), ("features", dict), ("data_path", str)):
        if not isinstance(info.get(name), kind) or info[name] == 0:
            raise LayoutError("meta/info.json", f"{name} is {info.get(name)!r}", "make the dataset again")
    layout = Layout(folder, info)
    (_read_version_3 if info["codebase_version"] == "v3.0" else _read_version_2)(layout)
    return layout


def _read_json(path: Path) -> dict[str, Any]:
    name = f"meta/{path.name}"
    try:
        content = json.loads(path.read_text())
    except FileNotFoundError:
        raise LayoutError(name, "is missing", "expected the folder of a LeRobot dataset, an HDF5 file, Zarr "
                          "arrays or MCAP files") from None
    except ValueError as error:
        raise LayoutError(name, f"is not JSON: {error}", "make the dataset again") from None
    if not isinstance(content, dict):
        raise LayoutError(name, "is not an object", "make the dataset again")
    return content


def read_table(folder: Path, path: Path) -> Any:
    """Reads a Parquet file. Raises LayoutError if it is not one."""
    name = str(path.relative_to(folder))
    if not path.exists():
        raise LayoutError(name, "is missing, but the dataset refers to it",
                          "copy the whole folder again, or make the dataset again")
    try:
        return pq.read_table(path)
    except (ValueError, OSError) as error:
        raise LayoutError(name, f"cannot be read ({str(error).splitlines()[0]}): its writer was interrupted "
                          "before it was closed, or it was cut",
                          "remove these episodes, or make the dataset again") from None


def _read_version_3(layout: Layout) -> None:
    meta = layout.folder / "meta"
    tasks = read_table(layout.folder, meta / "tasks.parquet")
    pandas = json.loads((tasks.schema.metadata or {}).get(b"pandas", b"{}"))
    texts = pandas.get("index_columns", [])
    # Not a name but a range, if pandas wrote its own numbers.
    if len(texts) != 1 or not isinstance(texts[0], str) or texts[0] not in tasks.column_names:
        raise LayoutError("meta/tasks.parquet", "does not declare the tasks as the index of a pandas frame: "
                          "LeRobot would read numbers instead of tasks",
                          "write it with pandas: frame.set_index('task')")
    layout.tasks = dict(zip(tasks["task_index"].to_pylist(), tasks[texts[0]].to_pylist()))
    layout.stats = _read_json(meta / "stats.json") if (meta / "stats.json").exists() else None
    files = sorted(meta.glob("episodes/chunk-*/file-*.parquet"))
    if not files:
        raise LayoutError("meta/episodes", "has no files", "copy the whole folder again, or make the dataset again")
    for file in files:
        table = read_table(layout.folder, file)
        # Without the statistics of episodes, of which there are many.
        for row in table.select([name for name in table.column_names if not name.startswith("stats/")]).to_pylist():
            layout.episodes.append(_episode_of_version_3(layout, row))


def _episode_of_version_3(layout: Layout, row: dict[str, Any]) -> ListedEpisode:
    try:
        data = layout.folder / layout.info["data_path"].format(
            chunk_index=row["data/chunk_index"], file_index=row["data/file_index"])
        films = {}
        for key in layout.film_keys:
            path = layout.folder / str(layout.info.get("video_path")).format(
                video_key=key, chunk_index=row[f"videos/{key}/chunk_index"],
                file_index=row[f"videos/{key}/file_index"])
            films[key] = FilmPart(path, row[f"videos/{key}/from_timestamp"],
                                  row[f"videos/{key}/to_timestamp"])
        return ListedEpisode(row["episode_index"], row["length"], data, row["dataset_from_index"], films,
                             row)
    except KeyError as error:
        raise LayoutError("meta/episodes", f"has no column {error}", "make the dataset again") from None


def _read_version_2(layout: Layout) -> None:
    meta = layout.folder / "meta"
    layout.tasks = {row["task_index"]: row["task"] for row in _read_lines(meta / "tasks.jsonl")}
    stats = _read_lines(meta / "episodes_stats.jsonl")
    layout.stats = _joined([row["stats"] for row in stats]) if stats else None
    size = layout.info.get("chunks_size", 1000)
    for row in _read_lines(meta / "episodes.jsonl"):
        number = {"episode_chunk": row["episode_index"] // size, "episode_index": row["episode_index"]}
        pattern, seconds = str(layout.info.get("video_path")), row["length"] / layout.info["fps"]
        films = {key: FilmPart(layout.folder / pattern.format(video_key=key, **number), 0, seconds)
                 for key in layout.film_keys}
        data = layout.folder / layout.info["data_path"].format(**number)
        layout.episodes.append(ListedEpisode(row["episode_index"], row["length"], data, None, films, row))


def _joined(stats: list[dict[str, Any]]) -> dict[str, Any]:
    """Returns statistics of all episodes as far as checks go: those of the first one, but with the
    spread of all."""
    joined = dict(stats[0])
    for name, first in joined.items():
        try:
            low, high, deviation = (np.array([one[name][word] for one in stats], float)
                                    for word in ("min", "max", "std"))
        except (KeyError, ValueError):
            continue  # the check of the statistics reports it
        spread = np.maximum(deviation.max(axis=0), high.max(axis=0) - low.min(axis=0))
        joined[name] = {**first, "std": spread.tolist()}
    return joined


def _read_lines(path: Path) -> list[dict[str, Any]]:
    name = f"meta/{path.name}"
    try:
        return [json.loads(line) for line in path.read_text().splitlines() if line]
    except FileNotFoundError:
        raise LayoutError(name, "is missing", "copy the whole folder again, or make the dataset again") from None
    except ValueError as error:
        raise LayoutError(name, f"is not JSON: {error}", "make the dataset again") from None
