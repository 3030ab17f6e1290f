"""Tests the simulator in Python: what it does is what the program does, to the last bit.

Usage: simulator_test.py SMILE_PROGRAM PROJECT_FOLDER
"""

import base64
import importlib
import json
import os
import pickle
import random
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import urllib.request
from pathlib import Path

import numpy as np
from hands import put_on

import smile
import smile.motion

PROGRAM, PROJECT = sys.argv[1], Path(sys.argv[2])
TOWER = PROJECT / "scenes/tower.xml"
PLACE = [0.3, 0.2, 0.2]


def tower(robot=None):
    return smile.Simulation(smile.load(TOWER, robot=robot))


def lift(sim, name, position=PLACE):
    hand = sim.hand("left")
    hand.grasp(name)
    hand.move_to(position)
    sim.run_until("arrived")
    return hand


class HandsTest(unittest.TestCase):
    def test_an_object_is_carried_released_and_put_back_exactly(self):
        sim = tower()
        name = sim.object_ids[0]
        sim.step(10)
        before, pose = sim.hash, sim.objects[name].pose
        hand = lift(sim, name)
        self.assertEqual(hand.held, name)
        np.testing.assert_allclose(sim.objects[name].position, PLACE, atol=1e-3)
        self.assertGreater(np.abs(sim.objects[name].position - pose[:3]).max(), 0.05)
        hand.rotate([0, 0, np.pi / 2])
        sim.run_until("arrived")
        hand.release()
        sim.run_until("still")
        self.assertEqual([event["kind"] for event in sim.events], ["grasped", "released"])
        self.assertLess(sim.objects[name].position[2], 0.1)
        sim.undo()
        sim.undo()
        self.assertEqual((sim.hash, sim.tick, sim.events), (before, 10, []))
        np.testing.assert_array_equal(sim.objects[name].pose, pose)

    def test_a_refused_command_says_why_and_changes_nothing(self):
        sim = tower()
        before = sim.hash
        with self.assertRaisesRegex(smile.Refused, "holds nothing|empty"):
            sim.hand("right").move_to(PLACE)
        with self.assertRaisesRegex(smile.Refused, "nothing|no object"):
            sim.hand("right").grasp("nothing")
        self.assertEqual(sim.hash, before)

    def test_a_wait_that_never_ends_times_out(self):
        sim = tower()
        with self.assertRaisesRegex(TimeoutError, "never.* within 0.5 s"):
            def never(_):
                return False
            sim.run_until(never, timeout=0.5)
        self.assertEqual(sim.tick, 30)


class StatesTest(unittest.TestCase):
    def test_another_process_continues_with_the_same_bits(self):
        sim = tower(robot="tern")
        lift(sim, sim.object_ids[0])
        sim.robot.move_to_pose("ready")
        sim.step(7)
        state = sim.save()
        sim.step(100)
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "state.pickle"
            file.write_bytes(pickle.dumps(state))
            program = (
                "import pickle, sys, smile\n"
                f"sim = smile.Simulation(smile.load({str(TOWER)!r}, robot='tern'))\n"
                "sim.restore(pickle.load(open(sys.argv[1], 'rb')))\n"
                "sim.step(100)\n"
                "print(sim.hash)\n")
            there = subprocess.run([sys.executable, "-c", program, file], check=True, text=True,
                                   stdout=subprocess.PIPE).stdout
        self.assertEqual(int(there), sim.hash)
        sim.restore(state)
        sim.step(100)
        self.assertEqual(int(there), sim.hash)

    def test_a_state_of_another_scene_is_refused(self):
        state = bytes(tower().save())
        other = smile.Simulation(smile.load(PROJECT / "scenes/row.xml", robot=None))
        with self.assertRaisesRegex(ValueError, "another scene"):
            other.restore(state)
        with self.assertRaisesRegex(ValueError, "another scene"):
            other.restore(tower().save())
        with self.assertRaisesRegex(ValueError, "truncated or damaged"):
            tower().restore(state[:-1] + b"x")


