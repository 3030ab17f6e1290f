"""Tests what the brains of examples/policy know and remember beside their networks.

Usage: policy_test.py PROJECT_FOLDER.
"""

import sys
import unittest
from pathlib import Path

import numpy as np

PROJECT = Path(sys.argv[1])
sys.path.append(str(PROJECT / "examples/policy"))

import alike  # noqa: E402
import network  # noqa: E402
from deciding import Deciding  # noqa: E402

NAMES = ["Red1", "Green1", "Blue1", "Red2", "Green2", "Blue2"]
LOOKS = np.array([0, 1, 2, 0, 1, 2])
OPEN, CLOSED = 1.4, 1.0  # openings of a gripper [units]


class AlikeTest(unittest.TestCase):
    def test_the_scene_tells_which_objects_look_alike(self):
        self.assertEqual(alike.looks_of(PROJECT / "scenes/row_robot.xml", NAMES).tolist(), LOOKS.tolist())
        blocks = ["RedBlock", "GreenBlock", "BlueBlock"]
        self.assertEqual(alike.looks_of(PROJECT / "scenes/tower_robot.xml", blocks).tolist(), [0, 1, 2])

    def test_only_those_that_look_alike_take_each_others_places(self):
        columns = np.array([[300.0, 20, 10, 200, 30, 40], [1.0, 20, 40, 200, 10, 30]])
        self.assertEqual(alike.order_by(np, LOOKS, columns).tolist(), [[3, 1, 2, 0, 4, 5], [0, 4, 5, 3, 1, 2]])

    def test_names_stay_where_they_were(self):
        before = np.array([[5.0, 0, 0, 0], [0, 1, 0, 0], [0, 2, 0, 0], [3, 0, 0, 0], [1, 1, 0, 0], [1, 2, 0, 0]])
        found = before[[3, 1, 2, 0, 4, 5]] + [0.3, 0, 0, 0]
        order = alike.order_as_before(LOOKS, found, before)
        np.testing.assert_allclose(found[order], before + [0.3, 0, 0, 0])


class DecidingTest(unittest.TestCase):
    """Networks that always say the same: an arm takes object 0. If both may, the left one does."""

    def setUp(self):
        self.objects = np.array([[-3.0, 0, 0.5, 0], [-1, 1, 0.5, 0], [2, 1, 0.5, 0]])
        self.waiting = np.array([[-8.0, -6, 4, 0], [8, -6, 4, 0]])
        seen = network.seen_by(self.tools(OPEN), self.objects, 0)
        inputs = network.see(np, *seen).shape[-1], network.aim(np, seen[0], self.objects[0], seen[3]).shape[-1]
        own_arm_takes = [0.0, 9, 0, 0, 0, 0, 0, 0, 0]
        turn = np.eye(1 + 2 * network.TURNS)[network.TURNS]
        nets = {"decide": [(np.zeros((inputs[0], 9)), np.array(own_arm_takes))],
                "place": [(np.zeros((inputs[0], 1)), np.zeros(1))],
                "turn": [(np.zeros((inputs[1], len(turn))), turn)]}
        self.deciding = Deciding(nets, np.zeros((1, 2)), self.waiting)

    def tools(self, opening, place=(-8.0, -6, 4)):
        return np.array([[*place, 0, opening], [8, -6, 4, 0, OPEN]])

    def target_after(self, tools, now):
        self.deciding.update(tools, now)
        self.deciding.goals(tools, self.objects, now)
        return self.deciding.decision and self.deciding.decision[:2]

    def test_an_arm_does_not_take_again_what_it_put_down(self):
        low, high = (-3.0, 0, 0.8), (-3.0, 0, 1.8)
        self.assertEqual(self.target_after(self.tools(OPEN), 0.0), (0, 0))
        self.assertIsNone(self.target_after(self.tools(CLOSED, low), 1.0), "it goes straight up first")
        self.assertEqual(self.target_after(self.tools(CLOSED, high), 1.5), (0, 0), "where it is put")
        self.assertIsNone(self.target_after(self.tools(OPEN, low), 2.0))
        self.assertEqual(self.target_after(self.tools(OPEN, high), 2.5), (1, 0), "the other one may")

    def test_what_was_held_without_a_decision_refuses_nothing(self):
        low, high = (-3.0, 0, 0.8), (-3.0, 0, 1.8)
        self.assertEqual(self.target_after(self.tools(CLOSED, high), 0.0), (0, 0))
        self.assertIsNone(self.target_after(self.tools(OPEN, low), 1.0))
        self.assertEqual(self.target_after(self.tools(OPEN, high), 1.5), (0, 0))

    def test_what_leads_nowhere_is_decided_otherwise(self):
        self.assertEqual(self.target_after(self.tools(OPEN), 0.0), (0, 0))
        self.assertEqual(self.target_after(self.tools(OPEN), 7.5), (0, 0))
        self.assertEqual(self.target_after(self.tools(OPEN), 8.5), (1, 0))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
