"""Tests how switches are found, and judged before and after a press."""

import math
import unittest

import numpy as np

from check.other_light import know_colors
from check.task_state import TaskState
from explain.demonstration import read_demonstration
from explain.devices import infer_devices
from explain.task_model import infer_task
from match.controls import locate
from match.pressing import button_of, looks_pressed
from recordings import RecordingTest
from scenes import BLUE, BROWN, CUBE, EYE, GRAY, GREEN, RED, block, picture_of, step, thing, view_of
from see.colors import table_color
from see.surfaces import surface_of
from see.unknown_objects import segment_top_faces
from things.areas import rotated


class PressTest(RecordingTest):
    """A switch is pressed: its raised side changes, and a lamp goes on."""

    def fixture(self, x, y, yaw, is_on, is_failing=False):
        def part(color, sides, dx, dy, bottom):
            dx, dy = rotated([dx, dy], yaw)
            return block(color, np.array(sides), x + dx, y + dy, bottom, yaw)

        side = -0.3 if is_on else 0.3
        lamps = [part(GREEN, [0.3, 0.3, 0.05], -0.3, 0.5, 0.2)] if is_on else []
        lamps += [part(RED, [0.3, 0.3, 0.05], 0.3, 0.5, 0.2)] if is_failing else []
        return [part(BROWN, [3, 2.4, 0.2], 0, 0, 0), part(BLUE, [0.4, 1.6, 0.3], 1.2, 0, 0.2), *lamps,
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
        # From finger to finger, along the hinge.
        self.assertAlmostEqual(math.remainder(button.yaw - yaw, math.pi), 0, delta=0.1)
        surface = surface_of(*view_of(self.fixture(x, y, yaw, True)), EYE)
        self.assertTrue(looks_pressed(self.press, alignment, surface, EYE))

    def test_a_lamp_that_an_earlier_press_switched_off_is_to_be_off(self):
        self.record(*(picture_of(self.fixture(0, -2, 0, *lamps)) for lamps in [(True, True), (False, False), (True, False)]))
        self.write(0, ["0,create,Panel,shape,composite", "0,move,Panel,0.0,-2.0,0.1,0.0,0.0,0.0"])
        self.write(1, ["1,trigger,LeftHand,Switch"])
        self.write(2, ["2,trigger,LeftHand,Switch"])
        _, press = infer_devices(read_demonstration(self.folder), [])
        alignment = locate(press, *view_of(self.fixture(1.5, -3, 0.4, False)), EYE, EYE)
        for is_failing in True, False:
            surface = surface_of(*view_of(self.fixture(1.5, -3, 0.4, True, is_failing)), EYE)
            self.assertEqual(looks_pressed(press, alignment, surface, EYE), not is_failing)

    def test_the_button_is_on_the_object_of_the_control_and_not_a_lamp_elsewhere(self):
        posts = [block(color, np.array([0.8, 0.8, 1.5]), 4, -1) for color in (GRAY, GREEN)]
        self.record(*(picture_of([*self.fixture(0, -2, 0, is_on), post]) for is_on, post in zip((False, True), posts)))
        self.write(0, ["0,create,Panel,shape,composite", "0,create,Post,shape,composite", "0,initializeControl,Switch,toggleSwitch,Panel,0",
                       "0,initializeControl,Lamp,indicatorLights,Post,off", "0,move,Panel,0.0,-2.0,0.1,0.0,0.0,0.0",
                       "0,move,Post,4.0,-1.0,0.75,0.0,0.0,0.0"])
        self.write(1, ["1,trigger,LeftHand,Switch"])
        demo = read_demonstration(self.folder)
        [press] = infer_devices(demo, [])
        np.testing.assert_array_equal(press.changed, self.press.changed)
        self.assertEqual(infer_task(demo, {}), ([], []), "a task may be to press something, and nothing else")

    def test_in_another_light_the_demonstration_is_compared_as_it_would_look_there(self):
        picture, heights = view_of(self.fixture(1.5, -3, 0.4, False))
        light = np.array([0.8, 0.75, 0.6])
        picture = np.round(255 * picture * light) / 255
        wanted = step(block(GREEN, CUBE, 0, 0), [])
        self.assertIsNone(locate(self.press, picture, heights, EYE, EYE))
        state = TaskState([wanted], presses=[self.press], shown=EYE)
        know_colors(state, picture, EYE, heights, segment_top_faces(picture, table_color(picture), heights))
        np.testing.assert_allclose(wanted.color, light * GREEN, atol=0.005)
        alignment = locate(self.press, picture, heights, EYE, EYE)
        self.assertAlmostEqual(math.remainder(alignment.angle + 0.4, 2 * math.pi), 0, delta=0.02)
        self.assertFalse(looks_pressed(self.press, alignment, surface_of(picture, heights, EYE), EYE))

    def test_in_the_same_light_nothing_changes(self):
        before = self.press.before.copy()
        state = TaskState([], presses=[self.press], shown=EYE)
        picture, heights = view_of([*self.fixture(1.5, -3, 0.4, True), *thing(RED, -3, -2)])
        know_colors(state, picture, EYE, heights, segment_top_faces(picture, table_color(picture), heights))
        np.testing.assert_array_equal(self.press.before, before)

    def test_what_is_not_there_is_not_found(self):
        picture, heights = view_of([block(GRAY, np.array([1.0, 0.5, 0.3]), 1, -3), *thing(RED, -2, -3)])
        self.assertIsNone(locate(self.press, picture, heights, EYE, EYE))


if __name__ == "__main__":
    unittest.main()
