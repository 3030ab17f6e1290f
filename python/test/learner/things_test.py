"""Tests areas on the table, and the faces on which objects rest."""

import math
import unittest

import numpy as np

from scenes import BROWN, block
from things.areas import overlap
from things.resting import resting_at, turns_between


class AreasTest(unittest.TestCase):
    def test_overlap_agrees_with_points_inside_both(self):
        random = np.random.default_rng(1)
        share = np.stack(np.meshgrid(*[np.linspace(-0.5, 0.5, 41)] * 2), -1).reshape(-1, 2)
        one = np.array([0.3, -0.2, 2.0, 0.7, 0.4])
        many = np.column_stack([random.uniform(-2.5, 2.5, (300, 2)),
                                random.uniform(0.5, 3, (300, 2)), random.uniform(-4, 4, 300)])
        answers = overlap(one, many)
        np.testing.assert_array_equal(overlap([one, many[0]], many),
                                      np.transpose([answers, overlap(many[0], many)]))
        for rectangle, answer in zip(many, answers):
            def has_common_point(grow):
                sides = rectangle[2:4] + grow
                c, s = np.cos(rectangle[4]), np.sin(rectangle[4])
                points = (share * sides) @ [[c, s], [-s, c]] + rectangle[:2] - one[:2]
                c, s = np.cos(one[4]), np.sin(one[4])
                inside = np.abs(points @ [[c, -s], [s, c]]) <= (one[2:4] + grow) / 2
                return inside.all(axis=1).any()

            # Points lie up to 0.08 apart, so as much larger or smaller ones bracket the truth.
            if has_common_point(-0.15):
                self.assertTrue(answer, rectangle)
            if not has_common_point(0.15):
                self.assertFalse(answer, rectangle)
        self.assertGreater(answers.sum(), 50)
        self.assertGreater((~answers).sum(), 50)


class RestingTest(unittest.TestCase):
    plank = block(BROWN, np.array([3, 1, 0.5]), -2, 0)

    def test_an_object_on_its_side_looks_like_another_block(self):
        for angles, size, yaw in (([0, 0, 30], [3, 1, 0.5], 30), ([90, 0, 30], [3, 0.5, 1], 30),
                                  ([-90, 0, 30], [3, 0.5, 1], 30), ([0, -90, 20], [1, 0.5, 3], 110),
                                  ([45, 0, 0], [3, 1, 0.5], 0)):
            found = resting_at(self.plank, np.array([1, 2, 3, *angles]))
            np.testing.assert_allclose(found.size, size)
            self.assertAlmostEqual(found.yaw, math.radians(yaw))
            np.testing.assert_allclose(found.position, [1, 2, 3])

    def test_turns_about_the_fingers_bring_a_block_onto_any_face(self):
        flat, side, end = np.array([[3, 1, 0.5], [3, 0.5, 1], [1, 0.5, 3]])
        self.assertEqual(turns_between(flat, flat, 2), [])
        self.assertEqual(turns_between(flat, end, 2), [1])
        self.assertEqual(turns_between(flat, side, 2), [1, 1])
        self.assertIsNone(turns_between(flat, side, 0.9))
        self.assertIsNone(turns_between(flat, np.array([2, 1, 1]), 2))


if __name__ == "__main__":
    unittest.main()
