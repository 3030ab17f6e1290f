"""Tests `smile ros perform --brain`: brains and the served robot on both sides of a ROS master, and of a bridge.

Usage: ros_brain_test.py PROJECT_FOLDER [TEST...], with the program in SMILE. Skipped without ROS.
"""

import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

# First: it finds ROS, or ends the test.
from ros_graph import Graph, Program

import numpy as np
import rospy
import smile
from rosbridge import GraphTopics, RosbridgeServer

PROJECT, PROGRAM = Path(sys.argv[1]), os.environ["SMILE"]
SCENE = PROJECT / "scenes/tower.xml"
IMAGE, DEPTH = "/cameras/eye_camera/image", "/cameras/eye_camera/depth"
LOOKS = """
import numpy as np

def init(aux):
    aux.initJointAngles = [[0, -0.5, 0, 1.0, 0, 0.5, 0]] * 2
    aux.imageSeconds = 0.5

def step(sensor, motor, aux):
    motor.jointVelocities[:, 0] = [0.2, -0.2]
    if "rgbVision" in sensor:
        print(sensor.rgbVision.shape, (sensor.rgbVision.max(axis=2) - sensor.rgbVision.min(axis=2) > 90).sum() > 50, flush=True)
    aux.exit = sensor.simTime > 1
"""
HANGS = """
import time

def step(sensor, motor, aux):
    motor.jointVelocities[:, 0] = [0.2, -0.2]
    if sensor.simTime > 0.5:
        time.sleep(600)
"""


