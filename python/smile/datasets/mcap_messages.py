"""Writer of MCAP: an episode is a file of messages of Foxglove's schemas, which Foxglove and others show.

Source of the messages: Foxglove, foxglove-schemas-protobuf 0.4.0; of the file: mcap 1.6.0.
"""

from __future__ import annotations

import json
import shutil
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt
from foxglove_schemas_protobuf.CameraCalibration_pb2 import CameraCalibration
from foxglove_schemas_protobuf.CompressedImage_pb2 import CompressedImage
from foxglove_schemas_protobuf.FrameTransforms_pb2 import FrameTransforms
from foxglove_schemas_protobuf.JointStates_pb2 import JointStates
from foxglove_schemas_protobuf.Log_pb2 import Log
from foxglove_schemas_protobuf.RawImage_pb2 import RawImage
from foxglove_schemas_protobuf.SceneUpdate_pb2 import SceneUpdate
from mcap.exceptions import McapError
from mcap.reader import make_reader
from mcap.writer import CompressionType
from mcap.writer import Writer as FileWriter
from mcap_protobuf.schema import register_schema

from smile.datasets import statistics
from smile.datasets.episode import Column, Episode
from smile.datasets.lerobot import Row
from smile.datasets.mcap_doctor import FAILURES
from smile.datasets.pictures import Pictures
from smile.datasets.scene_pieces import WORLD, ScenePieces, name_of
from smile.datasets.scene_writer import MEASURED, SceneWriter
from smile.datasets.stored import Stored
from smile.picture import Picture

FILE = "episode_{:06d}.mcap"
VALUES = "smile.Values"
_NANOSECONDS = 1_000_000_000
# Of features: a number for each dimension, which viewers can plot.
_VALUES = json.dumps({"type": "object", "additionalProperties": {"type": "number"}}).encode()


class Writer(SceneWriter):
    """A folder with a file for each episode in the making."""

    _scene: _Scene | None = None

    def observe(self, episode: Episode, intrinsics: Mapping[str, Any]) -> None:
        super().observe(episode, intrinsics)
        self._scene = _Scene(episode)

    def add(self, columns: Mapping[str, Column], task: str, films: Mapping[str, Row],
            pixels: Mapping[str, statistics.Pixels], more: Row) -> None:
        """Appends an episode, whose pictures `films` have."""
        assert self._scene is not None
        for name, values in self.measured.items():
            values.append(columns[name].values)
        length = len(next(iter(columns.values())).values)
        with _File(self.folder / FILE.format(self.num_episodes)) as file:
            file.add_metadata({"task": task, "fps": self.fps, **more})
            for frame in range(length):
                self._add_frame(file, frame, columns, more)
        self.num_episodes += 1
        self.num_frames += length

    def _add_frame(self, file: _File, frame: int, columns: Mapping[str, Column], more: Row) -> None:
        assert self._scene is not None
        time = frame * _NANOSECONDS // self.fps
        for name, column in columns.items():
            if name.startswith("sim.camera_pose."):
                continue  # a frame of /tf
            names = column.names if column.names is not None else ["value"]
            file.add_values(topic_of(name), time,
                            dict(zip(names, np.atleast_1d(column.values[frame]).tolist())))
        if "observation.state" in columns:
            file.add("/joint_states", time, _joints(time, columns["observation.state"], frame))
        for name, begin in zip(more.get("sparse_subtask_names", []), more.get("sparse_subtask_start_frames", [])):
            if begin == frame:
                file.add("/subtasks", time, Log(timestamp=_time(time), level=Log.Level.INFO, message=name,
                                                name="smile"))
        poses = {name_of(pictures.camera): columns[f"sim.camera_pose.{pictures.camera.name}"].values[frame]
                 for pictures in self.films.values()}
        file.add("/tf", time, self._scene.transforms(frame, time, poses))
        for update in self._scene.updates(frame, time):
            file.add("/scene", time, update)
        for pictures in self.films.values():
            self._add_picture(file, frame, time, pictures)

    def _add_picture(self, file: _File, frame: int, time: int, pictures: Pictures) -> None:
        camera, name = pictures.camera, name_of(pictures.camera)
        matrix = np.asarray(self.intrinsics[camera.name], float)
        picture = Picture(pictures.frames[frame], None, None, matrix, np.eye(4))
        file.add(f"/{name}/image", time, CompressedImage(timestamp=_time(time), frame_id=name, format="png",
                                                         data=picture.to_png()))
        for kind, maps in pictures.maps.items():
            values, encoding = maps[frame], "32FC1" if kind == "depth" else "mono16"
            file.add(f"/{name}/{kind}", time, RawImage(
                timestamp=_time(time), frame_id=name, width=camera.width, height=camera.height, encoding=encoding,
                step=values.strides[0], data=values.astype(values.dtype.newbyteorder("<")).tobytes()))
        (fx, _, cx), (_, fy, cy), _ = matrix
        file.add(f"/{name}/calibration", time, CameraCalibration(
            timestamp=_time(time), frame_id=name, width=camera.width, height=camera.height, K=matrix.ravel(),
            R=np.eye(3).ravel(), P=[fx, 0, cx, 0, 0, fy, cy, 0, 0, 0, 1, 0]))

    def append(self, path: Path) -> None:
        """Appends an episode of another dataset."""
        shutil.copy(path, self.folder / FILE.format(self.num_episodes))
        length = 0
        for name, values in self.measured.items():
            values.append(read_values(path, topic_of(name)).rows.astype(np.float32))
            length = len(values[-1])
        self.num_episodes += 1
        self.num_frames += length


class Values(NamedTuple):
    """A feature of an episode, read back."""

    names: list[str]
    rows: npt.NDArray[np.float64]
    """(frames, dimensions)"""


