"""Exports runs as a dataset."""

from __future__ import annotations

import importlib
import json
import os
import shutil
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, cast

import numpy as np
import numpy.typing as npt

import smile
from smile.datasets import statistics
from smile.datasets.episode import (
    ACTIONS, Column, Episode, Sampling, channels_of, positions_of, read_episode, rows_at)
from smile.datasets.features import Camera
from smile.datasets.lerobot import FilmFiles, Row, Writer, WriterOfVersion2, levels_of, write_json
from smile.datasets.pictures import MAPS, Pictures
from smile.datasets.sources import Source, find_sources
from smile.datasets.target import new_folder, refuse_existing
from smile.native import load
from smile.simulation import TICKS_PER_SECOND, picture_size

if TYPE_CHECKING:
    from smile import smile_simulator_native as _native
else:
    _native = load("smile_simulator_native")

FORMATS = ("lerobot-v3.0", "lerobot-v2.1", "robomimic", "zarr", "mcap", "rrd", "csv")
_WITH_MAPS = ("robomimic", "zarr", "mcap", "rrd")
# Which show the scene itself, beside its features.
_WITH_SCENE = ("mcap", "rrd")
_WITH_DEPTH = (*_WITH_MAPS, "lerobot-v3.0")
# Width and height of a film, of x265 [px].
_SMALLEST_DEPTH = 16
RATES = tuple(fps for fps in range(1, TICKS_PER_SECOND + 1) if TICKS_PER_SECOND % fps == 0)
# Statistics of colors are of at most as many pictures of an episode.
_SAMPLED_PICTURES = 100

META = "meta/smile.json"

Path_ = str | os.PathLike[str]


class Report(NamedTuple):
    """What was exported."""

    folder: Path
    episodes: int
    frames: int
    constant: dict[str, list[str]]
    """by feature: dimensions that never change, on which policies fail that divide by the standard
    deviation"""


class Options(NamedTuple):
    """How episodes are written."""

    format: str
    task: str | None
    extras: bool
    language: bool = False


class Plan(NamedTuple):
    """What is written."""

    sources: list[Source]
    sampling: Sampling
    cameras: list[Camera]
    robot: str
    has_success: bool
    has_interventions: bool


def export(runs: Iterable[Path_], folder: Path_, *, format: str = "lerobot-v3.0",
           cameras: Sequence[str] | Mapping[str, tuple[int, int]] = ("eye",),
           size: tuple[int, int] = (320, 240), fps: int = 30, action: str = "joint_position",
           task: str | None = None, include_failed: bool = False, drop_constant: bool = False,
           extras: bool = True, parts: int | None = None, maps: Sequence[str] = (),
           language: bool = False, progress: Callable[[str], None] | None = None) -> Report:
    """Exports runs as a dataset, an episode for each, in the order given.

    runs            recordings, or folders of imitations (docs/datasets.md)
    folder          to be made; it appears when it is complete
    format          one of FORMATS
    cameras         cameras of the robot or scene, or views for people; by name, perhaps with a size
    size            width and height of pictures without one [px], even numbers
    fps             frames per second, a divisor of 60
    action          one of ACTIONS
    task            what is to be done, in words; by default the title of each recording
    include_failed  whether imitations that failed are exported, too
    drop_constant   whether joints that never move are left out
    extras          whether the recordings are copied into the dataset
    parts           number of episodes of a part: an export that was interrupted continues after its
                    last part; only of lerobot-v3.0
    maps            some of `depth` and `id`: what each pixel shows, beside its color; in robomimic, zarr, mcap
                    and rrd, and depth in lerobot-v3.0
    language        whether each frame has the words of its subtask, as learners of language read them;
                    only of LeRobot's formats
    progress        called with a line for each step

    Raises ValueError if the runs cannot be exported in this way, FileExistsError if there is such a
    folder, OSError or RuntimeError if it cannot be written. Nothing is left of it then.
    """
    say = progress if progress is not None else lambda _: None
    target = Path(folder)
    _check_words(format, action, fps, parts, maps)
    refuse_existing(target)
    if language and not format.startswith("lerobot"):
        raise ValueError(f"language is asked for and format {format!r}, expected lerobot-v3.0 or lerobot-v2.1: the "
                         "others have the words of subtasks as `smile/subtask_words`")
    chosen = _cameras(cameras, size, maps)
    small = [camera for camera in chosen if min(camera.width, camera.height) < _SMALLEST_DEPTH]
    if "depth" in maps and format.startswith("lerobot") and small:
        raise ValueError(f"size is {small[0].width}x{small[0].height}, expected at least {_SMALLEST_DEPTH}x"
                         f"{_SMALLEST_DEPTH}: films of depth have no smaller ones")
    plan = _plan(_sources(runs, include_failed), chosen, fps, action, drop_constant)
    options = Options(format, task, extras, language)
    if parts is None:
        return _write(plan, options, target, say)
    # Imported late: it needs this module.
    from smile.datasets.parts import write_in_parts
    return write_in_parts(plan, options, target, parts, _write, say)


