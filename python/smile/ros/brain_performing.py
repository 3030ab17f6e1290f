"""Lets a brain drive a robot, watches it, and measures how well it followed."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

import smile
from smile.native import load
from smile.ros.camera_view import CameraView
from smile.ros.description import Opening, RobotDescription
from smile.ros.joint_path import JointPath
from smile.ros.link import CameraReading, GripperReading, Reading, RobotLink, SeeingLink
from smile.ros.motion_plan import ACCELERATION_SECONDS, Plan, table_of, workspace_fault
from smile.ros.performing import Stopped, Supervisor, Tracking, Watch, WatchedRobot
from smile.simulation import TICKS_PER_SECOND, Floats

if TYPE_CHECKING:
    from smile import smile_simulator_native as _native
else:
    _native = load("smile_simulator_native")

_TICK = 1 / TICKS_PER_SECOND
_NEAR_LIMIT = 1e-3
"""a joint may be beyond its limit by so much: encoders are no more exact [rad]"""
_MOST_SPEEDS = 3.0
"""multiple of a joint's maximum speed that is a mistake"""
_ANSWER_PART = 0.6
"""part of the time between two readings in which a brain's answer is waited for before the arms are told to stand"""
_START_PATIENCE = 0.05
"""the same at the start, when they stand anyway [s]"""
_GRIPPER_SECONDS = 2.0
"""time in which each gripper must have reported its opening [s]"""
_GRIPPER_STEP = 1.0
"""change of a gripper's goal that is worth a command [%]"""


@dataclass(frozen=True)
class CameraPose:
    """A calibrated camera of the robot's cell."""

    topic: str
    view: CameraView
    X_WC: Floats
    """(4, 4): x right, y down, z forward, in the world [m]"""
    has_depth: bool = False


@dataclass(frozen=True)
class BrainTask:
    """What a brain is to do, and how far it may go."""

    brain: str
    """as `--brain` of the program has it"""
    demonstration: str = ""
    """folder of the recording to imitate; empty for none"""
    camera: CameraPose | None = None
    speed: float = 0.3
    """seconds of the brain's clock per second of the robot's"""
    max_acceleration: float = 3.0
    """[rad/s²]"""
    timeout: float = 5.0
    """wall-clock time for a callback [s]"""
    seconds: float = 600.0
    """greatest time by the brain's clock [s]"""
    picture_age: float = 0.1
    """greatest age of a picture that the brain gets [s]"""
    picture_silence: float = 2.0
    """time of the robot in which the arms wait for a newer one [s]"""


@dataclass
class BrainOutcome:
    """What became of a brain's run."""

    reason: str | None
    """why the robot was stopped; None if the brain ended by itself"""
    seconds: float
    """by the brain's clock [s]"""
    tracking: Tracking
    claim: tuple[bool, str] | None
    """whether it did its task, and its words; None if it claims nothing"""
    num_pictures: int
    waits: dict[str, float] = field(default_factory=dict)
    """time in which the arms stood, by what they waited for [s]"""
    words: list[str] = field(default_factory=list)
    """the last warnings of the robot"""

    def report(self, task: BrainTask, robot: str) -> dict[str, Any]:
        """Returns the outcome as JSON values; angles in radians."""
        claim = None if self.claim is None else {"done": self.claim[0], "reason": self.claim[1]}
        return {"brain": task.brain, "robot": robot, "speed": task.speed, "performed": self.reason is None, "reason": self.reason,
                "seconds": round(self.seconds, 4), "claim": claim, "pictures": self.num_pictures,
                "waits": {name: round(one, 4) for name, one in self.waits.items()}, "joints": self.tracking.summary(),
                "robot_warnings": self.words}


