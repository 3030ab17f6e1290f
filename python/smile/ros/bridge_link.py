"""A robot behind a rosbridge server, on ROS 1 or 2, under the names of Baxter."""

from __future__ import annotations

import base64
import json
import math
import os
import threading
import time
from collections import deque
from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

from smile.ros.bridge import Bridge
from smile.ros.camera import depth_of, info_topic_of, intrinsics_of, rgb_of
from smile.ros.joint_path import JointPath
from smile.ros.link import CameraReading, GripperReading, Reading, SeeingLink, TrajectoryReading
from smile.ros.trajectory_goal import KIND, action_of, goal_of, reading_of

_CONNECTION_SECONDS = 10.0
_ACTION_SECONDS = 5.0
_ADVERTISE_SECONDS = 2.0
"""from the announcement of a topic to its first message [s]"""
_MOST_WORDS = 5
_MOST_JOINTS = 1000
_SAME_CLOCK = 60.0
"""greatest age of joint states by this machine's clock; beyond, the robot must have another one [s]"""
_POSITION_MODE = 1
"""of baxter_core_msgs/JointCommand"""
_WARN = {1: 4, 2: 30}
"""level of warnings by the version of ROS: rosgraph_msgs/Log and rcl_interfaces/Log"""


def seconds_of(stamp: Any) -> float:
    """Returns a time of ROS 1 (secs, nsecs) or ROS 2 (sec, nanosec) [s]."""
    if not isinstance(stamp, dict):
        raise TypeError(f"a time is {str(stamp)[:40]!r}, expected an object")
    whole, parts = ("secs", "nsecs") if "secs" in stamp else ("sec", "nanosec")
    return number_of(stamp[whole]) + number_of(stamp[parts]) / 1e9


def number_of(value: Any) -> float:
    """Returns a number; null, which stands for NaN and infinity, is NaN."""
    if value is None:
        return math.nan
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise TypeError(f"{str(value)[:40]!r} is not a number")
    return float(value)


def _list_of(value: Any, what: str) -> list[Any]:
    if not isinstance(value, list) or len(value) > _MOST_JOINTS:
        raise TypeError(f"{what} is {str(value)[:40]!r}, expected a list of up to {_MOST_JOINTS}")
    return value


def _flag_of(message: dict[str, Any], name: str) -> bool:
    if not isinstance(message[name], bool):
        raise TypeError(f"{name} is {str(message[name])[:40]!r}, expected true or false")
    return bool(message[name])


