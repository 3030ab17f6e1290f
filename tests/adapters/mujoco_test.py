"""Tests SMILE's demonstrator in MuJoCo, which tools/get_mujoco.sh installs, and the program of docs/other-simulators.md.

Usage: mujoco_test.py PROJECT_FOLDER. Ends with 77 where MuJoCo is not installed.
"""

import json
import os
import re
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

PROJECT = Path(sys.argv[1]).resolve()
sys.path.append(str(PROJECT / "tests"))
from installed_mujoco import mujoco

import smile
from smile.adapters.mujoco import Demonstrator, MujocoEngine, replay
from smile.adapters.page import Page

FOLDER = tempfile.TemporaryDirectory()
os.chdir(FOLDER.name)  # MuJoCo writes a log of its warnings
MODEL = """<mujoco>
  <worldbody>
    <geom type="plane" size="2 2 .1"/>
    <body name="a" pos="0 0 .05"><freejoint/><geom type="box" size=".05 .05 .05" mass=".5"/></body>
    <body name="b" pos=".3 0 .05" euler="0 0 30"><freejoint/><geom type="box" size=".05 .05 .05" mass=".2"/></body>
    <body name="cup" pos="0 .4 .05"><freejoint/><geom type="cylinder" size=".04 .05" mass=".1"/>
      <body name="lid" pos="0 0 .06"><joint type="hinge" axis="0 1 0" range="0 90"/>
        <geom type="box" size=".04 .04 .01" mass=".3" contype="0" conaffinity="0"/></body></body>
    <body name="shelf" pos="0 -.5 .1"><geom type="box" size=".2 .1 .02"/></body>
    <body name="marker" mocap="true" pos="1 1 1"/>
  </worldbody>
</mujoco>"""


def stage():
    return Demonstrator(mujoco.MjModel.from_xml_string(MODEL))


def stack(on):
    """Puts b on a, beside its middle, turned by a quarter."""
    hand = on.hand("right")
    hand.grasp("b")
    for position in ((0.3, 0, 0.3), (0.01, 0, 0.3), (0.01, 0, 0.152)):
        hand.move_to(position)
        assert on.advance_until_arrived()
    hand.rotate((0, 0, np.pi / 2))
    assert on.advance_until_arrived()
    hand.release()
    on.advance(1)