class GripperGoal:
    """Goal of a gripper whose opening a brain changes at a rate."""

    def __init__(self, opening: Opening) -> None:
        self._opening = opening
        self._direction = 0.0
        self._goal = 0.0
        self._sent: float | None = None

    def due(self, rate: float, measured: GripperReading) -> float | None:
        """Returns the percentage to command in this tick; None if the last one will do.

        rate  of the opening, by the brain's clock [m/s]
        """
        if rate == 0 and self._direction == 0:
            return None
        if np.sign(rate) not in (0, self._direction):
            # From where it is: an object may have stopped it.
            self._goal = self._opening.meters(measured.percent)
            self._sent = None
        self._direction = float(np.sign(rate)) or self._direction
        self._goal = float(np.clip(self._goal + rate * _TICK, self._opening.closed, self._opening.open))
        percent = self._opening.percent(self._goal)
        is_end = rate == 0 or percent in (0, 100)
        if self._sent is not None and abs(percent - self._sent) < (1e-6 if is_end else _GRIPPER_STEP):
            return None
        self._sent = percent
        return percent

    def correct(self, measured: GripperReading, sequence: int) -> None:
        """Limits the goal, before a step of the brain, to what is just beyond the measured opening: the brain knows that the
        fingers are slower than it thought. Fingers that close and were stopped by an object keep their goal, and press.

        sequence  of the last command
        """
        rests = not measured.is_moving and measured.sequence >= sequence
        if self._direction > 0:
            self._goal = min(self._goal, self._opening.meters(measured.percent + _GRIPPER_STEP))
        elif self._direction < 0 and not rests:
            self._goal = max(self._goal, self._opening.meters(measured.percent - _GRIPPER_STEP))


