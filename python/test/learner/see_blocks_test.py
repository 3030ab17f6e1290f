"""Tests how blocks are detected in pictures and by depth."""

import math
import unittest
from dataclasses import replace

import numpy as np

from scenes import BLUE, CUBE, EYE, GREEN, PLANK, RED, TABLE, block, empty_box, picture_of, step, view_of
from see.detection import detect_blocks
from see.measuring import edge_toward_nadir
from see.unknown_objects import detect_unknown_objects
from things.blocks import yaw_difference


class DetectionTest(unittest.TestCase):
    def assert_found(self, found, expected):
        same = [it for it in found if np.linalg.norm(it.position - expected.position) < 0.01]
        self.assertEqual(len(same), 1, f"{expected} is not among {found}")
        np.testing.assert_allclose(same[0].size, expected.size)
        self.assertLess(abs(yaw_difference(expected, same[0].yaw)), math.radians(0.5))

    def test_blocks_are_detected_within_a_hundredth_of_a_unit(self):
        blocks = [block(RED, PLANK, -2.5, -1.2, yaw=0.4), block(GREEN, CUBE, 2, -3.1, yaw=-0.3),
                  block(RED, CUBE, 4, -2), block(BLUE, CUBE, 4, -2, bottom=1, yaw=0.2),
                  block(GREEN, PLANK, 0.2, -2.6, yaw=math.pi / 2 - 0.1)]
        found = detect_blocks(picture_of(blocks), EYE, blocks)
        hidden = blocks.pop(2)
        for expected in blocks:
            self.assert_found(found, expected)
        self.assertEqual(len(found), len(blocks), f"{hidden} is below another")

    def test_only_wanted_blocks_are_detected(self):
        seen = [block(RED, CUBE, 1, -2), block(RED, np.array([2.5, 1, 1]), -2, -2),
                block(BLUE, CUBE, 3, -2)]
        [found] = detect_blocks(picture_of(seen), EYE, seen[:1])
        np.testing.assert_allclose(found.position, [1, -2, 0.5], atol=0.01)
        any_cube = block(None, CUBE, 0, 0)
        found = detect_blocks(picture_of(seen), EYE, [any_cube])
        self.assertEqual([it.color.tolist() for it in found], [[0, 0, 1], [1, 0, 0]])

    def test_two_blocks_that_touch_are_separated(self):
        row = [block(RED, CUBE, -2, -2, yaw=0.3),
               block(RED, CUBE, -2 + math.cos(0.3), -2 + math.sin(0.3), yaw=0.3)]
        found = detect_blocks(picture_of(row), EYE, row)
        self.assertEqual(len(found), 2)
        for one, expected in zip(found, row):
            np.testing.assert_allclose(one.position, expected.position, atol=0.02)

    def test_an_unknown_object_is_not_taken_for_a_block_higher_up(self):
        large = block(RED, np.array([1.3, 1.3, 1.25]), 2, -3, yaw=0.2)
        other = block(BLUE, CUBE, -2, -2)
        picture = picture_of([large, other])
        self.assertEqual(detect_blocks(picture, EYE, [block(RED, CUBE, 0, 0)]), [])
        [found] = detect_unknown_objects(picture, EYE, [other])
        np.testing.assert_allclose(found.position, large.position, atol=0.03)
        np.testing.assert_allclose(found.size, large.size, atol=0.05)

    def test_a_top_ends_where_the_line_below_it_leaves_it_last(self):
        is_top = np.zeros((480, 640), bool)
        is_top[250:271, 270:291] = True
        is_top[268, 272:290] = False  # as at a corner, of which pixels show the side
        (_, v), _ = edge_toward_nadir(*np.nonzero(is_top), EYE)
        self.assertEqual(math.floor(v), 271)

    def test_equal_colors_that_touch_at_several_heights_are_separated_by_depth(self):
        # Seen from the eye, the far edge of the tower meets the near edge of the block behind it.
        blocks = [block(RED, CUBE, 0, -1.62), block(RED, CUBE, 0.2, -3),
                  block(RED, CUBE, 0.2, -3, bottom=1)]
        picture, heights = view_of(blocks)
        found = detect_blocks(picture, EYE, blocks, heights=heights)
        self.assertEqual(len(found), 2)
        self.assert_found(found, blocks[0])
        self.assert_found(found, blocks[2])
        for it in detect_blocks(picture, EYE, blocks):  # without depth they are one shape
            self.assertGreater(min(np.linalg.norm(it.position - other.position)
                                   for other in blocks), 0.05)

    def test_the_expected_bottom_decides_between_a_block_and_two_halves(self):
        half = np.array([1, 1, 0.5])
        picture, heights = view_of([block(RED, CUBE, -2, -2), block(RED, half, 2, -2),
                                    block(RED, half, 2, -2, bottom=0.5)])
        on_half, cube = block(RED, half, 0, 0, bottom=0.5), block(RED, CUBE, 0, 0)
        for like, size in ([on_half], half), ([cube], CUBE), ([cube, on_half], CUBE):
            found = detect_blocks(picture, EYE, like, heights=heights)
            self.assertEqual([it.size.tolist() for it in found], [size.tolist()] * 2)
            for it in found:
                self.assertAlmostEqual(it.top, 1)

    def test_depth_shows_unknown_objects_on_others(self):
        lower, upper = block(RED, np.array([2, 2, 0.7]), 1, -2), block(BLUE, CUBE, 1, -2, bottom=0.7)
        picture, heights = view_of([lower, upper])
        [found] = detect_unknown_objects(picture, EYE, [lower], heights)
        np.testing.assert_allclose(found.position, upper.position, atol=0.03)
        np.testing.assert_allclose(found.size, upper.size, atol=0.05)
        floor = empty_box(1, -2, 0)
        picture, heights = view_of(floor)
        self.assertEqual(detect_unknown_objects(picture, EYE, [], heights), [])

    def test_what_stays_is_seen_below_what_stands_on_it(self):
        plate = block(GREEN, np.array([1.8, 1.8, 0.2]), -2, -2.5, yaw=0.3)
        cube = block(RED, CUBE, -2, -2.4, bottom=0.2, yaw=0.5)
        picture, heights = view_of([plate, cube])
        self.assertEqual(detect_blocks(picture, EYE, [plate], heights=heights), [])
        stays = replace(step(plate, []), stays=True)
        [found] = detect_blocks(picture, EYE, [stays], heights=heights)
        np.testing.assert_allclose(found.position, plate.position, atol=0.02)
        self.assertLess(abs(yaw_difference(plate, found.yaw)), math.radians(1))
        # A hole that nothing hides belongs to another shape.
        picture[heights > 0.5], heights[heights > 0.5] = TABLE, 0
        self.assertEqual(detect_blocks(picture, EYE, [stays], heights=heights), [])


if __name__ == "__main__":
    unittest.main()
