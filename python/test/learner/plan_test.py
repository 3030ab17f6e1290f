"""Tests which moves are proposed, and where blocks are put."""

import math
import unittest
from dataclasses import replace
from functools import partial
from types import SimpleNamespace
from unittest.mock import patch

import numpy as np

from act.arms import Arm
from act.grippers import grip_depth
from check.choices import Choices
from check.task_state import TaskState
from plan.clearing import clearing_moves, moves_from_place, uncovering_moves
from plan.free_places import free_placements
from plan.making_room import room_moves
from plan.moves import Move
from plan.pick_and_place import plan_pick_and_place
from plan.places_on_others import places_on_others
from plan.proposals import propose_moves, turning_moves
from plan.step_choice import plan_one_of
from plan.step_planning import plan_step
from plan.suitable_places import blocks_grasps
from plan.temporary_places import candidates, plan_temporary_placement
from plan.touching import beside_touching
from plan.transfers import plan_arm_pick_and_place
from scenes import BLUE, BROWN, CUBE, EYE, GREEN, PLANK, RED, block, step
from see.eye import Eye, to_pixel


class MovesTest(unittest.TestCase):
    def setUp(self):
        self.steps = [step(block(RED, CUBE, 0, -2), []),
                      step(block(GREEN, CUBE, 0, -2, bottom=1), [0]),
                      step(block(GREEN, CUBE, -3, -2), [])]

    def test_obstructing_blocks_come_first_and_covered_ones_wait(self):
        near, far = block(RED, CUBE, 3, -2), block(RED, CUBE, 4, -3)
        obstructing = block(BLUE, CUBE, 0.3, -2.2)
        on_near = block(BLUE, CUBE, 3, -2, bottom=1)
        state = TaskState(self.steps)
        state.known = [far, near, obstructing, on_near]
        moves = propose_moves(state, self.steps[0], state.known)
        self.assertEqual(moves, [Move(obstructing), Move(on_near)])
        state.known.remove(obstructing)
        moves = propose_moves(state, self.steps[0], state.known)
        self.assertEqual(moves, [Move(far, self.steps[0]), Move(on_near)])

    def test_what_touches_another_is_taken_before_the_building_leaves_no_room_beside_it(self):
        beside, right = block(GREEN, CUBE, 0, -0.7), block(GREEN, CUBE, 1, -0.7)
        steps = [step(block(RED, CUBE, 0, -1.95, yaw=math.pi / 2), []), step(block(GREEN, CUBE, -3, -4), [])]
        state = TaskState(steps)
        self.assertEqual(propose_moves(state, steps[0], [beside, right]), [Move(beside)])
        self.assertEqual(propose_moves(state, steps[0], [beside]), [], "fingers fit in on its other sides")
        state.asides.append((0, beside))
        self.assertEqual(propose_moves(state, steps[0], [beside, right]), [], "it was put there for this step")
        self.assertIs(propose_moves(state, steps[1], [beside, right])[0].block, beside, "not for another one")

    def test_a_step_for_which_others_made_room_comes_next_until_it_is_done(self):
        state = TaskState(self.steps)
        possible, tried = {2}, []

        def plan_step(_, k, *__):
            tried.append(k)
            return (["go"], None) if k in possible else ([], "blocked")

        def chosen(steps):
            tried.clear()
            plan_one_of(steps, state, [], EYE, [], None)
            return tried.copy()

        with patch("plan.step_choice.plan_step", side_effect=plan_step):
            self.assertEqual([chosen([0, 2]), chosen([0, 2])], [[0], [2]], "the first is blocked")
            possible.add(0)
            self.assertEqual([chosen([0, 2]), chosen([0]), chosen([0])], [[2], [0], [0]], "until it is done")
            possible.clear()
            self.assertEqual(chosen([0, 2]), [0, 0], "or blocked, too")
            self.assertEqual(state.first_failure, f"{self.steps[0]}: blocked")

    def test_what_was_found_impossible_is_not_tried_again_until_something_moves(self):
        state = TaskState(self.steps)
        red, blue = block(RED, CUBE, 3, -2), block(BLUE, CUBE, 5, -4)
        state.known = [red, blue]
        arms = [SimpleNamespace(opening=2)]

        def tried():
            with patch("plan.step_planning.plan_move", return_value=([], None, "", "no arm reaches it")) as plan_move:
                self.assertEqual(plan_step(state, 0, state.known, False, EYE, arms, None), ([], "no arm reaches it"))
            return plan_move.call_count

        self.assertEqual([tried(), tried()], [1, 0])
        self.assertEqual(str(state.notes[-1]), "saw: impossible for now: step: no arm reaches it")
        state.known = [red, block(BLUE, CUBE, 5, -3)]
        self.assertEqual(tried(), 1, "blue was moved")

    def test_what_the_building_would_hide_is_uncovered_while_blocks_are_missing(self):
        state = TaskState([step(block(BLUE, CUBE, 0, -2, bottom=k), []) for k in range(3)])
        behind, elsewhere = (block(RED, CUBE, x, -0.2, bottom=1) for x in (0, 3))
        state.known = [behind, elsewhere]
        self.assertEqual(uncovering_moves(state, state.known, EYE), [Move(behind)])
        state.known += [block(RED, CUBE, 0, -0.2)]
        self.assertEqual(uncovering_moves(state, state.known, EYE), [], "what it lies on is known")
        state.known = [behind, *(block(BLUE, CUBE, x, -4) for x in (0, 2, 4))]
        self.assertEqual(uncovering_moves(state, state.known, EYE), [], "nothing is missing")

    def test_room_for_the_fingers_is_cleared_and_kept(self):
        middle = block(RED, CUBE, 0, -2)
        left, right, front = (block(GREEN, CUBE, x, y)
                              for x, y in ((-1.1, -2), (1.1, -2), (0, -3.05)))
        state = TaskState(self.steps)
        state.known = [middle, left, right, front, block(BLUE, CUBE, 4, -2)]
        self.assertEqual(clearing_moves(state, [Move(middle)], state.known), [Move(front)])
        self.assertEqual(clearing_moves(state, [Move(left)], state.known), [])
        self.assertTrue(blocks_grasps(front, [middle, left, right]))
        self.assertFalse(blocks_grasps(front, [middle]))

    def test_as_few_blocks_as_possible_make_room_for_a_large_one(self):
        step = self.steps[0]
        plank = block(BROWN, np.array([5, 1, 1]), -4, -0.2)
        cubes = [block(GREEN, CUBE, x, y) for x in (-6, -3, 0, 3, 6) for y in (-4.5, -2.8, -1)]
        state = TaskState(self.steps)
        state.known = [plank, *cubes]
        sites = self.steps
        self.assertEqual(free_placements([], EYE, plank, cubes + sites, None), [])
        with patch("plan.making_room.is_suitable", return_value=True), patch("plan.making_room.plan_to_place", return_value=(["go"], None)):
            moves = room_moves(state, step, [Move(plank)], state.known, [], EYE, None)
            fixed = room_moves(state, step, [Move(plank)], [plank], [], EYE, None)
        self.assertEqual(fixed, [], "nothing may be put aside")
        rest = [it for it in cubes if it not in [move.block for move in moves]]
        places = free_placements([], EYE, plank, rest + sites, None)
        self.assertIn(moves[0].room.position.tolist(), [it.position.tolist() for it in places])
        for one in moves:
            others = [it for it in cubes if it is one.block or it in rest]
            self.assertEqual(free_placements([], EYE, plank, others + sites, None), [], "each is in the way")

    def test_a_place_that_failed_is_not_tried_again(self):
        places = [block(RED, CUBE, x, -3) for x in (4, -4)]
        tried = []
        with (patch("plan.temporary_places.can_reach", return_value=True), patch("plan.suitable_places.can_reach", return_value=True),
              patch("plan.temporary_places.free_placements", return_value=places),
              patch("plan.temporary_places.plan_to_place",
                    side_effect=lambda arms, held, place, *_: tried.append(place.position[0]) or ([], "it slips"))):
            actions, _, reason = plan_temporary_placement([], EYE, block(RED, CUBE, 5, -3), [], [[], []], None, None, (), [], None)
        self.assertEqual((actions, reason, tried), ([], "it slips", [4, -4]))

    def test_where_the_table_is_full_a_block_is_put_on_one_that_no_step_needs(self):
        moved = block(RED, CUBE, -4, -2)
        flat = np.array([1.2, 1.2, 0.8])
        large, small = block(BLUE, flat, 3, -1, yaw=0.3), block(BLUE, 0.6 * CUBE, 0, -1)
        needed, carrying, near = block(GREEN, CUBE, 1, -4), block(BLUE, flat, -2, -4), block(BLUE, CUBE, -3, 0)
        others = [large, small, needed, carrying, near, block(BLUE, CUBE, -2, -4, bottom=0.8), block(BLUE, CUBE, 12, 0)]
        places = places_on_others(moved, others, self.steps, EYE)
        np.testing.assert_allclose([it.bottom for it in places], [1, 1.8, 0.8], err_msg="the closest first, in view, also stacks")
        np.testing.assert_array_equal(places[2].position[:2], large.position[:2])
        self.assertEqual(places[2].yaw, large.yaw)
        (on_table, _), (on_others, _) = candidates([], EYE, moved, others, [self.steps], None, ())
        self.assertEqual({it.bottom for it in on_table}, {0}, "the table comes first")
        self.assertEqual(len(on_others), 3)

    def test_what_is_higher_than_the_fingers_is_taken_away_from_beside_a_place(self):
        place = step(block(RED, PLANK, 0, -2), [])
        low, high, far = block(GREEN, CUBE, 0.2, -3.7), block(BLUE, 1.4 * CUBE, 0.2, -3.85), block(BLUE, 1.4 * CUBE, 0, -5)
        self.assertEqual(moves_from_place(place, [low]), [])
        self.assertEqual(moves_from_place(place, [far, high]), [Move(high)])
        self.assertEqual(moves_from_place(place, [high, block(GREEN, CUBE, 0.2, -3.85, bottom=1.4)]), [], "what carries others waits")

    def test_what_touches_others_is_lowered_beside_them(self):
        goal = block(RED, np.array([2.0, 1, 1]), 0, -2, yaw=math.pi / 6)
        c, s = math.cos(goal.yaw), math.sin(goal.yaw)

        def at(along, across, bottom=0):
            return block(GREEN, CUBE, along * c - across * s, -2 + along * s + across * c, bottom, goal.yaw)

        right, left, behind = at(1.51, 0), at(-1.51, 0), at(0.3, 1.01)
        for others, along, across in (([right], -1, 0), ([right, behind], -1, -1), ([right, left], 0, 0), ([at(1.51, 0, 1)], 0, 0),
                                      ([at(1.6, 0)], 0, 0), ([right, at(-1.56, 0)], 0, 0), ([left, at(-0.5, -1.01)], 1, 1)):
            np.testing.assert_allclose(beside_touching(goal, others),
                                       0.04 * np.array([along * c - across * s, along * s + across * c]), atol=1e-9)

    def test_places_are_on_any_table_as_far_from_its_near_edge(self):
        def places(eye, y):
            return [it.position for it in free_placements([], eye, block(GREEN, CUBE, 0, y), [], None)]

        behind = EYE.pose + np.outer([0, 1, 0, 0], [0, 0, 0, -4])
        deep = places(Eye(EYE.intrinsics, behind, (20, 20)), -6)
        np.testing.assert_array_equal(deep, np.array(places(EYE, -2)) - [0, 4, 0])
        narrow = places(Eye(EYE.intrinsics, EYE.pose, (6, 12)), -2)
        self.assertEqual(np.abs([x for x, *_ in narrow]).max(), 2.5, "half a cube from its edge")

    def test_a_large_block_is_put_where_the_eye_sees_all_of_it(self):
        lid = block(BROWN, np.array([2.6, 2.6, 0.2]), -4, -1, bottom=1.3)
        pot = block(BROWN, np.array([2.4, 2.4, 1.3]), -4, -1)
        places = free_placements([], EYE, lid, [pot], None)
        self.assertEqual(len(places), 100)
        for place in places:
            corners = place.position + [[x, y, 0.1] for x in (-1.3, 1.3) for y in (-1.3, 1.3)]
            pixels = np.array([to_pixel(corner, EYE) for corner in corners])
            self.assertTrue(place.yaw or (0 < pixels).all() and (pixels < [640, 480]).all())

    def test_fingers_stay_above_what_a_low_block_stands_on(self):
        for height in 0.5, 0.75, 1, 2:
            tips = height - grip_depth(SimpleNamespace(reach=0.75, palm=0.75), height) - 0.75
            self.assertGreaterEqual(tips, 0.05 - 1e-9)
        self.assertEqual(grip_depth(SimpleNamespace(reach=0.75, palm=0.75), 2), 0.2)

    def test_what_carries_short_fingers_stays_above_a_block(self):
        arm = SimpleNamespace(reach=0.09, palm=0.45)  # like those of a Panda
        self.assertAlmostEqual(grip_depth(arm, 0.6), 0.35)
        arm.palm = 0.8
        self.assertAlmostEqual(grip_depth(arm, 0.6), 0.41)

    def test_a_block_wider_than_the_gripper_opens_is_not_taken(self):
        wide = block(BLUE, np.array([3, 2, 1]), 0, -2)
        _, reason = plan_pick_and_place([SimpleNamespace(opening=2)], wide, wide, [], None)
        self.assertEqual(reason, "it is wider than the gripper opens")

    def test_of_a_block_and_its_goal_it_is_told_which_one_is_beyond_reach(self):
        arm = Arm(None, "left", 0, 0, None, starts=[np.zeros(7), np.ones(7)], reach=0.75, has_torso=True)
        start, goal = block(RED, CUBE, -2, -2), block(RED, CUBE, 2, -2)

        def solve(reached, arm, poses, q):
            # From one of the starts only; at the goal, from there, it would touch the torso.
            are_reached = q[0] == 1 and all(it[0, 3] in reached and not (arm.has_torso and it[0, 3] == 2) for it in poses)
            return [q] if are_reached else []

        for reached, expected in (([-2, 2], (False, False)), ([-2], (False, True)), ([2], (True, False)), ([], (True, False))):
            with (patch("plan.transfers.plan_path_through", return_value=[]),
                  patch("plan.transfers.solve_poses", side_effect=partial(solve, reached))):
                actions, *are_beyond = plan_arm_pick_and_place(arm, start, 0, goal, 0, 3, 3, [0, 0], [], None)
            self.assertEqual((actions, tuple(are_beyond)), ([], expected))

    def test_yaws_with_which_an_arm_does_not_reach_a_block_or_its_goal_are_tried_once(self):
        arm = SimpleNamespace(opening=2, reach=0.75, palm=0.75, foot=np.zeros(2), index=0)
        start, goal = block(RED, CUBE, -2, -2), block(RED, CUBE, 2, -2)
        tried = []

        def transfer(arm, held, yaw, target, place_yaw, *_):
            tried.append((yaw, place_yaw))
            return [], yaw == tried[0][0], place_yaw == tried[0][1]

        with patch("plan.pick_and_place.plan_arm_pick_and_place", side_effect=transfer):
            plan_pick_and_place([arm], start, goal, [], SimpleNamespace(arms=[SimpleNamespace(joints=None)]))
        # Once more for a low way, on which the block is lifted less; the goal is reached as before.
        self.assertEqual(len(tried), 2 * (1 + 3 * 3))
        self.assertEqual([sum(it[k] == tried[0][k] for it in tried) for k in (0, 1)], [2, 1])

    def test_seeds_vary_how_a_block_is_held_and_carried(self):
        arm = SimpleNamespace(opening=2, reach=0.75, palm=0.75, foot=np.zeros(2), index=0)
        sensor = SimpleNamespace(arms=[SimpleNamespace(joints=None)])
        start, goal = block(RED, CUBE, -2, -2), block(RED, CUBE, 2, -2)

        def first_ways(choices):
            ways = []
            with patch("plan.pick_and_place.plan_arm_pick_and_place",
                       side_effect=lambda arm, held, yaw, target, place_yaw, height, *_: ways.append((yaw, height)) or ([1], 0, 0)):
                for move in range(30):
                    plan_pick_and_place([arm], start, goal, [], sensor, way=choices.way(move))
            return ways

        usual = first_ways(Choices())
        self.assertEqual(len(set(usual)), 1)
        held, carried = first_ways(Choices(grasp=7)), first_ways(Choices(path=7))
        self.assertGreater(len({yaw for yaw, _ in held}), 1)
        self.assertEqual({height for _, height in held}, {usual[0][1]})
        self.assertEqual(len({height for _, height in carried}), 30)
        self.assertTrue(all(0 <= height - usual[0][1] <= 1 for _, height in carried))
        self.assertEqual(held, first_ways(Choices(grasp=7)))


class TurningTest(unittest.TestCase):
    plank = block(BROWN, np.array([3, 1, 0.5]), -2, 0)

    def test_it_is_turned_if_it_does_not_look_as_wanted(self):
        goal = replace(step(block(BROWN, np.array([3, 0.5, 1]), 0, -2), []), start_size=self.plank.size)
        state = TaskState([goal])
        self.assertEqual([list(it.size) for it in state.unknown_objects], [[1, 0.5, 3], [3, 1, 0.5]])
        self.assertEqual(turning_moves(goal, [self.plank], 1.9),
                         [Move(self.plank, turns=(1, 1)), Move(self.plank)])
        there = block(BROWN, goal.size, 3, -2)
        self.assertEqual(turning_moves(goal, [self.plank, there], 1.9), [])


if __name__ == "__main__":
    unittest.main()
