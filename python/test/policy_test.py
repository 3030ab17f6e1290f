"""Tests what the brains of examples/policy know and remember beside their networks.

Usage: policy_test.py PROJECT_FOLDER.
"""

import sys
import unittest
from pathlib import Path
from types import SimpleNamespace

import numpy as np

PROJECT = Path(sys.argv[1])
sys.path.append(str(PROJECT / "examples/policy"))

import alike  # noqa: E402
import network  # noqa: E402
import sight  # noqa: E402
from deciding import Deciding  # noqa: E402
from eye import SURE, Eye  # noqa: E402

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


class EyeTest(unittest.TestCase):
    """An eye whose network finds an object by its color, in the cell that has most of it."""

    def setUp(self):
        copies = np.zeros((27, 3))
        copies[12:15] = np.eye(3)  # of the nine cells about it, the middle one
        colors = 20 * np.eye(3)[:, LOOKS]
        nets = {"find": [(copies, np.full(3, 0.5)), (copies, np.zeros(3)), (colors, np.zeros(len(LOOKS)))]}
        self.eye = Eye(nets, LOOKS, SimpleNamespace(cameraSize=sight.SIZE, cameraIntrinsics=np.eye(3)))

    def test_of_those_that_look_alike_the_fainter_one_is_found_too(self):
        picture = np.zeros((*sight.SIZE, 3))
        for row, column, color in ((20, 40, (0, 1, 0)), (30, 10, (0, 0.5, 0)), (5, 5, (1, 0, 0)), (5, 60, (1, 0, 0)),
                                   (50, 5, (0, 0, 1)), (50, 60, (0, 0, 1))):
            picture[row * sight.CELL:(row + 1) * sight.CELL, column * sight.CELL:(column + 1) * sight.CELL] = color
        cells, chances = self.eye.find(picture)
        columns = sight.SIZE[1] // sight.CELL
        places = [(5, 5), (30, 10), (50, 5), (5, 60), (20, 40), (50, 60)]
        self.assertEqual(cells.tolist(), [row * columns + column for row, column in places], "from left to right")
        self.assertGreater(chances.min(), SURE)

    def test_what_is_put_down_stays_where_the_gripper_opened(self):
        self.eye.seen = np.array([[0.0, 0, 0.5, 0], [5, 5, 0.5, 0]])
        for tool in ([0.1, 0, 0.8, 0, OPEN], [0.1, 0, 0.8, 0, CLOSED], [3, 2, 1.8, 0, CLOSED], [3, 2, 0.8, 0, OPEN], [6, 6, 3, 0, OPEN]):
            self.eye.follow(0, np.array(tool))
        np.testing.assert_allclose(self.eye.seen, [[2.9, 2, 0.5, 0], [5, 5, 0.5, 0]])


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
