"""What a robot is to do to perform a recording, and whether it may."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

import smile
from smile.motion import Robot
from smile.native import load
from smile.ros.description import RobotDescription
from smile.ros.joint_path import JointPath
from smile.simulation import TICKS_PER_SECOND, Floats

if TYPE_CHECKING:
    from smile import smile_simulator_native as _native
else:
    _native = load("smile_simulator_native")

APPROACH_SPEED = 0.1
"""fraction of the maximum speeds on the way to the start"""
ACCELERATION_SECONDS = 0.1
"""time over which accelerations are averaged: a simulated motor changes its speed at once, which no path of a real
arm shows [s]"""
MARGIN = 0.3
"""how far beyond the table's edges a tool may be [m]"""
HEIGHT = 1.0
"""how high above the table a tool may be [m]"""
_MOVES = 1e-3
"""a joint that moves less stands still [rad]"""
_GRIPPER_MOVES = 1e-3
"""the same of an opening [m]"""
_GRIPPER_PAUSE = 6
"""ticks without motion that end a motion of a gripper"""


class GripperMove(NamedTuple):
    """A motion of a gripper."""

    arm: str
    begin: float
    """[s] along the path"""
    end: float
    """by when it must have ended [s]"""
    percent: float
    """goal: 0 is closed, 100 open"""
    held: str | None
    """object that the gripper holds afterwards; it closes until then"""


@dataclass
class Plan:
    """A recorded motion for a robot."""

    description: RobotDescription
    title: str
    table: tuple[float, float]
    """width and depth [m]"""
    arms: list[str]
    """arms that move"""
    path: JointPath
    """joints of these arms, at the speed of the recording"""
    grippers: list[GripperMove]
    speed: float
    """fraction of the speed of the recording"""

    @property
    def seconds(self) -> float:
        """Duration at this speed, without waits for grippers [s]"""
        return self.path.duration / self.speed

    def columns(self, arm: str) -> list[int]:
        """Returns the columns of the path for an arm."""
        return [self.path.names.index(joint) for joint in self.description.arms[arm]]


def plan_of(recording: smile.Recording, limbs: Sequence[str], speed: float) -> Plan:
    """Returns the plan of a recording's robot.

    limbs  arms to be moved; empty: all that move in the recording
    speed  fraction of its speed

    Raises ValueError if there is no such arm, or nothing moves.
    """
    description = RobotDescription(recording)
    unknown = [limb for limb in limbs if limb not in description.arms]
    if unknown:
        raise ValueError(f"limb {unknown[0]!r}, expected some of {', '.join(description.arms)}")
    # A robot may be put into its first pose at once: no motion does that.
    jumps = [tick for tick in _native.jump_ticks(recording._native) if tick <= recording.ticks[0] + 1]
    first = int(np.searchsorted(recording.ticks, max([int(recording.ticks[0]), *(tick + 1 for tick in jumps)])))
    joints, ticks = recording.joints[first:], recording.ticks[first:].astype(np.int64)
    if len(ticks) < 2:
        raise ValueError(f"{recording.directory}: has {len(ticks)} ticks of motion, expected more")
    column = recording.joint_names.index
    moves = [arm for arm, names in description.arms.items()
             if np.ptp(joints[:, [column(name) for name in names]], axis=0).max() > _MOVES]
    arms = [arm for arm in description.arms if arm in (limbs or moves)]
    if not arms:
        raise ValueError(f"{recording.directory}: no arm moves in it")
    names = [name for arm in arms for name in description.arms[arm]]
    times = (ticks - ticks[0]) / TICKS_PER_SECOND
    return Plan(description, recording.title or recording.model.name, table_of(recording.model), arms,
                JointPath(names, times, joints[:, [column(name) for name in names]]),
                _gripper_moves(recording, description, arms, joints, ticks), speed)


def table_of(model: smile.Model) -> tuple[float, float]:
    """Returns width and depth of a scene's table [m]."""
    root = ElementTree.fromstring(model.xml)  # as SMILE has written it
    width, depth = (float(root.attrib[name]) * model.unit for name in ("xspan", "yspan"))
    return width, depth


