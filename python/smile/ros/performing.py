"""Performs a plan on a robot, watches it, and measures how well it followed."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from time import monotonic
from typing import Any

import numpy as np

from smile.ros.description import RobotDescription
from smile.ros.joint_path import JointPath
from smile.ros.link import GripperReading, Reading, RobotLink
from smile.ros.motion_plan import GripperMove, Plan, approach
from smile.simulation import Floats

_RAMP_SECONDS = 0.5
"""time to full speed [s]"""
_HOLD_READINGS = 5
"""readings in which a stopped robot is told to stay where it is"""
_SETTLE_SECONDS = 2.0
"""time at the end for the joints to arrive [s]"""
_SETTLED = 0.01
"""[rad]"""
_TRAJECTORY_SECONDS = 5.0
"""time that the robot's own controller may take longer [s]"""
_LATE_SECONDS = (0.0, 0.1, 0.2, 0.3, 0.4, 0.5)
"""by how much it may begin later [s]"""
_GRIPPER_TOLERANCE = 5.0
"""[%]"""
_GRIPPER_PATIENCE = 5.0
"""time that a gripper may take longer than in the recording [s]"""
_GRIPPER_REST = 0.5
"""time without motion after which a gripper that should hold something holds nothing [s]"""


@dataclass(frozen=True)
class Watch:
    """What stops the robot."""

    tolerance: float = 0.15
    """greatest tracking error [rad]"""
    silence: float = 0.5
    """wall-clock time without joint states [s]"""
    age: float = 0.25
    """greatest age of joint states [s]"""
    jump: float = 0.25
    """greatest time between two joint states [s]"""


class Supervisor:
    """Follows a performance, and may stop it. This one does neither."""

    def must_stop(self) -> str | None:
        """Returns why the robot must stop; None: it need not. Asked at each reading."""
        return None

    def show(self, phase: str, seconds: float, duration: float, error: float) -> None:
        """Receives the time along a motion and its duration [s], and the greatest error of a joint [rad], at each reading."""


class Stopped(Exception):
    """The robot was stopped; the message is the reason."""


@dataclass
class Tracking:
    """Errors of the joints along the path."""

    names: list[str]
    times: list[float] = field(default_factory=list)
    errors: list[Floats] = field(default_factory=list)
    """measured minus wanted position [rad]"""

    def summary(self) -> dict[str, dict[str, float]]:
        """Returns for each joint the root mean square and the greatest error [rad], and when that was [s]."""
        if not self.errors:
            return {}
        errors = np.abs(self.errors)
        rows = errors.argmax(axis=0)
        return {name: {"rms": float(np.sqrt((errors[:, i] ** 2).mean())), "max": float(errors[rows[i], i]),
                       "at": self.times[rows[i]]} for i, name in enumerate(self.names)}

    def table(self) -> str:
        """Returns the summary for people, in mrad."""
        lines = [f"{'joint':<24}{'rms':>8}{'greatest':>10}  mrad, at"]
        lines += [f"{name:<24}{1000 * one['rms']:>8.1f}{1000 * one['max']:>10.1f}  {one['at']:.2f} s"
                  for name, one in self.summary().items()]
        return "\n".join(lines)


@dataclass
class Outcome:
    """What became of a performance."""

    reason: str | None
    """why the robot was stopped; None if it performed everything"""
    seconds: float
    """time of the path that was performed, at the speed of the recording [s]"""
    tracking: Tracking
    words: list[str]
    """the last warnings of the robot"""

    def report(self, plan: Plan) -> dict[str, Any]:
        """Returns the outcome as JSON values; angles in radians."""
        return {"title": plan.title, "robot": plan.description.name, "limbs": plan.arms, "speed": plan.speed,
                "performed": self.reason is None, "reason": self.reason, "seconds": round(self.seconds, 4),
                "seconds_of_recording": round(plan.path.duration, 4), "joints": self.tracking.summary(),
                "robot_warnings": self.words}


def write_report(outcome: Outcome, plan: Plan, path: str) -> None:
    """Writes the outcome as a JSON file."""
    with open(path, "w", encoding="utf-8") as file:
        json.dump(outcome.report(plan), file, indent=2)
        file.write("\n")


