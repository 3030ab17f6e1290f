"""Writer of robomimic's HDF5, with what MimicGen needs to start from it.

Source of the layout: robomimic 0.5.0, robomimic/utils/dataset.py, scripts/get_dataset_info.py;
MimicGen, mimicgen/utils/file_utils.py.
"""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import numpy.typing as npt

from smile.datasets import statistics
from smile.datasets.episode import Column
from smile.datasets.features import Camera, features_of
from smile.datasets.lerobot import Row
from smile.datasets.pictures import Pictures
from smile.datasets.stored import Stored

FILE = "demo.hdf5"
# Of ten episodes, the last is for validation.
_VALID_EACH = 10
# robomimic's number for environments of gym; training needs no environment.
_GYM = 2


class Writer:
    """A file `demo.hdf5` in the making."""

    def __init__(self, folder: Path, fps: int, cameras: list[Camera], columns: Mapping[str, Column],
                 robot: str) -> None:
        if "action" not in columns:
            raise ValueError("robomimic needs actions, but no robot moves in these runs; export them as LeRobot")
        self.features = features_of(columns, cameras, fps)
        self.films = {camera.key: Pictures(camera) for camera in cameras}
        self._fps, self._robot = fps, robot
        self._file = h5py.File(folder / FILE, "w", libver="latest")
        self._data = self._file.create_group("data")
        self._values: dict[str, list[npt.NDArray[Any]]] = {"observation.state": [], "action": []}
        self.num_frames = 0

    @property
    def num_episodes(self) -> int:
        return len(self._values["action"])

    def add(self, columns: Mapping[str, Column], task: str, films: Mapping[str, Row],
            pixels: Mapping[str, statistics.Pixels], more: Row) -> None:
        """Appends an episode, whose pictures `films` have."""
        demo = self._data.create_group(f"demo_{self.num_episodes}")
        for name, values in self._values.items():
            values.append(columns[name].values)
        length = len(columns["action"].values)
        self.num_frames += length
        demo.attrs["num_samples"], demo.attrs["task"] = length, task
        for name, value in more.items():
            if isinstance(value, str):
                demo.attrs[name] = value
            elif value is not None:
                demo.attrs[name] = json.dumps(value)
        # Those of the format are scaled by all episodes.
        demo["unscaled_actions"] = columns["action"].values
        demo["dones"] = columns["next.done"].values.astype(np.uint8)
        success = columns.get("next.success", columns["next.done"])
        demo["rewards"] = success.values.astype(np.float32)
        demo["states"] = columns["sim.tick"].values.astype(np.float64)[:, None]
        self._add_observations(demo.create_group("obs"), columns)
        _add_datagen_info(demo.create_group("datagen_info"), columns, more)

    def append(self, demo: h5py.Group) -> None:
        """Appends an episode of another file."""
        copy = self._data.create_group(f"demo_{self.num_episodes}")
        for name, value in demo.attrs.items():
            copy.attrs[name] = value
        for name in demo:
            if name != "actions":
                demo.copy(name, copy)
        self._values["action"].append(demo["unscaled_actions"][:])
        self._values["observation.state"].append(demo["obs/state"][:])
        self.num_frames += int(demo.attrs["num_samples"])

    def _add_observations(self, group: h5py.Group, columns: Mapping[str, Column]) -> None:
        group["state"] = columns["observation.state"].values
        group["tool_poses"] = columns["sim.tool_poses"].values
        if "sim.object_poses" in columns:
            group["object"] = columns["sim.object_poses"].values
        for pictures in self.films.values():
            group[f"{pictures.camera.name}_pose"] = columns[f"sim.camera_pose.{pictures.camera.name}"].values
            group.create_dataset(f"{pictures.camera.name}_image", data=np.stack(pictures.frames),
                                 compression="gzip", compression_opts=1,
                                 chunks=(1, pictures.camera.height, pictures.camera.width, 3))
            for name, values in pictures.maps.items():
                # The last axis is that of channels, as of colors.
                group.create_dataset(f"{pictures.camera.name}_{name}", data=np.stack(values)[..., np.newaxis],
                                     compression="gzip", compression_opts=1,
                                     chunks=(1, pictures.camera.height, pictures.camera.width, 1))

    def finish(self) -> dict[str, statistics.Statistics]:
        """Completes the file; returns the statistics of states and actions."""
        totals = {name: statistics.of_rows(np.concatenate(values)) for name, values in self._values.items()}
        low, high = np.array(totals["action"]["min"]), np.array(totals["action"]["max"])
        offset, scale = (low + high) / 2, np.where(high > low, (high - low) / 2, 1)
        for number, action in enumerate(self._values["action"]):
            scaled = np.clip((action - offset) / scale, -1, 1)
            self._data[f"demo_{number}"]["actions"] = scaled.astype(np.float32)
        self._data.attrs["total"] = self.num_frames
        self._data.attrs["env_args"] = json.dumps({
            "env_name": f"smile-{self._robot}", "type": _GYM, "env_kwargs": {"fps": self._fps}})
        self._data.attrs["action_offset"], self._data.attrs["action_scale"] = offset, scale
        for name in ("action", "observation.state", "sim.object_poses", "sim.tool_poses"):
            if name in self.features:
                self._data.attrs[f"names.{name}"] = json.dumps(self.features[name]["names"])
        names = [f"demo_{number}" for number in range(self.num_episodes)]
        valid = names[_VALID_EACH - 1::_VALID_EACH]
        for mask, chosen in (("train", [name for name in names if name not in valid]), ("valid", valid)):
            self._file[f"mask/{mask}"] = np.array(chosen, dtype="S16")
        self._file.close()
        return totals

    def abandon(self) -> None:
        """Closes what is open."""
        try:
            self._file.close()
        except (OSError, RuntimeError):
            pass  # the reason why it was abandoned


