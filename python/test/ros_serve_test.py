"""Tests `smile ros serve`: the simulated robot on a ROS graph, as its clients see it.

Usage: ros_serve_test.py PROJECT_FOLDER, with the program in SMILE. Skipped without ROS.
"""

import math
import os
import sys
import tempfile
import time
import unittest
from pathlib import Path

# First: it finds ROS, or ends the test.
from ros_graph import PATIENCE, Graph, Program, wait_until

import actionlib
import numpy as np
import rospy
import trajectory_msgs.msg as trajectory
from rosgraph_msgs.msg import Clock, Log
from sensor_msgs.msg import CameraInfo, Image, JointState
from std_msgs.msg import Bool, Empty, Float64
from tf2_msgs.msg import TFMessage

import smile
from smile.ros import message_types as types
from smile.ros.description import RobotDescription, matrix_of, quaternion_of
from smile.ros.joint_path import JointPath
from smile.ros.description import describe
from smile.ros.served_robot import COMMAND_TIMEOUT, ServedRobot

PROJECT, PROGRAM = Path(sys.argv[1]), os.environ["SMILE"]
SCENE = PROJECT / "scenes/tower.xml"
GOLDEN = PROJECT / "tests/golden/recordings/imitation"
# By which nodes recognize messages: computed by programs of Rethink Robotics and ros-controls, and printed in
# generated code that is public (GitHub: "19bfec84..." and so on).
CHECKSUMS = {
    types.JointCommand: "19bfec8434dd568ab3c633d187c36f2e",
    types.AssemblyState: "356d9dd237ce73b2667da9235f541933",
    types.EndpointState: "44bea01d596ff699fa1447bec34167ac",
    types.EndEffectorCommand: "c003234e90416f2ca02ac7837c42cbb7",
    types.EndEffectorState: "ade777f069d738595bc19e246b8ec7a0",
    types.EndEffectorProperties: "65f719b6b567d6b71b340982808da896",
    types.FollowJointTrajectoryAction: "bc4f9b743838566551c0390c65f1a248",
}


class DescriptionTest(unittest.TestCase):

    def test_messages_have_the_published_checksums(self):
        for message, checksum in CHECKSUMS.items():
            self.assertEqual(message._md5sum, checksum, message._type)

    def test_frames_of_the_urdf_agree_with_the_kinematics(self):
        recording = smile.open(GOLDEN)
        robot = RobotDescription(recording)
        positions = dict(zip(recording.joint_names, recording.joints[300]))
        poses, waiting = {"base": np.eye(4)}, dict(robot.joints)
        while waiting:
            for name, joint in [one for one in waiting.items() if one[1].parent in poses]:
                poses[joint.child] = poses[joint.parent] @ joint.pose_at(positions.get(name, 0))
                del waiting[name]
        tool = robot.motion.forward("left", [positions[name] for name in robot.arms["left"]])
        # The classic gripper's tool is 0.0818 m beyond the flange (docs/robot.md).
        tool[:3, 3] -= 0.0818 * tool[:3, 2]
        np.testing.assert_allclose(poses["left_hand"], tool, atol=1e-9)

    def test_quaternions_and_matrices_are_inverse(self):
        random = np.random.default_rng(1)
        for quaternion in [*np.eye(4), *random.normal(size=(50, 4))]:
            quaternion = quaternion / np.linalg.norm(quaternion) * (1 if quaternion[0] >= 0 else -1)
            found = quaternion_of(matrix_of(np.array([0, 0, 0, *quaternion]))[:3, :3])
            np.testing.assert_allclose(abs(found @ quaternion), 1, atol=1e-12)

    def test_a_path_goes_through_its_points_and_rests_outside(self):
        path = JointPath(["a", "b"], [0, 1, 3], [[0, 0], [1, -1], [2, 5]], [[0, 0], [0.5, 0], [0, 0]])
        for time, positions in zip(path.times, path.positions):
            np.testing.assert_allclose(path.at(time)[0], positions)
        step = 1e-6
        slope = (path.at(0.4 + step)[0] - path.at(0.4 - step)[0]) / (2 * step)
        np.testing.assert_allclose(path.at(0.4)[1], slope, atol=1e-8)
        for time in (-1, 4):
            self.assertFalse(path.at(time)[1].any())
        for wrong, words in (([0, 0], "do not increase"), ([0, math.nan], "not finite"), ([-1, 0], "do not increase")):
            with self.assertRaisesRegex(ValueError, words):
                JointPath(["a"], wrong, [[0], [1]])


