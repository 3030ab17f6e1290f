"""Tests of `smile ros perform --brain` without ROS: what a brain gets of a robot, and what stops it.

The robot is a simulated one behind the interface of a real one.

Usage: robot_brain_test.py PROJECT_FOLDER [TEST...], with the program in SMILE.
"""

import json
import math
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest.mock import patch

import numpy as np
import smile
from simulated_link import SeeingSimulatedLink
from smile.ros.brain_command import camera_of, cell_fault
from smile.ros.brain_performing import BrainPerformance, BrainTask, GripperGoal
from smile.ros.camera import depth_of
from smile.ros.camera_view import CameraView
from smile.ros.description import Opening, describe
from smile.ros.link import CameraReading, GripperReading
from smile.ros.performing import Supervisor, Watch
from smile.ros.served_robot import ServedRobot

PROJECT, PROGRAM = Path(sys.argv[1]), os.environ["SMILE"]
SCENE = PROJECT / "scenes/tower.xml"
TOPIC = "/cameras/eye_camera/image"
SIZE = (64, 48)
TOLERANCE = 0.005
"""greatest error of a joint [rad]"""
START = "aux.initJointAngles = [[0, -0.5, 0, 1.0, 0, 0.5, 0]] * 2\n"


def reading_of(rgb, K, D=(0, 0, 0, 0, 0), depth=None):
    return CameraReading(rgb, np.array(K, float), np.array(D, float), 0.0, depth)


class CameraViewTest(unittest.TestCase):
    K = np.array([[500, 0, 321.5], [0, 510, 236], [0, 0, 1.0]])

    def test_pictures_of_the_same_size_stay_as_they_are(self):
        rgb = np.random.default_rng(1).integers(0, 256, (48, 64, 3), np.uint8)
        depth = np.arange(48 * 64, dtype=np.float32).reshape(48, 64)
        view = CameraView(np.array([[50, 0, 31], [0, 50, 24], [0, 0, 1.0]]), np.zeros(5), (64, 48), (64, 48))
        np.testing.assert_array_equal(view.picture(rgb), rgb)
        np.testing.assert_array_equal(view.depths(depth), depth)
        np.testing.assert_allclose(view.intrinsics, [[50, 0, 31.5], [0, 50, 24.5], [0, 0, 1]])

    def test_the_middle_is_taken_and_pixels_are_averaged(self):
        rgb = np.random.default_rng(2).integers(0, 256, (48, 64, 3), np.uint8)
        view = CameraView(np.array([[50, 0, 31.5], [0, 50, 23.5], [0, 0, 1.0]]), np.zeros(5), (64, 48), (24, 24))
        middle = rgb[:, 8:56].reshape(24, 2, 24, 2, 3).mean(axis=(1, 3))
        np.testing.assert_allclose(view.picture(rgb), middle, atol=0.51)
        np.testing.assert_allclose(view.intrinsics, [[25, 0, 12], [0, 25, 12], [0, 0, 1]])

    def test_distortion_is_removed(self):
        """A smooth pattern of directions looks the same through the lens as without one."""
        D = np.array([-0.2, 0.05, 0.002, -0.001, 0.0])

        def pattern(a, b):
            return np.stack([127 + 100 * np.sin(6 * a), 127 + 100 * np.cos(7 * b), 127 + 100 * np.sin(4 * (a + b))], axis=-1)

        def directions(K, size, first):
            x, y = np.meshgrid(np.arange(size[0]) + first, np.arange(size[1]) + first)
            return (x - K[0, 2]) / K[0, 0], (y - K[1, 2]) / K[1, 1]

        # By a fixed point: the direction whose distorted one is that of a pixel.
        u, v = directions(self.K, (640, 480), 0)
        a, b = u, v
        for _ in range(50):
            r2 = a * a + b * b
            radial = 1 + r2 * (D[0] + r2 * D[1])
            a, b = ((u - 2 * D[2] * a * b - D[3] * (r2 + 2 * a * a)) / radial, (v - D[2] * (r2 + 2 * b * b) - 2 * D[3] * a * b) / radial)
        view = CameraView(self.K, D, (640, 480), (160, 120))
        seen = view.picture(np.rint(pattern(a, b)).astype(np.uint8))
        np.testing.assert_allclose(seen, pattern(*directions(view.intrinsics, (160, 120), 0.5)), atol=2)
        plain = CameraView(self.K, np.zeros(5), (640, 480), (160, 120)).picture(np.rint(pattern(a, b)).astype(np.uint8))
        self.assertGreater(np.abs(plain.astype(float) - seen).max(), 10)

    def test_cameras_that_do_not_fit_are_refused(self):
        with self.assertRaisesRegex(ValueError, "the camera has 640 x 480 pixels, expected at least 800 x 480: choose a smaller --size"):
            CameraView(self.K, np.zeros(5), (640, 480), (800, 480))
        with self.assertRaisesRegex(ValueError, "the lens distorts so much .* has more than 67% of its width"):
            CameraView(self.K, np.array([3.0, 0, 0, 0, 0]), (640, 480), (320, 240))
        view = CameraView(self.K, np.zeros(5), (640, 480), (320, 240))
        black = np.zeros((480, 640, 3), np.uint8)
        self.assertIsNone(view.fault_of(reading_of(black, self.K)))
        for seen, words in ((reading_of(black[:400], self.K), "a picture has 640 x 400 pixels, expected 640 x 480"),
                            (reading_of(black, self.K * 1.01), "focus or zoom of the camera have changed"),
                            (reading_of(black, self.K, depth=np.zeros((240, 320), np.float32)), "the depths have 320 x 240 pixels")):
            self.assertIn(words, view.fault_of(seen))

    def test_depths_are_read_in_both_units_and_orders(self):
        for encoding, is_big, data in (("16UC1", False, b"\xe8\x03\x00\x00\xff"), ("16UC1", True, b"\x03\xe8\x00\x00\xff"),
                                       ("32FC1", False, np.array([1, math.nan], "<f4").tobytes()),
                                       ("32FC1", True, np.array([1, -math.inf], ">f4").tobytes())):
            np.testing.assert_allclose(depth_of(encoding, 2, 1, len(data), is_big, data), [[1, 0]])
        for encoding, step, words in (("rgb8", 4, "encoding is 'rgb8', expected one of 16UC1, 32FC1"), ("16UC1", 3, "4 bytes in rows of 3")):
            with self.assertRaisesRegex(ValueError, words):
                depth_of(encoding, 2, 1, step, False, b"\0\0\0\0")