def _gripper_moves(recording: smile.Recording, description: RobotDescription, arms: Sequence[str], joints: Floats,
                   ticks: "np.ndarray[tuple[int], np.dtype[np.int64]]") -> list[GripperMove]:
    channels = _native.channels_of(recording._native)
    positions = _native.channel_positions(recording._native, joints)
    moves = []
    for column, (_, arm, *_) in enumerate(channels):
        if arm not in arms:
            continue
        opening, range_of = positions[:, column], description.openings[arm]
        # As it was at the start.
        moves.append(GripperMove(arm, 0.0, 0.0, range_of.percent(opening[0]), None))
        for begin, end in _spans(np.abs(np.diff(opening)) > _GRIPPER_MOVES / TICKS_PER_SECOND):
            if abs(opening[end] - opening[begin]) < _GRIPPER_MOVES:
                continue
            held = [event["object"] for event in recording.events if event["kind"] == "gripper_holds"
                    and event["arm"] == arm and ticks[begin] <= event["tick"] <= ticks[end] + _GRIPPER_PAUSE]
            percent = 0.0 if held else range_of.percent(opening[end])
            moves.append(GripperMove(arm, (ticks[begin] - ticks[0]) / TICKS_PER_SECOND,
                                     (ticks[end] - ticks[0]) / TICKS_PER_SECOND, percent, held[0] if held else None))
    return sorted(moves, key=lambda move: move.begin)


def _spans(moves: "np.ndarray[tuple[int], np.dtype[np.bool_]]") -> list[tuple[int, int]]:
    """Returns begin and end of the spans in which something moves, with short pauses in them."""
    spans: list[tuple[int, int]] = []
    for tick in np.flatnonzero(moves):
        if spans and tick - spans[-1][1] <= _GRIPPER_PAUSE:
            spans[-1] = (spans[-1][0], int(tick) + 1)
        else:
            spans.append((int(tick), int(tick) + 1))
    return spans


class Fastest(NamedTuple):
    """The greatest rate of a joint, compared with its limit."""

    joint: str
    value: float
    limit: float
    time: float
    """[s] along the path"""

    @property
    def fraction(self) -> float:
        """Part of the limit"""
        return self.value / self.limit


def fastest(plan: Plan) -> Fastest:
    """Returns the joint that comes closest to its maximum speed [rad/s]."""
    rates = np.abs(np.diff(plan.path.positions, axis=0)) / np.diff(plan.path.times)[:, None] * plan.speed
    return _greatest(plan, rates, [plan.description.speed(name) for name in plan.path.names])


def hardest(plan: Plan, limit: float) -> Fastest:
    """Returns the joint with the greatest acceleration [rad/s²]."""
    window = round(ACCELERATION_SECONDS * TICKS_PER_SECOND)
    grid = np.arange(0, plan.path.duration + ACCELERATION_SECONDS, 1 / TICKS_PER_SECOND)
    # At rest before and after.
    padded = np.pad([plan.path.at(time)[0] for time in grid], ((2 * window, 2 * window), (0, 0)), mode="edge")
    speeds = (padded[window:] - padded[:-window]) / ACCELERATION_SECONDS
    rates = np.abs(speeds[window:] - speeds[:-window]) / ACCELERATION_SECONDS * plan.speed**2
    return _greatest(plan, rates, [limit] * len(plan.path.names))


def _greatest(plan: Plan, rates: Floats, limits: Sequence[float]) -> Fastest:
    row, column = divmod(int(np.argmax(rates / np.asarray(limits))), rates.shape[1])
    return Fastest(plan.path.names[column], float(rates[row, column]), limits[column],
                   float(plan.path.times[min(row, len(plan.path.times) - 1)]))