class RecordingTest(unittest.TestCase):
    def test_a_recording_made_in_python_replays_and_is_read_as_it_was(self):
        with tempfile.TemporaryDirectory() as folder:
            sim = tower(robot="tern")
            sim.step(5)
            sim.record(Path(folder) / "demo", size=(64, 48), title="by Python")
            hand = lift(sim, sim.object_ids[0])
            poses, hashes, events = [], [], sim.events
            hand.release()
            sim.run_until("still")
            sim.undo()
            hand.release()
            for _ in range(30):
                poses.append(sim.poses)
                hashes.append(sim.hash)
                sim.step()
            events = sim.events
            demo = sim.finish()
            report = subprocess.run([PROGRAM, "replay", demo.directory, "--verify"], text=True,
                                    stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            self.assertEqual(report.returncode, 0, report.stdout)
            self.assertIn("identical", report.stdout)
            demo.verify()
            self.assertEqual((demo.title, demo.object_ids), ("by Python", sim.object_ids))
            self.assertEqual((demo.times[0], demo.ticks[0]), (0, 5))
            np.testing.assert_array_equal(demo.hashes[-30:-1], hashes[1:])
            np.testing.assert_allclose(demo.poses[-30:-1], poses[1:], atol=1e-12)
            self.assertEqual(demo.joints.shape, (len(demo), len(demo.joint_names)))
            self.assertEqual(demo.events, events)
            self.assertEqual([action.words.split()[2] for action in demo.actions],
                             ["takes", "drops"])
            last = demo.at(float(demo.times[-1]))
            np.testing.assert_array_equal(last.render(size=(40, 30)).rgb,
                                          sim.render(size=(40, 30)).rgb)
            with self.assertRaisesRegex(ValueError, "expected a number from 0 to"):
                demo.at(1000)
            # The robot stands still, so that each frame shows its moment.
            for time, picture in zip(demo.frames.times, demo.video, strict=True):
                np.testing.assert_array_equal(picture, demo.at(time).render(size=(64, 48)).rgb)
            np.testing.assert_array_equal(demo.frames[-2:], demo.video[-2:])
            with self.assertRaisesRegex(IndexError, "expected less than"):
                demo.frames[len(demo.frames)]

    def test_what_is_no_recording_is_refused(self):
        with self.assertRaisesRegex(smile.SceneError, "demo.json"):
            smile.open(PROJECT / "scenes")


class TaskTest(unittest.TestCase):
    def test_what_was_shown_counts_in_another_layout_and_nothing_else(self):
        with tempfile.TemporaryDirectory() as folder:
            sim = tower()
            sim.record(Path(folder) / "demo", pictures=False)
            put_on(sim, "RedBlock", "BlueBlock")
            demo = sim.finish()
            elsewhere = smile.Simulation(smile.load(TOWER, robot=None).laid_out(3, "scattered"))
            self.assertGreater(np.abs(elsewhere.poses - tower().poses).max(), 0.05)
            task = smile.Task(demo, elsewhere)
            self.assertEqual(sorted(task.object_ids), ["BlueBlock", "RedBlock"])
            self.assertLess(task.compare().score, 1)
            put_on(elsewhere, "GreenBlock", "BlueBlock")
            self.assertFalse(task.compare().is_achieved)
            elsewhere.undo()
            elsewhere.undo()
            put_on(elsewhere, "RedBlock", "BlueBlock")
            done = task.compare()
            self.assertTrue(done.is_achieved, done)
            self.assertLess(done.errors["RedBlock"].distance, 0.005)
            self.assertEqual(done.match["RedBlock"], "RedBlock")
            elsewhere.close()
            with self.assertRaisesRegex(RuntimeError, "closed"):
                task.compare()
            with self.assertRaisesRegex(smile.SceneError, "Red|red"):
                smile.Task(demo, smile.Simulation(smile.load(PROJECT / "scenes/ball.xml", None)))


    def test_a_restored_state_takes_back_what_a_task_observed(self):
        with tempfile.TemporaryDirectory() as folder:
            sim = tower()
            sim.record(Path(folder) / "demo", pictures=False)
            put_on(sim, "RedBlock", "BlueBlock")
            demo = sim.finish()
            model = smile.load(TOWER, robot=None).laid_out(3, "scattered")
            sim = smile.Simulation(model)
            early, task = sim.save(), smile.Task(demo, sim)
            start = sim.save()
            put_on(sim, "RedBlock", "BlueBlock")
            sim.hand("left").grasp("RedBlock")
            held, is_held = sim.save(), task.compare()
            self.assertLess(is_held.score, 1)
            sim.hand("left").release()
            sim.run_until("still")
            done = sim.save()
            self.assertTrue(task.compare().is_achieved)
            # In the same simulation, and as bytes in another one that has the same task.
            other = smile.Simulation(model)
            for one, its in ((sim, task), (other, smile.Task(demo, other))):
                for state, achieved in ((start, False), (bytes(done), True), (held, False), (done, True),
                                        (pickle.loads(pickle.dumps(held)), False)):
                    one.restore(state)
                    self.assertEqual(its.compare().is_achieved, achieved)
                self.assertEqual(its.compare(), is_held)
            # A state without the task does not say what happened in it.
            for state in (early, bytes(early)):
                sim.restore(state)
                with self.assertRaisesRegex(RuntimeError, "before this task began"):
                    task.compare()
            self.assertLess(smile.Task(demo, sim).compare().score, 1)
            sim.restore(done)
            self.assertTrue(task.compare().is_achieved)
            damaged = bytearray(bytes(held))
            damaged[20] ^= 1
            with self.assertRaisesRegex(ValueError, "truncated or damaged"):
                sim.restore(bytes(damaged))
            self.assertTrue(task.compare().is_achieved)


class InterruptTest(unittest.TestCase):
    def test_ctrl_c_ends_a_long_step_after_a_tick(self):
        sim = tower(robot="tern")
        for advance in (lambda: sim.step(10**8), lambda: sim.run_until(lambda _: False, 10**6)):
            timer = threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT))
            timer.start()
            with self.assertRaises(KeyboardInterrupt):
                advance()
            timer.join()
        alone = tower(robot="tern")
        alone.step(sim.tick)
        self.assertEqual(alone.hash, sim.hash)