class GripperGoalTest(unittest.TestCase):

    def test_an_opening_begins_where_an_object_has_stopped_the_fingers(self):
        goal = GripperGoal(Opening(0, 0.1))

        def due(rate, percent):
            return goal.due(rate, GripperReading(0, percent, False, False))

        self.assertIsNone(due(0, 50))
        self.assertAlmostEqual(due(-0.03, 50), 49.5)
        self.assertIsNone(due(-0.03, 49.5))  # too little for a command
        self.assertAlmostEqual(due(-0.03, 49), 48.5)
        for _ in range(120):
            due(-0.03, 40)
        self.assertAlmostEqual(due(0.06, 40), 41)
        self.assertIsNone(due(0, 41))

    def test_a_slow_gripper_goes_no_farther_than_the_brain_wants(self):
        for start, rate, end in ((40, 0.3, 60), (60, -0.3, 40)):
            goal, measured = GripperGoal(Opening(0, 0.1)), float(start)
            sent = measured
            for _ in range(60):
                state = GripperReading(1, measured, True, False)
                goal.correct(state, 1)
                sent = goal.due(rate if (measured - end) * rate < 0 else 0.0, state) or sent
                measured += max(-1.0, min(1.0, sent - measured))
            self.assertAlmostEqual(measured, end, delta=6)

    def test_fingers_that_an_object_has_stopped_press_on_it(self):
        goal, state = GripperGoal(Opening(0, 0.1)), GripperReading(1, 40, False, True)
        sent = 40
        for _ in range(60):
            goal.correct(state, 1)
            percent = goal.due(-0.06, state)
            sent = sent if percent is None else percent
        self.assertEqual(sent, 0)


