"""Writer of recordings of Rerun: an episode is a file that the viewer of https://rerun.io shows.

Source of the archetypes: the package rerun-sdk 0.41.0.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import rerun as rr
import rerun.blueprint as views

from smile.datasets import statistics
from smile.datasets.episode import Column
from smile.datasets.features import Camera
from smile.datasets.lerobot import Row
from smile.datasets.pictures import Pictures
from smile.datasets.scene_pieces import WORLD, Piece, ScenePieces, name_of
from smile.datasets.scene_writer import SceneWriter
from smile.picture import Picture

FILE = "episode_{:06d}.rrd"
_NANOSECONDS = 1_000_000_000
# From where the scene is seen at first, and at what [m]: over the table towards the robot.
_EYE, _LOOKS_AT = (1.2, 1.8, 1.2), (0, -0.3, 0.1)


class Writer(SceneWriter):
    """A folder with a file for each episode in the making."""

    def add(self, columns: Mapping[str, Column], task: str, films: Mapping[str, Row],
            pixels: Mapping[str, statistics.Pixels], more: Row) -> None:
        """Appends an episode, whose pictures `films` have."""
        assert self.episode is not None
        for name, values in self.measured.items():
            values.append(columns[name].values)
        frames = len(next(iter(columns.values())).values)
        path = self.folder / FILE.format(self.num_episodes)
        with _File(path, frames, self.fps) as file:
            file.add_about({"task": task, "fps": str(self.fps), **more})
            for name, column in columns.items():
                if not name.startswith("sim.camera_pose."):
                    file.add_feature(name, column)
            poses = {name_of(film.camera): columns[f"sim.camera_pose.{film.camera.name}"].values
                     for film in self.films.values()}
            file.add_scene(ScenePieces(self.episode), poses)
            for film in self.films.values():
                file.add_camera(film, np.asarray(self.intrinsics[film.camera.name], float))
                file.add_names(film.camera, self.episode.recording.object_ids)
            file.add_subtasks(more)
            file.add_views([film.camera for film in self.films.values()], list(self.measured))
        self.num_episodes += 1
        self.num_frames += frames


class _File:
    """A recording of an episode in the making."""

    def __init__(self, path: Path, frames: int, fps: int) -> None:
        # A name of its own and no date: the same episode has the same content.
        self._stream = rr.RecordingStream("smile", recording_id=path.stem, send_properties=False)
        self._stream.set_log_time_enabled(False)
        self._stream.set_log_tick_enabled(False)
        self._stream.save(path)
        self._frames = frames
        self._times = np.arange(frames, dtype=np.int64) * _NANOSECONDS // fps

    def __enter__(self) -> _File:
        return self

    def __exit__(self, *_: Any) -> None:
        self._stream.disconnect()

    def add_about(self, values: Row) -> None:
        about = {name: value if isinstance(value, str) else json.dumps(value) for name, value in values.items()}
        self._stream.send_property("smile", rr.AnyValues(**about))

    def add_feature(self, name: str, column: Column) -> None:
        values = np.asarray(column.values, float).reshape(self._frames, -1)
        path = path_of(name.split("."))
        self._stream.log(path, rr.SeriesLines(names=column.names or ["value"]), static=True)
        columns = rr.Scalars.columns(scalars=values.ravel())
        self._send(path, columns.partition([values.shape[1]] * self._frames))

    def add_scene(self, scene: ScenePieces, cameras: Mapping[str, npt.NDArray[Any]]) -> None:
        """Adds the meshes, and the poses of all that moves and of the cameras."""
        self._stream.log(WORLD, rr.ViewCoordinates.RIGHT_HAND_Z_UP, static=True)
        poses: dict[str, list[npt.NDArray[Any]]] = {}
        shown_before: dict[int, bool] = {}
        for frame in range(self._frames):
            at = {name: rows[frame] for name, rows in cameras.items()}
            for name, pose in scene.poses(frame, at).items():
                poses.setdefault(name, []).append(pose)
            shown = {number for numbers in scene.shown(frame).values() for number in numbers}
            for number, piece in enumerate(scene.pieces):
                if piece.choice >= 0 and shown_before.get(number, False) != (number in shown):
                    self._add_mesh(scene, number, piece, frame, number in shown)
                    shown_before[number] = number in shown
        for number, piece in enumerate(scene.pieces):
            if piece.choice < 0:
                self._add_mesh(scene, number, piece, None, True)
        for name, rows in poses.items():
            numbers = np.asarray(rows)
            # Quaternions of Rerun are x, y, z, w.
            self._send(self._path(name), rr.Transform3D.columns(
                translation=numbers[:, :3], quaternion=numbers[:, [4, 5, 6, 3]]))

    def _add_mesh(self, scene: ScenePieces, number: int, piece: Piece, frame: int | None, is_shown: bool) -> None:
        """frame: from which on it is shown, or no longer; None: it always is"""
        parent = WORLD if piece.frame == 0 else self._path(scene.names[piece.frame])
        color = [round(255 * channel) for channel in piece.color]
        mesh = rr.Mesh3D(vertex_positions=piece.corners, triangle_indices=piece.triangles, albedo_factor=color)
        path = f"{parent}/mesh_{number}"
        turn = [piece.pose[k] for k in (4, 5, 6, 3)]
        self._stream.log(path, rr.Transform3D(translation=piece.pose[:3], quaternion=turn), static=True)
        if frame is None:
            self._stream.log(path, mesh, static=True)
            return
        self._stream.set_time("time", duration=np.timedelta64(self._times[frame], "ns"))
        self._stream.set_time("frame", sequence=frame)
        self._stream.log(path, mesh if is_shown else rr.Clear(recursive=False))
        self._stream.reset_time()

    def add_camera(self, film: Pictures, matrix: npt.NDArray[np.float64]) -> None:
        """matrix: of its intrinsics, (3, 3) [px]"""
        camera = film.camera
        path, size = self._path(name_of(camera)), (camera.width, camera.height)
        self._stream.log(path, rr.Pinhole(image_from_camera=matrix, resolution=size,
                                          camera_xyz=rr.ViewCoordinates.RDF), static=True)
        pictures = [Picture(rgb, None, None, matrix, np.eye(4)).to_png() for rgb in film.frames]
        self._send(f"{path}/image", rr.EncodedImage.columns(blob=pictures, media_type=["image/png"] * self._frames))
        for kind, maps in film.maps.items():
            archetype: Any = rr.DepthImage if kind == "depth" else rr.SegmentationImage
            channel = rr.ChannelDatatype.F32 if kind == "depth" else rr.ChannelDatatype.U16
            image_format = rr.components.ImageFormat(width=camera.width, height=camera.height,
                                                     channel_datatype=channel)
            self._stream.log(f"{path}/{kind}", archetype.from_fields(format=image_format), static=True)
            if kind == "depth":
                self._stream.log(f"{path}/{kind}", rr.DepthImage.from_fields(meter=1.0), static=True)
            self._send(f"{path}/{kind}", archetype.columns(buffer=[it.tobytes() for it in maps]))

    def add_names(self, camera: Camera, objects: list[str]) -> None:
        """Adds what the numbers in a picture of ids mean."""
        names = enumerate(["nothing", "table", *objects])
        self._stream.log(self._path(name_of(camera)), rr.AnnotationContext(list(names)), static=True)

    def add_subtasks(self, more: Row) -> None:
        begins = more.get("sparse_subtask_start_frames", [])
        if len(begins) > 0:
            self._send("subtasks", rr.TextLog.columns(text=more["sparse_subtask_names"]), np.asarray(begins))

    def add_views(self, cameras: list[Camera], plotted: list[str]) -> None:
        """Adds what the viewer shows at first: the scene, beside it pictures and plots."""
        paths = {camera.name: self._path(name_of(camera)) for camera in cameras}
        beside = [views.Spatial2DView(origin=path, contents=["$origin/image"], name=name)
                  for name, path in paths.items()]
        beside += [views.TimeSeriesView(origin=path_of(name.split(".")), name=name) for name in plotted]
        beside.append(views.TextLogView(origin="subtasks", name="subtasks"))
        eye = views.EyeControls3D(position=_EYE, look_target=_LOOKS_AT, eye_up=(0, 0, 1))
        # Points at all depths would hide what is there.
        hidden = [f"- {path}/{kind}" for path in paths.values() for kind in ("depth", "id")]
        scene = views.Spatial3DView(origin=WORLD, contents=["$origin/**", *hidden], name="scene", eye_controls=eye)
        self._stream.send_blueprint(views.Blueprint(
            views.Horizontal(scene, views.Vertical(*beside)), views.SelectionPanel(state="collapsed"),
            views.BlueprintPanel(state="collapsed"), views.TimePanel(state="collapsed", timeline="time")))

    def _path(self, name: str) -> str:
        """Returns the path of a frame of reference."""
        return path_of([WORLD, *name.split("/")])

    def _send(self, path: str, columns: Any, frames: npt.NDArray[Any] | None = None) -> None:
        """frames: those of which the columns tell, if not of all"""
        numbers = np.arange(self._frames) if frames is None else frames
        times = self._times[numbers].astype("timedelta64[ns]")
        self._stream.send_columns(path, [rr.TimeColumn("time", duration=times),
                                         rr.TimeColumn("frame", sequence=numbers)], columns)


def path_of(parts: list[str]) -> str:
    """Returns a path of Rerun, in which names may have any characters."""
    path: str = rr.new_entity_path(parts)
    return path