class ServedRobotTest(unittest.TestCase):
    """Without ROS: which commands are refused, and why."""

    @classmethod
    def setUpClass(cls):
        cls.model = smile.load(SCENE)
        cls.description = describe(cls.model)

    def setUp(self):
        self.sim = smile.Simulation(self.model)
        self.robot = ServedRobot(self.sim, self.description)
        self.names = self.description.arms["left"]
        self.arm = self.sim.robot.arms["left"]

    def command(self, mode=4, names=None, values=None, sender="/a"):
        names = self.names if names is None else names
        return self.robot.command_joints("left", mode, names, self.arm.q if values is None else values, sender)

    def refuses(self, words, **arguments):
        before = self.sim.hash
        self.assertRegex(str(self.command(**arguments)), words)
        self.assertEqual(self.sim.hash, before)

    def test_positions_are_reached_within_the_ratio_of_speed(self):
        goal = self.arm.q + np.array([0.1, 0, 0, -0.1, 0, 0, 0.2])
        for ratio in (0.3, 0.1):
            self.assertIsNone(self.robot.set_speed_ratio("left", ratio))
            for _ in range(4):
                self.command(mode=1, values=goal)
                self.robot.step()
                self.assertLess(abs(self.arm.velocities[0]), ratio * 1.5 + 0.05)  # a motor overshoots by some percent
        for _ in range(120):
            self.command(mode=4, values=goal)
            self.robot.step()
        np.testing.assert_allclose(self.arm.q, goal, atol=1e-3)

    def test_faulty_commands_are_refused_with_the_reason(self):
        self.refuses("3 \\(torque\\).*position and velocity only", mode=3)
        self.refuses("the mode is 7, expected", mode=7)
        self.refuses("joint 'left_x9' is unknown, expected some of left_s0", names=["left_x9"], values=[0])
        self.refuses("joint 'right_s0' is unknown", names=["right_s0"], values=[0])
        self.refuses("named twice", names=["left_s0", "left_s0"], values=[0, 0])
        self.refuses("no joint is named", names=[], values=[])
        self.refuses("command contains nan, expected finite", names=["left_s0"], values=[math.nan])
        self.refuses("command contains inf", mode=2, names=["left_s0"], values=[math.inf])
        self.refuses("command has 2 numbers, expected 1", names=["left_s0"], values=[0, 0])
        self.refuses("left_s1 is 1.2000 rad, expected -2.1470 to 1.0470", names=["left_s1"], values=[1.2])

    def test_a_second_controller_is_refused_until_the_first_is_silent(self):
        self.assertIsNone(self.command(sender="/a"))
        self.refuses("left is controlled by /a, and /b is a second controller", sender="/b")
        for _ in range(math.ceil(COMMAND_TIMEOUT * 60) + 1):
            self.robot.step()
        self.assertIsNone(self.command(sender="/b"))

    def test_a_limb_stops_when_commands_cease(self):
        self.command(mode=2, values=[0.5, 0, 0, 0, 0, 0, 0])
        self.robot.step()
        self.robot.step()
        self.assertGreater(self.arm.velocities[0], 0.3)
        for _ in range(30):
            self.robot.step()
        self.assertLess(abs(self.arm.velocities[0]), 0.01)

    def test_motors_that_are_off_take_no_commands(self):
        self.robot.enable(False)
        self.refuses("not enabled")
        self.robot.emergency_stop()
        self.refuses("is stopped")
        self.assertRegex(self.robot.enable(True), "expected a reset first")
        self.robot.reset()
        self.assertIsNone(self.robot.enable(True))
        self.assertIsNone(self.command())

    def test_grippers_go_to_percentages_and_refuse_the_rest(self):
        self.assertIsNone(self.robot.command_gripper("left", "go", '{"position": 25}', "me", 3))
        for _ in range(200):
            self.robot.step()
        self.assertAlmostEqual(self.arm.gripper, 0.05, delta=0.002)
        self.assertEqual((self.robot.grippers["left"].sender, self.robot.grippers["left"].sequence), ("me", 3))
        for command, args in (("go", '{"position": 101}'), ("go", '{"position": NaN}'), ("go", "[]"), ("go", "{"),
                              ("go", "[" * 5000), ("go", '{"position": true}'), ("dance", "")):
            self.assertIn("expected", self.robot.command_gripper("left", command, args, "me", 4), args[:20])
        self.assertEqual(self.robot.grippers["left"].sequence, 3)