class Hands(unittest.TestCase):
    def test_stack_two_boxes_that_stand(self):
        on = stage()
        stack(on)
        np.testing.assert_allclose(on.poses["b"][:3], [0.01, 0, 0.15], atol=0.001)
        half = np.radians((30 + 90) / 2)
        np.testing.assert_allclose(on.poses["b"][3:], [np.cos(half), 0, 0, np.sin(half)], atol=0.01)
        self.assertEqual([(row["do"], row["hand"]) for row in on.events],
                         [("grasp", "right")] + [("move", "right")] * 3 + [("rotate", "right"), ("release", "right")])

    def test_hold_what_hangs_on_a_body_without_sinking(self):
        on = stage()
        hand = on.hand("left")
        hand.grasp("cup", (0, 0.4, 0.1))
        hand.move_to((0, 0.4, 0.4))
        self.assertTrue(on.advance_until_arrived())
        on.advance(3)
        np.testing.assert_allclose(on.poses["cup"][:3], [0, 0.4, 0.35], atol=0.001)
        # It falls as soon as it is released, from rest: half g t2 within 0.1 s.
        hand.release()
        on.advance(0.1)
        self.assertAlmostEqual(on.poses["cup"][2], 0.35 - 9.81 * 0.01 / 2, delta=0.002)

    def test_stop_at_what_does_not_yield_and_push_what_does(self):
        on = stage()
        hand = on.hand()
        hand.grasp("a")
        hand.move_to((0, 0, -0.5))
        on.advance(1)
        self.assertGreater(on.poses["a"][2], 0.047)
        hand.move_to((0.3, 0, 0.06))
        self.assertTrue(on.advance_until_arrived())
        self.assertGreater(on.poses["b"][0], 0.38)

    def test_hand_over_and_free_each_other_as_in_our_own_worlds(self):
        on, ours = stage(), smile.Simulation(smile.load(PROJECT / "scenes/tower.xml", robot=None))
        first, second = ours.object_ids[-2:]
        ids = {"a": first, "b": second}
        for world, name in ((on, lambda id: id), (ours, ids.get)):
            world.hand("left").grasp(name("a"))
            world.hand("right").grasp(name("a"))
            world.hand("left").grasp(name("b"))
            world.hand("both").grasp(name("b"))
            self.assertEqual([world.hand(hand).held for hand in ("left", "right", "both", "any")],
                             [None, None, name("b"), None])
        # The releases that a grasp implies are actions of their own.
        self.assertEqual([(row["do"], row["hand"]) for row in on.events],
                         [("grasp", "left"), ("release", "left"), ("grasp", "right"), ("grasp", "left"),
                          ("release", "left"), ("release", "right"), ("grasp", "both")])
        refusals = []
        for world, name in ((on, lambda id: id), (ours, ids.get)):
            with self.assertRaises(smile.Refused) as refused:
                world.hand("any").grasp(name("a"))
            refusals.append(str(refused.exception).replace(name("b"), "b"))
        self.assertEqual(refusals, ["both hands are occupied: the pair of hands holds 'b'"] * 2)

    def test_are_refused_with_a_reason_and_without_effect(self):
        on = stage()
        before = on.hash
        hand = on.hand("left")
        for attempt, reason in (
                (lambda: hand.grasp("c"), "there is no body 'c', expected one of a, b, cup"),
                (lambda: hand.grasp("shelf"), "'shelf' is fixed (it has no joint)"),
                (lambda: hand.grasp("lid"), "'lid' has no free joint: hands carry bodies that nothing holds"),
                (lambda: hand.grasp("marker"), "'marker' is a mocap body, which only its program moves"),
                (lambda: hand.move_to((0, 0, 1)), "the left hand holds nothing"),
                (hand.destroy, f"'destroy' needs SMILE's own worlds; in MuJoCo {mujoco.__version__}, hands grasp, "
                               "move, rotate and release"),
                (on.undo, "nothing to undo"), (on.redo, "nothing to redo")):
            with self.assertRaises(smile.Refused) as refused:
                attempt()
            self.assertEqual(str(refused.exception), reason)
        with self.assertRaisesRegex(ValueError, r"point is \[0.0, nan, 0.0\], expected three finite numbers"):
            hand.grasp("a", (0, np.nan, 0))
        self.assertEqual((on.hash, on.events), (before, []))


