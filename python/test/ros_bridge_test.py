"""Tests `smile ros perform --bridge`: a robot behind a rosbridge server, and servers that misbehave.

The server is one of these tests (rosbridge.py), the robot is that of `smile ros serve`.

Usage: ros_bridge_test.py PROJECT_FOLDER [TEST...], with the program in SMILE. Skipped without ROS.
"""

import json
import math
import os
import re
import struct
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from pathlib import Path
from unittest import mock

# First: it finds ROS, or ends the test.
from ros_graph import PATIENCE, Graph, Program

import numpy as np
import rospy
import smile
from rosbridge import GraphTopics, RosbridgeServer
from smile.ros.bridge import Bridge
from smile.ros.bridge_link import BridgeLink, seconds_of
from smile.ros.camera import intrinsics_of, rgb_of
from smile.ros.motion_plan import plan_of
from smile.ros.performing import Performance, Watch

PROJECT, PROGRAM = Path(sys.argv[1]), os.environ["SMILE"]
GOLDEN = PROJECT / "tests/golden/recordings/imitation"
TOLERANCE = 0.1
"""greatest error of a joint through the bridge: a delay of some ticks on a loaded machine [rad]"""


class ObedientRobot:
    """Topics of a robot that is at once where a command wants it; it reports 60 times a second.

    damage  makes another text of a message of joint states, or None for silence
    """

    def __init__(self, positions, damage=lambda text: text, state=None):
        self.positions, self.commands, self.damage = positions, 0, damage
        self.state = state or {"enabled": True, "stopped": False, "error": False}
        self._senders = {}
        self._is_over = threading.Event()

    def advertise(self, topic, kind, latch):
        return lambda: None

    def publish(self, topic, values):
        if topic.endswith("joint_command"):
            self.commands += 1
            self.positions.update(zip(values["names"], values["command"]))

    def subscribe(self, topic, kind, send):
        if topic == "/robot/state":
            send(self.state)
        if topic == "/robot/joint_states":
            threading.Thread(target=self._report, daemon=True).start()
        return self._is_over.set

    def _report(self):
        while not self._is_over.wait(1 / 60):
            whole, part = divmod(time.time(), 1)
            text = self.damage(json.dumps({"op": "publish", "topic": "/robot/joint_states", "msg": {
                "header": {"stamp": {"sec": int(whole), "nanosec": int(part * 1e9)}, "frame_id": ""},
                "name": list(self.positions), "position": list(self.positions.values())}}))
            if text is not None:
                self.server.send_text(text)