def read_values(path: Path, topic: str) -> Values:
    """Returns a feature of an episode."""
    with path.open("rb") as stream:
        messages = [json.loads(message.data) for _, _, message in make_reader(stream).iter_messages([topic])]
    if not messages:
        raise ValueError(f"{path}: has no messages of {topic}")
    return Values(list(messages[0]), np.array([list(one.values()) for one in messages]))


def topic_of(feature: str) -> str:
    return "/" + feature.replace(".", "/")


class StoredFile(Stored):
    """A dataset with a file for each episode."""

    def common(self) -> Row:
        try:
            with self._paths()[0].open("rb") as stream:
                summary = make_reader(stream).get_summary()
        except (McapError, *FAILURES) as error:
            raise self._mend(f"{self._paths()[0].name}: cannot be read ({error!r})") from None
        topics = sorted(channel.topic for channel in summary.channels.values()) if summary else []
        return {"format": "mcap", "topics": topics, "names": {name: read_values(
            self._paths()[0], topic_of(name)).names for name in MEASURED if topic_of(name) in topics},
            **{name: self.about[name] for name in ("action", "dropped")}}

    def new_writer(self, folder: Path) -> Writer:
        names: dict[str, list[str]] = self.common()["names"]
        return Writer(folder, 1, [], {name: Column(np.zeros((0, len(its)), np.float32), its)
                                      for name, its in names.items()}, "")

    def append_to(self, writer: Writer, folder: Path) -> None:
        for path in self._paths():
            writer.append(path)

    def _paths(self) -> list[Path]:
        return sorted(self.folder.glob(FILE.replace("{:06d}", "*")))


class _File:
    """A file in the making."""

    def __init__(self, path: Path) -> None:
        self._stream = path.open("wb")
        self._writer = FileWriter(self._stream, compression=CompressionType.NONE)
        self._writer.start(library="smile")
        self._channels: dict[str, int] = {}
        self._schemas: dict[str, int] = {}

    def __enter__(self) -> _File:
        return self

    def __exit__(self, kind: Any, *_: Any) -> None:
        try:
            if kind is None:
                self._writer.finish()
        finally:
            self._stream.close()

    def add_metadata(self, values: Row) -> None:
        self._writer.add_metadata("smile", {name: value if isinstance(value, str) else json.dumps(value)
                                            for name, value in values.items()})

    def add(self, topic: str, time: int, message: Any) -> None:
        """time: since the begin of the episode [ns]"""
        if topic not in self._channels:
            name = type(message).DESCRIPTOR.full_name
            if name not in self._schemas:
                self._schemas[name] = register_schema(self._writer, type(message))
            self._channels[topic] = self._writer.register_channel(topic, "protobuf", self._schemas[name])
        self._writer.add_message(self._channels[topic], time, message.SerializeToString(deterministic=True), time)

    def add_values(self, topic: str, time: int, values: Mapping[str, Any]) -> None:
        if topic not in self._channels:
            if VALUES not in self._schemas:
                self._schemas[VALUES] = self._writer.register_schema(VALUES, "jsonschema", _VALUES)
            self._channels[topic] = self._writer.register_channel(topic, "json", self._schemas[VALUES])
        self._writer.add_message(self._channels[topic], time, json.dumps(values).encode(), time)


class _Scene:
    """The objects and the robot of an episode, in three dimensions."""

    def __init__(self, episode: Episode) -> None:
        self._scene = ScenePieces(episode)
        self._shown: dict[int, list[int]] = {}

    def transforms(self, frame: int, time: int, cameras: Mapping[str, npt.NDArray[Any]]) -> FrameTransforms:
        """Returns the poses of all that moves and of the cameras, in the world."""
        message = FrameTransforms()
        for name, pose in self._scene.poses(frame, cameras).items():
            transform = message.transforms.add(timestamp=_time(time), parent_frame_id=WORLD, child_frame_id=name)
            _set_pose(transform.translation, transform.rotation, pose)
        return message

    def updates(self, frame: int, time: int) -> Iterator[SceneUpdate]:
        """Yields an update if other pieces are visible than before: it shows them in their frames."""
        shown, names = self._scene.shown(frame), self._scene.names
        update = SceneUpdate()
        for number in sorted(self._shown.keys() - shown.keys()):
            update.deletions.add(timestamp=_time(time), id=names[number])
        for number in sorted(shown):
            if shown[number] != self._shown.get(number):
                self._add_entity(update, names[number], time, shown[number])
        self._shown = shown
        if update.deletions or update.entities:
            yield update

    def _add_entity(self, update: SceneUpdate, name: str, time: int, numbers: list[int]) -> None:
        entity = update.entities.add(timestamp=_time(time), frame_id=name, frame_locked=True, id=name)
        for number in numbers:
            piece = self._scene.pieces[number]
            part = entity.triangles.add(indices=piece.triangles.ravel())
            _set_pose(part.pose.position, part.pose.orientation, piece.pose)
            part.color.r, part.color.g, part.color.b = piece.color
            part.color.a = 1
            for x, y, z in piece.corners.tolist():
                part.points.add(x=x, y=y, z=z)


def _time(nanoseconds: int) -> dict[str, int]:
    return {"seconds": nanoseconds // _NANOSECONDS, "nanos": nanoseconds % _NANOSECONDS}


def _set_pose(position: Any, orientation: Any, pose: npt.NDArray[Any]) -> None:
    position.x, position.y, position.z, orientation.w, orientation.x, orientation.y, orientation.z = pose.tolist()


def _joints(time: int, state: Column, frame: int) -> JointStates:
    message = JointStates(timestamp=_time(time))
    for name, position in zip(state.names or [], state.values[frame].tolist()):
        message.joints.add(name=name, position=position)
    return message