class Drawn(unittest.TestCase):
    """Geoms in all their types, as shapes of the page."""

    def setUp(self):
        bodies = "".join(f'<body name="{kind}" pos="{k} 0 1"><freejoint/><geom type="{kind}" {size} rgba="1 .5 0 1"/></body>'
                         for k, (kind, size) in enumerate((("box", 'size=".1 .2 .3"'), ("sphere", 'size=".1"'),
                                                           ("cylinder", 'size=".1 .2"'), ("capsule", 'size=".1 .2"'),
                                                           ("ellipsoid", 'size=".1 .2 .3"'), ("mesh", 'mesh="wedge"'))))
        self.engine = MujocoEngine(mujoco.MjModel.from_xml_string(
            '<mujoco><asset><mesh name="wedge" vertex="0 0 0  .2 0 0  0 .2 0  0 0 .4"/><hfield name="hills" nrow="2" '
            'ncol="2" size="1 1 1 1"/></asset><worldbody><geom type="hfield" hfield="hills" pos="0 9 0"/>'
            f'<geom type="plane" size="0 0 .1" group="1"/><geom type="box" size="1 1 1" group="3"/>{bodies}</worldbody></mujoco>'))
        self.drawing = self.engine.drawing()

    def test_is_every_geom_that_mujocos_viewer_shows(self):
        self.assertEqual([visual.shape for visual in self.drawing.visuals],
                         ["block", "block", "sphere", "cylinder", "cylinder", "sphere", "sphere", "mesh", "mesh"])
        self.assertEqual(self.drawing.left_out, ["geoms of type hfield are not drawn"])
        self.assertEqual(self.drawing.visuals[1].color, "#ff8000")
        self.assertEqual(list(self.drawing.frame_of), ["box", "sphere", "cylinder", "capsule", "ellipsoid", "mesh"])

    def test_fills_the_same_space(self):
        np.testing.assert_allclose(self.drawing.visuals[1].size, (0.2, 0.4, 0.6))
        for visual, mesh in zip(self.drawing.visuals[-2:], self.drawing.meshes):
            count, triangles = np.frombuffer(mesh, "<u4", 2)
            corners = np.frombuffer(mesh, "<f4", 3 * count, 8).reshape(-1, 3)
            self.assertEqual((count, len(mesh)), (3 * triangles, 8 + 24 * count + 12 * triangles))
            pose = self.engine.frame_poses()[visual.frame]
            rotation = np.zeros(9)
            mujoco.mju_quat2Mat(rotation, visual.rotation)
            in_world = pose[:3] + visual.position + corners @ rotation.reshape(3, 3).T
            low, high = (-0.1, -0.2, -0.3), (0.1, 0.2, 0.3)
            if visual.frame == self.drawing.frame_of["mesh"]:
                low, high = (0, 0, 0), (0.2, 0.2, 0.4)
            np.testing.assert_allclose(in_world.min(0) - pose[:3], low, atol=1e-6)
            np.testing.assert_allclose(in_world.max(0) - pose[:3], high, atol=1e-6)

    def test_has_its_middle_below_the_objects(self):
        np.testing.assert_allclose(self.drawing.center, (2.5, 0.05, 0.7), atol=0.06)


