"""A robot at a ROS 1 master, under the names of Baxter."""

from __future__ import annotations

import json
import os
import threading
import time
from collections import deque
from collections.abc import Iterable, Mapping, Sequence
from functools import partial
from typing import Any

import actionlib
import rospy
from rosgraph_msgs.msg import Log
from sensor_msgs.msg import CameraInfo, Image, JointState
from std_msgs.msg import Bool, Float64

from smile.ros import message_types as types
from smile.ros.camera import depth_of, info_topic_of, intrinsics_of, rgb_of
from smile.ros.graph import join_graph, master_is_lost
from smile.ros.joint_path import JointPath
from smile.ros.link import CameraReading, GripperReading, Reading, SeeingLink, TrajectoryReading
from smile.ros.trajectory_goal import action_of, goal_of, reading_of

_CONNECTION_SECONDS = 10.0
_MOST_WORDS = 5
_PICTURE_BYTES = 1 << 25
_ACTION_SECONDS = 5.0


class RosLink(SeeingLink):
    """Streams positions at full ratio of speed: the path itself is slow.

    Raises RuntimeError if the robot is not at the master within some seconds.
    """

    def __init__(self, arms: Sequence[str], names: Sequence[str]) -> None:
        join_graph("smile_perform", anonymous=True)
        self._names = frozenset(names)
        self._news = threading.Condition()
        self._message: Any = None
        self._are_known = False
        """true after the first message about the joints"""
        self._state: Any = None
        self._grippers: dict[str, Any] = {}
        self._sequences = dict.fromkeys(arms, 0)
        self._words: deque[str] = deque(maxlen=_MOST_WORDS)
        self._actions: dict[str, Any] = {}
        """by arm: clients of the actions that were used"""
        self._sent: set[str] = set()
        """arms to which a trajectory was sent"""
        self._watched: dict[str, Any] = {}
        """the newest messages of the camera that is watched"""
        self._has_depth = False
        self._is_lost = master_is_lost()
        self._commands = {arm: self._publisher(f"/robot/limb/{arm}/joint_command", types.JointCommand) for arm in arms}
        self._ratios = {arm: self._publisher(f"/robot/limb/{arm}/set_speed_ratio", Float64) for arm in arms}
        self._grips = {arm: self._publisher(f"/robot/end_effector/{arm}_gripper/command", types.EndEffectorCommand)
                       for arm in arms}
        self._enable = self._publisher("/robot/set_super_enable", Bool)
        rospy.Subscriber("/robot/joint_states", JointState, self._take_joints, queue_size=1, tcp_nodelay=True)
        rospy.Subscriber("/robot/state", types.AssemblyState, self._take_state, queue_size=1)
        rospy.Subscriber("/rosout", Log, self._take_words, queue_size=20)
        for arm in arms:
            rospy.Subscriber(f"/robot/end_effector/{arm}_gripper/state", types.EndEffectorState,
                             lambda message, arm=arm: self._grippers.__setitem__(arm, message), queue_size=1)
        self._await_robot()
        for ratio in self._ratios.values():
            ratio.publish(1.0)

    @staticmethod
    def _publisher(topic: str, kind: Any) -> rospy.Publisher:
        return rospy.Publisher(topic, kind, queue_size=2, tcp_nodelay=True)

    def _await_robot(self) -> None:
        deadline = time.monotonic() + _CONNECTION_SECONDS
        while time.monotonic() < deadline:
            # The ratios as well: a message that is sent before the robot listens is lost, and the arms remain slow.
            deaf = _unheard([*self._commands.values(), *self._ratios.values()])
            if self._message is not None and self._state is not None and not deaf:
                return
            time.sleep(0.02)
        missing = (["/robot/joint_states"] if self._message is None else []) + (
            ["/robot/state"] if self._state is None else []) + deaf
        raise RuntimeError(f"no robot at {os.environ['ROS_MASTER_URI']}: {', '.join(missing)} not served within "
                           f"{_CONNECTION_SECONDS:g} s")

    def _take_joints(self, message: Any) -> None:
        with self._news:
            # Other parts of a robot report their joints in messages of their own.
            self._are_known |= bool(self._names & set(message.name))
            if not self._are_known or self._names & set(message.name):
                self._message = message
                self._news.notify()

    def _take_state(self, message: Any) -> None:
        self._state = message

    def _take_words(self, message: Any) -> None:
        if message.level >= Log.WARN and message.name != rospy.get_name():
            self._words.append(message.msg[:300])

    def wait(self, timeout: float) -> Reading | None:
        with self._news:
            if not self._news.wait_for(lambda: self._message is not None, timeout):
                return None
            message, self._message = self._message, None
        age = rospy.get_rostime() - message.header.stamp
        return Reading(message.header.stamp.to_sec(), age.to_sec(), dict(zip(message.name, message.position)))

    def command(self, arm: str, names: Sequence[str], positions: Sequence[float]) -> None:
        self._commands[arm].publish(types.JointCommand(
            mode=types.JointCommand.POSITION_MODE, names=list(names), command=[float(one) for one in positions]))

    def follow(self, paths: Mapping[str, JointPath], tolerance: float) -> None:
        for arm in paths:
            self._actions[arm] = self._actions.get(arm) or actionlib.SimpleActionClient(action_of(arm), types.FollowJointTrajectoryAction)
            if not _is_served(self._actions[arm]):
                raise RuntimeError(f"no action {action_of(arm)} at {os.environ['ROS_MASTER_URI']} within {_ACTION_SECONDS:g} s")
        for arm, path in paths.items():
            self._actions[arm].send_goal(types.fill(types.FollowJointTrajectoryGoal(), goal_of(path, tolerance)))
            self._sent.add(arm)

    def trajectory(self, arm: str) -> TrajectoryReading:
        client = self._actions[arm]
        return reading_of(client.get_state(), client.get_goal_status_text())

    def cancel(self) -> None:
        for arm in self._sent:
            if not self.trajectory(arm).is_done:
                self._actions[arm].cancel_goal()

    def grip(self, arm: str, percent: float) -> int:
        self._sequences[arm] += 1
        self._grips[arm].publish(types.EndEffectorCommand(
            id=getattr(self._grippers.get(arm), "id", 0), command=types.EndEffectorCommand.CMD_GO,
            args=json.dumps({"position": percent}), sender=rospy.get_name(), sequence=self._sequences[arm]))
        return self._sequences[arm]

    def gripper(self, arm: str) -> GripperReading | None:
        state = self._grippers.get(arm)
        if state is None:
            return None
        sequence = state.command_sequence if state.command_sender == rospy.get_name() else 0
        return GripperReading(sequence, state.position, state.moving == 1, state.gripping == 1)

    def enable(self) -> None:
        self._enable.publish(True)

    def motors_fault(self) -> str | None:
        if self._state.stopped:
            return "the robot is stopped (emergency stop)"
        if self._state.error:
            return "the robot reports an error"
        return None if self._state.enabled else "the motors are off"

    def connection_fault(self) -> str | None:
        if self._is_lost():
            return f"the ROS master at {os.environ['ROS_MASTER_URI']} no longer answers"
        deaf = _unheard(self._commands.values())
        return f"the robot no longer listens to {deaf[0]}" if deaf else None

    def words(self) -> list[str]:
        return list(self._words)

    def picture(self, topic: str, timeout: float) -> CameraReading:
        received: dict[str, Any] = {}
        is_complete = threading.Event()

        def take(name: str, message: Any) -> None:
            received.setdefault(name, message)
            if len(received) == 2:
                is_complete.set()

        listening = [rospy.Subscriber(topic, Image, partial(take, "image"), queue_size=1),
                     rospy.Subscriber(info_topic_of(topic), CameraInfo, partial(take, "info"), queue_size=1)]
        try:
            if not is_complete.wait(timeout):
                raise RuntimeError(f"{topic} and {info_topic_of(topic)} did not both arrive within {timeout:g} s")
        finally:
            for subscriber in listening:
                subscriber.unregister()
        return _camera_reading_of(received["image"], received["info"])

    def watch(self, topic: str, depth_topic: str | None) -> None:
        self._has_depth = depth_topic is not None
        topics = {"image": (topic, Image), "info": (info_topic_of(topic), CameraInfo)}
        if depth_topic is not None:
            topics["depth"] = (depth_topic, Image)
        for name, (one, kind) in topics.items():
            # A picture is larger than the buffer that rospy has by itself: older ones would wait in it.
            rospy.Subscriber(one, kind, partial(self._watched.__setitem__, name), queue_size=1, buff_size=_PICTURE_BYTES)

    def seen(self) -> CameraReading | None:
        newest = dict(self._watched)
        if len(newest) < (3 if self._has_depth else 2):
            return None
        return _camera_reading_of(newest["image"], newest["info"], newest.get("depth"))


def _unheard(publishers: Iterable[rospy.Publisher]) -> list[str]:
    """Returns the topics to which nobody listens."""
    return [one.resolved_name for one in publishers if one.get_num_connections() == 0]


def _is_served(client: Any) -> bool:
    """Waits by the wall clock: that of the robot may stand."""
    deadline = time.monotonic() + _ACTION_SECONDS
    while not client.action_client.wait_for_server(rospy.Duration(0.01)):
        if time.monotonic() > deadline:
            return False
        time.sleep(0.05)
    return True


def _camera_reading_of(image: Any, info: Any, depth: Any = None) -> CameraReading:
    rgb = rgb_of(image.encoding, image.width, image.height, image.step, image.data)
    stamps = [message.header.stamp.to_sec() for message in (image, depth) if message is not None]
    depths = None if depth is None else depth_of(depth.encoding, depth.width, depth.height, depth.step,
                                                 bool(depth.is_bigendian), depth.data)
    return CameraReading(rgb, *intrinsics_of(info.distortion_model, info.K, info.D), min(stamps), depths)