class WatchedRobot:
    """A robot that is moved, and watched meanwhile: any fault raises Stopped.

    arms           that are moved
    by_trajectory  the robot's own controller follows the way to the start
    """

    def __init__(self, link: RobotLink, description: RobotDescription, arms: Sequence[str], watch: Watch,
                 supervisor: Supervisor | None, by_trajectory: bool) -> None:
        self._link, self._description, self._arms, self._watch = link, description, list(arms), watch
        self._names = [name for arm in self._arms for name in description.arms[arm]]
        self._supervisor, self._by_trajectory = supervisor or Supervisor(), by_trajectory
        self._last: Reading | None = None
        self._elapsed = 0.0
        self._tracking = Tracking(self._names)

    # Readings.

    def read(self, *, at_rest: bool = False) -> Reading:
        """Returns the next reading; raises Stopped if it is not as it should be.

        at_rest  the arms rest, or only begin to move, and this computer was busy: time may have jumped, and what waits may
                 be old
        """
        deadline = monotonic() + self._watch.silence
        while True:
            reading = self._next()
            fault = self._age_fault(reading) or (None if at_rest else self._jump_fault(reading))
            if fault is None:
                break
            if not at_rest or monotonic() > deadline:
                raise Stopped(fault)
        self._last = reading
        # After the reading was found to be good: the arms are told to stay where it has them.
        if (reason := self._supervisor.must_stop()) is not None:
            raise Stopped(reason)
        return reading

    def _next(self) -> Reading:
        reading = self._link.wait(self._watch.silence)
        fault = self._link.connection_fault()
        if reading is None:
            raise Stopped(fault or f"no joint states for {self._watch.silence:g} s: the connection is lost")
        fault = fault or self._link.motors_fault() or self._joints_fault(reading)
        if fault is not None:
            raise Stopped(fault)
        return reading

    def _joints_fault(self, reading: Reading) -> str | None:
        missing = [name for name in self._names if name not in reading.positions]
        if missing:
            named = ", ".join(reading.positions)[:200]
            return f"the joint states lack {missing[0]}: they name {named or 'no joint'}"
        for name in self._names:
            if not math.isfinite(reading.positions[name]):
                return f"{name} is {reading.positions[name]}, expected a finite number"
        return None

    def _age_fault(self, reading: Reading) -> str | None:
        if reading.age > self._watch.age:
            return f"the joint states are {reading.age:.2f} s old, expected less than {self._watch.age:g} s"
        if reading.age < -self._watch.age:
            return f"the joint states are {-reading.age:.2f} s in the future: the clocks of robot and computer differ"
        return None

    def _jump_fault(self, reading: Reading) -> str | None:
        if self._last is not None:
            passed = reading.time - self._last.time
            if passed <= 0:
                return f"time went back by {-passed:.3f} s"
            if passed > self._watch.jump:
                return f"time jumped by {passed:.2f} s, expected less than {self._watch.jump:g} s"
        return None

    def positions(self, reading: Reading) -> Floats:
        """Returns the positions of the joints [rad]."""
        return np.array([reading.positions[name] for name in self._names])

    # Motions.

    def _command(self, positions: Floats) -> None:
        begin = 0
        for arm in self._arms:
            joints = self._description.arms[arm]
            self._link.command(arm, joints, positions[begin:begin + len(joints)].tolist())
            begin += len(joints)

    def _follow(self, path: JointPath, speed: float, during: Callable[[float, float], bool],
                tracking: Tracking | None) -> None:
        """Streams a path, at a fraction of its speed.

        during    called with the time along the path and the robot's; answers whether to wait there
        tracking  receives the errors
        """
        time = rate = 0.0
        while True:
            before = self._last
            reading = self.read()
            assert before is not None
            passed = reading.time - before.time
            rate = 0.0 if during(time, reading.time) else min(speed, rate + speed * passed / _RAMP_SECONDS)
            errors = self.positions(reading) - path.at(time)[0]
            self._check(errors, time)
            self._supervisor.show("Performing" if tracking is not None else "Moving to the start", time, path.duration,
                                  float(np.abs(errors).max()))
            if tracking is not None:
                self._elapsed = time
                tracking.times.append(time)
                tracking.errors.append(errors)
            if time >= path.duration and rate > 0:
                return
            # Where the joints should be when the next reading is taken.
            time = min(time + rate * passed, path.duration)
            self._command(path.at(time)[0])

    def _check(self, errors: Floats, time: float) -> None:
        worst = int(np.abs(errors).argmax())
        if abs(errors[worst]) > self._watch.tolerance:
            raise Stopped(f"{self._names[worst]} is {abs(errors[worst]):.3f} rad from where it should be at "
                          f"{time:.2f} s of the motion, expected less than {self._watch.tolerance:g} rad")

    def _hold(self) -> None:
        """Tells the arms to stay where they are. The grippers keep what they hold."""
        assert self._last is not None
        self._link.cancel()
        if not all(math.isfinite(self._last.positions.get(name, math.nan)) for name in self._names):
            return
        for _ in range(_HOLD_READINGS):
            self._command(self.positions(self._last))
            # Not read(): a stop must not fail on what it was made for.
            if self._link.wait(0.1) is None:
                return

    def _until_stopped(self, move: Callable[[], None]) -> str | None:
        """Moves the robot. Returns why it was stopped before the end, None if it was not; then it holds still."""
        reason = None
        try:
            move()
        except Stopped as error:
            reason = str(error)
        except KeyboardInterrupt:
            reason = "interrupted"
        if reason is not None and self._last is not None:
            self._hold()
        return reason

    def _settle(self, end: Floats) -> None:
        """Waits until the joints are where they should be in the end."""
        assert self._last is not None
        begin = self._last.time
        while True:
            reading = self.read()
            self._command(end)
            errors = np.abs(self.positions(reading) - end)
            if errors.max() < _SETTLED:
                return
            if reading.time - begin > _SETTLE_SECONDS:
                raise Stopped(f"{self._names[int(errors.argmax())]} came to rest {errors.max():.3f} rad from its "
                              f"end, expected less than {_SETTLED:g} rad")

    def _go_to_start(self, plan: Plan, say: Callable[[str], None]) -> None:
        """Moves slowly to the begin of a plan, if nothing is in the way."""
        path, fault = approach(plan, self.read(at_rest=True).positions)
        if fault is not None:
            raise Stopped(fault)
        self.read(at_rest=True)  # planning took its time
        say(f"moving to the start: {path.duration:.1f} s")
        if self._by_trajectory:
            self._send(path)
        else:
            self._follow(path, 1.0, lambda time, now: False, None)

    def _send(self, path: JointPath) -> None:
        """Lets the robot's own controllers follow a path, and watches them."""
        try:
            self._link.follow({arm: path.ordered(self._description.arms[arm]) for arm in self._arms}, self._watch.tolerance)
        except RuntimeError as error:
            raise Stopped(str(error)) from None
        begin = now = self.read(at_rest=True).time  # connecting took its time
        while True:
            states = {arm: self._link.trajectory(arm) for arm in self._arms}
            for arm, state in states.items():
                if state.fault is not None:
                    raise Stopped(f"the robot ended the trajectory of the {arm} arm: {state.fault}")
            if all(state.is_done for state in states.values()):
                return
            if now - begin > path.duration + _TRAJECTORY_SECONDS:
                late = next(arm for arm, state in states.items() if not state.is_done)
                raise Stopped(f"the robot has not {'ended' if states[late].has_begun else 'begun'} the trajectory of the {late} arm "
                              f"{_TRAJECTORY_SECONDS:g} s after it should have ended")
            reading = self.read()
            now = reading.time
            # The controllers begin when they have received it.
            errors = min((self.positions(reading) - path.at(now - begin - late)[0] for late in _LATE_SECONDS),
                         key=lambda one: float(np.abs(one).max()))
            self._check(errors, now - begin)
            self._supervisor.show("Moving to the start", now - begin, path.duration, float(np.abs(errors).max()))


