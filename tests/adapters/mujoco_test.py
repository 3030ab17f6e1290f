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
from smile.adapters.mujoco import Demonstrator, replay

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
