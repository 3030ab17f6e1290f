"""Tests that hands look where something hides the table from the eye, and what is known from it."""

import unittest
from types import SimpleNamespace
from unittest.mock import patch

import numpy as np

from act.actions import Action
from check.failures import num_failures, remember_failure
from check.hand_views import see_from_hand
from check.task_state import TaskState
from plan.hand_looks import plan_hand_look
from plan.own_arms import forget_arm, hides, links_of, plan_look_aside
from scenes import CUBE, EYE, GREEN, PLANK, RED, block, step, view_of

# A tower hides a green cube behind it.
TOWER = [block(RED, CUBE, 4, -2, bottom=k) for k in range(4)]
BEHIND = block(GREEN, CUBE, 4.6, -0.4)


class HandLooksTest(unittest.TestCase):
    def setUp(self):
        self.picture, self.heights = view_of([BEHIND, *TOWER])
        self.state = TaskState([step(block(GREEN, CUBE, 0, -2), [])])
        self.state.known = list(TOWER)

    def looks(self, *, free=(), camera="right_hand"):
        """Returns the places of the looks that are planned until there are no more, and the kinds of their actions."""
        arm = SimpleNamespace(name="right", index=0, camera=camera, reach=0.7, foot=np.array([2.6, -7]),
                              tool_pose=lambda point, across: np.block([[np.eye(3), np.reshape(point, (3, 1))], [0, 0, 0, 1]]))
        sensor = SimpleNamespace(depthVision=self.heights, arms=2 * [SimpleNamespace(joints=None)])
        kinds = []
        with (patch("plan.hand_looks.height_map", side_effect=lambda depth, eye: depth),
              patch("plan.hand_looks.plan_path_through", side_effect=lambda arm, poses, *_: ["there", "back"])):
            while actions := plan_hand_look([0], self.state, free, EYE, [arm], sensor):
                kinds.append([it.kind for it in actions])
        return self.state.hand_looks, kinds

    def test_a_hand_looks_behind_what_hides_the_table_once_at_each_place(self):
        places, kinds = self.looks()
        self.assertEqual(kinds, [["follow", "look", "follow", "observe"]] * len(places))
        tower_failures = num_failures(self.state, TOWER[3])
        remember_failure(self.state, [Action("follow"), Action("look"), Action("follow"), Action("observe")], "an obstacle")
        self.assertEqual((len(self.state.known), num_failures(self.state, TOWER[3])), (4, tower_failures), "if it is stopped")
        self.assertLess(np.linalg.norm(places[0] - BEHIND.position[:2]), 1.5)
        apart = [np.linalg.norm(one - other) for k, one in enumerate(places) for other in places[:k]]
        self.assertGreaterEqual(min(apart, default=9), 2)

    def test_it_does_not_if_nothing_is_missing_or_it_has_no_camera(self):
        self.assertEqual(self.looks(free=[block(GREEN, CUBE, 1, -4)])[0], [])
        self.assertEqual(self.looks(camera="")[0], [])

    def test_a_single_arm_without_a_camera_moves_aside_from_what_it_hides(self):
        # Its hand is 3 units high, and 4 away from its first joint, which turns it about the vertical.
        def points(q):
            return np.array([[4 * np.sin(q[0]), 4 * np.cos(q[0]) - 6, 3], [0, -6, 3], [0, -6, 0]])

        robot = SimpleNamespace(limits=lambda _: (np.full(2, -1e4), np.full(2, 1e4)))
        arm = SimpleNamespace(name="arm", index=0, robot=robot, points=points, parked=np.array([0.0, 7]), forward=lambda q: np.eye(4))
        sensor = SimpleNamespace(arms=[SimpleNamespace(joints=np.array([0.0, 7]))])
        seen, behind = np.array([5.0, -1]), np.array([0.0, -1])
        with (patch("plan.own_arms.move_joints", side_effect=lambda _, waypoints: waypoints[-1]),
              patch("plan.own_arms.is_path_valid", return_value=True), patch("plan.own_arms.is_path_over", return_value=True)):
            turn, look = plan_look_aside([seen, behind], self.state, EYE, arm, sensor)
            self.assertEqual(plan_look_aside([seen], self.state, EYE, arm, sensor), [], "it does not hide this")
        self.assertEqual((turn.kind, turn.path[1], look.kind), ("follow", 7, "observe"))
        np.testing.assert_array_equal(self.state.hand_looks, [behind])
        self.assertFalse(hides(links_of(arm, turn.path), [behind], EYE)[0])
        self.assertLess(abs(turn.path[0]), 1.5, "no farther than necessary")

        self.state.known = [block(RED, CUBE, 0, -2, bottom=2.5), block(GREEN, CUBE, 0, -2, bottom=2.5), block(RED, PLANK, 0, -4)]
        forget_arm(self.state, arm, sensor)
        self.assertEqual([it.position[2] for it in self.state.known], [3, 0.5], "a red thing at the arm is a part of it")

    def test_what_it_sees_is_known_from_then_on(self):
        # The eye is taken for the camera of the hand. It sees a green cube, and again the top of the tower.
        self.state.known = TOWER[3:]
        picture, heights = view_of([block(GREEN, CUBE, 1, -4), *TOWER])
        view = SimpleNamespace(rgb=255 * picture, depth=heights, pose=EYE.pose, intrinsics=EYE.intrinsics)
        self.state.steps.append(step(block(RED, CUBE, 2, -2), []))
        sensor = SimpleNamespace(cameras=SimpleNamespace(right_hand=view))
        with patch("check.hand_views.height_map", side_effect=lambda depth, eye: depth):
            see_from_hand(self.state, sensor, SimpleNamespace(name="right", camera="right_hand"))
        self.assertEqual(len(self.state.known), 2)
        np.testing.assert_allclose(self.state.known[0].position, [1, -4, 0.5], atol=0.05)
        self.assertEqual(str(self.state.notes[-1]), "saw: 1 more object with the right hand")


if __name__ == "__main__":
    unittest.main()