def _write(plan: Plan, options: Options, target: Path, say: Callable[[str], None]) -> Report:
    with new_folder(target) as partial:
        writer: Writer | None = None
        intrinsics: dict[str, Any] = {}
        fps = plan.sampling.fps
        try:
            for number, source in enumerate(plan.sources):
                episode = read_episode(source, smile.open(source.recording), plan.sampling)
                if not plan.has_success:
                    episode.columns.pop("next.success", None)
                if not plan.has_interventions:
                    episode.columns.pop("intervention")
                if writer is None:
                    columns = _columns_before_drawing(episode, plan.cameras)
                    writer = _writer_of(options.format)(partial, fps, plan.cameras, columns, plan.robot)
                    if options.language:
                        writer.add_language()
                say(f"episode {number + 1} of {len(plan.sources)}: {source.path}, {len(episode)} frames")
                drawn = _draw(episode, writer.films)
                episode.columns.update(_pose_columns(plan.cameras, drawn.poses))
                if options.format in _WITH_SCENE:
                    cast(Any, writer).observe(episode, drawn.intrinsics)
                writer.add(episode.columns, options.task if options.task is not None else _task_of(episode),
                           drawn.films, drawn.pixels, _more_about(episode, fps))
                intrinsics.update(drawn.intrinsics)
                if options.extras:
                    _copy_recording(source, partial / f"extras/episode_{number:06d}")
            assert writer is not None
            totals = writer.finish()
        except BaseException:
            if writer is not None:
                writer.abandon()
            raise
        constant = constant_of(writer.features, totals)
        is_lerobot = options.format.startswith("lerobot")
        about = {"format": 1, "action": plan.sampling.action if plan.sampling.has_robot else None,
                 "intrinsics": intrinsics, "constant": constant, "dropped": sorted(plan.sampling.dropped)}
        if isinstance(writer, Writer):
            about["pixels"] = pixels_of(writer)
        write_json(partial / (META if is_lerobot else "smile.json"), about)
        say("completing the files")
    return Report(target, writer.num_episodes, writer.num_frames, constant)


def pixels_of(writer: Writer) -> dict[str, Any]:
    """Returns how often each level of each color occurs, by camera: from this, statistics of several
    datasets are exact."""
    return {key: {"pictures": film.pixels.num_pictures, "counts": film.pixels.counts.tolist()}
            for key, film in writer.films.items()}


def _writer_of(format: str) -> type[Writer]:
    # Imported late: some of these need packages of their own.
    late = {"robomimic": "robomimic", "zarr": "zarr_arrays", "mcap": "mcap_messages", "rrd": "rerun_recording",
            "csv": "csv_films"}
    if format in late:
        writer: type[Writer] = importlib.import_module(f"smile.datasets.{late[format]}").Writer
        return writer
    return WriterOfVersion2 if format == "lerobot-v2.1" else Writer


