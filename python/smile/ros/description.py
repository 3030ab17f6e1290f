"""The robot of a recording: names, limits and frames, as ROS programs know them."""

from __future__ import annotations

import json
import tempfile
import xml.etree.ElementTree as ElementTree
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

import smile
from smile.motion import Robot
from smile.native import load
from smile.simulation import Floats, Simulation

if TYPE_CHECKING:
    from smile import smile_simulator_native as _native
else:
    _native = load("smile_simulator_native")


class UrdfJoint(NamedTuple):
    """A joint of the robot's URDF."""

    parent: str
    child: str
    X_PC: Floats
    """(4, 4): pose of the child in the parent at 0 [m]"""
    axis: Floats
    """(3,) in the child"""
    slides: bool
    speed: float
    """maximum speed [rad/s; m/s]; inf without a limit"""

    def pose_at(self, position: float) -> Floats:
        """Returns the (4, 4) pose of the child in the parent [m] at a position [rad; m]."""
        X_CQ = np.eye(4)
        if self.slides:
            X_CQ[:3, 3] = position * self.axis
        else:
            X_CQ[:3, :3] = rotation_about(self.axis, position)
        return self.X_PC @ X_CQ


class Opening(NamedTuple):
    """Range of a gripper's opening [m]."""

    closed: float
    open: float

    def percent(self, opening: float) -> float:
        """Returns an opening [m] in percent: 0 is closed, as Baxter's grippers have it."""
        return float(np.clip((opening - self.closed) / (self.open - self.closed), 0, 1)) * 100

    def meters(self, percent: float) -> float:
        """Returns the opening [m] at a percentage."""
        return self.closed + (self.open - self.closed) * percent / 100


def rotation_about(axis: Floats, angle: float) -> Floats:
    """Returns the (3, 3) rotation by an angle [rad] about a unit axis (Rodrigues' formula)."""
    x, y, z = axis
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def quaternion_of(rotation: Floats) -> Floats:
    """Returns the unit quaternion w, x, y, z of a (3, 3) rotation, with w not negative."""
    # The largest of the four squares is at least 1/4, so that its root may divide.
    w, x, y, z = 1 + np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]]) @ np.diag(rotation)
    r = rotation
    columns = np.array([[w, r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1]],
                        [r[2, 1] - r[1, 2], x, r[0, 1] + r[1, 0], r[0, 2] + r[2, 0]],
                        [r[0, 2] - r[2, 0], r[0, 1] + r[1, 0], y, r[1, 2] + r[2, 1]],
                        [r[1, 0] - r[0, 1], r[0, 2] + r[2, 0], r[1, 2] + r[2, 1], z]])
    quaternion = columns[int(np.argmax([w, x, y, z]))]
    quaternion = quaternion / np.linalg.norm(quaternion)
    return quaternion if quaternion[0] >= 0 else -quaternion


def matrix_of(pose: Floats) -> Floats:
    """Returns the (4, 4) matrix of a pose x, y, z and w, x, y, z."""
    w, v = pose[3], pose[4:7]
    cross = np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])
    X = np.eye(4)
    X[:3, :3] = np.eye(3) + 2 * w * cross + 2 * cross @ cross
    X[:3, 3] = pose[:3]
    return X


def _urdf_joints(path: Path) -> dict[str, UrdfJoint]:
    # SMILE wrote the file, from one that it has checked.
    joints = {}
    for element in ElementTree.parse(path).getroot().iter("joint"):
        parent, child = element.find("parent"), element.find("child")
        if parent is None or child is None:
            continue
        numbers = {name: np.array([float(word) for word in words.split()]) for name, words in (
            ("xyz", _attribute(element, "origin", "xyz", "0 0 0")), ("rpy", _attribute(element, "origin", "rpy", "0 0 0")),
            ("axis", _attribute(element, "axis", "xyz", "1 0 0")))}
        X_PC = np.eye(4)
        for axis, angle in zip(np.eye(3), numbers["rpy"]):
            X_PC[:3, :3] = rotation_about(axis, angle) @ X_PC[:3, :3]
        X_PC[:3, 3] = numbers["xyz"]
        joints[str(element.get("name"))] = UrdfJoint(
            str(parent.get("link")), str(child.get("link")), X_PC, numbers["axis"] / np.linalg.norm(numbers["axis"]),
            element.get("type") == "prismatic", float(_attribute(element, "limit", "velocity", "inf")))
    return joints


def _attribute(element: ElementTree.Element, name: str, attribute: str, absent: str) -> str:
    child = element.find(name)
    return absent if child is None else child.get(attribute, absent)


class RobotDescription:
    """The robot of a recording."""

    def __init__(self, recording: smile.Recording) -> None:
        if not recording.model.has_robot:
            raise ValueError(f"{recording.directory}: has no robot, expected a recording of a robot")
        info = json.loads((recording.directory / "demo.json").read_text())["robot"]
        self.name: str = info["name"]
        self.gripper: str = info.get("gripper", "")
        self.urdf = recording.directory / info["urdf"]
        self.motion = Robot(self.urdf, gripper=self.gripper)
        """its kinematics, in its base"""
        self.arms: dict[str, list[str]] = {arm: self.motion.joint_names(arm) for arm in self.motion.arms}
        """names of the joints of each arm, from the shoulder to the wrist"""
        self.joints = _urdf_joints(self.urdf)
        self.limits: dict[str, tuple[float, float]] = {}
        """(lower, upper) of joints [rad; m]"""
        self.openings: dict[str, Opening] = {}
        """of the grippers, by arm"""
        for name, arm, _, lower, upper in _native.channels_of(recording._native):
            if arm is None:
                self.limits[name] = (lower, upper)
            else:
                self.openings[arm] = Opening(lower, upper)
        arm = next(iter(self.arms))
        columns = [recording.joint_names.index(joint) for joint in self.arms[arm]]
        X_WG = matrix_of(_native.tool_poses(recording._native, recording.joints[:1])[0, 0])
        self.X_WB = X_WG @ np.linalg.inv(self.motion.forward(arm, recording.joints[0, columns]))
        """(4, 4): the robot's base in the world [m]"""
        self.files: object = None
        """keeps temporary files of the robot"""

    def speed(self, joint: str) -> float:
        """Returns a joint's maximum speed [rad/s; m/s]."""
        return self.joints[joint].speed if joint in self.joints else np.inf


def describe(model: smile.Model) -> RobotDescription:
    """Returns the description of a model's robot."""
    # A recording contains the robot's files, with the limits of its grippers.
    folder = tempfile.TemporaryDirectory(prefix="smile_ros_")
    with Simulation(model) as sim:
        sim.record(Path(folder.name) / "robot", pictures=False)
        sim.step()
        description = RobotDescription(sim.finish())
    description.files = folder
    return description