class MisbehaviorTest(unittest.TestCase):
    """Each ends the motion, with the reason. The messages have the times of ROS 2."""

    @classmethod
    def setUpClass(cls):
        cls.plan = plan_of(smile.open(GOLDEN), [], 0.3)
        cls.names = [name for joints in cls.plan.description.arms.values() for name in joints]

    def serve(self, **options):
        positions = dict.fromkeys(self.names, 0.0)
        positions.update(zip(self.plan.path.names, self.plan.path.positions[0]))
        self.robot = ObedientRobot(positions, **options)
        self.robot.server = self.server = RosbridgeServer(self.robot)
        self.addCleanup(self.server.close)

    def perform(self):
        link = BridgeLink(self.server.address, self.plan.arms, self.names)
        outcome = Performance(link, self.plan, Watch(silence=5, age=5, jump=5)).perform(lambda line: None)
        return outcome.reason, link

    def stops(self, words, damage):
        """The motion stops once 40 commands were obeyed and the damage begins."""
        self.serve()
        self.robot.damage = lambda text: damage(text) if self.robot.commands > 40 else text
        reason, _ = self.perform()
        self.assertRegex(str(reason), words)
        self.assertGreater(self.robot.commands, 40)
        self.assertLess(self.robot.commands, 150)

    def test_faulty_messages_stop_the_robot(self):
        def position(value):
            return lambda text: re.sub(r'("position": )\[[^,]*', rf"\1[{value}", text)

        def lacking(field):
            return lambda text: text.replace(f'"{field}"', '"nothing"')

        first = self.names[0]
        joint = self.plan.path.names[0]
        nulls = ", ".join(["null"] * len(self.names))
        for words, damage in (
                (f"{joint} is nan, expected a finite number",
                 lambda text: re.sub(r'"position": \[.*\]', f'"position": [{nulls}]', text)),
                (f"the joint states lack {joint}: they name {first}", lambda text: re.sub(r'"position": \[.*\]', '"position": [1]', text)),
                ("sent '{.op., expected JSON|sent '.* expected JSON", lambda text: text[:40]),
                ("sent '\\[\\[.*expected JSON", lambda text: "[" * 100_000),
                ("sent a message of /robot/joint_states without position", lacking("position")),
                ("sent a message of /robot/joint_states without nanosec", lacking("nanosec")),
                ("faulty message of /robot/joint_states: 'much' is not a number", position('"much"')),
                ("faulty message of /robot/joint_states: is '7', expected an object",
                 lambda text: '{"op": "publish", "topic": "/robot/joint_states", "msg": 7}'),
                ("faulty message of /robot/joint_states: position is .*, expected a list of up to 1000",
                 lambda text: re.sub(r'"position": \[', f'"position": [{"0, " * 2000}', text)),
                ("sent the operation 'fragment': expected whole messages", lambda text: '{"op": "fragment", "id": "1"}'),
                ("sent the operation 'png': expected whole messages", lambda text: '{"op": "png", "data": ""}'),
                ("sent the operation 'None', expected publish or status", lambda text: "{}"),
                ("sent binary data, expected JSON", lambda text: b"\0"),
                ("reports an error: type is unknown", lambda text: '{"op": "status", "level": "error", "msg": "type is unknown"}'),
                ("closed the connection: .*(1009|too big)", lambda text: '"' + " " * (17 << 20) + '"')):
            with self.subTest(words):
                self.stops(words, damage)

    def test_silence_and_a_lost_connection_stop_the_robot(self):
        self.stops("no joint states for 5 s: the connection is lost", lambda text: None)

        def close(text):
            self.server.close()
        self.stops(r"the bridge at ws://127\.0\.0\.1:\d+ closed the connection", close)

    def test_warnings_and_joints_of_other_parts_do_not_stop_it(self):
        self.serve()
        self.robot.damage = lambda text: self.server.send_text(re.sub(r'"name": \[.*\], "pos', '"name": ["finger"], "pos', text)) or text
        link = BridgeLink(self.server.address, self.plan.arms, self.names)
        self.server.send_text('{"op": "status", "level": "warning", "msg": "slow"}')
        self.server.send_text('{"op": "publish", "topic": "/rosout", "msg": {"level": 40, "msg": "hot"}}')
        self.server.send_text('{"op": "publish", "topic": "/rosout", "msg": {"level": 20, "msg": "fine"}}')
        while link.words() != ["hot", "slow"]:
            self.assertIsNone(link.connection_fault())
            time.sleep(0.01)
        for _ in range(30):
            reading = link.wait(5)
            self.assertEqual(list(reading.positions), self.names)
            self.assertLess(abs(reading.age), 5)

    @mock.patch("smile.ros.bridge_link._ACTION_SECONDS", 0.5)
    def test_a_robot_without_the_action_does_not_begin(self):
        self.serve()
        self.robot.positions[self.plan.path.names[0]] += 0.1
        link = BridgeLink(self.server.address, self.plan.arms, self.names)
        outcome = Performance(link, self.plan, Watch(silence=5, age=5, jump=5), by_trajectory=True).perform(lambda line: None)
        self.assertRegex(str(outcome.reason), "^no action /robot/limb/right/follow_joint_trajectory behind ws://.* within 0.5 s$")

    @mock.patch("smile.ros.bridge_link._CONNECTION_SECONDS", 2.0)
    def test_without_server_or_robot_nothing_begins(self):
        for address in ("http://robot", "ws://", "robot:9090"):
            with self.assertRaisesRegex(ValueError, "expected ws://HOST:PORT"):
                Bridge(address, lambda: None)
        self.serve(state={"enabled": 1, "stopped": False, "error": False})
        with self.assertRaisesRegex(RuntimeError, "faulty message of /robot/state: enabled is '1', expected true or false"):
            self.perform()
        self.serve(damage=lambda text: None)
        with self.assertRaisesRegex(RuntimeError, f"no robot behind {self.server.address}: /robot/joint_states not served within 2 s"):
            self.perform()
        self.serve(damage=lambda text: text.replace('"sec": ', '"sec": 1'))
        with self.assertRaisesRegex(RuntimeError, r"/clock \(the time of the joint states is 1\d+ s, not that of this machine\) not served"):
            self.perform()
        address = self.server.address
        self.server.close()
        time.sleep(0.2)
        with self.assertRaisesRegex(RuntimeError, f"no rosbridge server answers at {address}: "):
            Bridge(address, lambda: None)

    def test_simulated_time_counts_from_when_its_clock_is_known(self):
        self.serve(damage=lambda text: re.sub(r'"sec": \d+, "nanosec": \d+', '"sec": 5, "nanosec": 0', text))

        def tick():
            while self.robot.commands == 0 and not done.wait(0.5):
                self.server.send_text('{"op": "publish", "topic": "/clock", "msg": {"clock": {"sec": 5, "nanosec": 250000000}}}')

        done = threading.Event()
        self.addCleanup(done.set)
        threading.Thread(target=tick, daemon=True).start()
        self.assertEqual(BridgeLink(self.server.address, self.plan.arms, self.names).wait(5).age, 0.25)

    def test_pictures_are_read_in_each_order_of_colors(self):
        red = np.zeros((2, 3, 3), np.uint8)
        red[1, 2] = [200, 20, 10]
        padding = np.zeros((2, 5), np.uint8)
        for encoding, channels in (("rgb8", red), ("bgr8", red[:, :, ::-1]), ("rgba8", np.dstack([red, red[:, :, 0]])),
                                   ("bgra8", np.dstack([red[:, :, ::-1], red[:, :, 0]]))):
            rows = np.hstack([channels.reshape(2, -1), padding])
            np.testing.assert_array_equal(rgb_of(encoding, 3, 2, rows.shape[1], rows.tobytes()), red)
        np.testing.assert_array_equal(rgb_of("mono8", 1, 1, 1, b"\7"), [[[7, 7, 7]]])
        for words, arguments in (("encoding is 'bayer_rggb8', expected one of rgb8", ("bayer_rggb8", 1, 1, 1, b"0")),
                                 ("has 0 x 1 pixels", ("mono8", 0, 1, 1, b"")), ("has 99999 x 1 pixels", ("mono8", 99999, 1, 99999, b"")),
                                 ("has 3 bytes in rows of 2, expected 2 rows of at least 2", ("mono8", 2, 2, 2, b"123")),
                                 ("in rows of 1, expected 2 rows of at least 2", ("mono8", 2, 2, 1, b"12"))):
            with self.assertRaisesRegex(ValueError, words):
                rgb_of(*arguments)
        for words, arguments in (("distortion_model is 'fisheye'", ("fisheye", [1] * 9, [0] * 5)),
                                 ("the camera is not calibrated", ("plumb_bob", [0] * 9, [0] * 5)),
                                 ("the camera is not calibrated", ("plumb_bob", [math.nan] * 9, [0] * 5))):
            with self.assertRaisesRegex(ValueError, words):
                intrinsics_of(*arguments)

    def test_times_of_both_versions_are_read(self):
        self.assertEqual(seconds_of({"secs": 2, "nsecs": 500_000_000}), 2.5)
        self.assertEqual(seconds_of({"sec": 2, "nanosec": 500_000_000}), 2.5)
        self.assertTrue(math.isnan(seconds_of({"sec": None, "nanosec": 0})))