class Performance(WatchedRobot):
    """A plan on its way through a robot."""

    def __init__(self, link: RobotLink, plan: Plan, watch: Watch, supervisor: Supervisor | None = None, by_trajectory: bool = False) -> None:
        super().__init__(link, plan.description, plan.arms, watch, supervisor, by_trajectory)
        self._plan = plan
        self._waiting = list(plan.grippers)
        self._active: list[ActiveGrip] = []

    # Grippers.

    def _grip(self, time: float, now: float) -> bool:
        """Sends the commands of grippers that are due; answers whether the arms must wait for one."""
        while self._waiting and self._waiting[0].begin <= time:
            move = self._waiting.pop(0)
            self._active = [one for one in self._active if one.move.arm != move.arm]
            self._active.append(ActiveGrip(move, self._link.grip(move.arm, move.percent)))
        self._active = [one for one in self._active if not one.is_done(self._link.gripper(one.move.arm), now)]
        return any(time >= one.move.end and one.must_wait(now) for one in self._active)

    # The whole.

    def perform(self, say: Callable[[str], None]) -> Outcome:
        """Moves to the start and along the path; stops with a reason if anything is not as it should be."""
        def move() -> None:
            self._go_to_start(self._plan, say)
            say(f"performing: {self._plan.seconds:.1f} s")
            self._follow(self._plan.path, self._plan.speed, self._grip, self._tracking)
            self._settle(self._plan.path.positions[-1])

        reason = self._until_stopped(move)
        return Outcome(reason, self._elapsed, self._tracking, self._link.words())


class ActiveGrip:
    """A command that a gripper carries out."""

    def __init__(self, move: GripperMove, sequence: int) -> None:
        self.move, self._sequence = move, sequence
        self._since: float | None = None
        self._rests_since: float | None = None

    def is_done(self, state: GripperReading | None, now: float) -> bool:
        """Returns whether the gripper is where it should be; raises Stopped if it holds nothing."""
        if state is None or state.sequence < self._sequence:
            return False
        if self.move.held is None:
            return abs(state.percent - self.move.percent) < _GRIPPER_TOLERANCE
        if state.holds:
            return True
        if state.is_moving or self._rests_since is None:
            self._rests_since = now
        elif now - self._rests_since > _GRIPPER_REST:
            raise Stopped(f"the {self.move.arm} gripper closed to {state.percent:.0f} % and holds nothing, expected "
                          f"{self.move.held}")
        return False

    def must_wait(self, now: float) -> bool:
        """Returns true, for the arms to wait; raises Stopped after some seconds."""
        self._since = now if self._since is None else self._since
        if now - self._since > _GRIPPER_PATIENCE:
            raise Stopped(f"the {self.move.arm} gripper did not reach {self.move.percent:.0f} % within {_GRIPPER_PATIENCE:g} s")
        return True