class ViewerTest(unittest.TestCase):
    """The page itself is tested in a browser: web/test/viewer.test.mjs."""

    def test_a_simulation_is_shown_at_a_link_and_computes_the_same_bits(self):
        sim, alone = tower(), tower()
        with smile.studio(sim) as studio:
            self.assertIs(smile.studio(sim), studio)
            self.assertIn(f'<iframe src="{studio.url}"', studio._repr_html_())
            with urllib.request.urlopen(studio.url + "scenes") as answer:
                self.assertEqual(json.load(answer), {"scenes": [], "presets": []})
            for one in (sim, alone):
                put_on(one, "RedBlock", "BlueBlock")
            self.assertEqual(sim.hash, alone.hash)
            sim.close()
            studio.show(alone)
            alone.step(1)
        self.assertEqual(repr(studio), "<Studio: closed>")
        with self.assertRaisesRegex(RuntimeError, "the studio is closed"):
            studio.show(alone)
        with self.assertRaisesRegex(RuntimeError, "the simulation is closed"):
            smile.studio(sim)
        alone.step(1)

    def test_time_passes_no_faster_than_it_should(self):
        sim = tower()
        studio = smile.studio(sim, speed=4)
        begin = time.monotonic()
        sim.step(60)
        self.assertGreater(time.monotonic() - begin, 0.2)
        with smile.studio(sim, height=90) as another:
            self.assertTrue(studio.is_closed)
            self.assertIn('height="90"', another._repr_html_())
            begin = time.monotonic()
            sim.step(10_000)
            self.assertLess(time.monotonic() - begin, 41)

    def test_mistakes_are_named(self):
        sim = tower()
        for arguments, words in (({"port": 70000}, "0 to 65535"), ({"speed": float("nan")}, "speed is nan"),
                                 ({"speed": -1}, "speed is -1"), ({"speed": 1e-9}, "0.01 to 1000"),
                                 ({"height": 0.5}, "height is 0.5")):
            with self.assertRaisesRegex(ValueError, words):
                smile.studio(sim, **arguments)
        with self.assertRaisesRegex(TypeError, "expected a smile.Simulation"):
            smile.studio(sim.model)


