"""The served robot on a ROS graph: topics, frames, pictures and actions under the names of Baxter."""

from __future__ import annotations

import threading
import time
from collections import deque
from collections.abc import Callable
from typing import Any

import actionlib
import actionlib.action_server
import genpy
import numpy as np
import rospy
from geometry_msgs.msg import Point, Quaternion, Transform, TransformStamped, Vector3
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import CameraInfo, Image, JointState
from std_msgs.msg import Bool, Empty, Float64, Header
from tf2_msgs.msg import TFMessage

from smile.ros import message_types as types
from smile.ros.description import quaternion_of
from smile.ros.joint_path import JointPath
from smile.ros.served_robot import ServedRobot
from smile.simulation import TICKS_PER_SECOND, Floats

PATH_TOLERANCE = 0.2
"""largest error of a joint on a trajectory whose goal states none [rad]"""
GOAL_TOLERANCE = 0.01
"""largest error of a joint at the end [rad]"""
COMMAND_AGE = 0.5
"""largest difference between the start of a trajectory and its arrival [s]"""
_GOAL_TIME = 1.0
"""time after the end of a trajectory in which its joints must arrive [s]"""
_LOCKSTEP_PATIENCE = 5.0
"""wall-clock time that a tick waits for the next command of a node that is still there [s]"""
_CHECK_SECONDS = 0.05
"""wall-clock time after which it is seen that the node left [s]"""
_STATE_TICKS = 6
"""ticks between messages of states that change rarely"""