class GraphTest(unittest.TestCase):
    """The program, and this process as its client."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.graph = Graph(cls.folder.name)
        cls.addClassCleanup(cls.graph.master.end)
        cls.served = Program(cls.folder.name, "serve", [PROGRAM, "ros", "serve", SCENE, "--rate", 10, "--picture-rate", 4,
                                                        "--size", "64x40", "--record", Path(cls.folder.name) / "run"])
        cls.addClassCleanup(cls.served.end)
        cls.served.wait_for_output("serving baxter in tower")
        rospy.init_node("client", disable_signals=True)
        cls.logs = []
        rospy.Subscriber("/rosout", Log, lambda message: cls.logs.append(message.msg), queue_size=100)

    def message(self, topic, kind):
        return rospy.wait_for_message(topic, kind, PATIENCE)

    def publisher(self, topic, kind):
        publisher = rospy.Publisher(topic, kind, queue_size=10)
        wait_until(lambda: publisher.get_num_connections() > 0, f"a connection to {topic}")
        return publisher

    def joints(self):
        message = self.message("/robot/joint_states", JointState)
        return dict(zip(message.name, message.position))

    def test_the_state_of_the_robot_is_published(self):
        joints = self.message("/robot/joint_states", JointState)
        self.assertEqual(joints.name[:2] + joints.name[7:8], ["left_s0", "left_s1", "right_s0"])
        self.assertGreater(self.message("/clock", Clock).clock, joints.header.stamp)
        state = self.message("/robot/state", types.AssemblyState)
        self.assertTrue(state.enabled and not state.stopped)
        frames = {one.child_frame_id: one.header.frame_id for one in self.message("/tf", TFMessage).transforms}
        self.assertEqual((frames["base"], frames["left_wrist"]), ("world", "left_lower_forearm"))
        endpoint = self.message("/robot/limb/left/endpoint_state", types.EndpointState)
        description = RobotDescription(smile.open(GOLDEN))
        q = [dict(zip(joints.name, joints.position))[name] for name in description.arms["left"]]
        place = description.motion.forward("left", q)[:3, 3]
        np.testing.assert_allclose(
            [endpoint.pose.position.x, endpoint.pose.position.y, endpoint.pose.position.z], place, atol=0.02)
        gripper = self.message("/robot/end_effector/left_gripper/state", types.EndEffectorState)
        self.assertAlmostEqual(gripper.position, 100, delta=1)

    def test_pictures_are_those_of_the_robots_cameras(self):
        picture = self.message("/cameras/left_hand_camera/image", Image)
        self.assertEqual((picture.width, picture.height, picture.encoding), (64, 40, "rgb8"))
        self.assertGreater(len(set(picture.data)), 3)
        info = self.message("/cameras/left_hand_camera/camera_info", CameraInfo)
        self.assertAlmostEqual(info.K[0], 64 / (2 * math.tan(1.3963 / 2)), places=2)
        # The middle of the picture, counted from the center of the first pixel.
        np.testing.assert_allclose([info.K[2], info.K[5], info.P[2], info.P[6]], [31.5, 19.5] * 2)

    def test_refusals_are_logged(self):
        command = self.publisher("/robot/limb/left/joint_command", types.JointCommand)
        for mode, values, words in ((3, [0.0], "(torque)"), (1, [math.nan], "contains nan"), (1, [9.0], "left_s0 is 9.0000 rad")):
            def is_logged():
                command.publish(types.JointCommand(mode=mode, command=values, names=["left_s0"]))
                return any("/joint_command from /client" in line and words in line for line in self.logs)
            wait_until(is_logged, f"a refusal with {words}")

    def test_streamed_positions_move_the_arm_and_a_stop_ends_it(self):
        command = self.publisher("/robot/limb/right/joint_command", types.JointCommand)
        self.publisher("/robot/limb/right/set_speed_ratio", Float64).publish(1.0)
        goal = self.joints()["right_w2"] + 0.3

        def has_arrived():
            command.publish(types.JointCommand(mode=1, command=[goal], names=["right_w2"]))
            return abs(self.joints()["right_w2"] - goal) < 0.005
        wait_until(has_arrived, "the arrival of right_w2")
        stop = self.publisher("/robot/set_super_stop", Empty)
        enable = self.publisher("/robot/set_super_enable", Bool)
        stop.publish()
        wait_until(lambda: self.message("/robot/state", types.AssemblyState).stopped, "the stop")
        self.publisher("/robot/set_super_reset", Empty).publish()

        def is_enabled():
            enable.publish(True)
            return self.message("/robot/state", types.AssemblyState).enabled
        wait_until(is_enabled, "the motors")

    def follow(self, change, names=None, seconds=1):
        client = actionlib.SimpleActionClient("/robot/limb/left/follow_joint_trajectory", types.FollowJointTrajectoryAction)
        self.assertTrue(client.wait_for_server(rospy.Duration(10 * PATIENCE)))
        joints = self.joints()
        own = [name for name in joints if name.startswith("left_")]
        goal = types.FollowJointTrajectoryGoal()
        goal.trajectory.joint_names = own if names is None else names
        for step in (1, 2):
            goal.trajectory.points.append(trajectory.JointTrajectoryPoint(
                positions=[joints[name] + change * step for name in own][:len(goal.trajectory.joint_names)],
                time_from_start=rospy.Duration(step * seconds)))
        client.send_goal(goal)
        return client, {name: joints[name] + 2 * change for name in own}

    def test_a_trajectory_is_followed_to_its_end(self):
        client, goal = self.follow(-0.05)
        self.assertTrue(client.wait_for_result(rospy.Duration(10 * PATIENCE)))
        self.assertEqual(client.get_result().error_code, 0, client.get_result().error_string)
        now = self.joints()
        for name, position in goal.items():
            self.assertAlmostEqual(now[name], position, delta=0.01)

    def test_faulty_trajectories_are_rejected_with_a_code(self):
        types_of = types.FollowJointTrajectoryResult
        for change, names, code, words in ((0.1, ["left_s0"], types_of.INVALID_JOINTS, "expected left_s0, left_s1"),
                                           (5, None, types_of.INVALID_GOAL, "rad, expected"),
                                           (math.nan, None, types_of.INVALID_GOAL, "not finite")):
            client, _ = self.follow(change, names)
            self.assertTrue(client.wait_for_result(rospy.Duration(10 * PATIENCE)))
            self.assertEqual(client.get_result().error_code, code)
            self.assertIn(words, client.get_result().error_string)

    def test_a_trajectory_can_be_cancelled(self):
        client, _ = self.follow(-0.02, seconds=1000)
        wait_until(lambda: client.get_state() == actionlib.GoalStatus.ACTIVE, "the start")
        client.cancel_goal()
        self.assertTrue(client.wait_for_result(rospy.Duration(10 * PATIENCE)))
        self.assertEqual(client.get_state(), actionlib.GoalStatus.PREEMPTED)

    def test_zy_a_program_that_stood_still_has_not_lost_its_master(self):
        before = self.message("/clock", Clock).clock
        for program in (self.graph.master, self.served):
            program.freeze()
        time.sleep(3.5)
        self.served.thaw()
        time.sleep(0.5)
        self.graph.master.thaw()
        wait_until(lambda: self.message("/clock", Clock).clock > before, "going on")

    def test_zz_ends_with_its_master_and_leaves_a_recording(self):
        self.graph.master.end()
        self.assertNotEqual(self.served.wait(), 0)
        self.assertIn(f"the ROS master at {self.graph.address} no longer answers", self.served.output)
        recording = smile.open(Path(self.folder.name) / "run")
        recording.verify()
        self.assertGreater(len(recording), 10)


if __name__ == "__main__":
    # rospy leaves sockets to the garbage collector.
    unittest.main(argv=sys.argv[:1], warnings="ignore")