def _check_words(format: str, action: str, fps: int, parts: int | None, maps: Sequence[str]) -> None:
    for name, value, known in (("format", format, FORMATS), ("action", action, ACTIONS)):
        if value not in known:
            raise ValueError(f"{name} is {value!r}, expected {' or '.join(known)}")
    if isinstance(fps, bool) or fps not in RATES:
        raise ValueError(f"fps is {fps!r}, expected one of {', '.join(map(str, RATES))}: recordings have "
                         f"{TICKS_PER_SECOND} ticks per second")
    if isinstance(maps, str) or not set(maps) <= set(MAPS):
        raise ValueError(f"maps is {maps!r}, expected some of {', '.join(MAPS)}")
    for name, formats in (("depth", _WITH_DEPTH), ("id", _WITH_MAPS)):
        if name in maps and format not in formats:
            raise ValueError(f"maps is {maps!r} and format {format!r}, expected {' or '.join(formats)} for {name}: "
                             "readers of the others know no such films")
    if parts is not None and (parts < 1 or format != FORMATS[0]):
        raise ValueError(f"parts is {parts} and format {format!r}, expected at least 1 and {FORMATS[0]}")


def _cameras(cameras: Sequence[str] | Mapping[str, tuple[int, int]],
             size: tuple[int, int], maps: Sequence[str]) -> list[Camera]:
    if isinstance(cameras, str):
        raise ValueError(f"cameras is {cameras!r}, expected a list of names")
    named = cameras if isinstance(cameras, Mapping) else dict.fromkeys(cameras, size)
    result = []
    for name, its_size in named.items():
        width, height = picture_size(its_size)
        if width % 2 or height % 2:
            raise ValueError(f"size is {width}x{height}, expected even numbers: films have no others")
        if "/" in name:
            raise ValueError(f"camera is {name!r}, expected a name without '/'")
        result.append(Camera(name, width, height, tuple(name for name in MAPS if name in maps)))
    return result


def _sources(runs: Iterable[Path_], include_failed: bool) -> list[Source]:
    if isinstance(runs, (str, os.PathLike)):
        raise ValueError(f"runs is {os.fspath(runs)!r}, expected a list of folders")
    sources = [source for run in runs for source in find_sources(Path(run), include_failed)]
    if not sources:
        raise ValueError("there are no runs, expected one at least")
    failed = [source for source in sources if source.is_success is False]
    if failed and not include_failed:
        names = ", ".join(str(source.path) for source in failed[:3])
        rest = f" and {len(failed) - 3} more" if len(failed) > 3 else ""
        raise ValueError(f"{names}{rest}: failed ({failed[0].cause or 'no success'}); leave out such runs, or "
                         "ask for them: include_failed, --include-failed")
    return sources


def _plan(sources: list[Source], cameras: list[Camera], fps: int, action: str,
          drop_constant: bool) -> Plan:
    """Looks at all runs before anything is written: they must have the same robot, objects and
    cameras."""
    first = smile.open(sources[0].recording)
    names = [channel.name for channel in channels_of(first)]
    low, high = np.full(len(names), np.inf), np.full(len(names), -np.inf)
    for source in sources:
        recording = smile.open(source.recording)
        if recording.object_ids != first.object_ids:
            raise ValueError(f"{source.path}: has other objects than {sources[0].path}, expected the same; "
                             "export them as datasets of their own")
        if [channel.name for channel in channels_of(recording)] != names:
            raise ValueError(f"{source.path}: has another robot than {sources[0].path}, expected the same; "
                             "export them as datasets of their own")
        for camera in cameras:
            try:
                recording[0].render(camera.name, (16, 16))
            except ValueError as error:
                raise ValueError(f"{source.path}: {error}") from None
        if names:
            positions = positions_of(recording, rows_at(recording, fps, True))
            low, high = np.minimum(low, positions.min(axis=0)), np.maximum(high, positions.max(axis=0))
    moves = high - low > 1e-9
    has_robot = bool(np.any(moves))
    dropped = [name for name, moved in zip(names, moves) if not moved] if drop_constant else []
    sampling = Sampling(fps, action, has_robot, frozenset(dropped if has_robot else []))
    robot = sources[0].robot_name() if has_robot else "none"
    has_success = not has_robot or all(source.result is not None for source in sources)
    has_interventions = any(source.corrects() for source in sources)
    return Plan(sources, sampling, cameras, robot, has_success, has_interventions)


def _task_of(episode: Episode) -> str:
    title = episode.recording.title.removesuffix(", imitated")
    return title or episode.recording.model.name or "the task of the demonstration"


def _pose_columns(cameras: Sequence[Camera], poses: Mapping[str, npt.NDArray[np.float32]]
                  ) -> dict[str, Column]:
    """Poses of the cameras at each frame, (frames, 12): those of a robot move."""
    names = [f"{row}{column}" for row in "xyz" for column in ("x", "y", "z", "t")]
    return {f"sim.camera_pose.{camera.name}": Column(poses[camera.key], names) for camera in cameras}