def stamp_of(tick: int) -> genpy.Time:
    """Returns the time of a tick."""
    return genpy.Time(tick // TICKS_PER_SECOND, tick % TICKS_PER_SECOND * 1_000_000_000 // TICKS_PER_SECOND)


def transform_of(X: Floats) -> Transform:
    """Returns a (4, 4) pose as a message."""
    w, x, y, z = quaternion_of(X[:3, :3])
    return Transform(Vector3(*X[:3, 3]), Quaternion(x, y, z, w))


class ServedGraph:
    """Publishes the robot's state after each tick, and passes commands to the robot.

    picture_rate  pictures per second of simulated time, of cameras to which a node listens
    lockstep      while a limb is commanded, each tick waits for its next command
    """

    def __init__(self, robot: ServedRobot, *, picture_rate: float, picture_size: tuple[int, int],
                 lockstep: bool) -> None:
        self._robot, self._lockstep = robot, lockstep
        self._picture_ticks, self._picture_size = round(TICKS_PER_SECOND / picture_rate), picture_size
        # One lock for the robot: ROS calls from threads of its own.
        self._lock = threading.Condition()
        self._commanded: set[str] = set()
        """arms that have a command for the next tick"""
        self._commands: dict[str, rospy.Subscriber] = {}
        rospy.set_param("/use_sim_time", True)
        rospy.set_param("/robot_description", robot.description.urdf.read_text())
        self._clock = rospy.Publisher("/clock", Clock, queue_size=10)
        self._joint_states = rospy.Publisher("/robot/joint_states", JointState, queue_size=10)
        self._frames = rospy.Publisher("/tf", TFMessage, queue_size=10)
        self._state = rospy.Publisher("/robot/state", types.AssemblyState, queue_size=10)
        self._subscribe("/robot/set_super_enable", Bool, lambda message, sender: robot.enable(message.data))
        self._subscribe("/robot/set_super_stop", Empty, lambda message, sender: robot.emergency_stop())
        self._subscribe("/robot/set_super_reset", Empty, lambda message, sender: robot.reset())
        self._endpoints = {arm: self._offer_limb(arm) for arm in robot.limbs}
        self._grippers = {arm: self._offer_gripper(arm) for arm in robot.grippers}
        self._cameras = {name: (rospy.Publisher(f"/cameras/{name}_camera/image", Image, queue_size=2),
                                rospy.Publisher(f"/cameras/{name}_camera/camera_info", CameraInfo, queue_size=2),
                                rospy.Publisher(f"/cameras/{name}_camera/depth", Image, queue_size=2))
                         for name in robot.sim.model.camera_names}
        self._actions = {arm: TrajectoryAction(arm, robot) for arm in robot.limbs}

    def _subscribe(self, topic: str, kind: Any, handle: Callable[[Any, str], str | None]) -> rospy.Subscriber:
        def receive(message: Any) -> None:
            sender = message._connection_header.get("callerid", "an unknown node")
            with self._lock:
                refusal = handle(message, sender)
            if refusal is not None:
                rospy.logwarn_throttle_identical(1, f"{topic} from {sender} refused: {refusal}")

        return rospy.Subscriber(topic, kind, receive, queue_size=10, tcp_nodelay=True)

    def _offer_limb(self, arm: str) -> rospy.Publisher:
        def command(message: Any, sender: str) -> str | None:
            refusal = self._robot.command_joints(arm, message.mode, message.names, message.command, sender)
            if refusal is None:
                self._commanded.add(arm)
                self._lock.notify_all()
            return refusal

        self._commands[arm] = self._subscribe(f"/robot/limb/{arm}/joint_command", types.JointCommand, command)
        self._subscribe(f"/robot/limb/{arm}/set_speed_ratio", Float64,
                        lambda message, sender: self._robot.set_speed_ratio(arm, message.data))
        return rospy.Publisher(f"/robot/limb/{arm}/endpoint_state", types.EndpointState, queue_size=10)

    def _offer_gripper(self, arm: str) -> rospy.Publisher:
        topic = f"/robot/end_effector/{arm}_gripper"
        self._subscribe(f"{topic}/command", types.EndEffectorCommand, lambda message, sender: self._robot.command_gripper(
            arm, message.command, message.args, message.sender, message.sequence))
        # The last message is kept for nodes that come later.
        properties = rospy.Publisher(f"{topic}/properties", types.EndEffectorProperties, queue_size=1, latch=True)
        properties.publish(types.EndEffectorProperties(
            ui_type=types.EndEffectorProperties.ELECTRIC_GRIPPER, manufacturer="SMILE",
            product=f"simulated gripper {self._robot.description.gripper}", controls_grip=True, senses_grip=True,
            controls_position=True, senses_position=True, properties="{}"))
        return rospy.Publisher(f"{topic}/state", types.EndEffectorState, queue_size=10)

    # The loop.

    def run(self, rate: float, is_over: Callable[[], bool]) -> None:
        """Steps until `is_over`, at most `rate` times as fast as real time."""
        due = time.monotonic()
        while not is_over():
            self._await_commands(is_over)
            with self._lock:
                for action in self._actions.values():
                    action.check()
                self._robot.step()
                self._publish()
            due = max(due + 1 / (rate * TICKS_PER_SECOND), time.monotonic() - 0.1)
            if not self._is_paced_by_commands():
                time.sleep(max(0.0, due - time.monotonic()))

    def _is_paced_by_commands(self) -> bool:
        return self._lockstep and any(limb.owner is not None and limb.path is None
                                      for limb in self._robot.limbs.values())

    def _is_awaited(self, arm: str) -> bool:
        limb = self._robot.limbs[arm]
        return (limb.owner is not None and limb.path is None and arm not in self._commanded
                and self._commands[arm].get_num_connections() > 0)

    def _await_commands(self, is_over: Callable[[], bool]) -> None:
        """In lockstep, waits for a command to each limb that is being commanded."""
        if not self._lockstep:
            return
        deadline = time.monotonic() + _LOCKSTEP_PATIENCE
        with self._lock:
            while any(map(self._is_awaited, self._robot.limbs)) and time.monotonic() < deadline and not is_over():
                self._lock.wait(_CHECK_SECONDS)
            self._commanded.clear()

    # Messages of a tick.

    def _publish(self) -> None:
        tick = self._robot.sim.tick
        stamp = stamp_of(tick)
        header = Header(stamp=stamp, frame_id="base")
        self._clock.publish(Clock(stamp))
        for arm, publisher in self._endpoints.items():
            self._publish_endpoint(arm, publisher, header)
        for arm, publisher in self._grippers.items():
            self._publish_gripper(arm, publisher, stamp)
        # Last: by these, a controller knows that a tick is over.
        names, positions, velocities = self._joints()
        self._joint_states.publish(JointState(header, names, positions, velocities, [0.0] * len(names)))
        if tick % _STATE_TICKS == 0:
            self._publish_state()
            self._publish_frames(stamp, dict(zip(names, positions)))
        if tick % self._picture_ticks == 0:
            self._publish_pictures(stamp)

    def _joints(self) -> tuple[list[str], list[float], list[float]]:
        names, positions, velocities = [], [], []
        for arm, joints in self._robot.description.arms.items():
            names += joints
            positions += self._robot.robot.arms[arm].q.tolist()
            velocities += self._robot.robot.arms[arm].velocities.tolist()
        return names, positions, velocities

    def _publish_endpoint(self, arm: str, publisher: rospy.Publisher, header: Header) -> None:
        if publisher.get_num_connections() == 0:
            return
        motion, hand = self._robot.description.motion, self._robot.robot.arms[arm]
        state = types.EndpointState(header=header)
        pose = transform_of(motion.forward(arm, hand.q))
        state.pose.position = Point(pose.translation.x, pose.translation.y, pose.translation.z)
        state.pose.orientation = pose.rotation
        twist = motion.jacobian(arm, hand.q) @ hand.velocities
        state.twist.linear, state.twist.angular = Vector3(*twist[:3]), Vector3(*twist[3:])
        publisher.publish(state)

    def _publish_gripper(self, arm: str, publisher: rospy.Publisher, stamp: genpy.Time) -> None:
        gripper, hand = self._robot.grippers[arm], self._robot.robot.arms[arm]
        holds = bool(hand.held)
        position = self._robot.description.openings[arm].percent(hand.gripper)
        publisher.publish(types.EndEffectorState(
            timestamp=stamp, enabled=self._robot.is_enabled, calibrated=1, ready=1, moving=gripper.is_moving,
            gripping=holds, missed=not holds and not gripper.is_moving and position < 1 and gripper.goal is not None,
            position=position, force=100.0 if holds else 0.0, state="{}", command=gripper.command,
            command_sender=gripper.sender, command_sequence=gripper.sequence))

    def _publish_state(self) -> None:
        is_stopped = self._robot.is_stopped
        self._state.publish(types.AssemblyState(
            ready=self._robot.is_enabled, enabled=self._robot.is_enabled, stopped=is_stopped, error=False,
            estop_button=0, estop_source=types.AssemblyState.ESTOP_SOURCE_USER if is_stopped else 0))

    def _publish_frames(self, stamp: genpy.Time, positions: dict[str, float]) -> None:
        frames = [TransformStamped(Header(stamp=stamp, frame_id="world"), "base",
                                   transform_of(self._robot.description.X_WB))]
        for name, joint in self._robot.description.joints.items():
            # The head and the fingers have no place in joint_states: their frames show them at 0.
            pose = joint.pose_at(positions.get(name, 0.0))
            frames.append(TransformStamped(Header(stamp=stamp, frame_id=joint.parent), joint.child, transform_of(pose)))
        self._frames.publish(TFMessage(frames))

    def _publish_pictures(self, stamp: genpy.Time) -> None:
        for name, (images, infos, depths) in self._cameras.items():
            if not any(one.get_num_connections() for one in (images, infos, depths)):
                continue
            has_depth = depths.get_num_connections() > 0
            picture = self._robot.sim.render(name, self._picture_size, channels=("rgb", "depth") if has_depth else ("rgb",))
            assert picture.rgb is not None
            height, width, _ = picture.rgb.shape
            header = Header(stamp=stamp, frame_id=f"{name}_camera")
            if picture.depth is not None:
                depths.publish(Image(header, height, width, "32FC1", 0, 4 * width, picture.depth.astype("<f4").tobytes()))
            images.publish(Image(header, height, width, "rgb8", 0, 3 * width, picture.rgb.tobytes()))
            # ROS counts pixels from the center of the first one, as OpenCV does; SMILE from its corner.
            K = picture.intrinsics - [[0, 0, 0.5], [0, 0, 0.5], [0, 0, 0]]
            infos.publish(CameraInfo(
                header=header, height=height, width=width, distortion_model="plumb_bob", D=[0.0] * 5,
                K=K.ravel().tolist(), R=np.eye(3).ravel().tolist(),
                P=np.column_stack([K, np.zeros(3)]).ravel().tolist()))


class TrajectoryAction:
    """Action server of an arm: control_msgs/FollowJointTrajectory."""

    def __init__(self, arm: str, robot: ServedRobot) -> None:
        self._arm, self._robot = arm, robot
        # From threads of actionlib, which hold its lock: check() answers them.
        self._requests: deque[Any] = deque()
        self._cancellations: deque[Any] = deque()
        self._handle: Any = None
        self._goal: Any = None
        self._server = actionlib.action_server.ActionServer(
            f"/robot/limb/{arm}/follow_joint_trajectory", types.FollowJointTrajectoryAction,
            self._requests.append, self._cancellations.append,
            auto_start=False)
        self._server.start()

    def _accept(self) -> None:
        handle = self._requests.popleft()
        goal = handle.get_goal()
        refusal = self._start(goal, handle.get_goal_id().id)
        if refusal is None:
            handle.set_accepted()
            self._handle, self._goal = handle, goal
            return
        rospy.logwarn(f"trajectory of limb {self._arm} refused: {refusal[1]}")
        handle.set_rejected(types.FollowJointTrajectoryResult(*refusal), refusal[1])

    def _cancel(self) -> None:
        handle = self._cancellations.popleft()
        # actionlib makes a new handle of the goal.
        if self._handle is not None and self._handle == handle:
            self._robot.stop(self._arm)
            self._handle = None
            handle.set_canceled()

    def _start(self, goal: Any, sender: str) -> tuple[int, str] | None:
        result = types.FollowJointTrajectoryResult
        if self._handle is not None:
            return result.INVALID_GOAL, f"limb {self._arm} follows another trajectory, expected its end or cancellation first"
        start = goal.trajectory.header.stamp.to_sec()
        if start != 0 and abs(start - self._robot.time) > COMMAND_AGE:
            return (result.OLD_HEADER_TIMESTAMP, f"the trajectory starts at {start:.3f} s, and now is {self._robot.time:.3f} s; "
                                                 f"expected 0 or within {COMMAND_AGE:g} s of now")
        limb = self._robot.limbs[self._arm]
        unknown = [name for name in goal.trajectory.joint_names if name not in limb.joints]
        if unknown or len(set(goal.trajectory.joint_names)) != len(limb.joints):
            return result.INVALID_JOINTS, (f"the joints are {', '.join(goal.trajectory.joint_names)[:200] or 'none'}, "
                                           f"expected {', '.join(limb.joints)}")
        try:
            path = self._path_of(goal.trajectory)
        except ValueError as error:
            return result.INVALID_GOAL, str(error)
        refusal = self._robot.follow(self._arm, path, sender)
        return None if refusal is None else (result.INVALID_GOAL, refusal)

    def _path_of(self, trajectory: Any) -> JointPath:
        points = trajectory.points
        if any(len(point.positions) != len(trajectory.joint_names) for point in points):
            raise ValueError(f"a point has not {len(trajectory.joint_names)} positions")
        times = [point.time_from_start.to_sec() for point in points]
        positions = [list(point.positions) for point in points]
        has_velocities = bool(points) and all(point.velocities for point in points)
        velocities = [list(point.velocities) for point in points] if has_velocities else None
        if times and times[0] > 0:
            # From where the arm is to the first point.
            joints = self._robot.limbs[self._arm].joints
            now = self._robot.robot.arms[self._arm].q
            times.insert(0, 0.0)
            positions.insert(0, [now[joints.index(name)] for name in trajectory.joint_names])
            if velocities is not None:
                velocities.insert(0, [0.0] * len(joints))
        return JointPath(trajectory.joint_names, times, np.array(positions, float), velocities)

    def check(self) -> None:
        """Answers requests, and reports progress and end of the trajectory; called before each tick."""
        while self._cancellations:
            self._cancel()
        while self._requests:
            self._accept()
        if self._handle is not None:
            self._follow()

    def _follow(self) -> None:
        result = types.FollowJointTrajectoryResult
        limb = self._robot.limbs[self._arm]
        if limb.path is None:
            self._end("set_aborted", result.INVALID_GOAL, "the robot was stopped")
            return
        desired, speeds = self._robot.reference(self._arm)
        actual = self._robot.robot.arms[self._arm].q
        errors = np.abs(desired - actual)
        late = self._robot.time - limb.begin - limb.path.duration
        if self._robot.sim.tick % _STATE_TICKS == 0:
            self._report(desired, speeds, actual)
        for joint, error in zip(limb.joints, errors):
            tolerance = self._tolerance(self._goal.path_tolerance, joint, PATH_TOLERANCE)
            if late < 0 and error > tolerance:
                self._end("set_aborted", result.PATH_TOLERANCE_VIOLATED, f"{joint} is off by {error:.4f} rad, expected less than {tolerance:g}")
                return
        wrong = [f"{joint} is off by {error:.4f} rad" for joint, error in zip(limb.joints, errors)
                 if error > self._tolerance(self._goal.goal_tolerance, joint, GOAL_TOLERANCE)]
        if late >= 0 and not wrong:
            self._end("set_succeeded", result.SUCCESSFUL, "")
        elif late > (self._goal.goal_time_tolerance.to_sec() or _GOAL_TIME):
            self._end("set_aborted", result.GOAL_TOLERANCE_VIOLATED, wrong[0])

    @staticmethod
    def _tolerance(tolerances: Any, joint: str, usual: float) -> float:
        """control_msgs/JointTolerance: 0 means the usual one, and a negative one none."""
        for tolerance in tolerances:
            if tolerance.name == joint and tolerance.position != 0:
                return tolerance.position if tolerance.position > 0 else np.inf
        return usual

    def _report(self, desired: Floats, speeds: Floats, actual: Floats) -> None:
        feedback = types.FollowJointTrajectoryFeedback(joint_names=self._robot.limbs[self._arm].joints)
        feedback.header.stamp = stamp_of(self._robot.sim.tick)
        feedback.desired.positions, feedback.desired.velocities = desired.tolist(), speeds.tolist()
        feedback.actual.positions = actual.tolist()
        feedback.error.positions = (desired - actual).tolist()
        self._handle.publish_feedback(feedback)

    def _end(self, how: str, code: int, words: str) -> None:
        self._robot.stop(self._arm)
        getattr(self._handle, how)(types.FollowJointTrajectoryResult(code, words), words)
        self._handle = None