class PicturesTest(unittest.TestCase):
    def test_an_object_is_seen_where_the_camera_projects_it(self):
        sim = tower()
        picture = sim.render("eye", size=(200, 150), channels=("rgb", "depth", "id"))
        self.assertEqual((picture.rgb.shape, picture.rgb.dtype), ((150, 200, 3), np.uint8))
        self.assertEqual((picture.depth.shape, picture.depth.dtype), ((150, 200), np.float32))
        for index, name in enumerate(sim.object_ids):
            in_camera = np.linalg.inv(picture.pose) @ [*sim.objects[name].position, 1]
            u, v, _ = picture.intrinsics @ in_camera[:3] / in_camera[2]
            self.assertEqual(picture.id[int(v), int(u)], index + 2)
            self.assertAlmostEqual(picture.depth[int(v), int(u)], in_camera[2], delta=0.1)
        self.assertIsNone(sim.render(size=(8, 8)).depth)
        self.assertTrue(picture.to_png().startswith(b"\x89PNG"))
        np.testing.assert_array_equal(np.asarray(picture), picture.rgb)

    def test_a_view_for_people_and_unknown_cameras(self):
        sim = tower(robot="tern")
        self.assertGreater(sim.render("close", size=(40, 30)).rgb.max(), 100)
        with self.assertRaisesRegex(ValueError, "expected .*eye"):
            sim.render("nowhere")


    def test_a_recording_is_shown_as_its_film(self):
        with tempfile.TemporaryDirectory() as folder:
            sim = tower()
            sim.record(Path(folder) / "demo", pictures=False, title="<red> & blue")
            put_on(sim, "RedBlock", "BlueBlock")
            demo = sim.finish()
            demo.film(Path(folder) / "film.mp4", size=(64, 48), rate=5)
            self.assertEqual((Path(folder) / "film.mp4").read_bytes()[4:8], b"ftyp")
            html = demo._repr_html_()
            self.assertIn("&lt;red&gt; &amp; blue", html)
            film = base64.b64decode(html.partition("base64,")[2].partition('"')[0])
            self.assertEqual(film[4:8], b"ftyp")
            self.assertLess(len(html), 1_000_000)
            with self.assertRaisesRegex(ValueError, "speed is 0"):
                demo.film(Path(folder) / "film.mp4", speed=0)
            with self.assertRaisesRegex(ValueError, "expected .*eye"):
                demo.film(Path(folder) / "film.mp4", camera="nowhere")


class RobotTest(unittest.TestCase):
    def test_joints_move_as_commanded(self):
        sim = tower(robot="tern")
        arm = next(iter(sim.robot.arms.values()))
        start = arm.q
        arm.move(np.full(len(start), 0.1), gripper=0.0)
        sim.step(60)
        np.testing.assert_allclose(arm.q - start, 0.1, atol=0.01)
        arm.set_q(start)
        np.testing.assert_allclose(arm.q, start, atol=1e-12)
        with self.assertRaisesRegex(ValueError, r"velocities has shape \(2,\), expected \(6,\)"):
            arm.move([0, 0])
        with self.assertRaisesRegex(ValueError, r"angles\[1\] is not finite"):
            arm.set_q([0, np.nan, 0, 0, 0, 0])


