"""Writer of LeRobot datasets, version 3.0.

Source of the layout: LeRobot 0.6.2, src/lerobot/datasets (utils.py, dataset_metadata.py).
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt
import pyarrow as pa
import pyarrow.parquet as pq

from smile.datasets import language, statistics
from smile.datasets.episode import Column
from smile.datasets.features import Camera, array_of, depth_feature, features_of, schema_of
from smile.native import load

if TYPE_CHECKING:
    from smile import smile_simulator_native as _native
else:
    _native = load("smile_simulator_native")

MEGABYTE = 1_000_000
FILES_PER_CHUNK = 1000
EPISODES_PER_FILE = 5000
# Divides EPISODES_PER_FILE.
_EPISODES_PER_BLOCK = 250

Row = dict[str, Any]


def write_json(path: Path, content: Any) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps(content, indent=2) + "\n")


def place(file: int) -> dict[str, int]:
    """Returns the numbers in the name of a file."""
    return {"chunk_index": file // FILES_PER_CHUNK, "file_index": file % FILES_PER_CHUNK}


def path_of(pattern: str, file: int, camera: str = "") -> str:
    """Returns the name of a file, by the pattern of either version; in 2.1 files are episodes."""
    return pattern.format(**place(file), episode_chunk=file // FILES_PER_CHUNK, episode_index=file,
                          video_key=camera)


class FilmFiles:
    """Films of one camera: episodes one after another, in files of a limited size."""

    IS_DEPTH = False

    def __init__(self, folder: Path, camera: Camera, fps: int, pattern: str, megabytes: int) -> None:
        self._folder, self.camera, self._fps, self._pattern = folder, camera, fps, pattern
        self._limit = megabytes * MEGABYTE
        self._file = -1
        self._film: Any = None
        self._path = folder
        self.pixels = self.new_pixels()

    @property
    def key(self) -> str:
        """of the feature"""
        return self.camera.key

    def begin(self) -> Row:
        """Begins an episode; returns its place."""
        if self._film is not None and self._path.stat().st_size >= self._limit:
            self.finish()
        if self._film is None:
            self._file += 1
            self._path = self._folder / path_of(self._pattern, self._file, self.key)
            self._path.parent.mkdir(parents=True, exist_ok=True)
            self._film = _native.VideoWriter(self._path, self.camera.width, self.camera.height, self._fps,
                                             self.IS_DEPTH)
        return {**place(self._file), "from_timestamp": self._film.num_frames / self._fps}

    def add(self, picture: npt.NDArray[Any]) -> None:
        assert self._film is not None
        self._film.add(picture)

    def new_pixels(self) -> statistics.Pixels:
        """Returns counts of pixels, of no picture yet."""
        return statistics.Pixels()

    def end(self) -> float:
        """Ends an episode; returns its end in the film [s]."""
        assert self._film is not None
        return float(self._film.num_frames / self._fps)

    def finish(self) -> None:
        if self._film is not None:
            self._film.finish()
        self._film = None


class DepthFiles(FilmFiles):
    """Films of the depth of one camera."""

    IS_DEPTH = True

    @property
    def key(self) -> str:
        return self.camera.depth_key

    def add(self, picture: npt.NDArray[Any]) -> None:
        """picture: (height, width, 1), levels_of() depths"""
        assert self._film is not None
        self._film.add_levels(picture)

    def new_pixels(self) -> statistics.Pixels:
        return statistics.Pixels(statistics.DEPTH_LEVELS, 1)


def levels_of(depth: npt.NDArray[np.float32]) -> npt.NDArray[np.uint16]:
    """Returns depths [m] as numbers of millimeters, (height, width, 1); 0 where nothing is seen. What is
    beyond the highest level has that one."""
    return np.rint(depth * 1000.0).clip(0, statistics.DEPTH_LEVELS[-1]).astype(np.uint16)[:, :, None]


class DataFiles:
    """Parquet files of frames: a row group for each episode, in files of a limited size."""

    def __init__(self, folder: Path, schema: pa.Schema, pattern: str, megabytes: int) -> None:
        self._folder, self.schema, self._pattern = folder, schema, pattern
        self._limit = megabytes * MEGABYTE
        self._file = -1
        self._writer: Any = None
        self._sink: Any = None

    def add(self, table: pa.Table) -> Row:
        """Appends an episode; returns its place."""
        if self._sink is not None and self._sink.tell() >= self._limit:
            self.finish()
        if self._writer is None:
            self._file += 1
            path = self._folder / path_of(self._pattern, self._file)
            path.parent.mkdir(parents=True, exist_ok=True)
            self._sink = pa.OSFile(str(path), "wb")
            self._writer = pq.ParquetWriter(self._sink, self.schema, compression="snappy")
        self._writer.write_table(table, row_group_size=max(1, len(table)))
        return place(self._file)

    def finish(self) -> None:
        if self._writer is not None:
            self._writer.close()
        if self._sink is not None:
            self._sink.close()
        self._writer = self._sink = None

    def abandon(self) -> None:
        """Closes the file as it is."""
        if self._sink is not None:
            try:
                self.finish()
            except OSError:
                pass  # the reason why it was abandoned


class Writer:
    """A dataset of version 3.0 in the making."""

    VERSION = "v3.0"
    DATA = "data/chunk-{chunk_index:03d}/file-{file_index:03d}.parquet"
    FILMS = "videos/{video_key}/chunk-{chunk_index:03d}/file-{file_index:03d}.mp4"
    DATA_MEGABYTES, FILM_MEGABYTES = 100, 200
    EPISODES = "meta/episodes/chunk-{chunk_index:03d}/file-{file_index:03d}.parquet"

    def __init__(self, folder: Path, fps: int, cameras: list[Camera], columns: Mapping[str, Column],
                 robot: str) -> None:
        """columns: of any episode; the others have the same"""
        self._folder, self._fps, self._robot = folder, fps, robot
        with_depth = [camera for camera in cameras if "depth" in camera.maps]
        self.features = {**{camera.depth_key: depth_feature(camera, fps) for camera in with_depth},
                         **features_of(columns, cameras, fps)}
        self._schema = schema_of(self.features)
        films = [kind(folder, camera, fps, self.FILMS, self.FILM_MEGABYTES)
                 for kind, some in ((FilmFiles, cameras), (DepthFiles, with_depth)) for camera in some]
        self.films = {film.key: film for film in films}
        self._data = DataFiles(folder, self._schema, self.DATA, self.DATA_MEGABYTES)
        self._tasks: dict[str, int] = {}
        self._episodes: list[Row] = []
        self._num_episodes = self._num_frames = 0
        self._blocks: dict[int, list[pa.Table]] = {}
        self._totals: dict[str, statistics.Values] = {}

    def add_language(self) -> None:
        """Lets each frame have the words of its subtask. To be called before the first episode."""
        self.features = {**self.features, **language.FEATURES}
        self._data.schema = pa.schema([*self._schema, *language.TYPES.items()])

    @property
    def num_episodes(self) -> int:
        return self._num_episodes

    @property
    def num_frames(self) -> int:
        return self._num_frames

    def add(self, columns: Mapping[str, Column], task: str, films: Mapping[str, Row],
            pixels: Mapping[str, statistics.Pixels], more: Row,
            known: Mapping[str, statistics.Statistics] | None = None) -> None:
        """Appends an episode, whose pictures are already in its films.

        films   by camera: chunk_index, file_index, from_timestamp, to_timestamp
        pixels  by camera
        more    further columns of the episode
        known   statistics of the episode, by feature, as far as they were computed before
        """
        length = len(next(iter(columns.values())).values)
        values = {name: column.values for name, column in columns.items()}
        values.update(self._default_columns(length, task))
        self._add_words(values, more)
        data = self._write_frames(values, more)
        row: Row = {"episode_index": self._num_episodes, "tasks": [task], "length": length}
        row.update({f"data/{name}": number for name, number in data.items()})
        row["dataset_from_index"] = self._num_frames
        row["dataset_to_index"] = self._num_frames + length
        for camera, film in films.items():
            row.update({f"videos/{camera}/{name}": value for name, value in film.items()})
        row["stats"] = self._statistics_of(values, pixels, known or {})
        row.update(more)
        self._num_episodes += 1
        self._num_frames += length
        self._list(row)

    def _list(self, row: Row) -> None:
        """Appends an episode to the list of episodes."""
        self._episodes.append(row)
        if len(self._episodes) == _EPISODES_PER_BLOCK:
            self._make_block()

    def _make_block(self) -> None:
        """Packs the last episodes of the list: as objects of Python they need some times the memory."""
        if self._episodes:
            file = (self._num_episodes - 1) // EPISODES_PER_FILE
            self._blocks.setdefault(file, []).append(_episodes_table(self._episodes, place(file)))
            self._episodes = []

    def _add_words(self, values: dict[str, npt.NDArray[Any]], more: Row) -> None:
        """Adds features that are numbers and stand for words."""

    def _write_frames(self, values: Mapping[str, npt.NDArray[Any]], more: Row) -> Row:
        """Appends the frames of an episode to the data; returns their place."""
        arrays = [array_of(values[field.name], field.type) for field in self._schema]
        if language.PERSISTENT in self.features:
            rows = language.rows_of(more["smile/subtask_words"], more["sparse_subtask_start_frames"], self._fps)
            arrays += [array for _, array in language.arrays_of(rows, len(arrays[0]))]
        return self._data.add(pa.table(arrays, schema=self._data.schema))

    def _default_columns(self, length: int, task: str) -> dict[str, npt.NDArray[Any]]:
        frames = np.arange(length)
        return {"timestamp": (frames / self._fps).astype(np.float32), "frame_index": frames,
                "episode_index": np.full(length, self._num_episodes),
                "index": self._num_frames + frames,
                "task_index": np.full(length, self._tasks.setdefault(task, len(self._tasks)))}

    def _statistics_of(self, values: Mapping[str, npt.NDArray[Any]],
                       pixels: Mapping[str, statistics.Pixels],
                       known: Mapping[str, statistics.Statistics]) -> dict[str, statistics.Statistics]:
        of_episode = {}
        for name, feature in self.features.items():
            if feature["dtype"] == language.DTYPE:
                continue
            if name in values:
                if name not in self._totals:
                    self._totals[name] = statistics.Values(self._folder, name)
                self._totals[name].add(values[name])
                of_episode[name] = known[name] if name in known else statistics.of_rows(values[name])
            else:
                self.films[name].pixels.join(pixels[name])
                of_episode[name] = pixels[name].statistics()
        return of_episode

    def finish(self) -> dict[str, statistics.Statistics]:
        """Completes all files; returns the statistics of the dataset."""
        for film in self.films.values():
            film.finish()
        self._data.finish()
        totals = {name: self.films[name].pixels.statistics() if name in self.films
                  else self._totals[name].statistics()
                  for name, feature in self.features.items() if feature["dtype"] != language.DTYPE}
        self._write_meta(totals)
        return totals

    def abandon(self) -> None:
        """Closes what is open."""
        self._data.abandon()

    def _info(self) -> Row:
        return {"codebase_version": self.VERSION, "robot_type": self._robot,
                "total_episodes": self._num_episodes, "total_frames": self._num_frames,
                "total_tasks": len(self._tasks), "chunks_size": FILES_PER_CHUNK,
                "fps": self._fps, "splits": {"train": f"0:{self._num_episodes}"},
                "data_path": self.DATA, "video_path": self.FILMS if self.films else None,
                "features": self.features}

    def _write_meta(self, totals: dict[str, statistics.Statistics]) -> None:
        info = self._info()
        info["data_files_size_in_mb"] = self.DATA_MEGABYTES
        info["video_files_size_in_mb"] = self.FILM_MEGABYTES
        write_json(self._folder / "meta/info.json", info)
        write_json(self._folder / "meta/stats.json", totals)
        pq.write_table(_tasks_table(list(self._tasks)), self._folder / "meta/tasks.parquet")
        self._make_block()
        for file, blocks in self._blocks.items():
            path = self._folder / self.EPISODES.format(**place(file))
            path.parent.mkdir(parents=True, exist_ok=True)
            # Where a block knows no value of a column, another one tells its type.
            table = pa.concat_tables(blocks, promote_options="permissive").combine_chunks()
            pq.write_table(table, path, compression="snappy")


class WriterOfVersion2(Writer):
    """A dataset of version 2.1 in the making: a file for each episode, and meta data in lines of JSON.

    With `modality.json`, for GR00T. Source: LeRobot 0.3.3; GR00T, "Data preparation".
    """

    VERSION = "v2.1"
    DATA = "data/chunk-{episode_chunk:03d}/episode_{episode_index:06d}.parquet"
    FILMS = "videos/chunk-{episode_chunk:03d}/{video_key}/episode_{episode_index:06d}.mp4"
    # Each episode begins a file.
    DATA_MEGABYTES, FILM_MEGABYTES = 0, 0

    def add_language(self) -> None:
        # Annotations of GR00T are numbers in the list of tasks.
        self.features = {**self.features, language.ANNOTATION: {"dtype": "int64", "shape": [1], "names": None}}
        self._schema = self._data.schema = schema_of(self.features)

    def _add_words(self, values: dict[str, npt.NDArray[Any]], more: Row) -> None:
        if language.ANNOTATION in self.features:
            numbers = [self._tasks.setdefault(words, len(self._tasks)) for words in more["smile/subtask_words"]]
            values[language.ANNOTATION] = np.array(numbers)[values["sim.subtask"]]

    def _list(self, row: Row) -> None:
        self._episodes.append(_listed(row))
        meta = self._folder / "meta"
        meta.mkdir(exist_ok=True)
        with (meta / "episodes_stats.jsonl").open("a") as file:
            file.write(json.dumps({"episode_index": row["episode_index"], "stats": row["stats"]}) + "\n")

    def _write_meta(self, totals: dict[str, statistics.Statistics]) -> None:
        info = self._info()
        info["total_videos"] = self.num_episodes * len(self.films)
        info["total_chunks"] = -(-self.num_episodes // FILES_PER_CHUNK)
        meta = self._folder / "meta"
        write_json(meta / "info.json", info)
        # Readers of version 2.0 look for it.
        write_json(meta / "stats.json", totals)
        write_json(meta / "modality.json", modality_of(self.features))
        _write_lines(meta / "tasks.jsonl", ({"task_index": number, "task": task}
                                            for task, number in self._tasks.items()))
        _write_lines(meta / "episodes.jsonl", self._episodes)


def _listed(row: Row) -> Row:
    """Returns an episode without what version 2.1 has elsewhere."""
    places = ("data/", "videos/", "dataset_", "stats")
    return {name: value for name, value in row.items() if not name.startswith(places)}


def _write_lines(path: Path, rows: Iterable[Row]) -> None:
    path.write_text("".join(json.dumps(row) + "\n" for row in rows))


def modality_of(features: Mapping[str, Any]) -> Row:
    """Returns `modality.json`: the parts of states and actions, by arm and gripper."""
    parts = {name: _parts_of(features[key]["names"]) if key in features else {}
             for name, key in (("state", "observation.state"), ("action", "action"))}
    cameras = {key.removeprefix("observation.images."): {"original_key": key}
               for key, feature in features.items() if feature["dtype"] == "video"}
    annotations = {"human.task_description": {"original_key": "task_index"}}
    if language.ANNOTATION in features:
        annotations[language.ANNOTATION.removeprefix("annotation.")] = {"original_key": language.ANNOTATION}
    return {**parts, "video": cameras, "annotation": annotations}


def _parts_of(names: Sequence[str]) -> dict[str, dict[str, int]]:
    """The joints of an arm are followed by its gripper."""
    parts, begin = {}, 0
    for at, name in enumerate(names):
        if name.endswith("_gripper"):
            if at > begin:
                parts[name.removesuffix("_gripper") + "_arm"] = {"start": begin, "end": at}
            parts[name] = {"start": at, "end": at + 1}
            begin = at + 1
    if begin < len(names):
        parts["others" if parts else "joints"] = {"start": begin, "end": len(names)}
    return parts


def _tasks_table(tasks: Sequence[str]) -> pa.Table:
    """Readers find a task by the index of a pandas frame, which the file must declare."""
    def column(name: str, pandas_type: str, numpy_type: str) -> Row:
        return {"name": name, "field_name": name, "pandas_type": pandas_type, "numpy_type": numpy_type,
                "metadata": None}

    pandas = {"index_columns": ["task"],
              "column_indexes": [{**column("", "unicode", "object"), "name": None, "field_name": None,
                                  "metadata": {"encoding": "UTF-8"}}],
              "columns": [column("task_index", "int64", "int64"), column("task", "unicode", "object")],
              "creator": {"library": "pyarrow", "version": pa.__version__}, "pandas_version": "2.0.0"}
    schema = pa.schema([("task_index", pa.int64()), ("task", pa.string())],
                       metadata={"pandas": json.dumps(pandas)})
    return pa.table([list(range(len(tasks))), list(tasks)], schema=schema)


def _episodes_table(rows: Sequence[Row], file: Mapping[str, int]) -> pa.Table:
    flat = []
    for row in rows:
        one = {name: value for name, value in row.items() if name != "stats"}
        one.update({f"meta/episodes/{name}": number for name, number in file.items()})
        for feature, values in row["stats"].items():
            one.update({f"stats/{feature}/{name}": value for name, value in values.items()})
        flat.append(one)
    return pa.Table.from_pylist(flat)
