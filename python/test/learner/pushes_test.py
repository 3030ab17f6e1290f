"""Tests how blocks are pushed to where fingers have no room."""

import math
import unittest
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np
from smile.motion import Robot

from act.arms import Arm
from act.finger_room import grasp_yaws
from act.push_ways import is_on_way, push_ways
from act.pushing_hands import pushing_hands, way_to_push
from match.sites import can_all_be_pushed
from plan.clearing import moves_from_push
from scenes import BLUE, CUBE, GREEN, RED, block, step

BASE = np.array([[0.0, -1, 0, 0], [1, 0, 0, -8], [0, 0, 1, 2], [0, 0, 0, 1]])
ROBOT = Robot(Path(__file__).parents[3] / "robots/baxter.urdf", base=BASE, unit=0.1)


class PushTest(unittest.TestCase):
    """The place of a block is in the corner of two others, to its left and below it as seen from above."""

    def setUp(self):
        self.corner = [block(RED, CUBE, 0, -2), block(GREEN, CUBE, 1, -3)]
        self.goal = block(BLUE, CUBE, 1, -2)
        self.arm = Arm(ROBOT, "right", 1, 2, ROBOT.pose("right", "ready"), parked=ROBOT.pose("right", "parked"), reach=0.75)
        self.arm.foot = self.arm.points(self.arm.ready)[-1, :2]

    def ways(self, *more):
        return push_ways(self.goal, self.goal, [*self.corner, *more])

    def test_ways_lead_away_from_what_a_block_touches(self):
        self.assertEqual(grasp_yaws(self.goal, self.corner), [])
        self.assertEqual(push_ways(replace(self.goal, form="disc"), self.goal, self.corner), [], "only blocks are pushed")
        np.testing.assert_allclose([it.away for it in self.ways()], [[1, 0], [0, 1]], atol=1e-9)
        np.testing.assert_allclose([it.start.position[:2] for it in self.ways()], [[1.45, -2], [1, -1.55]])
        [only] = self.ways(block(RED, CUBE, 1, -0.6))
        np.testing.assert_allclose(only.away, [1, 0], atol=1e-9, err_msg="the other start is taken")

    def test_a_block_on_others_does_not_fall_where_its_way_begins(self):
        upper = replace(self.goal, position=np.array([1, -2, 1.5]))
        below = [block(RED, CUBE, 1, -2.1), block(RED, CUBE, 2, -2)]
        beside = [replace(it, position=it.position + [0, 0, 1]) for it in self.corner]
        [only] = push_ways(upper, upper, [*self.corner, *beside, *below])
        np.testing.assert_allclose(only.away, [1, 0], atol=1e-9)

    def test_a_block_is_pushed_from_where_it_comes_to_its_place(self):
        way = self.ways()[0]
        for shift, turn, expected in ((0, 0, 0), 0, True), ((-0.2, 0.03, 0), math.pi / 2, True), ((0.1, 0, 0), 0, False), \
                ((0, 0.05, 0), 0, False), ((-0.5, 0, 0), 0, False), ((0, 0, 1), 0, False), ((0, 0, 0), 0.1, False):
            there = replace(way.start, position=way.start.position + shift, yaw=turn)
            self.assertEqual(is_on_way(there, way), expected, (shift, turn))

    def test_fingers_end_at_the_pushed_side_and_within_it(self):
        way = self.ways()[0]
        hands = pushing_hands(self.arm, way.start, way, self.corner)
        np.testing.assert_allclose([math.sin(it.across) ** 2 for it in hands], [1, 1], err_msg="beside each other along the side")
        for hand in hands:
            # Fingers of Baxter are 0.4 wide and 0.3 thick.
            np.testing.assert_allclose([it[0, 3] - 0.2 for it in hand.poses], [2.05, 1.5, 1.6])
            self.assertAlmostEqual(hand.opening / 2 + 0.3, 0.45)
            self.assertAlmostEqual(hand.poses[1][2, 3], 0.8)
        self.assertEqual(pushing_hands(self.arm, way.start, way, [block(RED, CUBE, 2.6, -2)]), [], "something is behind it")

    def test_a_building_is_where_what_must_be_pushed_can_be(self):
        steps = [step(it, []) for it in (*self.corner, self.goal)]
        self.assertIsNotNone(way_to_push([self.arm], steps[2], steps[:2]))
        self.assertTrue(can_all_be_pushed(steps, [self.arm]))
        far = [replace(it, position=it.position + [0, 4, 0]) for it in steps]
        self.assertFalse(can_all_be_pushed(far, [self.arm]))
        far[2].stays = True
        self.assertTrue(can_all_be_pushed(far, [self.arm]), "what stays is not pushed")

    def test_what_is_where_a_hand_pushes_goes_elsewhere(self):
        goal, far = step(self.goal, []), block(BLUE, CUBE, -5, -2)
        # Behind the two starts; the second one could be pushed itself.
        behind = [block(RED, CUBE, 2.7, -2), block(BLUE, CUBE, 1, -0.3)]

        def moves(built, *free):
            return [(it.block, *it.room.position[:2].round(6)) for it in moves_from_push(
                SimpleNamespace(known=[*built, *free], containers=[]), goal, free, [self.arm])]

        self.assertEqual(moves(self.corner, behind[0], far), [], "along the other way it can push")
        self.assertEqual(moves(self.corner, *behind, far), [], "the way of the second one is free")
        behind[1] = replace(behind[1], color=RED)
        self.assertEqual(moves(self.corner, *behind, far), [(behind[0], 1.7, -2), (behind[1], 1, -1.3)], "room for fingers, too")
        self.assertEqual(moves(self.corner, *behind), [], "there is nothing to push")
        self.assertEqual(moves(self.corner[:1], *behind, far), [], "fingers have room there")


if __name__ == "__main__":
    unittest.main()
