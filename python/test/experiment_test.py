"""Tests the functions that do in Python what the commands of the program do.

Usage: experiment_test.py SMILE_PROGRAM PROJECT_FOLDER
"""

import importlib.util
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

import smile

PROGRAM, PROJECT = sys.argv[1], Path(sys.argv[2])
TOWER = PROJECT / "scenes/tower.xml"

# What it does depends on all that it senses: pictures, depth, the demonstration, joints and objects.
BRAIN = """
import numpy as np
import smile.motion

def init(aux):
    aux.watch = True
    aux.channels = ["rgb", "depth"]
    aux.imageSeconds = 0.1
    aux.number = len(aux.attention) + len(aux.demonstration)
    smile.motion.robot_of(aux)
    for arm in aux.arms:
        arm.initJoints = 0.4 * arm.minJoints + 0.6 * arm.maxJoints

def step(sensor, motor, aux):
    if "rgbVision" in sensor:
        aux.number += float(sensor.rgbVision.mean())
    if "depthVision" in sensor:
        aux.number += float(sensor.depthVision.sum())
    if sensor.demoCue:
        return
    aux.steps = aux.steps + 1 if "steps" in aux else 1
    for arm, sensed in zip(motor.arms, sensor.arms):
        arm.velocities = 0.3 * np.sin(aux.number + sensed.joints)
        arm.gripperVelocity = np.cos(aux.number)
    aux.drawMarkers = [[0, 0, aux.number % 3]]
    if aux.steps == 20:
        motor.ticks = 5
    if aux.steps == 90:
        aux.claim = "gave up"
        aux.exit = True
"""


def module_of(file):
    spec = importlib.util.spec_from_file_location(file.stem, file)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


class ExperimentTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        with smile.Simulation(smile.load(TOWER, robot=None)) as sim:
            sim.record(cls.folder / "demo", size=(64, 48), rate=2)
            hand, under = sim.hand("left"), sim.objects["BlueBlock"]
            hand.grasp("RedBlock")
            for place in ([0, 0, 0.3], [*under.position[:2], 0.3], [*under.position[:2], 0.16]):
                hand.move_to(place)
                sim.run_until("arrived")
            hand.release()
            sim.run_until("still")
            cls.demo = sim.finish()

    def program(self, *arguments):
        done = subprocess.run([PROGRAM, *map(str, arguments)], text=True, stdout=subprocess.PIPE)
        return json.loads(done.stdout)


class BrainTest(ExperimentTest):
    def imitate(self, brain, out, **options):
        return smile.imitate(self.demo, smile.load(TOWER), brain, self.folder / out, size=(64, 48),
                             pictures=False, **options)

    def test_a_function_does_the_same_bits_as_a_process(self):
        file = self.folder / "brain/brain.py"
        file.parent.mkdir()
        file.write_text(BRAIN)
        noise = {"joints": 0.01, "image": 0.02, "depth": 0.1, "seed": 7}
        there = self.imitate(file, "there", noise=noise)
        self.assertIsNone(there.brain_error)
        here = self.imitate(module_of(file), "here", noise=noise)
        self.assertGreater(len(there.recording), 100)
        np.testing.assert_array_equal(here.recording.hashes, there.recording.hashes)
        self.assertGreater(np.abs(np.ptp(here.recording.joints, axis=0)).max(), 0.05)
        here.recording.verify()
        for result in (here.result, there.result):
            del result["realtime_factor"]
        self.assertEqual(here.result, there.result)
        self.assertEqual(here.result["brain"]["claim"], {"done": False, "reason": ""})
        self.assertEqual(json.loads((here.directory / "result.json").read_text())["score"], here.score)
        self.assertFalse(here.is_success)

    def test_the_first_action_that_differs_is_named(self):
        def pushes(speed):
            def step(sensor, motor, aux):
                motor.arms[0].velocities[:] = 0.1 if sensor.simTime < 0.5 else speed
                aux.exit = sensor.simTime > 0.7
            return step

        first, same, other = (self.imitate(pushes(speed), f"speed{k}").recording
                              for k, speed in enumerate((0.2, 0.2, 0.201)))
        self.assertIsNone(first.first_difference(same))
        difference = first.first_difference(other)
        self.assertEqual(difference.command["tick"], 30)
        self.assertEqual((difference.command["left"][0], difference.other["left"][0]), (0.2, 0.201))

    def test_what_a_function_raises_is_raised_and_the_recording_whole(self):
        class Failing:
            steps = 0

            def step(self, sensor, motor, aux):
                self.steps += 1
                if self.steps == 30:
                    raise KeyError("lost")

        brain = Failing()
        with self.assertRaisesRegex(KeyError, "lost"):
            self.imitate(brain, "failed")
        self.assertEqual(brain.steps, 30)
        recording = smile.open(self.folder / "failed/imitation")
        recording.verify()
        self.assertEqual(recording.cuts, [])

        def wrong(sensor, motor, aux):
            motor.arms[0].velocities = [1, 2]

        with self.assertRaisesRegex(ValueError, r"motor.arms\[0\].velocities is 2, expected 7"):
            self.imitate(wrong, "wrong")

    def test_reports_progress_until_it_is_interrupted(self):
        steps = []

        def report(step, done, total):
            steps.append((step, done))
            if len(steps) == 3:
                raise KeyboardInterrupt

        with self.assertRaises(KeyboardInterrupt):
            self.imitate(lambda sensor, motor, aux: None, "interrupted", progress=report, seconds=3600)
        self.assertEqual(len(steps), 3)
        self.assertLess(steps[0][1], steps[2][1])

    def test_impossible_things_are_refused(self):
        with self.assertRaisesRegex(TypeError, "brain is int, expected a path, a function"):
            self.imitate(3, "none")
        with self.assertRaisesRegex(smile.SceneError, "no such brain"):
            self.imitate(self.folder / "missing.py", "none")
        with self.assertRaisesRegex(ValueError, "noise has jonits, expected joints"):
            self.imitate(print, "none", noise={"jonits": 1})
        with self.assertRaisesRegex(smile.SceneError, "Red|red"):
            smile.imitate(self.demo, PROJECT / "scenes/ball_robot.xml", print, self.folder / "none")

    def test_an_evaluation_is_that_of_the_program(self):
        brain = PROJECT / "python/examples/agents/idle.py"
        evaluation = smile.evaluate(self.demo, PROJECT / "scenes/tower_robot.xml", brain,
                                    self.folder / "evaluation", scenes=2, jobs=1,
                                    options=["--size", "64x48"])
        self.assertEqual(evaluation.success_rates, {"idle": 0})
        self.assertEqual([run["seed"] for run in evaluation.runs], [1, 2])
        self.assertEqual(evaluation.result,
                         json.loads((evaluation.directory / "evaluation.json").read_text()))
        with self.assertRaisesRegex(RuntimeError, "--keep"):
            smile.evaluate(self.demo, TOWER, brain, self.folder / "evaluation", keep="some")


    def test_a_generation_is_that_of_the_program(self):
        shown = self.folder / "shown"
        subprocess.run([PROGRAM, "run", PROJECT / "scenes/tower.xml", "--commands", PROJECT / "examples/tower.jsonl",
                        "--kinematic", "--record", shown], check=True, capture_output=True)
        options = ["--size", "64x48"]
        made = smile.generate(shown, PROJECT / "scenes/tower_robot.xml",
                              PROJECT / "python/examples/agents/true_poses.py", self.folder / "made", count=1,
                              seed=7, oracle=True, jobs=1, options=options)
        self.assertTrue(made.is_complete, made.summary)
        self.assertEqual(made.summary, json.loads((made.directory / "summary.json").read_text()))
        self.assertEqual([(one["seed"], one["outcome"]) for one in made.attempts], [(7, "success")])
        smile.open(made.episodes[0]).verify()
        none = smile.generate(shown, PROJECT / "scenes/tower_robot.xml", PROJECT / "python/examples/agents/idle.py",
                              self.folder / "none", count=1, tries=1, jobs=1, options=options)
        self.assertEqual((none.is_complete, none.episodes, len(none.attempts)), (False, [], 1))
        with self.assertRaisesRegex(RuntimeError, "--tries"):
            smile.generate(shown, TOWER, PROJECT / "python/examples/agents/idle.py", self.folder / "none", tries=0)