class BrainPerformance(WatchedRobot):
    """A brain that drives a robot.

    The clock of the brain advances in ticks of 1/60 s while the arms move, and stands while it computes for longer
    than that: then they stand, too.
    """

    def __init__(self, link: RobotLink, model: smile.Model, description: RobotDescription, task: BrainTask, watch: Watch,
                 supervisor: Supervisor | None = None, by_trajectory: bool = False) -> None:
        super().__init__(link, description, list(model.arm_names), watch, supervisor, by_trajectory)
        self._task, self._table = task, table_of(model)
        camera = None
        if task.camera is not None:
            view = task.camera.view
            camera = (*view.size, view.intrinsics, task.camera.X_WC)
        self._brain = _native.RobotBrain(model, task.brain, camera, task.camera is not None and task.camera.has_depth, self._look,
                                         task.demonstration, task.timeout)
        limits = np.array([description.limits[name] for name in self._names])
        self._bounds = limits[:, 0] - _NEAR_LIMIT, limits[:, 1] + _NEAR_LIMIT
        self._goals = np.zeros(len(self._names))
        self._velocities = np.zeros(len(self._names))
        self._grippers = {arm: GripperGoal(opening) for arm, opening in description.openings.items()}
        self._sequences = dict.fromkeys(self._grippers, 0)
        self._asked: tuple[float, Floats] | None = None
        """time [s] and positions at the last question"""
        window = round(ACCELERATION_SECONDS * TICKS_PER_SECOND)
        self._history = deque([np.zeros(len(self._names))] * (2 * window), maxlen=2 * window)
        self._waits = {"brain": 0.0, "pictures": 0.0}
        self._num_pictures = 0
        self._is_moving = False
        """the arms get goals"""
        self._say: Callable[[str], None] = lambda line: None

    # What the brain gets.

    def _state_of(self, arm: str) -> GripperReading:
        state = self._link.gripper(arm)
        if state is None or not math.isfinite(state.percent):
            raise Stopped(f"the {arm} gripper does not report its opening")
        return state

    def _sense(self, reading: Reading) -> None:
        q = self.positions(reading)
        velocities = np.zeros_like(q)
        if self._asked is not None:
            # By the brain's clock.
            velocities = (q - self._asked[1]) / ((reading.time - self._asked[0]) * self._task.speed)
        self._asked = reading.time, q
        arms, begin = [], 0
        for arm in self._arms:
            end = begin + len(self._description.arms[arm])
            opening, holds = None, False
            if arm in self._description.openings:
                state = self._state_of(arm)
                opening, holds = self._description.openings[arm].meters(state.percent), state.holds
            arms.append((q[begin:end].tolist(), velocities[begin:end].tolist(), opening, holds))
            begin = end
        self._brain.sense(arms)

    def _look(self) -> tuple[Any, Any]:
        """Returns a picture that is new enough for the brain, while the arms wait for it."""
        camera, last = self._task.camera, self._last
        assert camera is not None and last is not None and isinstance(self._link, SeeingLink)
        begin = now = last.time
        while True:
            seen = self._seen(camera)
            if seen is not None and now - self._task.picture_age <= seen.time <= now + self._watch.age:
                break
            if now - begin > self._task.picture_silence:
                raise Stopped(f"no picture of {camera.topic} for {self._task.picture_silence:g} s that is newer than "
                              f"{self._task.picture_age:g} s")
            now = self._stand("pictures").time
        self._num_pictures += 1
        return camera.view.picture(seen.rgb), None if seen.depth is None else camera.view.depths(seen.depth)

    def _seen(self, camera: CameraPose) -> CameraReading | None:
        assert isinstance(self._link, SeeingLink)
        try:
            seen = self._link.seen()
        except ValueError as error:
            raise Stopped(f"{camera.topic}: {error}") from None
        fault = None if seen is None else camera.view.fault_of(seen)
        if fault is not None:
            raise Stopped(f"{camera.topic}: {fault}")
        return seen

    def _stand(self, why: str) -> Reading:
        """Reads once more, while the arms stand at their goals."""
        before = self._last
        reading = self.read(at_rest=not self._is_moving)
        if self._is_moving and before is not None:
            self._observe(reading)
            self._command(self._goals)
            self._waits[why] += reading.time - before.time
        return reading

    def _ask(self, reading: Reading, patience: float) -> None:
        """Asks the brain, if it is its turn, and waits for the answer.

        patience  wall-clock time in which the answer is waited for before the arms are told to stand [s]
        """
        self._sense(reading)
        if self._brain.ask():
            for arm, goal in self._grippers.items():
                goal.correct(self._state_of(arm), self._sequences[arm])
            while not self._brain.take(patience):
                self._stand("brain")
        for line in self._brain.lines():
            self._say(f"brain: {line}")
        if self._brain.status == "failed":
            raise Stopped(f"the brain failed: {self._brain.error}")

    # What it commands.

    def _take_commands(self) -> None:
        """Reads the velocities of the next tick, and refuses what the arms must not do."""
        velocities = np.concatenate([self._brain.velocities(k) for k in range(len(self._arms))])
        limits = np.array([self._description.speed(name) for name in self._names])
        for name, value, limit in zip(self._names, velocities, limits):
            if abs(value) > limit * _MOST_SPEEDS:
                raise Stopped(f"the brain asks {name} for {value:.2f} rad/s, expected up to {limit:g}")
        # As in simulation: a brain that catches up with a delay may ask for more.
        velocities = np.clip(velocities, -limits, limits)
        self._history.append(velocities)
        self._check_accelerations()
        end = self._goals + velocities * _TICK
        for name, value in zip(self._names, end):
            lower, upper = self._description.limits[name]
            if not lower - _NEAR_LIMIT <= value <= upper + _NEAR_LIMIT:
                raise Stopped(f"the brain drives {name} to {value:.4f} rad, expected {lower:.4f} to {upper:.4f}")
        self._check_places(end)
        self._velocities = velocities
        for k, arm in enumerate(self._arms):
            if arm in self._grippers:
                percent = self._grippers[arm].due(self._brain.opening_rate(k), self._state_of(arm))
                if percent is not None:
                    self._sequences[arm] = self._link.grip(arm, percent)

    def _check_accelerations(self) -> None:
        half = len(self._history) // 2
        speeds = np.array(self._history)
        rates = np.abs(speeds[half:].mean(axis=0) - speeds[:half].mean(axis=0)) / ACCELERATION_SECONDS * self._task.speed**2
        worst = int(rates.argmax())
        if rates[worst] > self._task.max_acceleration:
            slower = self._task.speed * np.sqrt(self._task.max_acceleration / rates[worst])
            raise Stopped(f"the brain accelerates {self._names[worst]} by {rates[worst]:.2f} rad/s², expected up to "
                          f"{self._task.max_acceleration:g}; --speed {np.floor(slower * 1000) / 1000:g} keeps to it")

    def _check_places(self, q: Floats) -> None:
        begin, joints = 0, []
        for arm in self._arms:
            joints.append(q[begin:begin + len(self._description.arms[arm])])
            begin += len(joints[-1])
            place = (self._description.X_WB @ self._description.motion.forward(arm, joints[-1]))[:3, 3]
            if (fault := workspace_fault(self._table, place)) is not None:
                raise Stopped(f"the brain drives the {arm} tool to {fault} at {self._brain.seconds:.2f} s")
        touching = self._brain.touch([one.tolist() for one in joints])
        if touching is not None:
            raise Stopped(f"the brain drives the arms to where {touching}")

    # The whole.

    def start(self, say: Callable[[str], None]) -> Plan | None:
        """Starts the brain, which moves nothing; returns the way to the posture in which it begins, None if any will do.

        Raises Stopped if the brain fails or asks for what a robot cannot do.
        """
        self._say = say
        reading = begin = self.read(at_rest=True)
        # Grippers report less often than joints.
        while reading.time - begin.time < _GRIPPER_SECONDS and any(self._link.gripper(arm) is None for arm in self._grippers):
            reading = self.read(at_rest=True)
        self._ask(reading, _START_PATIENCE)
        initial = [self._brain.initial_joints(k) for k in range(len(self._arms))]
        if all(one is None for one in initial):
            return None
        reading = self.read(at_rest=True)  # starting took its time
        start = np.concatenate([[reading.positions[name] for name in self._description.arms[arm]] if one is None else one
                                for arm, one in zip(self._arms, initial)])
        return Plan(self._description, self._task.brain, self._table, self._arms, JointPath(self._names, [0.0], [start]), [], 1.0)

    def perform(self, say: Callable[[str], None]) -> BrainOutcome:
        """Lets the brain drive until it ends; stops with a reason if anything is not as it should be."""
        def move() -> None:
            plan = self.start(say)
            if plan is not None:
                self._go_to_start(plan, say)
            reading = self.read(at_rest=True)
            self._goals = self.positions(reading) if plan is None else plan.path.positions[0].copy()
            self._asked, self._is_moving = None, True
            say("the brain drives the robot")
            self._drive(reading)
            self._settle(self._goals)

        reason = self._until_stopped(move)
        return BrainOutcome(reason, self._brain.seconds, self._tracking, self._brain.claim, self._num_pictures, self._waits,
                            self._link.words())

    def close(self) -> None:
        """Ends the brain."""
        self._brain.close()

    def _drive(self, reading: Reading) -> None:
        """Asks the brain at the reading that is nearest to the begin of each tick, and streams goals between."""
        ticks = passed = 0.0
        due = 0
        period = _TICK
        while True:
            if ticks + passed / 2 >= due:
                self._ask(reading, _ANSWER_PART * period)
                reading = self._last or reading
                if self._brain.status == "exited":
                    return
                if self._brain.seconds > self._task.seconds:
                    raise Stopped(f"the time limit of {self._task.seconds:g} s was reached")
                self._take_commands()
                self._brain.tick()
                due += 1
            # Where the joints should be when the next reading is taken: at most a tick ahead, the clock of the brain
            # is no faster than the readings.
            passed = min(period * self._task.speed * TICKS_PER_SECOND, 1.0)
            ticks += passed
            # Until the next question it may be a little more than a tick, for which limits were checked.
            self._goals = np.clip(self._goals + self._velocities * (passed * _TICK), *self._bounds)
            self._command(self._goals)
            before = reading
            reading = self.read()
            period = reading.time - before.time
            self._observe(reading)

    def _observe(self, reading: Reading) -> None:
        errors = self.positions(reading) - self._goals
        seconds = self._brain.seconds
        self._check(errors, seconds)
        self._supervisor.show("The brain drives", seconds, self._task.seconds, float(np.abs(errors).max()))
        self._tracking.times.append(seconds)
        self._tracking.errors.append(errors)