class BridgeLink(SeeingLink):
    """Streams positions at full ratio of speed: the path itself is slow.

    The robot's clock is /clock if it is published, else this machine's.

    Raises RuntimeError if there is no bridge, or no robot behind it within some seconds.
    """

    def __init__(self, address: str, arms: Sequence[str], names: Sequence[str]) -> None:
        self._names = frozenset(names)
        self._name = f"/smile_perform_{os.getpid()}_{time.time_ns() % 1_000_000}"
        self._news = threading.Condition()
        self._reading: Reading | None = None
        self._are_known = False
        """true after the first message about the joints"""
        self._clock: float | None = None
        self._state: dict[str, Any] | None = None
        self._grippers: dict[str, tuple[int, GripperReading]] = {}
        self._sequences = dict.fromkeys(arms, 0)
        self._words: deque[str] = deque(maxlen=_MOST_WORDS)
        self._goals: dict[str, str] = {}
        """by arm: id of the trajectory that was sent last"""
        self._trajectories: dict[str, tuple[int, str]] = {}
        """status and words of trajectories, by their ids"""
        self._serving: set[str] = set()
        """arms whose action has reported"""
        self._watched: dict[str, dict[str, Any]] = {}
        """the newest messages of the camera that is watched"""
        self._watched_topic, self._has_depth = "", False
        self._bridge = Bridge(address, self._notify)
        for arm in arms:
            self._bridge.advertise(f"/robot/limb/{arm}/joint_command", "baxter_core_msgs/JointCommand")
            # A bridge does not say when the robot listens.
            self._bridge.advertise(f"/robot/limb/{arm}/set_speed_ratio", "std_msgs/Float64", latch=True)
            self._bridge.advertise(f"/robot/end_effector/{arm}_gripper/command", "baxter_core_msgs/EndEffectorCommand")
        self._bridge.advertise("/robot/set_super_enable", "std_msgs/Bool")
        self._subscribe(arms)
        self._await_robot()
        for arm in arms:
            self._bridge.publish(f"/robot/limb/{arm}/set_speed_ratio", {"data": 1.0}, latch=True)

    def _subscribe(self, arms: Sequence[str]) -> None:
        self._bridge.subscribe("/clock", "rosgraph_msgs/Clock", self._take_clock)
        self._bridge.subscribe("/robot/state", "baxter_core_msgs/AssemblyState", self._take_state)
        # Its type depends on the version of ROS.
        self._bridge.subscribe("/rosout", None, self._take_words)
        for arm in arms:
            self._bridge.subscribe(f"/robot/end_effector/{arm}_gripper/state", "baxter_core_msgs/EndEffectorState",
                                   partial(self._take_gripper, arm))
        self._bridge.subscribe("/robot/joint_states", "sensor_msgs/JointState", self._take_joints)

    def _await_robot(self) -> None:
        deadline = time.monotonic() + _CONNECTION_SECONDS
        with self._news:
            self._news.wait_for(lambda: self._bridge.fault is not None or not self._missing(),
                                deadline - time.monotonic())
        if self._bridge.fault is not None:
            raise RuntimeError(self._bridge.fault)
        if self._missing():
            raise RuntimeError(f"no robot behind {self._bridge.address}: {', '.join(self._missing())} not served within "
                               f"{_CONNECTION_SECONDS:g} s")

    def _missing(self) -> list[str]:
        missing = [topic for topic, news in (("/robot/joint_states", self._reading), ("/robot/state", self._state))
                   if news is None]
        # Simulated time: its topic may be connected later than others.
        if self._reading is not None and self._clock is None and not abs(self._reading.age) < _SAME_CLOCK:
            missing.append(f"/clock (the time of the joint states is {self._reading.time:.0f} s, not that of this machine)")
        return missing

    def _age_of(self, stamp: float) -> float:
        return (time.time() if self._clock is None else self._clock) - stamp

    # Messages, in the thread of the bridge.

    def _notify(self) -> None:
        with self._news:
            self._news.notify_all()

    def _take_clock(self, message: dict[str, Any]) -> None:
        self._clock = seconds_of(message["clock"])
        self._notify()

    def _take_joints(self, message: dict[str, Any]) -> None:
        names = [str(name) for name in _list_of(message["name"], "name")]
        positions = [number_of(value) for value in _list_of(message["position"], "position")]
        # Other parts of a robot report their joints in messages of their own.
        is_about_them = bool(self._names & set(names))
        self._are_known |= is_about_them
        if self._are_known and not is_about_them:
            return
        stamp = seconds_of(message["header"]["stamp"])
        with self._news:
            self._reading = Reading(stamp, self._age_of(stamp), dict(zip(names, positions)))
            self._news.notify_all()

    def _take_state(self, message: dict[str, Any]) -> None:
        state = {name: _flag_of(message, name) for name in ("enabled", "stopped", "error")}
        with self._news:
            self._state = state
            self._news.notify_all()

    def _take_gripper(self, arm: str, message: dict[str, Any]) -> None:
        is_ours = message["command_sender"] == self._name
        sequence = int(number_of(message["command_sequence"])) if is_ours else 0
        self._grippers[arm] = int(number_of(message["id"])), GripperReading(
            sequence, number_of(message["position"]), number_of(message["moving"]) == 1, number_of(message["gripping"]) == 1)

    def _take_words(self, message: dict[str, Any]) -> None:
        if number_of(message["level"]) >= _WARN[1 if "header" in message else 2]:
            self._words.append(str(message["msg"])[:300])

    # The interface.

    def wait(self, timeout: float) -> Reading | None:
        with self._news:
            self._news.wait_for(lambda: self._reading is not None or self._bridge.fault is not None, timeout)
            reading, self._reading = self._reading, None
        return None if reading is None else reading._replace(age=self._age_of(reading.time))

    def command(self, arm: str, names: Sequence[str], positions: Sequence[float]) -> None:
        self._bridge.publish(f"/robot/limb/{arm}/joint_command", {
            "mode": _POSITION_MODE, "names": list(names), "command": [float(one) for one in positions]})

    def follow(self, paths: Mapping[str, JointPath], tolerance: float) -> None:
        # An action of ROS 1 consists of topics.
        new = [arm for arm in paths if arm not in self._serving]
        for arm in new:
            self._offer_action(arm)
        with self._news:
            self._news.wait_for(lambda: self._serving.issuperset(paths) or self._bridge.fault is not None, _ACTION_SECONDS)
        if missing := [action_of(arm) for arm in paths if arm not in self._serving]:
            raise RuntimeError(self._bridge.fault or f"no action {missing[0]} behind {self._bridge.address} within {_ACTION_SECONDS:g} s")
        if new:
            # A goal that is sent before the robot listens to its topic is lost; the bridge does not say when that is.
            time.sleep(_ADVERTISE_SECONDS)
        stamp = {"secs": 0, "nsecs": 0}
        for arm, path in paths.items():
            name = f"{self._name}-{arm}-{time.monotonic_ns()}"
            self._trajectories[name] = 0, ""
            self._goals[arm] = name
            self._bridge.publish(f"{action_of(arm)}/goal", {
                "header": {"stamp": stamp, "frame_id": ""}, "goal_id": {"stamp": stamp, "id": name}, "goal": goal_of(path, tolerance)})

    def _offer_action(self, arm: str) -> None:
        action = action_of(arm)
        self._bridge.advertise(f"{action}/goal", f"{KIND}ActionGoal")
        self._bridge.advertise(f"{action}/cancel", "actionlib_msgs/GoalID")
        self._bridge.subscribe(f"{action}/result", f"{KIND}ActionResult", lambda message: self._take_status(message["status"]))
        self._bridge.subscribe(f"{action}/status", "actionlib_msgs/GoalStatusArray", partial(self._take_statuses, arm))

    def _take_statuses(self, arm: str, message: dict[str, Any]) -> None:
        with self._news:
            self._serving.add(arm)
            self._news.notify_all()
        for status in _list_of(message["status_list"], "status_list"):
            self._take_status(status)

    def _take_status(self, status: dict[str, Any]) -> None:
        name = status["goal_id"]["id"]
        # Of other programs; or one that is older than the result.
        if name not in self._trajectories or reading_of(*self._trajectories[name]).is_done:
            return
        self._trajectories[name] = int(number_of(status["status"])), str(status["text"])[:300]

    def trajectory(self, arm: str) -> TrajectoryReading:
        return reading_of(*self._trajectories[self._goals[arm]])

    def cancel(self) -> None:
        for arm, name in self._goals.items():
            if not self.trajectory(arm).is_done:
                self._bridge.publish(f"{action_of(arm)}/cancel", {"stamp": {"secs": 0, "nsecs": 0}, "id": name})

    def grip(self, arm: str, percent: float) -> int:
        self._sequences[arm] += 1
        number = self._grippers[arm][0] if arm in self._grippers else 0
        self._bridge.publish(f"/robot/end_effector/{arm}_gripper/command", {
            "id": number, "command": "go", "args": json.dumps({"position": percent}), "sender": self._name,
            "sequence": self._sequences[arm]})
        return self._sequences[arm]

    def gripper(self, arm: str) -> GripperReading | None:
        return self._grippers[arm][1] if arm in self._grippers else None

    def enable(self) -> None:
        self._bridge.publish("/robot/set_super_enable", {"data": True})

    def motors_fault(self) -> str | None:
        assert self._state is not None  # _await_robot
        if self._state["stopped"]:
            return "the robot is stopped (emergency stop)"
        if self._state["error"]:
            return "the robot reports an error"
        return None if self._state["enabled"] else "the motors are off"

    def connection_fault(self) -> str | None:
        return self._bridge.fault

    def words(self) -> list[str]:
        return [*self._words, *self._bridge.statuses]

    def picture(self, topic: str, timeout: float) -> CameraReading:
        received: dict[str, dict[str, Any]] = {}

        def take(name: str, message: dict[str, Any]) -> None:
            received.setdefault(name, message)
            self._notify()

        info_topic = info_topic_of(topic)
        self._bridge.subscribe(topic, "sensor_msgs/Image", partial(take, "image"))
        self._bridge.subscribe(info_topic, "sensor_msgs/CameraInfo", partial(take, "info"))
        with self._news:
            self._news.wait_for(lambda: len(received) == 2 or self._bridge.fault is not None, timeout)
        for one in (topic, info_topic):
            self._bridge.unsubscribe(one)
        if len(received) < 2:
            raise RuntimeError(self._bridge.fault or f"{topic} and {info_topic} did not both arrive within {timeout:g} s")
        return _camera_reading_of(topic, received)

    def watch(self, topic: str, depth_topic: str | None) -> None:
        self._watched_topic, self._has_depth = topic, depth_topic is not None
        topics = {"image": (topic, "sensor_msgs/Image"), "info": (info_topic_of(topic), "sensor_msgs/CameraInfo")}
        if depth_topic is not None:
            topics["depth"] = (depth_topic, "sensor_msgs/Image")
        for name, (one, kind) in topics.items():
            self._bridge.subscribe(one, kind, partial(self._watched.__setitem__, name))

    def seen(self) -> CameraReading | None:
        newest = dict(self._watched)
        if len(newest) < (3 if self._has_depth else 2):
            return None
        return _camera_reading_of(self._watched_topic, newest)


def _image_fields(image: dict[str, Any]) -> tuple[str, int, int, int]:
    width, height, step = (int(number_of(image[name])) for name in ("width", "height", "step"))
    return str(image["encoding"]), width, height, step


def _camera_reading_of(topic: str, messages: dict[str, dict[str, Any]]) -> CameraReading:
    image, info, depth = messages["image"], messages["info"], messages.get("depth")
    try:
        rgb = rgb_of(*_image_fields(image), base64.b64decode(image["data"], validate=True))
        stamps = [seconds_of(message["header"]["stamp"]) for message in (image, depth) if message is not None]
        depths = None if depth is None else depth_of(*_image_fields(depth), bool(number_of(depth["is_bigendian"])),
                                                     base64.b64decode(depth["data"], validate=True))
        # ROS 2 has small letters.
        K, D = (_list_of(info[name if name in info else name.lower()], name) for name in ("K", "D"))
        return CameraReading(rgb, *intrinsics_of(str(info["distortion_model"]), [number_of(one) for one in K],
                                                 [number_of(one) for one in D]), min(stamps), depths)
    except (KeyError, TypeError, ValueError, OverflowError) as error:
        raise ValueError(f"{topic}: the picture or its camera_info is faulty: {error}") from None