class GraphTest(unittest.TestCase):
    """The programs on both sides of server and master."""

    @classmethod
    def setUpClass(cls):
        cls.holder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.holder.cleanup)
        cls.folder = Path(cls.holder.name)
        graph = Graph(cls.folder)
        cls.addClassCleanup(graph.master.end)
        rospy.init_node("rosbridge", disable_signals=True)

    def test_a_recording_is_performed_through_the_bridge(self):
        for version in (1, 2):
            with self.subTest(version=version):
                self.perform(version)

    def perform(self, version):
        record, report = self.folder / f"served{version}", self.folder / "report.json"
        # Slow until the first command: as many commands as are on their way then remain on their way.
        served = Program(self.folder, "serve", [PROGRAM, "ros", "serve", GOLDEN / "scene.xml", "--lockstep", "--pose", "parked",
                                                "--rate", 0.1, "--record", record])
        self.addCleanup(served.end)
        served.wait_for_output("serving baxter")
        server = RosbridgeServer(GraphTopics(version))
        self.addCleanup(server.close)
        self.photograph(["--bridge", server.address])
        if version == 1:
            self.photograph([])
        # Without a master of its own.
        performed = Program(self.folder, "perform", [
            "env", "-u", "ROS_MASTER_URI", PROGRAM, "ros", "perform", GOLDEN, "--bridge", server.address, "--speed", 0.9,
            "--max-acceleration", 30, "--tolerance", 0.3, "--yes", "--silence", 30, "--page", "--report", report,
            # ROS 2 has no actions of topics.
            *(["--start-by-trajectory"] if version == 1 else [])])
        self.addCleanup(performed.end)
        self.assertEqual(performed.wait(), 0, performed.output)
        self.assertRegex(performed.output, "right gripper closes on RedBlock\n(.*\n)+stop button: http://127.0.0.1:[0-9]+/\n(.*\n)+performed\n$")
        self.assertLess(max(one["max"] for one in json.loads(report.read_text())["joints"].values()), TOLERANCE)
        served.interrupt()
        served.wait()
        built, wanted = smile.open(record), smile.open(GOLDEN)
        np.testing.assert_allclose(built.poses[-1, 0, :3], wanted.poses[-1, 0, :3], atol=0.003)

    def photograph(self, link):
        """`touch` notes a point and the picture of the eye."""
        out = self.folder / "measured.json"
        topic = "/cameras/eye_camera/image"
        done = subprocess.run([PROGRAM, "ros", "touch", GOLDEN, "--limb", "right", "--camera", topic, "--out", out, *link],
                              input="t\n", capture_output=True, text=True, timeout=PATIENCE)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        measured = json.loads(out.read_text())
        self.assertEqual(len(measured["table"]), 1)
        camera = measured["camera"]
        self.assertEqual((camera["name"], camera["image"], camera["D"]), (topic, "measured.png", [0] * 5))
        # The middle of a picture of 320 x 200 pixels.
        np.testing.assert_allclose([camera["K"][2], camera["K"][5]], [160, 100], atol=1)
        header = (self.folder / "measured.png").read_bytes()[:24]
        self.assertEqual(struct.unpack(">2I", header[16:]), (320, 200))


if __name__ == "__main__":
    # rospy leaves sockets to the garbage collector.
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]], warnings="ignore")