class _Drawn(NamedTuple):
    """Pictures of an episode, by the key of the camera."""

    films: dict[str, Row]
    """places in the films"""
    pixels: dict[str, statistics.Pixels]
    poses: dict[str, npt.NDArray[np.float32]]
    """(frames, 12): the upper rows of the camera's pose in the world"""
    intrinsics: dict[str, list[list[float]]]


def _draw(episode: Episode, films: Mapping[str, FilmFiles]) -> _Drawn:
    """Draws an episode into the films."""
    reader = _native.FrameReader(episode.recording._native)
    drawn = _Drawn({key: film.begin() for key, film in films.items()},
                   {key: film.new_pixels() for key, film in films.items()},
                   {key: np.zeros((len(episode), 12), np.float32) for key in films}, {})
    step = -(-len(episode) // _SAMPLED_PICTURES)
    for number, row in enumerate(episode.rows):
        tick = int(episode.recording.ticks[row])
        for key, film in films.items():
            camera = film.camera
            if key != camera.key:
                continue  # drawn with its camera
            rgb, depth, id, matrix, pose = reader.render(tick, camera.name, camera.width, camera.height,
                                                         True, *(one in camera.maps for one in MAPS))
            film.add(rgb)
            if camera.depth_key in films:
                levels = levels_of(depth)
                films[camera.depth_key].add(levels)
                if number % step == 0:
                    drawn.pixels[camera.depth_key].add(levels)
            elif camera.maps:
                cast(Pictures, film).add_maps(depth, id)
            drawn.poses[key][number] = pose[:3].reshape(-1)
            drawn.intrinsics[camera.name] = matrix.tolist()
            if number % step == 0:
                drawn.pixels[key].add(rgb)
    for key, film in films.items():
        drawn.films[key]["to_timestamp"] = film.end()
    return drawn


def _columns_before_drawing(episode: Episode, cameras: Sequence[Camera]) -> dict[str, Column]:
    empty = {camera.key: np.zeros((len(episode), 12), np.float32) for camera in cameras}
    return {**episode.columns, **_pose_columns(cameras, empty)}


def _more_about(episode: Episode, fps: int) -> Row:
    """Columns of an episode beside LeRobot's own: where it comes from, and its parts, which LeRobot's
    reward models read under the names of sparse and dense subtasks."""
    source, recording = episode.source, episode.recording
    row: Row = {"smile/recording_sha256": source.digest(), "smile/state_hash": f"{recording.hashes[-1]:016x}",
                "smile/seed": source.seed, "smile/success": source.is_success, "smile/cause": source.cause,
                "smile/source": source.path.name, "smile/corrects": (source.corrects() or {}).get("recording", ""),
                "smile/variation": json.dumps(source.variation) if source.variation is not None else "",
                "smile/subtask_words": [part.words for part in episode.subtasks]}
    for kind in ("sparse", "dense"):
        row.update({
            f"{kind}_subtask_names": [part.name for part in episode.subtasks],
            f"{kind}_subtask_start_frames": [part.begin for part in episode.subtasks],
            f"{kind}_subtask_end_frames": [part.end for part in episode.subtasks],
            f"{kind}_subtask_start_times": [part.begin / fps for part in episode.subtasks],
            f"{kind}_subtask_end_times": [part.end / fps for part in episode.subtasks]})
    return row


def _copy_recording(source: Source, folder: Path) -> None:
    shutil.copytree(source.recording, folder)
    if source.result is not None:
        shutil.copy(source.recording.parent / "result.json", folder.with_suffix(".result.json"))


def constant_of(features: Mapping[str, Any], totals: Mapping[str, statistics.Statistics]
                ) -> dict[str, list[str]]:
    """Returns the dimensions of states and actions that never change, by feature."""
    constant = {}
    for name in ("observation.state", "action"):
        if name in features:
            names = features[name]["names"]
            found = [names[i] for i, (low, high) in enumerate(zip(totals[name]["min"], totals[name]["max"]))
                     if low == high]
            if found:
                constant[name] = found
    return constant
