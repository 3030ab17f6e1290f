"""Tests how things of several colors are recognized by their parts."""

import math
import unittest
from dataclasses import replace
from types import SimpleNamespace
from unittest.mock import patch

import numpy as np

from explain.demonstration import read_demonstration
from explain.part_measuring import measure_parts
from plan.pick_and_place import plan_pick_and_place
from recordings import RecordingTest
from scenes import EYE, GREEN, LIGHT, RED, block, picture_of, thing, view_of
from see.layouts import detect_layouts
from things.blocks import yaw_difference
from things.kinds import is_same_kind


class PartsTest(RecordingTest):
    """A thing with a red label is lifted and turned."""

    def setUp(self):
        self.record(picture_of(thing(RED, 2, -3)), picture_of(thing(RED, 1, -2.5, 0.2, 1.5)))
        self.write(0, ["0,create,Thing,shape,composite", "0,move,Thing,2.0,-3.0,0.8,0.0,0.0,0.0"])
        self.write(1, ["1,grasp,LeftHand,Thing", f"1,move,Thing,1.0,-2.5,2.3,0.0,0.0,{math.degrees(0.2)}"])
        self.write(2, ["2,release,LeftHand"])
        self.kind = measure_parts(read_demonstration(self.folder), 0)

    def test_the_parts_of_a_thing_are_what_moves_with_it(self):
        plate, label = sorted(self.kind.parts, key=lambda it: -it.size[1])
        np.testing.assert_allclose(plate.position, [0, 0.1, 0.9], atol=0.03)
        np.testing.assert_allclose(label.position, [0, -0.75, 0.9], atol=0.03)
        np.testing.assert_allclose(label.color, RED, atol=0.01)
        np.testing.assert_allclose(self.kind.size, [0.9, 2, 1.6], atol=0.05)

    def test_a_thing_is_recognized_by_the_colors_and_places_of_its_parts(self):
        for yaw in 0.3, 0.3 + math.pi:
            picture, heights = view_of([*thing(RED, -2, -3, yaw), *thing(GREEN, 2, -3)])
            [found] = detect_layouts(picture, EYE, [self.kind], heights)
            np.testing.assert_allclose(found.position, [-2, -3, 0.8], atol=0.03)
            self.assertLess(abs(yaw_difference(found, yaw)), 0.02)
            self.assertTrue(is_same_kind(found, self.kind))
            self.assertFalse(is_same_kind(block(LIGHT, found.size, -2, -3), self.kind))

    def test_a_thing_is_not_put_down_the_other_way_round(self):
        thing = replace(self.kind, size=self.kind.size[[1, 0, 2]])
        goal, turns = replace(thing, position=np.array([0, -2, 0.8]), yaw=1.0), []
        arm = SimpleNamespace(opening=2, reach=0.75, palm=0.75, foot=np.zeros(2), index=0)
        with patch("plan.pick_and_place.plan_arm_pick_and_place",
                   side_effect=lambda arm, held, yaw, target, place_yaw, *_: turns.append(place_yaw - yaw) or ([], 0, 0)):
            plan_pick_and_place([arm], thing, goal, [], SimpleNamespace(arms=[SimpleNamespace(joints=None)]))
        self.assertTrue(turns)
        np.testing.assert_allclose([math.remainder(it - 1, 2 * math.pi) for it in turns], 0, atol=1e-9)


if __name__ == "__main__":
    unittest.main()