def tools(plan: Plan, arm: str) -> Floats:
    """Returns where an arm's tool is along the path, (k, 3) in the world [m]."""
    X_WB, motion = plan.description.X_WB, plan.description.motion
    return np.array([(X_WB @ motion.forward(arm, q))[:3, 3] for q in plan.path.positions[:, plan.columns(arm)]])


def workspace_fault(table: tuple[float, float], place: Floats) -> str | None:
    """Returns why a tool must not be at a place, which begins with the place; None if it may.

    table  width and depth [m]
    place  (3,) in the world [m]
    """
    width, depth = table
    low, high = np.array([-width / 2 - MARGIN, -depth / 2 - MARGIN, 0]), np.array([width / 2 + MARGIN, depth / 2 + MARGIN, HEIGHT])
    if ((place >= low) & (place <= high)).all():
        return None
    return (f"({', '.join(f'{one:.3f}' for one in place)}) m, outside of the workspace from ({', '.join(f'{one:g}' for one in low)}) to "
            f"({', '.join(f'{one:g}' for one in high)}) m,")


def faults(plan: Plan, max_acceleration: float) -> list[str]:
    """Returns why the motion must not be performed; empty if it may be."""
    found = []
    for column, name in enumerate(plan.path.names):
        lower, upper = plan.description.limits[name]
        beyond = (plan.path.positions[:, column] < lower - _MOVES) | (plan.path.positions[:, column] > upper + _MOVES)
        for row in np.flatnonzero(beyond)[:1]:
            found.append(f"{name} is {plan.path.positions[row, column]:.4f} rad at {plan.path.times[row]:.2f} s, "
                         f"expected {lower:.4f} to {upper:.4f}")
    for what, unit, worst, power in (("moves at", "rad/s", fastest(plan), 1),
                                     ("accelerates by", "rad/s²", hardest(plan, max_acceleration), 2)):
        if worst.fraction > 1:
            slower = plan.speed / worst.fraction ** (1 / power)
            found.append(f"{worst.joint} {what} {worst.value:.2f} {unit} at {worst.time:.2f} s of the recording, expected up to "
                         f"{worst.limit:g}; --speed {np.floor(slower * 1000) / 1000:g} keeps to it")
    for arm in plan.arms:
        for time, place in zip(plan.path.times, tools(plan, arm)):
            if (fault := workspace_fault(plan.table, place)) is not None:
                found.append(f"the {arm} tool is at {fault} at {time:.2f} s")
                break
    return found


def approach(plan: Plan, now: Mapping[str, float]) -> tuple[JointPath, str | None]:
    """Returns the slow way from where the robot is to the start of the path, and what is in it.

    now  positions of the joints of all arms [rad]
    """
    description = plan.description
    start = dict(zip(plan.path.names, plan.path.positions[0]))
    names = [name for joints in description.arms.values() for name in joints]
    # Encoders may report a joint at its limit as just beyond.
    here, there = (np.array([np.clip(positions[name], *description.limits[name]) for name in names])
                   for positions in (now, {**now, **start}))
    robot = Robot(description.urdf, base=description.X_WB, gripper=description.gripper)
    counts = {len(joints) for joints in description.arms.values()}
    shape = (2, len(description.arms), -1) if len(counts) == 1 else (2, -1)
    arm = "both" if len(description.arms) > 1 else next(iter(description.arms))
    waypoints = np.array([here, there]).reshape(shape if arm == "both" else (2, -1))
    if np.abs(there - here).max() < _MOVES:
        return JointPath(plan.path.names, [0.0], plan.path.positions[:1]), None
    motion = robot.move_joints(arm, waypoints, speed=APPROACH_SPEED)
    fault = robot.first_invalid(motion, table=plan.table)
    columns = [motion.joint_names.index(name) for name in plan.path.names]
    positions = motion.positions.reshape(len(motion.times), -1)[:, columns]
    velocities = motion.velocities.reshape(len(motion.times), -1)[:, columns]
    words = None if fault is None else f"the way to the start is blocked after {fault.seconds:.2f} s: {fault.reason}"
    return JointPath(plan.path.names, motion.times, positions, velocities), words
