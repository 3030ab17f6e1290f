"""Tests `smile ros perform`: plans and their checks, a performance and what stops it, and the programs on a graph.

Usage: ros_perform_test.py PROJECT_FOLDER [TEST...], with the program in SMILE. Skipped without ROS.
"""

import itertools
import json
import math
import os
import re
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import urllib.error
import urllib.request
from pathlib import Path
from unittest import mock

# First: it finds ROS, or ends the test.
from ros_graph import Graph, Program, wait_until

import numpy as np
import rospy
import smile
from sensor_msgs.msg import JointState
from smile.ros.__main__ import switch_on
from smile.ros.message_types import AssemblyState, JointCommand
from smile.ros.joint_path import JointPath
from smile.ros.motion_plan import approach, faults, plan_of
from smile.ros.performing import Performance, Watch
from smile.ros.description import describe
from smile.ros.served_robot import ServedRobot
from smile.ros.stop_page import StopPage
from std_msgs.msg import Float64
from simulated_link import SimulatedLink

PROJECT, PROGRAM = Path(sys.argv[1]), os.environ["SMILE"]
GOLDEN = PROJECT / "tests/golden/recordings/imitation"
TOLERANCE = 0.005
"""greatest error of a joint in these performances [rad]"""


class PlanTest(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        cls.recording = smile.open(GOLDEN)

    def plan(self, speed=0.3, limbs=()):
        return plan_of(self.recording, limbs, speed)

    def test_contains_the_arms_that_move_and_what_grippers_do(self):
        plan = self.plan()
        self.assertEqual(plan.arms, ["right"])
        self.assertEqual(plan.table, (2.0, 1.2000000000000002))
        self.assertEqual([move.held for move in plan.grippers], [None, None, "RedBlock", None])
        self.assertEqual(plan.grippers[2].percent, 0)
        held = next(event for event in self.recording.events if event["kind"] == "gripper_holds")
        self.assertAlmostEqual(plan.grippers[2].end, held["tick"] / 60, delta=0.1)
        self.assertEqual(faults(plan, 3), [])
        with self.assertRaisesRegex(ValueError, "limb 'third', expected some of left, right"):
            self.plan(limbs=["third"])

    def test_refuses_what_is_too_fast_and_proposes_a_speed(self):
        found = faults(self.plan(speed=1), 3)
        self.assertRegex(found[0], r"^right_w2 accelerates by 6\.\d+ rad/s² at .* expected up to 3; --speed 0\.6")
        proposed = float(re.search("--speed ([0-9.]+)", found[0])[1])
        self.assertEqual(faults(self.plan(speed=proposed), 3), [])
        plan = self.plan(speed=1)
        plan.path = JointPath(plan.path.names, plan.path.times / 2, plan.path.positions)
        self.assertRegex(faults(plan, 1000)[0], r"^right_s0 moves at 2\.\d+ rad/s .* expected up to 1\.5; --speed 0\.5")

    def test_refuses_limits_and_places_outside_of_the_workspace(self):
        for joint, value, words in (("right_e1", 3.0, r"right_e1 is 3\.0000 rad at 1\.00 s, expected -0\.0500 to 2\.6180"),
                                    ("right_e1", 0.3, r"the right tool is at \(.*\) m, outside of the workspace from .* at 1\.00 s")):
            plan = self.plan(speed=0.01)
            positions = plan.path.positions.copy()
            positions[60, plan.path.names.index(joint)] = value
            plan.path = JointPath(plan.path.names, plan.path.times, positions)
            self.assertRegex("\n".join(faults(plan, 1000)), words)

    def test_the_way_to_the_start_is_slow_and_free(self):
        plan = self.plan()
        description = plan.description
        now = dict.fromkeys((name for joints in description.arms.values() for name in joints), 0.0)
        now.update(zip(description.arms["left"], [1.315, -1.054, -0.95, 1.795, 0.4738, 1.0776, -0.2123]))
        path, fault = approach(plan, now)
        self.assertIsNone(fault)
        np.testing.assert_allclose(path.positions[[0, -1]], [np.zeros(7), plan.path.positions[0]], atol=1e-9)
        self.assertLess(np.abs(path.velocities / [description.speed(name) for name in path.names]).max(), 0.1001)
        for left, right, words in (([-1.2, 0, 0, 0.5, 0, 0, 0], [1.2, 0, 0, 0.5, 0, 0, 0], "would touch left_"),
                                   ([0] * 7, [0.3, 0.9, 0, 0.3, 0, 0.3, 0], "would touch an obstacle")):  # the table
            now.update(zip(description.arms["left"] + description.arms["right"], left + right))
            self.assertRegex(str(approach(plan, now)[1]), f"the way to the start is blocked after .* s: .*{words}")


class PerformanceTest(unittest.TestCase):
    """In this process, in simulated time."""

    @classmethod
    def setUpClass(cls):
        cls.recording = smile.open(GOLDEN)
        cls.model = smile.load(GOLDEN / "scene.xml")
        cls.description = describe(cls.model)

    def setUp(self):
        self.sim = smile.Simulation(self.model)
        self.sim.apply({"do": "pose", "name": "parked", "speed": 0.5})
        self.sim.run_until("arrived")
        self.start = self.sim.tick

    def perform(self, speed=0.9, supervisor=None, by_trajectory=False, **link):
        self.link = SimulatedLink(ServedRobot(self.sim, self.description), **link)
        return Performance(self.link, plan_of(self.recording, [], speed), Watch(), supervisor, by_trajectory).perform(lambda line: None)

    def stops(self, words, damage, moves=True, supervisor=None, by_trajectory=False):
        """The performance stops for a reason, and then the arms stand."""
        outcome = self.perform(damage=damage, moves=moves, supervisor=supervisor, by_trajectory=by_trajectory)
        self.assertRegex(str(outcome.reason), words)
        for _ in range(30):
            self.link.robot.step()
        for arm in self.sim.robot.arms.values():
            self.assertLess(np.abs(arm.velocities).max(), 0.01)
        return outcome

    def after(self, ticks, change):
        """A damage that begins after some ticks."""
        return lambda tick, reading: change(reading) if tick > self.start + ticks else reading

    def test_a_trajectory_is_canceled_if_not_even_its_begin_can_be_watched(self):
        def old_once_sent(tick, reading):
            return reading._replace(age=1.0) if self.link._trajectories else reading

        self.displace()
        with mock.patch("smile.ros.performing.monotonic", side_effect=itertools.count(step=0.1).__next__):
            self.stops("the joint states are 1.00 s old", old_once_sent, by_trajectory=True)
        self.assertIsNone(self.link.robot.limbs["right"].path)

    def test_the_block_ends_where_it_did_in_the_recording(self):
        outcome = self.perform()
        self.assertIsNone(outcome.reason)
        self.assertAlmostEqual(outcome.seconds, (len(self.recording) - 1) / 60, delta=0.1)
        np.testing.assert_allclose(self.sim.objects["RedBlock"].position, self.recording.poses[-1, 0, :3], atol=0.002)
        errors = outcome.tracking.summary()
        self.assertEqual(list(errors), self.description.arms["right"])
        self.assertLess(max(one["max"] for one in errors.values()), TOLERANCE)

    def test_the_way_to_the_start_may_be_a_trajectory(self):
        self.displace()
        outcome = self.perform(by_trajectory=True)
        self.assertIsNone(outcome.reason)
        np.testing.assert_allclose(self.sim.objects["RedBlock"].position, self.recording.poses[-1, 0, :3], atol=0.002)

    def test_a_trajectory_is_watched_and_cancelled(self):
        for words, damage, moves in (
                ("right_s1 is nan", self.after(60, lambda reading: reading._replace(positions={**reading.positions, "right_s1": math.nan})), True),
                (r"right_\w+ is 0\.\d+ rad from where it should be", lambda tick, reading: reading, False),
                ("the robot ended the trajectory of the right arm: the robot is not enabled", lambda tick, reading: self.off(reading), True)):
            with self.subTest(words):
                self.setUp()
                self.displace()
                self.assertEqual(self.stops(words, damage, moves=moves, by_trajectory=True).seconds, 0)
                self.assertIsNone(self.link.robot.limbs["right"].path)

    def displace(self):
        """Turns the right arm away from the start of the recording."""
        self.sim.apply({"do": "joint_angles", "right": (self.sim.robot.arms["right"].q - [0.5, 0, 0, 0, 0, 0, 0]).tolist()})

    def off(self, reading):
        """The motors refuse, but do not report it."""
        self.link.robot.enable(False)
        self.link.motors_fault = lambda: None
        return reading

    def test_faulty_joint_states_stop_the_robot(self):
        def with_position(value):
            return lambda reading: reading._replace(positions={**reading.positions, "right_s1": value})

        for words, change in (
                ("right_s1 is nan, expected a finite number", with_position(math.nan)),
                ("right_s1 is inf", with_position(math.inf)),
                (r"right_s1 is 1\.\d+ rad from where it should be at", with_position(0.4)),
                ("the joint states lack right_s0: they name elbow", lambda reading: reading._replace(positions={"elbow": 0.0})),
                (r"are 0\.40 s old, expected less than 0\.25 s", lambda reading: reading._replace(age=0.4)),
                (r"are 9\.00 s in the future", lambda reading: reading._replace(age=-9)),
                (r"time jumped by 1\.02 s", lambda reading: reading._replace(time=reading.time + 1)),
                (r"time went back by 0\.\d+ s", lambda reading: reading._replace(time=reading.time - 1))):
            with self.subTest(words):
                self.setUp()
                outcome = self.stops(words, self.after(120, change))
                self.assertGreater(self.link.commands, 100)
                self.assertLess(outcome.seconds, 3)

    def test_silence_stops_the_robot(self):
        self.stops(r"no joint states for 0\.5 s: the connection is lost", self.after(120, lambda reading: None))

    def test_the_button_of_the_page_stops_the_robot(self):
        page = StopPage("Tower")
        self.addCleanup(page.close, "over")

        def ask(path, data=None, **headers):
            with urllib.request.urlopen(urllib.request.Request(page.link + path, data, headers), timeout=30) as answer:
                return answer.read()

        for path, data, headers, code in (("other", None, {}, 404), ("other", b"", {}, 404), ("stop", None, {}, 404),
                                          ("stop", b"", {"Host": "robot.example"}, 403), ("state", None, {"Host": "robot.example"}, 403)):
            with self.assertRaisesRegex(urllib.error.HTTPError, str(code)):
                ask(path, data, **headers)
        self.assertIn(b"STOP", ask(""))
        shown = []

        def press(tick, reading):
            if tick == self.start + 120:
                shown.append(json.loads(ask("state")))
                ask("stop", b"")
            return reading

        outcome = self.stops("^the button of the page was pressed$", press, supervisor=page)
        self.assertEqual((shown[0]["phase"], shown[0]["end"]), ("Performing", None))
        self.assertAlmostEqual(shown[0]["seconds"], outcome.seconds, delta=0.1)

    def test_a_robot_that_does_not_move_is_noticed(self):
        outcome = self.stops(r"right_\w+ is 0\.\d+ rad from where it should be", lambda tick, reading: reading, moves=False)
        self.assertLess(outcome.seconds, 2)

    def test_motors_that_are_switched_off_are_noticed(self):
        def switch_off(reading):
            self.link.robot.enable(False)
            return reading
        self.stops("the motors are off", self.after(120, switch_off))

    def test_motors_are_switched_on_if_they_can_be(self):
        link = SimulatedLink(ServedRobot(self.sim, self.description))
        link.robot.enable(False)
        switch_on(link)
        self.assertIsNone(link.motors_fault())
        link.robot.emergency_stop()
        with self.assertRaisesRegex(RuntimeError, "the motors are off, 0.1 s after they were switched on"):
            switch_on(link, patience=0.1)

    def test_a_grasp_of_nothing_stops_the_robot(self):
        self.sim.hand().grasp("RedBlock")
        self.sim.hand().destroy()
        self.stops("the right gripper closed to .* % and holds nothing, expected RedBlock", lambda tick, reading: reading)


class GraphTest(unittest.TestCase):
    """The programs on both sides of a ROS master."""

    @classmethod
    def setUpClass(cls):
        cls.holder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.holder.cleanup)
        cls.folder = Path(cls.holder.name)
        scene = PROJECT / "scenes/tower.xml"
        for words in (["run", scene, "--commands", PROJECT / "examples/tower.jsonl", "--record", cls.folder / "demo"],
                      ["imitate", cls.folder / "demo", scene, "--brain", PROJECT / "python/learner/learner.py",
                       "--out", cls.folder / "tower", "--no-pictures"]):
            subprocess.run([PROGRAM, *words], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def setUp(self):
        self.graph = Graph(self.folder)
        self.addCleanup(self.graph.master.end)

    def serve(self, scene=PROJECT / "scenes/tower.xml"):
        record = Path(tempfile.mkdtemp(dir=self.folder)) / "served"
        served = Program(self.folder, "serve", [PROGRAM, "ros", "serve", scene, "--lockstep", "--pose", "parked",
                                                "--record", record])
        self.addCleanup(served.end)
        served.wait_for_output("serving baxter")
        return served, record

    def perform(self, *words):
        performed = Program(self.folder, "perform", [PROGRAM, "ros", "perform", *words, "--silence", 30])
        self.addCleanup(performed.end)
        return performed

    def test_a_tower_is_built_through_the_graph(self):
        served, record = self.serve()
        report = self.folder / "report.json"
        performed = self.perform(self.folder / "tower", "--speed", 0.8, "--max-acceleration", 30, "--yes", "--report", report,
                                 "--start-by-trajectory")
        self.assertEqual(performed.wait(), 0, performed.output)
        self.assertRegex(performed.output, "left gripper closes on GreenBlock\n(.*\n)+performed\n$")
        outcome = json.loads(report.read_text())
        self.assertEqual((outcome["performed"], outcome["limbs"], len(outcome["joints"])), (True, ["left", "right"], 14))
        self.assertLess(max(one["max"] for one in outcome["joints"].values()), TOLERANCE)
        served.interrupt()
        served.wait()
        built, wanted = smile.open(record), smile.open(self.folder / "tower/imitation")
        np.testing.assert_allclose(built.poses[-1, :, :3], wanted.poses[-1, :, :3], atol=0.003)
        self.assertAlmostEqual(built.poses[-1, built.object_ids.index("BlueBlock"), 2], 0.25, delta=0.002)
        built.verify()

    def test_the_commands_of_the_document_work(self):
        blocks = re.findall(r"```sh\n(.*?)```", (PROJECT / "docs/real-robot.md").read_text(), re.DOTALL)
        self.assertEqual(len(blocks), 3)
        folder = self.folder / "document"
        folder.mkdir()
        for name in ("scenes", "examples", "python"):
            (folder / name).symlink_to(PROJECT / name)
        script = "\n".join(blocks).replace("./run ", f"'{PROGRAM}' ").replace(
            "http://127.0.0.1:11311", self.graph.address).replace("rosmaster --core", ": rosmaster --core")
        typed = Program(self.folder, "document", [
            "bash", "-ec", f"cd '{folder}'; trap 'kill $(jobs -p) || true' EXIT\n{script}"])
        self.addCleanup(typed.end)
        self.assertEqual(typed.wait(), 0, typed.output)
        self.assertIn("nothing moved: this would be performed", typed.output)
        self.assertIn("\nperformed\n", typed.output)

    def test_full_speed_is_asked_for_once_the_robot_listens(self):
        rospy.init_node("late_robot", disable_signals=True)
        is_over = threading.Event()
        self.addCleanup(is_over.set)
        states = (rospy.Publisher("/robot/joint_states", JointState, queue_size=1), JointState(name=["right_s0"], position=[0])), (
            rospy.Publisher("/robot/state", AssemblyState, queue_size=1), AssemblyState(enabled=True))

        def report():
            while not is_over.wait(0.02):
                for publisher, message in states:
                    publisher.publish(message)

        threading.Thread(target=report, daemon=True).start()
        rospy.Subscriber("/robot/limb/right/joint_command", JointCommand, lambda message: None)
        linked = Program(self.folder, "link", [
            sys.executable, "-c", "from smile.ros.ros_link import RosLink; RosLink(['right'], ['right_s0']); print('linked')"])
        self.addCleanup(linked.end)
        wait_until(lambda: states[0][0].get_num_connections() > 0, "the connection")
        # Everything else is there for a while.
        time.sleep(0.5)
        self.assertNotIn("linked", linked.output)
        ratios = []
        rospy.Subscriber("/robot/limb/right/set_speed_ratio", Float64, lambda message: ratios.append(message.data))
        wait_until(lambda: ratios, "the speed ratio")
        self.assertEqual((linked.wait(), ratios), (0, [1.0]), linked.output)

    def test_ctrl_c_stops_the_robot(self):
        served, record = self.serve(GOLDEN / "scene.xml")
        performed = self.perform(GOLDEN, "--yes")
        performed.wait_for_output("performing:")
        performed.interrupt()
        self.assertEqual(performed.wait(), 1, performed.output)
        self.assertRegex(performed.output, r"stopped after .* s of 10\.98 s: interrupted\n$")
        served.interrupt()
        served.wait()
        joints = smile.open(record).joints
        np.testing.assert_allclose(joints[-1], joints[-2], atol=1e-3)

    def test_a_dead_master_stops_the_robot(self):
        self.serve(GOLDEN / "scene.xml")
        performed = self.perform(GOLDEN, "--yes", "--speed", 0.05)
        performed.wait_for_output("performing:")
        self.graph.master.end()
        self.assertEqual(performed.wait(), 1, performed.output)
        self.assertRegex(performed.output, f"stopped after .* s: (the ROS master at {self.graph.address} no longer answers|"
                                           "the robot no longer listens to /robot/limb/right/joint_command)\n$")

    def test_without_master_robot_or_consent_nothing_moves(self):
        refused = self.perform(GOLDEN, "--yes")
        self.assertEqual(refused.wait(), 2)
        self.assertRegex(refused.output, f"error: no robot at {self.graph.address}: /robot/joint_states, /robot/state, "
                                         "/robot/limb/right/joint_command, /robot/limb/right/set_speed_ratio not served within 10 s")
        refused = self.perform(GOLDEN, "--yes", "--speed", 1)
        self.assertEqual(refused.wait(), 1)
        self.assertRegex(refused.output, r"refused: right_w2 accelerates by")
        self.serve(GOLDEN / "scene.xml")
        refused = self.perform(GOLDEN)
        self.assertEqual(refused.wait(), 2)
        self.assertIn("expected --yes", refused.output)
        dry = self.perform(GOLDEN, "--dry-run")
        self.assertEqual(dry.wait(), 0, dry.output)
        self.assertRegex(dry.output, "nothing moved: this would be performed\n$")
        self.graph.master.end()
        refused = self.perform(GOLDEN, "--yes")
        self.assertEqual(refused.wait(), 2)
        self.assertIn(f"no ROS master answers at {self.graph.address}", refused.output)


if __name__ == "__main__":
    # rospy leaves sockets to the garbage collector.
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]], warnings="ignore")