class StoredFile(Stored):
    """A dataset with a file `demo.hdf5`."""

    def common(self) -> Row:
        with self._open() as file:
            data = file["data"]
            attributes = {name: value for name, value in data.attrs.items()
                          if name == "env_args" or name.startswith("names.")}
            demo = data["demo_0"]
            arrays: list[str] = []
            demo.visit(lambda name: arrays.append(name) if name.startswith("obs/") else None)
            shapes = {name: demo[name].shape[1:] for name in arrays}
        return {"format": "robomimic", **attributes, "observations": shapes, "action": self.about["action"],
                "dropped": self.about["dropped"]}

    def require_sound(self) -> None:
        super().require_sound()
        with self._open() as file:
            for number in range(len(file["data"])):
                if "unscaled_actions" not in file["data"].get(f"demo_{number}", {}):
                    raise self._mend(f"demo_{number} is missing, or is of an earlier export")

    def new_writer(self, folder: Path) -> Writer:
        with self._open() as file:
            attributes = dict(file["data"].attrs)
        environment = json.loads(attributes["env_args"])
        columns = {}
        for name, value in attributes.items():
            if name.startswith("names."):
                names = json.loads(value)
                columns[name.removeprefix("names.")] = Column(np.zeros((0, len(names)), np.float32), names)
        return Writer(folder, environment["env_kwargs"]["fps"], [], columns,
                      environment["env_name"].removeprefix("smile-"))

    def append_to(self, writer: Writer, folder: Path) -> None:
        with self._open() as file:
            for number in range(len(file["data"])):
                writer.append(file[f"data/demo_{number}"])

    def _open(self) -> h5py.File:
        try:
            return h5py.File(self.folder / FILE, "r")
        except OSError as error:
            raise self._mend(f"{FILE} cannot be read ({error})") from None


def _add_datagen_info(group: h5py.Group, columns: Mapping[str, Column], more: Row) -> None:
    """For MimicGen, which knows one arm: that whose tool moves most."""
    tools = columns["sim.tool_poses"].values.reshape(len(columns["sim.tool_poses"].values), -1, 7)
    way = np.linalg.norm(np.diff(tools[:, :, :3], axis=0), axis=2).sum(axis=0)
    arm = int(np.argmax(way))
    names = columns["sim.tool_poses"].names
    assert names is not None
    arm_name = names[7 * arm].removesuffix(".x")
    poses = matrices_of(tools[:, arm])
    group.attrs["arm"] = arm_name
    group["eef_pose"] = poses
    group["target_pose"] = np.concatenate([poses[1:], poses[-1:]])
    action_names = columns["action"].names
    assert action_names is not None
    grippers = [i for i, name in enumerate(action_names) if name == f"{arm_name}_gripper"]
    group["gripper_action"] = columns["action"].values[:, grippers]
    if "sim.object_poses" in columns:
        ids = columns["sim.object_exists"].names or []
        objects = columns["sim.object_poses"].values.reshape(len(poses), -1, 7)
        for i, id in enumerate(ids):
            group[f"object_poses/{id}"] = matrices_of(objects[:, i])
    seen: Counter[str] = Counter()
    for name, end in zip(more["sparse_subtask_names"], more["sparse_subtask_end_frames"]):
        word = name.replace(" ", "_").replace("/", "_")
        seen[word] += 1
        signal = np.zeros(len(poses), np.int64)
        # The edge from 0 to 1 is the end of the subtask.
        signal[min(end, len(poses) - 1):] = 1
        group[f"subtask_term_signals/{word}" + (f"_{seen[word]}" if seen[word] > 1 else "")] = signal


def matrices_of(poses: npt.NDArray[Any]) -> npt.NDArray[np.float64]:
    """Returns poses, (n, 7) with quaternions w, x, y, z, as (n, 4, 4) matrices."""
    w, x, y, z = poses[:, 3:].astype(float).T
    matrices = np.zeros((len(poses), 4, 4))
    matrices[:, :3, :3] = np.moveaxis(np.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]), 2, 0)
    matrices[:, :3, 3] = poses[:, :3]
    matrices[:, 3, 3] = 1
    return matrices