class MistakesTest(unittest.TestCase):
    def test_a_faulty_scene_has_an_error_with_each_place(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "wrong.xml"
            file.write_text(TOWER.read_text().split("\n")[1] + '\n<block id="a" mass="-1"/>\n<blok/>\n</tabletop>\n')
            with self.assertRaises(smile.SceneError) as caught:
                smile.load(file, robot=None)
        lines = [(one.file, one.line) for one in caught.exception.diagnostics]
        self.assertTrue({(str(file), 2), (str(file), 3)} <= set(lines), caught.exception)

    def test_the_kind_of_an_error_does_not_depend_on_other_modules(self):
        importlib.import_module("smile.motion")  # its errors are ValueErrors
        with self.assertRaises(smile.SceneError):
            smile.load(PROJECT / "scenes/none.xml")

    def test_a_closed_simulation_refuses_everything(self):
        sim = tower()
        sim.close()
        sim.close()
        for use in (sim.step, sim.save, lambda: sim.tick, lambda: sim.objects, sim.render):
            with self.assertRaisesRegex(RuntimeError, "closed"):
                use()

    def test_two_threads_at_a_time_are_refused_and_one_after_the_other_are_not(self):
        sim = tower()
        worker = threading.Thread(target=sim.step, args=(200_000,))
        worker.start()
        refused = False
        while worker.is_alive() and not refused:
            try:
                _ = sim.tick
            except RuntimeError as error:
                refused = "another thread" in str(error)
        worker.join()
        self.assertTrue(refused)
        # Pictures, too: each thread has a renderer of its own.
        here, there = sim.render(size=(8, 8)).rgb, []
        worker = threading.Thread(target=lambda: there.append(sim.render(size=(8, 8)).rgb))
        worker.start()
        worker.join()
        np.testing.assert_array_equal(here, there[0])

    def test_a_recording_with_pictures_goes_on_and_ends_in_another_thread(self):
        with tempfile.TemporaryDirectory() as folder:
            recordings = []
            for name in ("here", "there"):
                sim = tower()
                sim.record(Path(folder) / name, size=(32, 24), rate=60)
                sim.step(2)
                sim.hand("left").grasp("RedBlock")
                sim.hand("left").move_to(PLACE)
                work = lambda sim=sim: (sim.step(30), recordings.append(sim.finish()), sim.close())  # noqa: E731
                if name == "here":
                    work()
                    continue
                sim.render(size=(8, 8))  # holds the context of this thread
                worker = threading.Thread(target=work)
                worker.start()
                worker.join()
            here, there = (recording[-1].render(size=(32, 24)).rgb for recording in recordings)
            np.testing.assert_array_equal(here, there)
            for recording in recordings:
                recording.verify()
            # One that is given up is destroyed in any thread.
            sim = tower()
            sim.record(Path(folder) / "left", size=(32, 24))
            sim.step(2)
            worker = threading.Thread(target=sim.close)
            worker.start()
            worker.join()

    def test_messages_survive_paths_and_names_of_any_bytes(self):
        with self.assertRaisesRegex(KeyError, r"\\xff"):
            tower()._native.pose(b"\xff")
        with self.assertRaisesRegex(smile.SceneError, r"\\xff\\xfe: is not a recording"):
            smile.open(b"\xff\xfe")
        with self.assertRaisesRegex(ValueError, r"\\xff\\xfe"):
            smile.load(b"\xff\xfe")
        with self.assertRaisesRegex(ValueError, r"\\xff\\xfe"):
            smile.motion.Robot(b"\xff\xfe")

    def test_objects_of_a_closed_simulation_can_be_shown(self):
        sim = tower()
        block = sim.objects["RedBlock"]
        sim.close()
        self.assertEqual(repr(block), "<Object RedBlock: the simulation is closed, expected an open one>")

    def test_nothing_that_python_passes_crashes(self):
        rng = random.Random(1)
        values = [None, -1, 0, 1, 10**20, 1.5, float("nan"), float("inf"), "", "left", "\0", "RedBlock", [],
                  [0, 0, 0], [1e300] * 3, [[1, 2, 3]], {}, object(), b"", b"SMILESIM", ("rgb",), (3, 2),
                  {"do": "spawn", "xml": "<world><block/></world>"}, {"do": "clear"}]
        sim = tower(robot="tern")
        things = [sim, sim.hand("left"), sim.hand("both"), sim.robot,
                  *sim.robot.arms.values(), *sim.objects.values()]
        for _ in range(3000):
            thing = rng.choice(things)
            name = rng.choice([name for name in dir(type(thing)) if not name.startswith("_")])
            if name in ("close", "record", "finish"):
                continue
            arguments = [rng.choice(values) for _ in range(rng.randrange(4))]
            if name == "step":
                arguments = [rng.choice([-1, 0, 3, "a", 1.5, True])]
            if name == "run_until":
                arguments = [rng.choice(values), 0.1]
            try:
                member = getattr(thing, name)
                if callable(member):
                    member(*arguments)
            except (ValueError, TypeError, KeyError, RuntimeError, TimeoutError):
                pass
        self.assertGreater(sim.tick, 0)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
