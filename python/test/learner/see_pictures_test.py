"""Tests what pictures and depth tell beside blocks: heights, regions, what hides and what is not recognized, round things, noise."""

import unittest
from dataclasses import replace

import numpy as np

from act.finger_room import grasp_yaws
from scenes import (
    BLUE, BROWN, CUBE, EYE, GREEN, PLANK, RED, TABLE, add_ball, block, picture_of, update_beliefs, view_of)
from see.balls import ball_color
from see.denoising import without_noise
from see.detection import detect_blocks
from see.eye import height_map, pixel_at, to_pixel
from see.pictures import noise_of, num_pictures
from see.regions import is_cut, label_regions
from see.sight import is_top_hidden
from see.unexplained import is_unexplained, unexplained_points
from see.unknown_objects import detect_unknown_objects
from things.areas import footprint
from things.blocks import yaw_difference


class RoundThingsTest(unittest.TestCase):
    def test_discs_are_distinguished_from_squares(self):
        disc = replace(block(RED, CUBE, -1, -2), form="disc")
        square = block(RED, CUBE, 2, -2, yaw=0.3)
        picture, heights = view_of([disc, square])
        for wanted in (disc, square):
            [found] = detect_blocks(picture, EYE, [wanted], heights=heights)
            np.testing.assert_allclose(found.position, wanted.position, atol=0.01)
            self.assertEqual(found.is_round, wanted.is_round)
        self.assertEqual(update_beliefs([disc], [], *view_of([disc])[:1], EYE, heights), [disc])
        self.assertEqual(len(grasp_yaws(disc, [])), 8)
        self.assertEqual(yaw_difference(disc, 1), 0)
        [unknown] = detect_unknown_objects(picture, EYE, [square], heights)
        self.assertTrue(unknown.is_round)
        np.testing.assert_allclose(unknown.size, disc.size, atol=0.02)

    def test_a_ball_is_measured_by_its_outline_and_its_surface(self):
        picture, heights = view_of([block(BROWN, CUBE, 2, -2)])
        center = np.array([-1, -2.5, 0.35])
        add_ball(picture, heights, RED, center, 0.35)
        np.testing.assert_allclose(ball_color(picture, EYE, center, 0.35) / RED.max(), 0.95 * RED,
                                   atol=0.1)
        self.assertIsNone(ball_color(picture, EYE, np.array([2, -2, 0.5]), 0.5), "it is a cube")
        ball = replace(block(RED, 0.7 * CUBE, 0, 0), form="ball")
        picture[:, :280], heights[:, :280] = TABLE, 0  # a part is hidden
        [found] = detect_blocks(picture, EYE, [ball, block(BROWN, CUBE, 0, 0)], heights=heights)[1:]
        np.testing.assert_allclose(found.position, center, atol=0.01)
        larger = replace(ball, size=0.8 * CUBE)
        self.assertEqual(detect_blocks(picture, EYE, [larger], heights=heights), [])