class Paged(unittest.TestCase):
    """The page on a model, as its server has it; web/test/mujoco.test.mjs uses it with a mouse."""

    def setUp(self):
        self.told = []
        self.page = Page(stage(), folder=Path(FOLDER.name) / "demos", tell=self.told.append)
        self.addCleanup(self.page.close)

    def test_is_refused_at_no_port(self):
        with self.assertRaisesRegex(ValueError, "port is 99999, expected a whole number from 0 to 65535"):
            Page(stage(), port=99999)

    def test_answers_everything_with_a_reason(self):
        before = self.page.demonstrator.hash
        for command, reason in (
                ({"do": "destroy", "hand": "left"}, "'destroy' needs SMILE's own worlds; in MuJoCo "),
                ({"do": "grasp", "hand": "left", "object": "shelf"}, "'shelf' is fixed"),
                ({"do": "grasp", "hand": "left"}, "object"), ({"do": "grasp", "hand": 3, "object": "a"}, "hand"),
                ({"do": "move_to", "hand": "left", "position": [0, 0, 1]}, "the left hand holds nothing"),
                ({"do": "move_to", "hand": "left", "position": [0, 0, 1e300]}, "position"),
                ({"do": "drag", "hand": "left", "origin": [0, 0, 1], "direction": [0, 0, -1]}, "the left hand holds nothing"),
                ({"do": "finish"}, "there is no recording to finish"), ({"do": "undo"}, "nothing to undo"),
                ({"do": "start", "name": "../a"}, "name"), ({}, "do"), ([], ""), (None, ""), (7, ""), ("grasp", "")):
            with self.subTest(command), self.assertRaisesRegex((smile.Refused, ValueError), reason):
                self.page._command(command)
            if isinstance(command, dict) and command.get("do") in ("destroy", "grasp"):
                self.assertRegex(self.page._allowed({"do": "command", "command": command}), reason)
        self.assertRegex(self.page._allowed({"do": "load"}), "'load' needs SMILE's own worlds")
        self.assertRegex(self.page._allowed({}), "needs SMILE's own worlds")
        self.assertEqual((self.page.demonstrator.hash, self.page.demonstrator.events), (before, []))

    def test_moves_and_turns_as_the_mouse_wants(self):
        do = lambda **command: self.page._command({"hand": "right", **command})
        do(do="grasp", object="a", point=[0, 0, 1])
        do(do="rotate", angles=[0, 0, 30])
        # Lengths are in units of 0.1 m. The ray meets the plane through the goal, which is turned by 90 degrees.
        do(do="plane", angle=90)
        do(do="drag", origin=[-5, 2, 4], direction=[1, 0, 0])
        do(do="drag", origin=[3, 2, 9], direction=[0, 0, -2], level=True)
        hand = self.page._state()["hands"]["right"]
        np.testing.assert_allclose(hand["goal"], [3, 2, 4], atol=1e-3)
        np.testing.assert_allclose(hand["place"], [3, 2, 3.5], atol=1e-3)
        np.testing.assert_allclose(hand["angles"], [0, 0, 30], atol=1e-3)
        self.assertEqual((hand["object"], hand["plane"]), ("a", 90))
        with self.assertRaisesRegex(smile.Refused, "the ray is parallel to the motion plane of the right hand"):
            do(do="drag", origin=[0, 0, 4], direction=[0, 1, 0])
        self.assertTrue(self.page.demonstrator.advance_until_arrived())
        np.testing.assert_allclose(self.page.demonstrator.poses["a"][:3], [0.3, 0.2, 0.35], atol=1e-3)

    def test_writes_recordings_that_replay_also_at_its_end(self):
        for end in (lambda: self.page._command({"do": "finish"}), self.page.close):
            self.page._command({"do": "start"})
            self.page._command({"do": "grasp", "hand": "right", "object": "b", "point": [3, 0, 0.5]})
            self.page._command({"do": "move_to", "hand": "right", "position": [3, 0, 2]})
            self.page.demonstrator.advance(0.3)
            self.page._command({"do": "release", "hand": "right"})
            end()
        files = [Path(line.removeprefix("recording: ")) for line in self.told]
        self.assertEqual([file.name for file in files], ["MuJoCo-Model-1.jsonl", "MuJoCo-Model-2.jsonl"])
        for file in files:
            replayed = replay(file, mujoco.MjModel.from_xml_string(MODEL))
            self.assertEqual([row["do"] for row in replayed.events], ["grasp", "move", "release"])

    def test_advances_also_by_steps_longer_than_a_frame(self):
        on = self.page.demonstrator
        on.model.opt.timestep = 0.05
        self.page._set_speed({"factor": 0.1})
        for _ in range(2 * 30):
            self.page.update()
        self.assertAlmostEqual(on.steps, 2, delta=1)

    def test_stops_time_where_numbers_explode(self):
        on = self.page.demonstrator
        self.page._command({"do": "grasp", "hand": "right", "object": "a"})
        on.data.qvel[on.model.body("b").dofadr[0]] = 1e12
        on._last = on.engine.save()
        self.page.update()
        self.assertTrue(self.page._state()["paused"])
        self.page._command({"do": "undo"})
        self.assertEqual(on.events, [])


class Undo(unittest.TestCase):
    def test_and_redo_are_exact_at_every_action(self):
        on, again = stage(), stage()
        stack(on)
        end, rows = on.hash, len(on.events)
        for _ in range(4):  # release, rotate, the carry, grasp
            on.undo()
        self.assertEqual((on.hash, on.steps, on.events), (stage().hash, 0, []))
        on.advance(0.5)  # dropped by redo
        for _ in range(4):
            on.redo()
        self.assertEqual((on.hash, len(on.events)), (end, rows))
        # The state that undo restores continues to the same bits as one in which nothing was undone.
        on.undo()
        on.hand("right").release()
        on.advance(1)
        stack(again)
        self.assertEqual(on.hash, again.hash)


    def test_leads_back_from_numbers_that_explode(self):
        model = mujoco.MjModel.from_xml_string(MODEL)
        data = mujoco.MjData(model)
        data.qvel[model.body("b").dofadr[0]] = 1e12
        on = Demonstrator(model, data)
        before = on.hash
        on.hand().grasp("a")
        with self.assertRaisesRegex(RuntimeError, "MuJoCo reports an unstable simulation"):
            on.step()
        on.undo()
        self.assertEqual(on.hash, before)


