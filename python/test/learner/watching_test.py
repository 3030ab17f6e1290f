"""Tests how the learner in python/learner understands a demonstration from its pictures alone, without the
simulator: watching_test.py, with python/learner on the path.
"""

import json
import math
import tempfile
import unittest
from pathlib import Path

import numpy as np
from PIL import Image

from explain.explanation import explain
from explain.limits import NotUnderstood
from explain.watching import watch_demonstration
from scenes import BLUE, CUBE, EYE, GREEN, PLANK, RED, TILT, block, picture_of
from see.eye import to_pixel
from explain.task_model import infer_task

YELLOW = np.array([1.0, 1, 0])
PLATE = np.array([1.8, 1.6, 0.2])


def with_hand(picture, point, width=30, height=30):
    """Returns a picture in which something shaded hides what is around a point."""
    column, row = np.round(to_pixel(np.array(point, float), EYE)).astype(int)
    part = np.s_[max(row - height, 0):row + height, max(column - width, 0):column + width]
    shade = np.linspace(0.7, 1, picture[part].shape[1])[None, :, None]
    picture = picture.copy()
    picture[part] = shade * [0.85, 0.65, 0.52]
    return picture


class WatchingTest(unittest.TestCase):
    def watch(self, *pictures):
        """Returns the demonstration in some pictures; after None, the scene did not change for a while."""
        with tempfile.TemporaryDirectory() as folder:
            folder = Path(folder)
            half = (math.pi / 2 + TILT) / 2
            eye = {"fx": EYE.intrinsics[0, 0], "fy": EYE.intrinsics[1, 1], "cx": 320, "cy": 240,
                   "position_m": list(EYE.pose[:3, 3] / 10), "rotation_wxyz": [math.cos(half), -math.sin(half), 0, 0]}
            (folder / "demo.json").write_text(json.dumps({"meters_per_unit": 0.1, "eye": eye}))
            lines = ["frame,tick,image"]
            for k, picture in enumerate(pictures):
                lines.append(f"{k},{k}," + ("" if picture is None else f"{k}.png"))
                if picture is not None:
                    Image.fromarray(np.round(255 * picture).astype(np.uint8)).save(folder / f"{k}.png")
            (folder / "frames.csv").write_text("\n".join(lines))
            return watch_demonstration(folder)

    def test_what_a_hand_hides_is_understood_when_it_moves_on(self):
        yellow, red = block(YELLOW, PLANK, -2, 2), block(RED, CUBE, 2, -1)
        green, half_hidden = block(GREEN, CUBE, 2, 1.5), (2.4, 1.5, 1)
        placed, on_it = block(YELLOW, PLANK, -1, -1), block(RED, CUBE, -2.5, -1, 1)
        demo = self.watch(
            with_hand(picture_of([yellow, red, green]), half_hidden),
            with_hand(picture_of([block(YELLOW, PLANK, -1, 1, 1.5), red, green]), (-1, 1, 3)),
            # The hand hides the left end of the plank, then a block does so until the end.
            with_hand(picture_of([placed, red, green]), (-2.5, -1, 1), 36), None,
            with_hand(picture_of([placed, block(RED, CUBE, 1, -0.5, 2), green]), (-2.5, -1, 1), 20),
            with_hand(picture_of([placed, on_it, green]), (-2.5, -1, 2)), None,
            with_hand(picture_of([placed, on_it, block(GREEN, CUBE, 0.5, 0, 2.5)]), (0.5, 0, 3)),
            with_hand(picture_of([placed, block(GREEN, CUBE, 0.5, -1, 1), on_it]), (0.1, -1, 2), 12), None)
        steps, _ = infer_task(demo, {})
        self.assertEqual([step.name for step in steps], ["Yellow1", "Red1", "Green1"])
        self.assertEqual([step.on for step in steps], [[], [0], [0]])
        for step, x, z in zip(steps, (-1, -2.5, 0.5), (0.5, 1.5, 1.5)):
            np.testing.assert_allclose(step.position, [x, -1, z], atol=0.05)
        self.assertEqual(len(explain(demo, []).keyframes), 4)
        self.assertEqual(demo.unclear, [])

    def test_what_is_seen_last_counts(self):
        plate, red = block(BLUE, PLATE, 0, 0, yaw=0.3), block(RED, CUBE, 0, 0, 0.2, 0.3)
        aside = block(RED, CUBE, 3, -1)
        demo = self.watch(picture_of([plate, red]), picture_of([plate, block(RED, CUBE, 1, 0, 1.5)]),
                          picture_of([plate, aside]), None, picture_of([plate, block(RED, CUBE, 1, 0, 2)]),
                          picture_of([plate, red]), None)
        steps, _ = infer_task(demo, {})
        self.assertEqual([(step.name, step.stays, step.on) for step in steps],
                         [("Blue1", True, []), ("Red1", False, [0])])
        np.testing.assert_allclose(steps[0].size, PLATE, atol=0.03)
        self.assertEqual(demo.placed, [demo.ids.index("Red1")] * 2)

    def test_a_place_of_which_too_little_is_visible_is_not_guessed(self):
        yellow, red = block(YELLOW, PLANK, -2, 2), block(RED, CUBE, 4, -3.5)
        placed = block(YELLOW, PLANK, 0, -1)
        moved = block(RED, CUBE, 4, 1)
        demo = self.watch(picture_of([yellow, red]), picture_of([block(YELLOW, PLANK, -1, 1, 1.5), red]),
                          with_hand(with_hand(picture_of([moved, placed]), (-1.6, -1, 1), 24), (1.6, -1, 1), 24), None)
        self.assertEqual((demo.ids, demo.placed), (["Red1"], [0]))
        self.assertEqual(demo.unclear, ["what else is yellow at the end"], "it is said that something was not understood")
        with self.assertRaisesRegex(NotUnderstood, "show no block that moved: without texts, only upright blocks of one color"):
            self.watch(picture_of([yellow, red]), None)

    def test_a_color_that_pixels_show_as_two_is_one(self):
        red, gray = block(RED, CUBE, 2, -1), block(np.array([0.5, 0.5, 0.5]), [1.6, 1.2, 1.5], -1, 1)
        pictures = [picture_of([red, gray]), picture_of([gray, block(RED, CUBE, -1, 1, 1.5)])]
        for picture in pictures:
            picture[:, ::2][(picture[:, ::2] == 0.5).all(axis=2)] = 127 / 255  # the others become 128
        demo = self.watch(*pictures, None)
        self.assertEqual(demo.ids, ["Gray1", "Red1"])
        steps, _ = infer_task(demo, {})
        self.assertEqual([(step.name, step.stays, step.on) for step in steps],
                         [("Gray1", True, []), ("Red1", False, [0])])


if __name__ == "__main__":
    unittest.main()