class BrainGraphTest(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        cls.holder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.holder.cleanup)
        cls.folder = Path(cls.holder.name)
        subprocess.run([PROGRAM, "run", SCENE, "--commands", PROJECT / "examples/tower.jsonl", "--record", cls.folder / "demo"],
                       check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        cls.graph = Graph(cls.folder)
        cls.addClassCleanup(cls.graph.master.end)
        # For the bridges in this process.
        rospy.init_node("rosbridge", disable_signals=True)

    def cell(self, size):
        """A calibration of the served robot's eye, with a picture of a size."""
        with smile.Simulation(smile.load(SCENE)) as sim:
            seen = sim.render("eye", size)
        K = seen.intrinsics - [[0, 0, 0.5], [0, 0, 0.5], [0, 0, 0]]
        path = self.folder / "cell.json"
        path.write_text(json.dumps({
            "format": 1, "robot": "baxter", "table": {"middle": [0, 0, 0], "normal": [0, 0, 1]},
            "camera": {"name": IMAGE, "pose": seen.pose.tolist(), "K": K.ravel().tolist(), "D": [0] * 5, "width": size[0],
                       "height": size[1]}}))
        return path

    def brain(self, text):
        path = self.folder / "brain.py"
        path.write_text(text)
        return path

    def serve(self, size="320x200", *words):
        record = Path(tempfile.mkdtemp(dir=self.folder)) / "served"
        served = Program(self.folder, "serve", [PROGRAM, "ros", "serve", SCENE, "--lockstep", "--pose", "parked", "--size", size,
                                                "--record", record, *words])
        self.addCleanup(served.end)
        served.wait_for_output("serving baxter")
        return served, record

    def perform(self, *words):
        performed = Program(self.folder, "perform", [PROGRAM, "ros", "perform", SCENE, "--silence", 30, *words])
        self.addCleanup(performed.end)
        return performed

    def test_the_learner_builds_the_tower_through_the_graph(self):
        served, record = self.serve("640x480")
        report = self.folder / "report.json"
        performed = self.perform("--brain", PROJECT / "python/learner/learner.py", "--demonstration", self.folder / "demo", "--camera", IMAGE,
                                 "--depth", DEPTH, "--cell", self.cell((640, 480)), "--speed", 1, "--max-acceleration", 100, "--timeout", 60,
                                 "--yes", "--report", report)
        self.assertEqual(performed.wait(), 0, performed.output)
        self.assertRegex(performed.output, "the brain claims: done: .*\nperformed\n$")
        outcome = json.loads(report.read_text())
        self.assertEqual((outcome["performed"], outcome["claim"]["done"], len(outcome["joints"])), (True, True, 14))
        served.interrupt()
        served.wait()
        built = smile.open(record)
        wanted = smile.open(self.folder / "demo")
        heights = [dict(zip(one.object_ids, one.poses[-1, :, 2])) for one in (built, wanted)]
        for name, height in heights[1].items():
            self.assertAlmostEqual(heights[0][name], height, delta=0.002, msg=name)
        built.verify()

    def test_a_brain_sees_through_a_bridge_and_drives(self):
        served, record = self.serve()
        bridge = RosbridgeServer(GraphTopics(version=2))
        self.addCleanup(bridge.close)
        words = ("--brain", self.brain(LOOKS), "--camera", IMAGE, "--cell", self.cell((320, 200)), "--size", "160x100", "--bridge", bridge.address)
        dry = self.perform(*words, "--dry-run")
        self.assertEqual(dry.wait(), 0, dry.output)
        self.assertRegex(dry.output, "it sees 160 x 100 pixels of /cameras/eye_camera/image, .*° x .*°, without distortion\n"
                         "  the way to the posture in which it begins takes .* s\nnothing moved: this would be performed\n$")
        refused = self.perform(*words[:-4], "--size", "640x400", "--dry-run", "--bridge", bridge.address)
        self.assertEqual(refused.wait(), 2, refused.output)
        self.assertIn("the camera has 320 x 200 pixels, expected at least 640 x 400", refused.output)
        performed = self.perform(*words, "--yes", "--picture-age", 2, "--tolerance", 0.5, "--speed", 0.5)
        self.assertEqual(performed.wait(), 0, performed.output)
        self.assertIn("brain: (100, 160, 3) True\n", performed.output)
        served.interrupt()
        served.wait()
        joints = smile.open(record).joints
        self.assertAlmostEqual(joints[-1, smile.open(record).joint_names.index("left_s0")], 0.2, delta=0.05)

    def test_a_brain_that_hangs_and_ctrl_c_stop_the_robot(self):
        served, record = self.serve()
        performed = self.perform("--brain", self.brain(HANGS), "--yes", "--timeout", 3)
        self.assertEqual(performed.wait(), 1, performed.output)
        self.assertRegex(performed.output, r"stopped after 0\.5\d s: the brain failed: .*brain.py")
        performed = self.perform("--brain", PROJECT / "python/examples/wave.py", "--yes")
        performed.wait_for_output("the brain drives the robot")
        performed.interrupt()
        self.assertEqual(performed.wait(), 1, performed.output)
        self.assertRegex(performed.output, r"stopped after .* s: interrupted\n$")
        served.interrupt()
        served.wait()
        joints = smile.open(record).joints
        np.testing.assert_allclose(joints[-1], joints[-2], atol=1e-3)

    def test_what_contradicts_itself_is_refused(self):
        wave = PROJECT / "python/examples/wave.py"
        for words, code, said in (
                (("--camera", IMAGE), 2, "--camera is for a brain, expected --brain as well"),
                (("--brain", wave, "--limb", "left"), 2, "expected no --limb"),
                (("--brain", wave, "--camera", IMAGE), 2, "where the camera is must be known, expected --cell"),
                (("--brain", wave, "--depth", DEPTH), 2, "expected --camera as well"),
                (("--brain", wave, "--camera", "/other/image", "--cell", self.cell((320, 200))), 1,
                 "refused: the calibration is that of the camera '/cameras/eye_camera/image', expected /other/image")):
            refused = self.perform(*words)
            self.assertEqual(refused.wait(), code, refused.output)
            self.assertIn(said, refused.output)


if __name__ == "__main__":
    # rospy leaves sockets to the garbage collector.
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]], warnings="ignore")