class Recording(unittest.TestCase):
    def setUp(self):
        self.file = Path(FOLDER.name) / "stack.jsonl"

    def record(self):
        on = stage()
        stack(on)
        on.save(self.file)
        return on

    def test_replays_to_the_last_bit(self):
        on = self.record()
        replayed = replay(self.file, mujoco.MjModel.from_xml_string(MODEL))
        self.assertEqual((replayed.hash, replayed.events), (on.hash, on.events))

    def test_begins_and_ends_when_wanted(self):
        on = stage()
        stack(on)
        hand = on.hand("left")
        hand.grasp("cup")
        with self.assertRaisesRegex(smile.Refused, "hand 'left' holds 'cup'; release it first"):
            on.start()
        hand.release()
        on.start()
        self.assertEqual((on.steps, on.events, on.can_undo), (0, [], False))
        hand.grasp("cup")
        on.advance(0.1)
        on.finish(self.file)
        replayed = replay(self.file, mujoco.MjModel.from_xml_string(MODEL))
        self.assertEqual((replayed.hash, [row["do"] for row in replayed.events]), (on.hash, ["grasp"]))
        # Without a recording, time leaves nothing behind.
        rows = len(on._rows)
        on.advance(1)
        self.assertEqual(len(on._rows), rows)
        with self.assertRaisesRegex(RuntimeError, "there is no recording"):
            on.save(self.file)

    def test_names_the_first_difference(self):
        self.record()
        rows = [json.loads(line) for line in self.file.read_text().splitlines()]
        head, end = rows[0], len(rows)
        first = next(index for index, row in enumerate(rows) if "poses" in row)
        cases = [(0, {**head, "engine": "Bullet"}, ":1: engine is 'Bullet', expected 'MuJoCo "),
                 (0, {**head, "model": "0"}, ":1: model is '0', expected '"),
                 (0, {**head, "start": "AAAA"}, ":1: the state has 3 bytes, expected "),
                 (0, {"format": "demo"}, ":1: format is 'demo', expected 'smile engine recording'"),
                 (1, {**rows[1], "object": "cup"}, f":{first + 1}: step "),
                 (1, {**rows[1], "hand": "third"}, ":2: 'third' is missing or unknown"),
                 (1, {**rows[1], "step": 10**9}, ":2: step is 1000000000, expected a whole number from 0 to "),
                 (1, [], ":2: found list, expected a JSON object"),
                 (end - 1, rows[-2], f":{end}: the recording ends without its last row")]
        for index, row, message in cases:
            with self.subTest(message):
                changed = [*rows[:index], row, *rows[index + 1:]]
                self.file.write_text("".join(json.dumps(one) + "\n" for one in changed))
                with self.assertRaises(ValueError) as error:
                    replay(self.file, mujoco.MjModel.from_xml_string(MODEL))
                self.assertIn(str(self.file) + message, str(error.exception))

    def test_contains_no_change_that_others_made(self):
        on = stage()
        on.data.qpos[0] += 0.1
        with self.assertRaisesRegex(RuntimeError, "the state of MuJoCo .* was changed outside"):
            on.step()
        on = stage()
        on.model.opt.gravity[2] = -1
        with self.assertRaisesRegex(RuntimeError, "the model was changed since the start"):
            on.save(self.file)

    def test_the_program_of_the_documents_runs(self):
        text = (PROJECT / "docs/other-simulators.md").read_text().split("## Demonstrate in MuJoCo")[1]
        program = re.search(r"```python\n(.*?)```", text, re.DOTALL).group(1)
        Path("boxes.xml").write_text(MODEL)
        exec(compile(program, "docs/other-simulators.md", "exec"), {})
        self.assertTrue(Path("stack.jsonl").exists())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
