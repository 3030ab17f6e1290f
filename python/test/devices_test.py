"""Tests how the learner in python/learner recognizes things of several colors, finds and judges buttons, and uses
tools, without the simulator: devices_test.py, with python/learner on the path.
"""

import math
import unittest
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from unittest.mock import patch

import numpy as np

from explain.demonstration import read_demonstration
from explain.devices import infer_devices
from explain.explanation import explain
from explain.part_measuring import measure_parts
from explain.task_model import infer_task
from learner_test import BLUE, BROWN, EYE, GREEN, RED, RecordingTest, block, picture_of, view_of
from match.pressing import button_of, locate, looks_pressed
from match.tools import find_tool
from plan.carrying import surroundings_of
from plan.loads import belongs_to, load_of
from plan.pick_and_place import plan_pick_and_place
from see.layouts import detect_layouts
from see.surfaces import surface_of
from things.areas import rotated
from things.blocks import yaw_difference
from things.kinds import is_same_kind

GRAY, DARK, LIGHT = np.full(3, 0.5), np.full(3, 0.2), np.full(3, 0.85)


def thing(label, x, y, yaw=0.0, bottom=0.0):
    """Returns a dark block with a light plate on it, and a label of some color at its near end."""
    body = block(DARK, np.array([0.9, 2.2, 1.6]), x, y, bottom, yaw)
    dx, dy = rotated([0, 0.1], yaw)
    plate = block(LIGHT, np.array([0.7, 1.2, 0.1]), x + dx, y + dy, bottom + 1.6, yaw)
    dx, dy = rotated([0, -0.75], yaw)
    return [body, plate, block(label, np.array([0.9, 0.5, 0.1]), x + dx, y + dy, bottom + 1.6, yaw)]


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
        arm = SimpleNamespace(opening=2, reach=0.75, foot=np.zeros(2), index=0)
        with patch("plan.pick_and_place.plan_arm_pick_and_place",
                   side_effect=lambda arm, held, yaw, target, place_yaw, *_: turns.append(place_yaw - yaw)):
            plan_pick_and_place([arm], thing, goal, [], SimpleNamespace(arms=[SimpleNamespace(joints=None)]))
        self.assertTrue(turns)
        np.testing.assert_allclose([math.remainder(it - 1, 2 * math.pi) for it in turns], 0, atol=1e-9)


class PressTest(RecordingTest):
    """A switch is pressed: its raised side changes, and a lamp goes on."""

    def fixture(self, x, y, yaw, is_on):
        def part(color, sides, dx, dy, bottom):
            dx, dy = rotated([dx, dy], yaw)
            return block(color, np.array(sides), x + dx, y + dy, bottom, yaw)

        side = -0.3 if is_on else 0.3
        lamp = [part(GREEN, [0.3, 0.3, 0.05], -0.3, 0.5, 0.2)] if is_on else []
        return [part(BROWN, [3, 2.4, 0.2], 0, 0, 0), part(BLUE, [0.4, 1.6, 0.3], 1.2, 0, 0.2), *lamp,
                part(GRAY, [1, 0.5, 0.1], 0, -0.4, 0.2), part(GRAY, [0.4, 0.5, 0.15], side, -0.4, 0.3)]

    def setUp(self):
        self.record(picture_of(self.fixture(0, -2, 0, False)), picture_of(self.fixture(0, -2, 0, True)))
        self.write(0, ["0,create,Panel,shape,composite", "0,move,Panel,0.0,-2.0,0.1,0.0,0.0,0.0"])
        self.write(1, ["1,trigger,LeftHand,Switch"])
        [self.press] = infer_devices(read_demonstration(self.folder), [])

    def test_a_button_is_found_where_the_scene_looks_like_the_demonstration(self):
        x, y, yaw = 1.5, -3, 0.4
        picture, heights = view_of(self.fixture(x, y, yaw, False))
        alignment = locate(self.press, picture, heights, EYE, EYE)
        self.assertAlmostEqual(math.remainder(alignment.angle + yaw, 2 * math.pi), 0, delta=0.02)
        np.testing.assert_allclose(alignment.moved(np.array([[x, y, 0]]))[0, :2], [0, -2], atol=0.03)
        surface = surface_of(picture, heights, EYE)
        self.assertFalse(looks_pressed(self.press, alignment, surface, EYE))
        button = button_of(self.press, alignment, surface, EYE)
        np.testing.assert_allclose(button.position[:2], [x, y] + rotated([0.3, -0.4], yaw), atol=0.1)
        self.assertAlmostEqual(button.top, 0.45, delta=0.01)
        surface = surface_of(*view_of(self.fixture(x, y, yaw, True)), EYE)
        self.assertTrue(looks_pressed(self.press, alignment, surface, EYE))

    def test_what_is_not_there_is_not_found(self):
        picture, heights = view_of([block(GRAY, np.array([1.0, 0.5, 0.3]), 1, -3), *thing(RED, -2, -3)])
        self.assertIsNone(locate(self.press, picture, heights, EYE, EYE))


