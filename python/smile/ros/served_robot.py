"""The simulated robot behind the interface of a real one: goals of joints and grippers, and who may set them.

Knows nothing of ROS. Each command answers None, or the reason why it was refused; then nothing has changed.
"""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from enum import IntEnum
from typing import Any

import numpy as np

from smile.ros.description import RobotDescription
from smile.ros.joint_path import JointPath
from smile.simulation import TICKS_PER_SECOND, Floats, Simulation

COMMAND_TIMEOUT = 0.2
"""seconds without a command after which a limb stops and another controller may command it, as on Baxter"""
SPEED_RATIO = 0.3
"""fraction of the maximum speeds in position mode until it is set, as on Baxter"""
_GRIPPER_SPEED = 0.1
"""rate of change of an opening [m/s]"""
_OPENING_TOLERANCE = 0.001
"""[m]"""
_MOST_TEXT = 4096
"""characters of a gripper's arguments"""


class Mode(IntEnum):
    """Modes of a joint command, by their numbers in baxter_core_msgs/JointCommand."""

    POSITION = 1
    VELOCITY = 2
    TORQUE = 3
    RAW_POSITION = 4


@dataclass
class Limb:
    """Goals of an arm."""

    joints: list[str]
    mode: Mode | None = None
    """None: stands still"""
    goals: Floats = field(default_factory=lambda: np.zeros(0))
    """[rad] or [rad/s]; NaN for joints that have none"""
    owner: str | None = None
    """name of the node whose commands are in effect"""
    until: float = 0
    """time at which they lapse [s]"""
    speed_ratio: float = SPEED_RATIO
    path: JointPath | None = None
    """trajectory that is followed"""
    begin: float = 0
    """time at which it began [s]"""


@dataclass
class Gripper:
    """Goal of a gripper, and its last command."""

    goal: float | None = None
    """opening [m]; None: stands still"""
    is_moving: bool = False
    command: str = "no_op"
    sender: str = ""
    sequence: int = 0


def _numbers_fault(name: str, values: Sequence[float], count: int) -> str | None:
    if len(values) != count:
        return f"{name} has {len(values)} numbers, expected {count}"
    wrong = [value for value in values if not math.isfinite(value)]
    return f"{name} contains {wrong[0]}, expected finite numbers" if wrong else None


