"""Writer of Zarr arrays, as Diffusion Policy reads them: all episodes one after another.

Source of the layout: diffusion_policy, common/replay_buffer.py.
"""

from __future__ import annotations

import contextlib
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import zarr
from numcodecs import blosc

from smile.datasets import statistics
from smile.datasets.episode import Column
from smile.datasets.features import Camera, features_of
from smile.datasets.lerobot import Row
from smile.datasets.pictures import Pictures
from smile.datasets.stored import Stored

FOLDER = "replay.zarr"
_FRAMES_PER_CHUNK = 1024
_PICTURES_PER_CHUNK = 32


class Writer:
    """A folder `replay.zarr` in the making."""

    def __init__(self, folder: Path, fps: int, cameras: list[Camera], columns: Mapping[str, Column],
                 robot: str) -> None:
        self.features = features_of(columns, cameras, fps)
        self.films = {camera.key: Pictures(camera) for camera in cameras}
        self._root = zarr.open_group(str(folder / FOLDER), mode="w")
        self._data, self._meta = self._root.create_group("data"), self._root.create_group("meta")
        self._values: dict[str, list[npt.NDArray[Any]]] = {
            name: [] for name in ("observation.state", "action") if name in columns}
        self._ends: list[int] = []
        self._episodes: list[Row] = []
        self._root.attrs["fps"], self._root.attrs["robot"] = fps, robot
        self._root.attrs["names"] = {_name_of(name): column.names for name, column in columns.items()
                                     if column.names is not None}

    @property
    def num_episodes(self) -> int:
        return len(self._ends)

    @property
    def num_frames(self) -> int:
        return self._ends[-1] if self._ends else 0

    def add(self, columns: Mapping[str, Column], task: str, films: Mapping[str, Row],
            pixels: Mapping[str, statistics.Pixels], more: Row) -> None:
        """Appends an episode, whose pictures `films` have."""
        for name, values in self._values.items():
            values.append(columns[name].values)
        for name, column in columns.items():
            self._append(_name_of(name), column.values, _FRAMES_PER_CHUNK)
        for pictures in self.films.values():
            self._append(pictures.camera.name, np.stack(pictures.frames), _PICTURES_PER_CHUNK)
            for name, maps in pictures.maps.items():
                self._append(f"{pictures.camera.name}_{name}", np.stack(maps), _PICTURES_PER_CHUNK)
        self._ends.append(self.num_frames + len(next(iter(columns.values())).values))
        self._episodes.append({"task": task, **more})

    def _append(self, name: str, values: npt.NDArray[Any], frames_per_chunk: int) -> None:
        if name not in self._data:
            shape = values.shape[1:]
            self._data.create_dataset(name, shape=(0, *shape), chunks=(frames_per_chunk, *shape),
                                      dtype=values.dtype)
        with _one_thread():
            self._data[name].append(values)

    def append(self, root: zarr.Group) -> None:
        """Appends all episodes of another dataset."""
        for name, array in root["data"].arrays():
            step = array.chunks[0]
            for begin in range(0, len(array), step):
                self._append(name, array[begin:begin + step], step)
        for name, values in self._values.items():
            values.append(root["data"][_name_of(name)][:])
        begin = self.num_frames
        self._ends += [begin + int(end) for end in root["meta/episode_ends"][:]]
        self._episodes += root.attrs["episodes"]

    def finish(self) -> dict[str, statistics.Statistics]:
        """Completes the arrays; returns the statistics of states and actions."""
        self._meta.array("episode_ends", np.array(self._ends, np.int64))
        self._root.attrs["episodes"] = self._episodes
        return {name: statistics.of_rows(np.concatenate(values)) for name, values in self._values.items()}

    def abandon(self) -> None:
        """Does nothing: no file stays open."""


@contextlib.contextmanager
def _one_thread() -> Iterator[None]:
    """Lets Blosc compress with one thread: several write the blocks of a chunk as they finish, so
    the same pictures would be other bytes each time."""
    before, blosc.use_threads = blosc.use_threads, False
    try:
        yield
    finally:
        blosc.use_threads = before


class StoredFile(Stored):
    """A dataset with a folder `replay.zarr`."""

    def common(self) -> Row:
        root = self._open()
        arrays = {name: [list(array.shape[1:]), str(array.dtype)] for name, array in sorted(root["data"].arrays())}
        return {"format": "zarr", **{name: root.attrs[name] for name in ("fps", "robot", "names")},
                "arrays": arrays, "action": self.about["action"], "dropped": self.about["dropped"]}

    def require_sound(self) -> None:
        super().require_sound()
        root = self._open()
        if len(root.attrs.get("episodes", [])) != len(root["meta/episode_ends"]):
            raise self._mend("meta/episode_ends does not fit to the list of episodes")

    def new_writer(self, folder: Path) -> Writer:
        root = self._open()
        names = {"observation.state" if name == "state" else name: its for name, its in root.attrs["names"].items()}
        columns = {name: Column(np.zeros((0, len(its)), np.float32), its) for name, its in names.items()}
        return Writer(folder, root.attrs["fps"], [], columns, root.attrs["robot"])

    def append_to(self, writer: Writer, folder: Path) -> None:
        writer.append(self._open())

    def _open(self) -> zarr.Group:
        try:
            root = zarr.open_group(str(self.folder / FOLDER), mode="r")
            root["data"], root["meta/episode_ends"]
        except (ValueError, KeyError, OSError) as error:
            raise self._mend(f"{FOLDER} cannot be read ({error!r})") from None
        return root


def _name_of(feature: str) -> str:
    """`state` and `action`, as readers call them; others keep their names."""
    return feature.removeprefix("observation.")
