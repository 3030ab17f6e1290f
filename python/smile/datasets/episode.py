"""An episode: the frames of a recording as columns of a dataset.

Frame k shows the world at k / fps seconds; its action leads to frame k + 1.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
import numpy.typing as npt

import smile
from smile.datasets.sources import Source
from smile.native import load
from smile.simulation import TICKS_PER_SECOND, Floats

if TYPE_CHECKING:
    from smile import smile_simulator_native as _native
else:
    _native = load("smile_simulator_native")

ACTIONS = ("joint_position", "joint_velocity", "end_effector")

# What an event completes.
_VERBS = {"gripper_holds": "take", "grasped": "take", "gripper_let_go": "place", "released": "place",
          "destroyed": "remove", "pressed": "press", "triggered": "trigger", "fastened": "fasten",
          "loosened": "loosen", "used": "use"}
_AXES = ("x", "y", "z", "qw", "qx", "qy", "qz")
_TAKES, _LEAVES = ("gripper_holds", "grasped"), ("gripper_let_go", "released", "destroyed")


class Column(NamedTuple):
    """A feature of a dataset."""

    values: npt.NDArray[Any]
    """(frames,) or (frames, dimensions)"""
    names: list[str] | None
    """of the dimensions; None for a single number"""


class Subtask(NamedTuple):
    """A part of an episode, from one deed to the next."""

    name: str
    words: str
    """what is done, in words, for example `put BlueBlock on RedBlock`"""
    begin: int
    """first frame"""
    end: int
    """frame after the last one"""


class Channel(NamedTuple):
    """A movable joint of the robot, or the opening of a gripper."""

    name: str
    arm: str | None
    """of a gripper; None for a joint"""
    slides: bool
    lower: float
    upper: float


@dataclass
class Episode:
    """A recording, sampled."""

    source: Source
    recording: smile.Recording
    rows: npt.NDArray[np.intp]
    """(frames,): indices into the arrays of the recording"""
    subtasks: list[Subtask]
    columns: dict[str, Column] = field(default_factory=dict)

    def __len__(self) -> int:
        return len(self.rows)


class Sampling(NamedTuple):
    """Which frames and columns episodes have."""

    fps: int
    action: str
    """one of ACTIONS"""
    has_robot: bool
    """false: only objects"""
    dropped: frozenset[str] = frozenset()
    """channels that are left out"""


def channels_of(recording: smile.Recording) -> list[Channel]:
    """Returns the joints and grippers of the recording's robot; none without one."""
    if not recording.model.has_robot:
        return []
    return [Channel(*one) for one in _native.channels_of(recording._native)]


def positions_of(recording: smile.Recording, rows: npt.NDArray[np.intp]) -> Floats:
    """Returns the positions of all channels, (rows, channels) [rad or m]."""
    positions: Floats = _native.channel_positions(recording._native, recording.joints[rows])
    return positions