class BrainOnRobotTest(unittest.TestCase):
    """In this process, in simulated time."""

    @classmethod
    def setUpClass(cls):
        cls.holder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.holder.cleanup)
        cls.folder = Path(cls.holder.name)
        cls.model = smile.load(SCENE)
        cls.description = describe(cls.model)

    def brain(self, step, init=START):
        """A brain in Python: the lines of its functions."""
        path = self.folder / "brain.py"
        lines = "\n".join(f"    {line}" for line in init.splitlines()) or "    pass"
        steps = "\n".join(f"    {line}" for line in step.splitlines())
        path.write_text(f"import json, math, os, time\nimport numpy as np\n\ndef init(aux):\n{lines}\n\n"
                        f"def step(sensor, motor, aux):\n{steps}\n")
        return path

    def perform(self, brain, supervisor=None, camera=True, has_depth=False, pose="parked", link=None, **task):
        self.sim, self.lines = smile.Simulation(self.model), []
        if pose is not None:
            self.sim.apply({"do": "pose", "name": pose, "speed": 0.5})
            self.sim.run_until("arrived")
        self.link = SeeingSimulatedLink(ServedRobot(self.sim, self.description), size=SIZE, **(link or {}))
        seen = self.sim.render("eye", SIZE)
        K = seen.intrinsics - [[0, 0, 0.5], [0, 0, 0.5], [0, 0, 0]]
        cell = {"camera": {"name": TOPIC, "width": SIZE[0], "height": SIZE[1], "K": K.ravel().tolist(), "D": [0] * 5,
                           "pose": seen.pose.tolist()}}
        view = camera_of(self.link, cell, TOPIC, "depth" if has_depth else None, SIZE) if camera else None
        task = BrainTask(str(brain), camera=view, **{"speed": 1.0, "max_acceleration": 30.0, "seconds": 3.0, **task})
        performance = BrainPerformance(self.link, self.model, self.description, task, Watch(), supervisor)
        try:
            outcome = performance.perform(self.lines.append)
        finally:
            performance.close()
        json.dumps(outcome.report(task, "baxter"), allow_nan=False)
        return outcome

    def stops(self, words, brain, **more):
        """The run stops for a reason, and then the arms stand."""
        outcome = self.perform(brain, **more)
        self.assertRegex(str(outcome.reason), words)
        for _ in range(30):
            self.link.robot.step()
        for arm in self.sim.robot.arms.values():
            self.assertLess(np.abs(arm.velocities).max(), 0.01)
        return outcome

    def late(self, change):
        """A change of what a link reports that begins one second after the brain does."""
        begin = []

        def changed(tick, value):
            if not begin and "the brain drives the robot" in self.lines:
                begin.append(tick)
            return change(value) if begin and tick > begin[0] + 60 else value
        return changed

    def test_a_brain_gets_what_it_gets_in_simulation(self):
        """All fields at all steps are equal, but for rounding; and so is what the robot does."""
        out = self.folder / "values.jsonl"
        brain = self.brain(
            f"swing = math.cos(2 * math.pi * sensor.simTime)\n"
            "motor.jointVelocities[:, 0] = 0.4 * swing * np.array([1, -1])\n"
            "motor.gripperVelocities[:] = 0.5 if sensor.simTime < aux.begin + 0.5 else -0.5\n"
            "values = {name: np.asarray(value).tolist() for name, value in vars(sensor).items() if not name.startswith('_') and name not in ('trackerLoc', 'heldObject')}\n"
            "values.update({name: place.tolist() for name, place in sensor.trackerLoc.items()})\n"
            "values.update({f'pose {k}': arm.endEffector.tolist() for k, arm in enumerate(sensor.arms)})\n"
            "values['rgbVision'] = np.asarray(sensor.rgbVision).tolist() if 'rgbVision' in sensor else None\n"
            "print(json.dumps(values), file=aux.out, flush=True)\n"
            "aux.exit = sensor.simTime > 1",
            START + f"aux.out = open({str(out)!r}, 'w')\naux.begin = 0\naux.imageSeconds = 0.1\n"
            "constants = {name: np.asarray(getattr(aux, name)).tolist() for name in ('minJointAngles', 'maxJointAngles', 'robotBase', "
            "'cameraIntrinsics', 'cameraPose', 'cameraSize', 'unit', 'tickSeconds', 'robotGripper')}\n"
            "print(json.dumps(constants), file=aux.out)")
        # In simulation nothing moves while a brain computes: here its answers count as being in time, on a loaded machine, too.
        with patch("smile.ros.brain_performing._ANSWER_PART", 300):
            outcome = self.perform(brain, link={"ticks": 1})
        self.assertIsNone(outcome.reason)
        self.assertEqual(outcome.waits["brain"], 0)
        self.assertEqual(outcome.num_pictures, 11)
        on_robot = [json.loads(line) for line in out.read_text().splitlines()]
        subprocess.run([PROGRAM, "run", SCENE, "--brain", brain, "--size", "64x48"], check=True, stdout=subprocess.DEVNULL)
        simulated = [json.loads(line) for line in out.read_text().splitlines()]
        self.assertEqual(len(on_robot), len(simulated))
        for robot, simulation in zip(on_robot, simulated):
            self.assertEqual(robot.keys(), simulation.keys())
            for name, value in robot.items():
                if isinstance(value, str) or value is None or name == "isHolding":
                    self.assertEqual(value, simulation[name], name)
                else:
                    # Measured velocities are averages over the last tick. Pixels at edges differ.
                    np.testing.assert_allclose(value, simulation[name], err_msg=name, atol={
                        "rgbVision": 255, "jointVelocities": 0.3, "gripperOpening": 0.05}.get(name, 0.02))
                if name == "rgbVision" and value is not None:
                    self.assertLess(np.abs(np.subtract(value, simulation[name])).mean(), 1)

    def test_brains_in_all_languages_drive_it(self):
        for brain in ("python/examples/wave.py", "matlab/examples/wave", Path(PROGRAM).with_name("smile_wave")):
            with self.subTest(brain=str(brain)):
                outcome = self.perform(PROJECT / brain, seconds=1.0)
                self.assertRegex(outcome.reason, "^the time limit of 1 s was reached$")
                self.assertLess(max(one["max"] for one in outcome.tracking.summary().values()), TOLERANCE)
                # After a quarter of a wave: 0.4 rad/s * 2 / pi * 1 s.
                self.assertAlmostEqual(self.sim.robot.arms["left"].q[0], 0.8 / math.pi, delta=0.02)
                self.assertEqual(self.lines[-1].partition(":")[0] if brain else "", "brain")

    def test_the_clock_of_a_brain_runs_at_the_speed(self):
        brain = self.brain("motor.jointVelocities[0, 0] = 0.4\naux.exit = sensor.simTime >= 0.99\n"
                           "if aux.exit: print(f'{sensor.simTime:.2f} {sensor.jointVelocities[0, 0]:.2f}')")
        outcome = self.perform(brain, speed=0.4)
        self.assertIsNone(outcome.reason)
        self.assertAlmostEqual(outcome.seconds, 1, delta=0.05)
        self.assertIn("brain: 1.00 0.40", self.lines)
        self.assertAlmostEqual(self.sim.robot.arms["left"].q[0], 0.4, delta=0.02)
        # Without the time in which the arms waited for the brain, on a loaded machine.
        self.assertAlmostEqual(len(outcome.tracking.times) / 60 - outcome.waits["brain"], 2.5, delta=0.1)

    def test_velocities_are_limited_as_in_simulation(self):
        outcome = self.perform(self.brain("motor.jointVelocities[0, 0] = 2.5\naux.exit = sensor.simTime >= 0.19"))
        self.assertIsNone(outcome.reason)
        self.assertAlmostEqual(self.sim.robot.arms["left"].q[0], 0.3, delta=0.03)  # at 1.5 rad/s

    def test_what_no_robot_can_do_is_refused(self):
        for step, init, words in (
                ("motor.jointAngles = [[0] * 7] * 2", "", "motor puts the left arm at joint angles at once, which no real arm can"),
                ("motor.headVelocity = 0.1", "", "motor.headVelocity moves the head, which is not connected: expected 0"),
                ("pass", "aux.channels = ['rgb', 'depth']", "aux.channels asks for depth, but the camera has none"),
                ("pass", "aux.channels = ['segmentation']", "aux.channels asks for segmentation, which no real camera has"),
                ("pass", "aux.cameras = ['left_hand']", "left_hand")):
            with self.subTest(words):
                self.assertEqual(self.stops(f"^the brain failed: .*{words}", self.brain(step, init)).seconds, 0)

    def test_faulty_brains_stop_the_robot(self):
        moving = "motor.jointVelocities[:, 0] = 0.4 * np.array([1, -1])\nif sensor.simTime > 0.5:\n    "
        for step, words in (
                ("raise ValueError('lost')", "the brain failed: .*brain.py:[0-9]+: ValueError: lost"),
                ("motor.jointVelocities[0, 0] = math.nan", r"the brain failed: .*motor.jointVelocities\[0, 0\] is nan"),
                ("os._exit(3)", "the brain failed: .*(ended|lost|exit)"),
                ("time.sleep(60)", "the brain failed: .*no answer .* within 0.5 s|the brain failed: .*(late|longer|timeout|0.5 s)"),
                ("motor.jointVelocities[0, 0] = 9", r"the brain asks left_s0 for 9\.00 rad/s, expected up to 1\.5"),
                ("motor.jointVelocities[0, 0] = -1.4", r"accelerates left_s0 by .* rad/s², expected up to 15; --speed 0\.9"),
                ("motor.jointVelocities[:, 3] = -1.2", "the brain drives left_e1 to -0.0[0-9]+ rad, expected -0.05")):
            with self.subTest(words):
                # The others need not be quick on a busy machine.
                timeout = 0.5 if "sleep" in step else 5.0
                self.stops(words, self.brain(moving + step), timeout=timeout, max_acceleration=15.0)

    def test_the_table_and_the_room_around_it_are_left_alone(self):
        for step, init, words in (
                ("motor.jointVelocities[:, 1] = 0.6", START, "(tool to .* m, outside of the workspace from|would touch the table)"),
                ("motor.jointVelocities[:, 1] = -0.6", START, r"the brain drives the \w+ tool to .* outside of the workspace .* at \d"),
                ("motor.jointVelocities[:, 0] = 1.2 * np.array([-1, 1])", "aux.initJointAngles = [[0, -0.5, 0, 0.3, 0, 0.2, 0]] * 2",
                 "the brain drives the arms to where .* would touch left_")):
            with self.subTest(words):
                self.stops(words, self.brain(step, init))

    def test_lost_and_faulty_pictures_stop_the_robot(self):
        brain = self.brain("motor.jointVelocities[0, 0] = 0.2")
        last = []

        def freeze(seen):
            last.append(seen)
            return last[0]

        for change, words in ((freeze, "no picture of /cameras/eye_camera/image for 2 s that is newer than 0.1 s"),
                              (lambda seen: seen._replace(intrinsics=seen.intrinsics * 1.1),
                               "/cameras/eye_camera/image: camera_info has other intrinsics")):
            with self.subTest(words):
                outcome = self.stops(words, brain, link={"blur": self.late(change)}, seconds=60.0)
                self.assertGreater(outcome.num_pictures, 2)

    def test_the_arms_wait_for_a_new_picture(self):
        brain = self.brain("motor.jointVelocities[0, 0] = 0.2\naux.exit = sensor.simTime > 1", START + "aux.imageSeconds = 0")
        outcome = self.perform(brain, link={"ticks": 12})
        self.assertIsNone(outcome.reason)
        self.assertGreater(outcome.waits["pictures"], 0.3)
        self.assertAlmostEqual(self.sim.robot.arms["left"].q[0], 0.2, delta=0.02)

    def test_faulty_joint_states_and_the_button_stop_the_robot(self):
        brain = self.brain("motor.jointVelocities[0, 0] = 0.2")

        class Button(Supervisor):
            def must_stop(self):
                return "the button was pressed" if self.seconds > 0.5 else None

            def show(self, phase, seconds, duration, error):
                self.seconds = seconds if phase == "The brain drives" else 0

        button = Button()
        button.seconds = 0
        self.stops("^the button was pressed$", brain, supervisor=button)
        for change, words in ((lambda reading: None, "no joint states for 0.5 s"),
                              (lambda reading: reading._replace(time=reading.time + 1), r"time jumped by 1\.\d+ s"),
                              (lambda reading: reading._replace(positions={**reading.positions, "left_s0": math.nan}), "left_s0 is nan")):
            with self.subTest(words):
                self.stops(words, brain, link={"damage": self.late(change)}, seconds=60.0)

    def test_a_cell_must_be_that_of_the_robot_and_the_camera(self):
        cell = {"format": 1, "robot": "baxter", "table": {"middle": [0, 0, 0], "normal": [0, 0, 1]}}
        self.assertIsNone(cell_fault(cell, self.model, self.description, None))
        self.assertIn("the calibration has no camera", cell_fault(cell, self.model, self.description, TOPIC))
        cell["camera"] = {"name": "/other"}
        self.assertIn("that of the camera '/other', expected", cell_fault(cell, self.model, self.description, TOPIC))
        cell["table"]["middle"] = [0, 0, 0.02]
        self.assertIn("20 mm higher", cell_fault(cell, self.model, self.description, TOPIC))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