class UseTest(RecordingTest):
    """A knife with a blue tip cuts a string, and is put back."""

    def knife(self, x, y, yaw):
        dx, dy = rotated([1.3, 0], yaw)
        return [block(RED, np.array([1.8, 0.5, 0.8]), x, y, yaw=yaw),
                block(BLUE, np.array([0.8, 0.3, 0.4]), x + dx, y + dy, yaw=yaw)]

    def setUp(self):
        string = [block(GREEN, np.array([0.2, 3, 0.2]), 1, -2, 1), block(BROWN, np.array([0.5, 0.5, 1]), 1, -0.5)]
        self.record(picture_of([*self.knife(-2, -3, 0), *string]),
                    picture_of([*self.knife(-2, -3, 0), string[1]]))
        self.write(0, ["0,create,Knife,shape,composite", "0,move,Knife,-2.0,-3.0,0.4,0.0,0.0,0.0"])
        self.write(1, ["1,grasp,LeftHand,Knife", "1,move,Knife,-2.0,-3.0,2.0,0.0,0.0,0.0",
                       "2,move,Knife,-1.0,-2.0,1.0,0.0,0.0,0.0", "3,move,Knife,-0.7,-2.0,1.0,0.0,0.0,0.0"])
        self.write(2, ["4,use,LeftHand,Knife,cut,String between link 1 and 2", "4,move,Knife,-0.4,-2.0,1.0,0.0,0.0,0.0",
                       "5,move,Knife,-2.0,-3.0,0.4,0.0,0.0,0.0"])
        self.write(3, ["6,release,LeftHand"])
        Path(self.folder / "rgb/1.png").rename(self.folder / "rgb/6.png")
        self.demo = read_demonstration(self.folder)
        self.steps, _ = infer_task(self.demo, {})

    def test_a_tool_that_was_put_back_is_no_step_but_used(self):
        self.assertEqual(self.steps, [])
        [use] = infer_devices(self.demo, self.steps)
        np.testing.assert_allclose(use.pose, [-0.4, -2, 1, 0], atol=1e-9)
        np.testing.assert_allclose(use.begin, [-1, -2, 1])
        self.assertIn("cut String Knife", explain(self.demo, None).goal)

    def test_a_tool_is_turned_as_its_surroundings_look(self):
        [use] = infer_devices(self.demo, self.steps)
        for yaw in 0.5, 0.5 + math.pi:
            picture, heights = view_of(self.knife(1, -3, yaw))
            known = [block(RED, np.array([1.8, 0.5, 0.8]), 1, -3, yaw=0.5)]
            _, found = find_tool(use, known, surface_of(picture, heights, EYE), EYE)
            self.assertAlmostEqual(math.remainder(found.yaw - yaw, 2 * math.pi), 0)

    def test_what_sticks_out_of_a_carried_tool_avoids_what_the_eye_sees(self):
        picture, heights = view_of([*self.knife(-2, -3, 0), block(BROWN, np.array([0.5, 0.5, 3]), 3, -3)])
        points = surface_of(picture, heights, EYE).points
        tool = block(RED, np.array([1.8, 0.5, 0.8]), -2, -3)
        is_tool = belongs_to(tool, points)
        self.assertAlmostEqual(points[is_tool, 0].max(), -0.3, delta=0.05)  # the blue tip
        self.assertTrue((points[~is_tool, 0] > 2).all(), "the post is no part of it")
        around = surroundings_of(points[~is_tool])

        def pose_at(q):  # the tool points down
            return np.array([[1, 0, 0, q[0]], [0, -1, 0, q[1]], [0, 0, -1, q[2]], [0, 0, 0, 1.0]])

        arm = SimpleNamespace(forward=pose_at, reach=0.75, points=lambda q: np.array([q, q + [0, -1, 3]]))
        load = load_of(points[is_tool], 0.4, pose_at([-2, -3, 0.6]))
        for x, z, is_clear, is_hand_clear in ((0.5, 2, True, True), (1.5, 2, False, True), (1.5, 4, True, True),
                                              (2.5, 3.5, True, False)):
            path = SimpleNamespace(positions=np.linspace([-2.0, -3, 2], [x, -3, z], 20)[-1:])
            self.assertEqual(around.avoids(arm, path, load), is_clear and is_hand_clear, (x, z))
            self.assertEqual(around.avoids(arm, path), is_hand_clear, (x, z))


if __name__ == "__main__":
    unittest.main()