class RecordingTest(ExperimentTest):
    def test_a_replay_is_identical_or_names_what_differs(self):
        replay = smile.replay(self.demo)
        self.assertTrue(replay.is_identical)
        self.assertEqual((replay.ticks, replay.hash), (len(self.demo) - 1, self.demo.hashes[-1]))
        self.assertEqual(smile.replay(self.demo, 0.5, 1).ticks, 30)
        with self.assertRaisesRegex(ValueError, "1000"):
            smile.replay(self.demo, end=1000)
        lines = (self.demo.directory / "commands.jsonl").read_text().splitlines()
        other = self.folder / "other"
        other.mkdir()
        for file in self.demo.directory.iterdir():
            if file.is_file():
                (other / file.name).write_bytes(file.read_bytes())
        moves = [index for index, line in enumerate(lines) if "move_to" in line]
        move = json.loads(lines[moves[0]])
        move["position"][0] += 0.5
        lines[moves[0]] = json.dumps(move)
        (other / "commands.jsonl").write_text("\n".join(lines) + "\n")
        replay = smile.replay(other)
        self.assertFalse(replay.is_identical)
        self.assertEqual(replay.deviations[0].object, "RedBlock")
        self.assertAlmostEqual(replay.deviations[0].distance, 0.05, delta=0.02)

    def test_is_described_as_by_the_program(self):
        description = smile.describe(self.demo)
        self.assertEqual(description.structure, self.program("describe", self.demo.directory, "--json"))
        self.assertTrue(any("RedBlock on BlueBlock" in line for line in description.words),
                        description.words)

    def test_is_analyzed_as_by_the_program(self):
        counts = []
        analysis = smile.analyze(self.demo, jobs=2, progress=lambda *count: counts.append(count))
        self.assertEqual(analysis, self.program("analyze", self.demo.directory, "--json"))
        self.assertEqual(counts[0][0], "simulating")
        with self.assertRaisesRegex(ValueError, "jobs is 0, expected 1 to 256"):
            smile.analyze(self.demo, jobs=0)

    def test_is_edited_as_by_the_program(self):
        edits = [{"do": "speed", "factor": 2}]
        edited = smile.edit(self.demo, edits, self.folder / "faster", pictures=False)
        report = self.program("edit", self.demo.directory, "--speed", 2, "--dry-run", "--json")
        self.assertEqual(edited.report, report)
        self.assertLess(len(edited.recording), 0.75 * len(self.demo))
        edited.recording.verify()
        self.assertIsNone(smile.edit(self.demo, edits).recording)
        with self.assertRaisesRegex(ValueError, "segment|action|drop"):
            smile.edit(self.demo, [{"do": "drop", "first": 9, "last": 9}])
        with self.assertRaisesRegex(ValueError, "fly"):
            smile.edit(self.demo, [{"do": "fly"}])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
