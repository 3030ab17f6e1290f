"""Tests what is believed after a look, which steps are done, and which grasps failed."""

import math
import unittest
from types import SimpleNamespace

import numpy as np

from act.actions import Action, Grasp
from check.beliefs import corrected
from check.choices import Choices
from check.failures import able_arms, has_failed, is_too_heavy, num_failures, remember_failure
from check.looking import compare
from check.notes import tops_of
from check.progress import assess_progress, open_steps
from check.task_state import TaskState
from check.verdict_notes import verdict_notes
from check.verdicts import Verdict, verdicts_on
from plan.pick_and_place import plan_pick_and_place
from scenes import BLUE, CUBE, EYE, GREEN, RED, block, picture_of, step, update_beliefs, view_of


class CheckTest(unittest.TestCase):
    def setUp(self):
        self.steps = [step(block(RED, CUBE, 0, -2), []),
                      step(block(GREEN, CUBE, 0, -2, bottom=1), [0]),
                      step(block(GREEN, CUBE, -3, -2), [])]

    def test_a_block_in_its_place_makes_the_step_done(self):
        state = TaskState(self.steps)
        there, elsewhere = block(RED, CUBE, 0.05, -2, yaw=math.pi), block(RED, CUBE, 0.1, -2)
        state.known = [elsewhere, there, block(RED, CUBE, 0, -2, bottom=1)]
        self.assertEqual(assess_progress(state), [there])
        self.assertEqual(state.done, [True, False, False])
        self.assertAlmostEqual(state.placement_errors[0][0], 0.05)

    def test_a_step_is_open_when_its_supports_are_done(self):
        state = TaskState(self.steps)
        self.assertEqual(open_steps(state), [0, 2])
        state.done[0] = True
        self.assertEqual(open_steps(state), [1, 2])

    def test_a_seed_varies_the_order_of_open_steps(self):
        steps = [step(block(RED, CUBE, 2 * k, -2), []) for k in range(3)]
        steps.append(step(block(GREEN, CUBE, 0, -2, bottom=1), [0]))
        orders = {tuple(open_steps(TaskState(steps, choices=Choices(order=seed)))) for seed in range(60)}
        self.assertEqual(len(orders), 6)
        self.assertTrue(all(sorted(order) == [0, 1, 2] for order in orders))

    def test_hidden_blocks_are_remembered_but_not_missing_ones(self):
        tower = block(RED, CUBE, 0, -4), block(GREEN, CUBE, 0, -4, bottom=1)
        missing = block(BLUE, CUBE, 3, -2)
        known = [tower[0], missing]
        known = update_beliefs(known, [tower[1]], picture_of(tower), EYE)
        self.assertEqual(known, [tower[1], tower[0]])

    def test_depth_shows_where_blocks_are_hidden_and_where_they_are_missing(self):
        tower = block(RED, CUBE, 0, -4), block(GREEN, CUBE, 0, -4, bottom=1)
        missing = block(BLUE, CUBE, 3, -2), block(BLUE, CUBE, 0, -4, bottom=2)
        picture, heights = view_of(tower)
        known = update_beliefs([tower[0], *missing], [tower[1]], picture, EYE, heights)
        self.assertEqual(known, [tower[1], tower[0]])
        half_covered = block(RED, CUBE, 0.5, -4), block(RED, CUBE, 0, -4, bottom=1)
        for lower in (half_covered[0], block(RED, CUBE, 0.49, -4), block(RED, CUBE, 0.51, -4)):
            picture, heights = view_of([lower, half_covered[1]])
            known = update_beliefs([lower], [half_covered[1]], picture, EYE, heights)
            self.assertEqual(known, [half_covered[1], lower])

    def test_each_expectation_has_a_verdict(self):
        tower = [block(RED, CUBE, 0, -4), block(GREEN, CUBE, 0, -4, bottom=1)]
        missing = block(BLUE, CUBE, 3, -2)
        shifted = [block(RED, CUBE, 3, -1, yaw=0.5), block(RED, CUBE, -3, -1.1)]
        there = [shifted[0], block(RED, CUBE, -3, -1)]
        picture, heights = view_of([*tower, *there])
        verdicts = verdicts_on([*tower, missing, *shifted], [tower[1], *there], picture, EYE, heights)
        self.assertEqual([it.word for it in verdicts], [
            "hidden", "as expected", "contradicted", "as expected", "contradicted"])
        notes = verdict_notes(verdicts, [tower[1], *there], [], "Red1")
        self.assertEqual(notes[0].text, "Red1: off by 0.10 units and 0.0 degrees")
        self.assertEqual([it.word for it in notes], [
            "contradicted", "as expected", "hidden", "contradicted"])
        np.testing.assert_allclose(tops_of(notes[:1]), [[1, 0, -3, -1.1, 1, 1, 1, 0, 0],
                                                        [1, 1, -3, -1, 1, 1, 1, 0, 0]])

    def test_a_contradicted_move_is_remembered_as_failed(self):
        state = TaskState(self.steps)
        there, goal = block(RED, CUBE, 3, -2), block(RED, CUBE, 0, -2)
        state.known, state.moved, state.grasp = [goal], "Red1", Grasp(there.position, 0, 0.5)
        picture, heights = view_of([there])
        compare(state, [there], picture, EYE, heights)
        self.assertEqual(state.known, [there])
        self.assertEqual(num_failures(state, there), 1)
        self.assertEqual(str(state.notes[0]), "contradicted: Red1: it is not there")

    def test_a_half_hidden_block_is_where_it_was_known_to_be(self):
        post = block(BLUE, np.array([1, 1, 3]), 0.3, -2.2)
        known, seen = block(RED, CUBE, 0, -1), block(RED, CUBE, 0.05, -1, yaw=0.4)
        picture = picture_of([known, post])
        self.assertEqual(update_beliefs([known], [seen, post], picture, EYE), [known, post])
        self.assertEqual(update_beliefs([known], [seen], picture, EYE), [seen])

    def test_tops_of_hidden_blocks_do_not_make_another_one(self):
        known = [block(RED, np.array([2.0, 1, 1]), 0, -y) for y in (2, 3)]
        seen = block(RED, np.array([2.0, 1, 1]), -0.5, -2.5, yaw=math.pi / 2)
        hidden = [Verdict("hidden", it) for it in known]
        self.assertEqual(corrected([seen], hidden), known)
        beside = block(RED, np.array([2.0, 1, 1]), -0.8, -2.5, yaw=math.pi / 2)
        self.assertEqual(corrected([beside], hidden), [beside, *known])
        self.assertEqual(corrected([seen], hidden[:1]), [seen, known[0]])
        self.assertEqual(corrected([seen], [*hidden, Verdict("as expected", seen, 0)]), [seen, *known])

    def test_failed_grasps_are_remembered(self):
        there, goal = block(RED, CUBE, 3, -2), block(RED, CUBE, 0, -2)
        state = TaskState(self.steps)
        state.known = [goal]
        state.grasp = Grasp(there.position, 0, 0.5)
        remember_failure(state, [Action("grasp"), Action("follow"), Action("open")], "an obstacle")
        self.assertEqual(state.known, [], "it is not where it was to go")
        self.assertEqual(num_failures(state, there), 1)
        self.assertEqual(num_failures(state, goal), 0)
        for rest, known in ([Action("follow"), Action("push")], []), ([Action("push"), Action("follow")], [goal]):
            state.known = [goal]
            remember_failure(state, rest, "an obstacle")
            self.assertEqual(state.known, known, "unless it was pushed already")
        for arm, yaw, expected in (0, 0.6, True), (0, 0.5 + math.pi, False), (1, 0.5, False):
            self.assertEqual(has_failed(Grasp(there.position, arm, yaw), state.failures), expected)

    def test_what_an_arm_could_not_lift_is_too_heavy_for_it_wherever_it_is(self):
        there, goal = block(RED, CUBE, 3, -2), block(RED, CUBE, 0, -2)
        right, left = (SimpleNamespace(index=k, opening=2, name=name) for k, name in enumerate(("right", "left")))
        state = TaskState(self.steps)
        state.known, state.grasp = [goal], Grasp(there.position, 0, 0.5)
        remember_failure(state, [Action("lift"), Action("follow"), Action("open")], "an obstacle is in the way of the arm")
        self.assertFalse(is_too_heavy(there, right, state.failures))
        state.known, state.grasp = [goal], Grasp(there.position, 0, 0.5)
        remember_failure(state, [Action("lift"), Action("follow"), Action("open")], "the arm cannot lift it")
        elsewhere = block(RED, CUBE, 5, -2)
        self.assertTrue(is_too_heavy(elsewhere, right, state.failures))
        self.assertFalse(is_too_heavy(elsewhere, left, state.failures))
        self.assertFalse(is_too_heavy(block(BLUE, CUBE, 5, -2), right, state.failures))
        _, reason = plan_pick_and_place([right], elsewhere, goal, [], None, state.failures)
        self.assertEqual(reason, "it is too heavy to be lifted")
        able, reason = able_arms([right, left], elsewhere, 1, state.failures)
        self.assertEqual((able, reason), ([left], "it is too heavy for the arm right, and no other one can do it"))

    def test_what_was_turned_in_vain_is_too_heavy_on_its_other_faces_too(self):
        lying, on_its_side = block(RED, np.array([3, 1, 0.5]), 3, -2), block(RED, np.array([3, 0.5, 1]), 0, -2)
        failed = Grasp(lying.position, 0, 0.5, too_heavy=on_its_side)
        self.assertTrue(is_too_heavy(lying, SimpleNamespace(index=0), [failed]))
        self.assertFalse(is_too_heavy(block(RED, np.array([3, 1, 1]), 3, -2), SimpleNamespace(index=0), [failed]))


if __name__ == "__main__":
    unittest.main()