def rows_at(recording: smile.Recording, fps: int, has_robot: bool) -> npt.NDArray[np.intp]:
    """Returns the indices of the frames, with one more if a robot acts: where its last action leads.

    Raises ValueError if there are fewer than two frames.
    """
    ticks = recording.ticks.astype(np.int64)
    start = int(ticks[0])
    if has_robot:
        # A robot may be put into its first pose at once: no action does that.
        jumps = [tick for tick in _native.jump_ticks(recording._native) if start <= tick <= start + 1]
        start = max([start, *(tick + 1 for tick in jumps)])
    at = np.arange(start, int(ticks[-1]) + 1, TICKS_PER_SECOND // fps)
    if len(at) < (3 if has_robot else 2):
        raise ValueError(f"{recording.directory}: has {len(at)} frames at {fps} frames per second, "
                         "expected more; choose a larger fps")
    # The last state known by then, where a recording was imported with gaps.
    return np.searchsorted(ticks, at, side="right") - 1


def read_episode(source: Source, recording: smile.Recording, sampling: Sampling) -> Episode:
    """Samples a recording."""
    rows = rows_at(recording, sampling.fps, sampling.has_robot)
    frames = rows[:-1] if sampling.has_robot else rows
    episode = Episode(source, recording, frames, subtasks_of(recording, frames))
    if sampling.has_robot:
        episode.columns.update(_robot_columns(recording, rows, sampling))
    episode.columns.update(_truth_columns(recording, frames, episode.subtasks))
    done = np.zeros(len(frames), bool)
    done[-1] = True
    episode.columns["next.done"] = Column(done, None)
    is_success = source.is_success if sampling.has_robot else True
    if is_success is not None:
        episode.columns["next.success"] = Column(done & is_success, None)
    corrects = source.corrects()
    since = corrects["seconds"] - 0.5 / TICKS_PER_SECOND if corrects else np.inf
    episode.columns["intervention"] = Column(recording.times[frames] >= since, None)
    return episode


def _robot_columns(recording: smile.Recording, rows: npt.NDArray[np.intp],
                   sampling: Sampling) -> dict[str, Column]:
    channels = channels_of(recording)
    kept = [i for i, channel in enumerate(channels) if channel.name not in sampling.dropped]
    positions = positions_of(recording, rows)
    names = [channels[i].name for i in kept]
    state = Column(positions[:-1, kept].astype(np.float32), names)
    if sampling.action == "end_effector":
        action = _end_effector_action(recording, rows, channels, positions, sampling)
    else:
        targets = _channel_targets(recording, rows, channels, positions)
        if sampling.action == "joint_velocity":
            targets = np.multiply(targets - positions[:-1], sampling.fps)
        action = Column(targets[:, kept].astype(np.float32), names)
    tools = _native.tool_poses(recording._native, recording.joints[rows[:-1]])
    poses = Column(tools.reshape(len(tools), -1).astype(np.float32),
                   [f"{arm}.{axis}" for arm in _native.arm_names_of(recording._native) for axis in _AXES])
    return {"observation.state": state, "action": action, "sim.tool_poses": poses}


def _channel_targets(recording: smile.Recording, rows: npt.NDArray[np.intp],
                     channels: Sequence[Channel], positions: Floats) -> Floats:
    """(frames, channels): where each action leads. A joint: where it is at the next frame. A gripper:
    how far it is commanded to open or close by then, even if an object is in between."""
    targets: Floats = positions[1:].copy()
    arms = _native.arm_names_of(recording._native)
    rates = _native.gripper_rates(recording._native, recording.ticks)
    # Integral of the commanded rates; a row belongs to the tick after it.
    follows = np.vstack([np.zeros(len(arms), int), np.cumsum(np.isnan(rates), axis=0)])
    way = np.vstack([np.zeros(len(arms)), np.cumsum(np.nan_to_num(rates) / TICKS_PER_SECOND, axis=0)])
    for i, channel in enumerate(channels):
        if channel.arm is None:
            continue
        arm = arms.index(channel.arm)
        commanded = positions[:-1, i] + way[rows[1:], arm] - way[rows[:-1], arm]
        is_commanded = follows[rows[1:], arm] == follows[rows[:-1], arm]
        targets[is_commanded, i] = np.clip(commanded, channel.lower, channel.upper)[is_commanded]
    return targets


def _end_effector_action(recording: smile.Recording, rows: npt.NDArray[np.intp],
                         channels: Sequence[Channel], positions: Floats,
                         sampling: Sampling) -> Column:
    """Displacements of the tools [m] and their rotations [rad], along the axes of the world; then the
    openings to which the grippers are commanded [m]."""
    tools = _native.tool_poses(recording._native, recording.joints[rows])
    targets = _channel_targets(recording, rows, channels, positions)
    parts: list[Floats] = []
    names: list[str] = []
    for i, arm in enumerate(_native.arm_names_of(recording._native)):
        parts.append(tools[1:, i, :3] - tools[:-1, i, :3])
        parts.append(rotation_between(tools[:-1, i, 3:], tools[1:, i, 3:]))
        names += [f"{arm}.{axis}" for axis in ("x", "y", "z", "rx", "ry", "rz")]
        for k, channel in enumerate(channels):
            if channel.arm == arm:
                parts.append(targets[:, [k]])
                names.append(channel.name)
    return Column(np.hstack(parts).astype(np.float32), names)


def rotation_between(before: Floats, after: Floats) -> Floats:
    """Returns the rotations, (n, 3) axis times angle [rad] in the world, that lead from orientations to
    others, (n, 4) quaternions w, x, y, z."""
    w, v = before[:, :1], -before[:, 1:]
    real = after[:, :1] * w - np.sum(after[:, 1:] * v, axis=1, keepdims=True)
    imaginary = after[:, :1] * v + w * after[:, 1:] + np.cross(after[:, 1:], v)
    # The shorter of both ways around.
    imaginary = np.where(real < 0, -imaginary, imaginary)
    length = np.linalg.norm(imaginary, axis=1, keepdims=True)
    angle = 2 * np.arctan2(length, np.abs(real))
    factor = np.divide(angle, length, out=np.full_like(length, 2), where=length > 1e-12)
    return np.multiply(imaginary, factor)


def _truth_columns(recording: smile.Recording, frames: npt.NDArray[np.intp],
                   subtasks: Sequence[Subtask]) -> dict[str, Column]:
    """What the simulator knows, and a policy does not see."""
    ids = recording.object_ids
    columns: dict[str, Column] = {}
    if ids:
        poses = recording.poses
        exists = ~np.isnan(poses[:, :, 0])
        columns["sim.object_poses"] = Column(
            _without_gaps(poses)[frames].reshape(len(frames), -1).astype(np.float32),
            [f"{id}.{axis}" for id in ids for axis in _AXES])
        columns["sim.object_exists"] = Column(exists[frames].astype(np.float32), list(ids))
        columns["sim.object_held"] = Column(_held(recording)[frames].astype(np.float32), list(ids))
    columns["sim.tick"] = Column(recording.ticks[frames].astype(np.int64), None)
    index, progress = np.zeros(len(frames), np.int64), np.zeros(len(frames), np.float32)
    for number, subtask in enumerate(subtasks):
        length = subtask.end - subtask.begin
        index[subtask.begin:subtask.end] = number
        progress[subtask.begin:subtask.end] = np.arange(length) / length
    columns["sim.subtask"] = Column(index, None)
    columns["sim.subtask_progress"] = Column(progress, None)
    return columns


def _without_gaps(poses: Floats) -> Floats:
    """Absent objects are where they were last, or where they will be first."""
    filled = poses.copy()
    for i in range(poses.shape[1]):
        known = np.flatnonzero(~np.isnan(poses[:, i, 0]))
        if len(known) == 0:
            filled[:, i] = [0, 0, 0, 1, 0, 0, 0]
        elif len(known) < len(poses):
            last = np.searchsorted(known, np.arange(len(poses)), side="right") - 1
            filled[:, i] = poses[known[np.maximum(last, 0)], i]
    return filled


def _held(recording: smile.Recording) -> npt.NDArray[np.bool_]:
    """(ticks, objects): True while a hand or a gripper holds an object."""
    ids = recording.object_ids
    change = np.zeros((len(recording) + 1, len(ids)), int)
    for event in recording.events:
        sign = (event["kind"] in _TAKES) - (event["kind"] in _LEAVES)
        if sign and event.get("object") in ids:
            row = np.searchsorted(recording.ticks, event["tick"])
            change[row, ids.index(event["object"])] += sign
    held: npt.NDArray[np.bool_] = np.cumsum(change, axis=0)[:-1] > 0
    return held


def subtasks_of(recording: smile.Recording, frames: npt.NDArray[np.intp]) -> list[Subtask]:
    """Cuts an episode where something was taken, placed, pressed, …."""
    ticks = recording.ticks[frames].astype(np.int64)
    subtasks: list[Subtask] = []
    begin = 0
    holders: dict[str, int] = {}
    for event, place in zip(recording.events, _native.places_of_events(recording._native), strict=True):
        id = event.get("object", "")
        holders[id] = max(0, holders.get(id, 0) + (event["kind"] in _TAKES) - (event["kind"] in _LEAVES))
        verb = _VERBS.get(event["kind"])
        if verb is None:
            continue
        end = int(np.searchsorted(ticks, event["tick"], side="right"))
        if end > begin:
            thing = event.get("control") or id
            words = _words_of(event, f"{verb} {thing}".strip(), place if holders[id] == 0 else None)
            subtasks.append(Subtask(f"{verb} {thing}".strip(), words, begin, end))
            begin = end
    if begin < len(frames):
        subtasks.append(Subtask("finish", "finish", begin, len(frames)))
    return subtasks


def _words_of(event: dict[str, Any], name: str, place: tuple[str, bool, bool] | None) -> str:
    """place: of what was released: its support, empty for the table; whether it lies in that; whether
    it already rests there. None beyond the table's edge, or where something else still holds it"""
    if event["kind"] in ("gripper_let_go", "released"):
        if place is None:
            return f"release {event['object']}"
        support, is_inside, is_near = place
        return (f"{'put' if is_near else 'drop'} {event['object']} {'into' if is_inside else 'on'} "
                f"{support or 'the table'}")
    if event["kind"] == "destroyed":
        return f"remove {event['object']} from the table"
    if event["kind"] == "used":
        return f"{event.get('state', 'use')} {event.get('part', '')} with {event.get('by', '')}"
    return name
