"""Tests how a dragged object is understood and found, by its handle."""

import math
import unittest

import numpy as np

from check.task_state import TaskState
from match.building_site import choose_site
from recordings import RecordingTest
from scenes import BROWN, RED, block, picture_of
from things.kinds import is_in_place


class DraggingTest(RecordingTest):
    """A door with a post on it is dragged by 2 and 1; another post of the same color stays."""

    def setUp(self):
        def scene(x, y):
            yellow, red, post = BROWN * 1.5, RED * 0.7, np.array([1, 0.6, 1.2])
            return picture_of([block(red, post, 4, -4),
                               block(yellow, np.array([3.0, 2, 2]), x, y, yaw=0.5),
                               block(red, post, x, y, bottom=2, yaw=0.5)])
        self.record(scene(-2, -3), scene(0, -2))
        self.write(0, ["0,create,Door,shape,composite", "0,move,Door,-2.2,-3.1,1.9,0.0,0.0,0.0"])
        self.write(1, ["1,grasp,LeftHand,Door", "1,move,Door,-0.2,-2.1,1.9,0.0,0.0,0.0",
                       "1,release,LeftHand"])

    def test_its_post_is_the_handle(self):
        [step], containers = self.infer_task()
        self.assertEqual(containers, [])
        np.testing.assert_allclose(step.displacement, [2, 1])
        self.assertAlmostEqual(step.top, 3.2, delta=0.05)  # by its displacement
        np.testing.assert_allclose(step.position[:2], [-2, -3], atol=0.03)
        np.testing.assert_allclose(step.size[:2], [1, 0.6], atol=0.03)

    def test_an_invisible_handle_is_reported(self):
        (self.folder / "rgb/1.png").unlink()
        with self.assertRaisesRegex(ValueError, "the handle of Door"):
            self.infer_task()

    def test_the_displacement_of_a_rotated_one_is_rotated(self):
        [step], _ = self.infer_task()
        state = TaskState([step])
        problem = choose_site(state, None, None, None)
        self.assertFalse(state.has_site)
        self.assertRegex(problem, "0 visible objects look like Door")
        state.known = [block(step.color, step.size, 3, -2, yaw=0.8)]
        choose_site(state, None, None, None)
        self.assertTrue(state.has_site)
        c, s = math.cos(0.3), math.sin(0.3)
        np.testing.assert_allclose(state.steps[0].position[:2],
                                   [3 + 2 * c - s, -2 + 2 * s + c], atol=0.01)

    def test_it_may_end_as_far_to_the_side_as_its_direction_is_uncertain(self):
        [step], _ = self.infer_task()
        for away, is_there in (0.1, True), (0.15, False):
            x, y = step.position[:2] + away * np.array([-1, 2]) / math.sqrt(5)
            self.assertEqual(is_in_place(block(step.color, step.size, x, y, yaw=step.yaw), step), is_there)


if __name__ == "__main__":
    unittest.main()