class ServedRobot:
    """A robot in a simulation, commanded as a real one is."""

    def __init__(self, sim: Simulation, description: RobotDescription) -> None:
        if sim.robot is None:
            raise ValueError("the simulation has no robot")
        self.sim, self.robot, self.description = sim, sim.robot, description
        self.is_enabled = True
        self.is_stopped = False
        """true after an emergency stop, until reset()"""
        self.limbs = {arm: Limb(joints) for arm, joints in description.arms.items()}
        self.grippers = {arm: Gripper() for arm in description.openings}

    @property
    def time(self) -> float:
        """Simulated time [s]"""
        return self.sim.time

    # Motors.

    def enable(self, is_on: bool) -> str | None:
        """Switches the motors."""
        if is_on and self.is_stopped:
            return "the robot is stopped, expected a reset first"
        self.is_enabled = is_on
        if not is_on:
            self._forget_goals()
        return None

    def emergency_stop(self) -> None:
        """Stops all motors until reset()."""
        self.is_stopped, self.is_enabled = True, False
        self._forget_goals()

    def reset(self) -> None:
        """Ends an emergency stop; the motors stay off."""
        self.is_stopped = False

    def _forget_goals(self) -> None:
        for limb in self.limbs.values():
            limb.mode, limb.path, limb.owner = None, None, None
        for gripper in self.grippers.values():
            gripper.goal = None

    # Commands of limbs.

    def command_joints(self, arm: str, mode: int, names: Sequence[str], values: Sequence[float],
                       sender: str) -> str | None:
        """Sets goals of some joints of an arm, in effect for COMMAND_TIMEOUT."""
        limb = self.limbs[arm]
        refusal = (self._motors_fault() or self._mode_fault(mode) or self._names_fault(limb, names)
                   or _numbers_fault("command", values, len(names)) or self._owner_fault(arm, sender)
                   or (None if mode == Mode.VELOCITY else self._limits_fault(names, values)))
        if refusal is not None:
            return refusal
        goals = np.full(len(limb.joints), np.nan)
        goals[[limb.joints.index(name) for name in names]] = values
        limb.mode, limb.goals, limb.path = Mode(mode), goals, None
        limb.owner, limb.until = sender, self.time + COMMAND_TIMEOUT
        return None

    def set_speed_ratio(self, arm: str, ratio: float) -> str | None:
        """Sets the fraction of the maximum speeds that position mode uses."""
        if not 0 <= ratio <= 1:
            return f"the speed ratio is {ratio}, expected a number from 0 to 1"
        self.limbs[arm].speed_ratio = ratio
        return None

    def follow(self, arm: str, path: JointPath, sender: str) -> str | None:
        """Starts a trajectory of all joints of an arm, at its time 0."""
        limb = self.limbs[arm]
        refusal = self._motors_fault() or self._names_fault(limb, path.names)
        if refusal is None and len(path.names) != len(limb.joints):
            refusal = f"the trajectory has {len(path.names)} joints, expected all {len(limb.joints)}: {', '.join(limb.joints)}"
        refusal = refusal or self._owner_fault(arm, sender)
        for positions in path.positions:
            refusal = refusal or self._limits_fault(path.names, positions)
        if refusal is not None:
            return refusal
        limb.path, limb.begin, limb.mode = path.ordered(limb.joints), self.time, Mode.RAW_POSITION
        limb.owner, limb.until = sender, math.inf
        return None

    def stop(self, arm: str) -> None:
        """Stops an arm where it is, and releases it."""
        limb = self.limbs[arm]
        limb.mode, limb.path, limb.owner = None, None, None

    def reference(self, arm: str) -> tuple[Floats, Floats]:
        """Returns where the trajectory of an arm should be now, and how fast [rad; rad/s]."""
        limb = self.limbs[arm]
        assert limb.path is not None
        return limb.path.at(self.time - limb.begin)

    def _motors_fault(self) -> str | None:
        if self.is_stopped:
            return "the robot is stopped"
        return None if self.is_enabled else "the robot is not enabled"

    @staticmethod
    def _mode_fault(mode: int) -> str | None:
        if mode == Mode.TORQUE:
            return "the mode is 3 (torque), but the simulated joints are driven by position and velocity only"
        return None if mode in set(Mode) else f"the mode is {mode}, expected 1 (position), 2 (velocity) or 4 (raw position)"

    @staticmethod
    def _names_fault(limb: Limb, names: Sequence[str]) -> str | None:
        if not names:
            return "no joint is named"
        if len(set(names)) != len(names):
            return "a joint is named twice"
        unknown = [name for name in names if name not in limb.joints]
        return f"joint {unknown[0]!r} is unknown, expected some of {', '.join(limb.joints)}" if unknown else None

    def _owner_fault(self, arm: str, sender: str) -> str | None:
        limb = self.limbs[arm]
        if limb.owner in (None, sender) or self.time >= limb.until:
            return None
        return f"limb {arm} is controlled by {limb.owner}, and {sender} is a second controller"

    def _limits_fault(self, names: Sequence[str], values: Sequence[float]) -> str | None:
        for name, value in zip(names, values):
            lower, upper = self.description.limits[name]
            # As exact as encoders are.
            if not lower - 1e-3 <= value <= upper + 1e-3:
                return f"{name} is {value:.4f} rad, expected {lower:.4f} to {upper:.4f}"
        return None

    # Commands of grippers.

    def command_gripper(self, arm: str, command: str, args: str, sender: str, sequence: int) -> str | None:
        """Carries out a command of baxter_core_msgs/EndEffectorCommand."""
        gripper, opening = self.grippers[arm], self.description.openings[arm]
        goal: float | None
        if command in ("no_op", "configure", "set", "calibrate", "reset", "clear_calibration", "prepare_to_grip"):
            goal = gripper.goal  # the simulated gripper is always calibrated, and has nothing to configure
        elif command == "stop":
            goal = None
        elif command in ("go", "grip", "release"):
            fault, percent = _percent_of(command, args)
            fault = fault or self._motors_fault()
            if fault is not None:
                return fault
            goal = opening.meters(percent)
        else:
            return f"the gripper command is {command[:40]!r}, expected go, grip, release, stop, calibrate or configure"
        gripper.goal, gripper.command, gripper.sender, gripper.sequence = goal, command, sender, sequence
        return None

    # Time.

    def step(self) -> None:
        """Advances by a tick, towards the goals."""
        for arm, limb in self.limbs.items():
            self.robot.arms[arm].move(self._velocities(arm, limb),
                                      self._gripper_rate(arm) if arm in self.grippers else None)
        self.sim.step()

    def _velocities(self, arm: str, limb: Limb) -> Floats:
        if limb.path is None and self.time >= limb.until:
            limb.mode, limb.owner = None, None
        now = self.robot.arms[arm].q
        if limb.mode is None:
            return np.zeros(len(limb.joints))
        if limb.mode == Mode.VELOCITY:
            return np.nan_to_num(limb.goals)
        if limb.path is not None:
            # Where the joints should be after this tick.
            goals, _ = limb.path.at(self.time - limb.begin + 1 / TICKS_PER_SECOND)
        else:
            goals = np.where(np.isnan(limb.goals), now, limb.goals)
        ratio = limb.speed_ratio if limb.mode == Mode.POSITION else 1
        speeds = ratio * np.array([self.description.speed(joint) for joint in limb.joints])
        return np.clip((goals - now) * TICKS_PER_SECOND, -speeds, speeds)

    def _gripper_rate(self, arm: str) -> float:
        gripper, hand = self.grippers[arm], self.robot.arms[arm]
        missing = 0.0 if gripper.goal is None else gripper.goal - hand.gripper
        # What is held stays held until the gripper is to open: any motion would release it.
        is_done = abs(missing) < _OPENING_TOLERANCE or (bool(hand.held) and missing < 0)
        gripper.is_moving = not is_done
        return 0.0 if is_done else float(np.clip(missing * TICKS_PER_SECOND, -_GRIPPER_SPEED, _GRIPPER_SPEED))


def _percent_of(command: str, args: str) -> tuple[str | None, float]:
    """Returns what is wrong with the arguments of a gripper command, and the position that it asks for [%]."""
    if command != "go":
        return None, 100.0 if command == "release" else 0.0
    try:
        value: Any = json.loads(args) if len(args) <= _MOST_TEXT else None
    except (ValueError, RecursionError):
        value = None
    position = value.get("position") if isinstance(value, dict) else None
    if isinstance(position, bool) or not isinstance(position, (int, float)) or not 0 <= position <= 100:
        return f'the arguments of go are {args[:40]!r}, expected {{"position": P}} with P from 0 to 100', 0.0
    return None, float(position)