class PictureTest(unittest.TestCase):
    def test_depth_determines_heights(self):
        _, heights = view_of([block(RED, CUBE, 1, -2), block(BLUE, CUBE, -2, -3, bottom=1.5)])
        row, column = np.indices(heights.shape).reshape(2, -1)
        ray = EYE.pose[2, :3] @ [(column + 0.5 - 320) / EYE.intrinsics[0, 0],
                                 (row + 0.5 - 240) / EYE.intrinsics[1, 1], np.ones(row.size)]
        depth = (heights - EYE.pose[2, 3]) / ray.reshape(heights.shape)
        np.testing.assert_allclose(height_map(depth, EYE), heights, atol=1e-9)
        np.testing.assert_array_equal(height_map(0 * depth, EYE), 0 * depth)

    def test_nothing_is_put_where_something_unexplained_is(self):
        plate = block(GREEN, np.array([1.8, 1.8, 0.2]), -2, -2.5)
        tower = block(RED, np.array([1, 1, 2]), -2, -2.5, bottom=0.2)
        _, heights = view_of([plate, tower])
        points = unexplained_points([tower], heights, EYE)
        places = footprint([block(RED, CUBE, -2, -1.7), block(RED, CUBE, -3.2, -2.5),
                            block(RED, CUBE, 2, -2)], 0)
        self.assertEqual(is_unexplained(places, points).tolist(), [True, True, False])
        self.assertEqual(len(unexplained_points([tower, plate], heights, EYE)), 0)

    def test_what_cuts_a_top_is_known(self):
        post, behind = block(BLUE, np.array([1, 1, 3]), 0.7, -2.2), block(RED, CUBE, 0, -0.5)
        beside = block(RED, CUBE, 3, -0.5)
        picture, heights = view_of([behind, beside, post])
        for it, expected in (behind, True), (beside, False), (post, False):
            number = label_regions(np.abs(picture - it.color).max(axis=2) < 0.01, heights)
            middle = pixel_at(picture, EYE, [*it.position[:2], it.top])
            row, column = np.nonzero(number == number[middle])
            self.assertEqual(is_cut(row, column, it.top, heights), expected)

    def test_a_higher_block_hides_what_is_behind_it(self):
        behind, beside = block(RED, CUBE, 0, -1), block(RED, CUBE, 3, -1)
        post = block(BLUE, np.array([1, 1, 3]), 0.3, -2.2)
        self.assertTrue(is_top_hidden(behind, [beside, post], EYE))
        self.assertFalse(is_top_hidden(beside, [behind, post], EYE))
        self.assertFalse(is_top_hidden(post, [behind, beside, post], EYE))

    def test_regions_are_numbered_by_their_first_pixel(self):
        mask = np.array([[0, 1, 0, 1], [1, 1, 0, 1], [0, 0, 1, 0], [1, 0, 1, 1]], bool)
        np.testing.assert_array_equal(
            label_regions(mask), [[0, 1, 0, 4], [1, 1, 0, 4], [0, 0, 3, 0], [2, 0, 3, 3]])

    def test_regions_that_meet_late_are_one(self):
        spiral = np.zeros((40, 40), bool)
        spiral[::2] = True
        self.assertEqual(label_regions(spiral).max(), 20)
        spiral[:, 39] = True
        self.assertEqual(label_regions(spiral).max(), 1)

    def test_noisy_pictures_are_taken_repeatedly(self):
        picture = picture_of([block(RED, PLANK, 0, -2)])
        self.assertEqual(num_pictures(noise_of(picture)), 1)
        noise = 0.02 * np.random.default_rng(1).standard_normal(picture.shape)
        self.assertAlmostEqual(num_pictures(noise_of(picture + noise)), 16, delta=1)

    def test_noise_leaves_flat_colors_also_where_it_is_cut_off(self):
        picture, heights = view_of([block(RED, PLANK, 0, -2), block(GREEN, CUBE, 3, -2, yaw=0.3)])
        picture[(picture == TABLE).all(axis=2)] = 1
        picture[:100] = 0
        picture = np.round(255 * picture) / 255
        random = np.random.default_rng(1)
        noisy = [np.round(np.clip(255 * picture + 7.5 * random.standard_normal(picture.shape), 0, 255)) / 255
                 for _ in range(36)]
        noise = noise_of(noisy[0])
        self.assertAlmostEqual(noise, 7.5 / 255, delta=0.004)
        found = without_noise(np.mean(noisy, axis=0), noise, len(noisy))
        self.assertLess(np.mean(np.abs(found - picture).max(axis=2) > 1.5 / 255), 0.001)
        self.assertEqual(len(detect_unknown_objects(found, EYE, [], heights)), 2)

    def test_a_point_ahead_is_in_the_middle_of_the_picture(self):
        ahead = EYE.pose[:3, 3] + 9 * EYE.pose[:3, 2]
        np.testing.assert_allclose(to_pixel(ahead, EYE), [320, 240])


if __name__ == "__main__":
    unittest.main()
