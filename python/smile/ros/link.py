"""The interface to a robot: what `smile ros perform` needs of one, whichever way it is reached."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from smile.ros.joint_path import JointPath


class Reading(NamedTuple):
    """Positions of joints at a time."""

    time: float
    """of the measurement, by the robot's clock [s]"""
    age: float
    """how long ago that is, by the same clock [s]"""
    positions: Mapping[str, float]
    """by the names of joints [rad]"""


class GripperReading(NamedTuple):
    """State of a gripper."""

    sequence: int
    """number of the last command that it has taken"""
    percent: float
    """opening: 0 is closed, 100 open"""
    is_moving: bool
    holds: bool


class TrajectoryReading(NamedTuple):
    """State of a trajectory that a robot follows by itself."""

    has_begun: bool
    is_done: bool
    fault: str | None
    """why the robot refused or ended it; None if it did not"""


class CameraReading(NamedTuple):
    """A picture of a camera."""

    rgb: npt.NDArray[np.uint8]
    """(height, width, 3), row 0 on top"""
    intrinsics: npt.NDArray[np.float64]
    """(3, 3) [px]"""
    distortion: npt.NDArray[np.float64]
    """(5,) coefficients of ROS' plumb_bob"""
    time: float
    """at which it was taken, by the robot's clock; with depths, when the older of both was [s]"""
    depth: npt.NDArray[np.float32] | None = None
    """(height, width): distance along the camera's axis [m], 0 where it is not known; None without a camera of depths"""


class RobotLink(ABC):
    """A connection to a robot.

    Arms and joints have names. Its methods return at once, except wait(); what the robot makes of a command
    is seen in the next readings only.
    """

    @abstractmethod
    def wait(self, timeout: float) -> Reading | None:
        """Returns the newest reading that was not returned yet; None after wall-clock time without one [s]."""

    @abstractmethod
    def command(self, arm: str, names: Sequence[str], positions: Sequence[float]) -> None:
        """Sends goals of an arm's joints [rad]. An arm without commands stops by itself."""

    @abstractmethod
    def follow(self, paths: Mapping[str, JointPath], tolerance: float) -> None:
        """Sends trajectories of all joints of some arms, which their own controllers begin at once.

        tolerance  error of a joint on the way at which a controller ends its trajectory [rad]

        Raises RuntimeError if an arm has no such controller; then nothing was sent.
        """

    @abstractmethod
    def trajectory(self, arm: str) -> TrajectoryReading:
        """Returns the state of the trajectory that was sent last to an arm."""

    @abstractmethod
    def cancel(self) -> None:
        """Ends the trajectories that were sent and are not done. Does nothing if there are none."""

    @abstractmethod
    def grip(self, arm: str, percent: float) -> int:
        """Sends the goal of a gripper; returns the number of the command."""

    @abstractmethod
    def gripper(self, arm: str) -> GripperReading | None:
        """Returns the newest state of a gripper; None if it has not reported any."""

    @abstractmethod
    def enable(self) -> None:
        """Asks for the motors to be switched on."""

    @abstractmethod
    def motors_fault(self) -> str | None:
        """Returns why the motors do not run; None if they do."""

    @abstractmethod
    def connection_fault(self) -> str | None:
        """Returns what is wrong with the connection; None if nothing is."""

    @abstractmethod
    def words(self) -> list[str]:
        """Returns the newest warnings of the robot."""


class SeeingLink(RobotLink):
    """A connection to a robot and its cameras."""

    @abstractmethod
    def picture(self, topic: str, timeout: float) -> CameraReading:
        """Returns the next picture of a topic, with the camera_info beside it.

        Raises RuntimeError if they do not arrive within wall-clock time [s], ValueError if they are faulty.
        """

    @abstractmethod
    def watch(self, topic: str, depth_topic: str | None) -> None:
        """Receives pictures of a topic from now on, with the camera_info beside it.

        depth_topic  of the depths in the same pixels; None without
        """

    @abstractmethod
    def seen(self) -> CameraReading | None:
        """Returns the newest picture of the topic that is watched; None before the first one.

        Raises ValueError if it is faulty.
        """
