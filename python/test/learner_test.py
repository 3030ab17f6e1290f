"""Tests the parts of the learner in python/learner, without the simulator: learner_test.py, with
python/learner on the path. matlab/test/learner_test.m contains the same claims about its twin.
"""

import json
import math
import tempfile
import unittest
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from unittest.mock import patch

import numpy as np
from PIL import Image

from balls import ball_color
from beliefs import corrected
from blocks import Block, yaw_difference
from building_site import choose_site, shifted
from clearance import container_walls, footprint, grasp_yaws, held_part, is_grasp_blocked, overlap
from containers import detect_container
from demonstration import read_demonstration
from detection import detect_blocks
from execution import Action, Grasp
from explain import explain
from eye import Eye, height_map, pixel_at, to_pixel
from joint_estimates import JointEstimates
from knobs import find_knobs
from landmarks import place_by_what_stays
from motion_planning import grip_depth, has_failed, plan_pick_and_place
from notes import tops_of, verdict_notes
from pictures import num_pictures
from progress import assess_progress, compare, open_steps
from proposals import Move, clearing_moves, propose_moves, turning_moves, uncovering_moves
from regions import is_cut, label_regions
from resting import resting_at, turns_between
from sentences import page_of
from sight import is_top_hidden
from sites import site_cost
from steps import Step
from task_model import infer_task
from task_state import TaskState, num_failures, remember_failure
from temporary_places import blocks_grasps, free_placements
from unexplained import is_unexplained, unexplained_points
from unknown_objects import detect_unknown_objects
from verdicts import verdicts_on

RED, GREEN, BLUE = np.eye(3)
CUBE = np.array([1.0, 1, 1])
PLANK = np.array([4.0, 1, 1])
BROWN = np.array([0.5, 0.3, 0.2])
TABLE = np.array([0.6, 0.5, 0.4])
TILT = math.radians(56.05)  # of the robot's eye, downwards
EYE = Eye(np.array([[240 / math.tan(math.pi / 6), 0, 320], [0, 240 / math.tan(math.pi / 6), 240],
                    [0, 0, 1]]),
          np.array([[1, 0, 0, 0], [0, -math.sin(TILT), math.cos(TILT), -6.1168],
                    [0, -math.cos(TILT), -math.sin(TILT), 11.5921], [0, 0, 0, 1]]))


def block(color, size, x, y, bottom=0.0, yaw=0.0):
    return Block(color, size, np.array([x, y, bottom + size[2] / 2]), yaw)


def step(it, on):
    return Step(it.color, it.size, it.position, it.yaw, "step", on)


def update_beliefs(known, seen, picture, eye, heights=None):
    """Returns the known blocks after a look at a picture."""
    return corrected(seen, verdicts_on(known, seen, picture, eye, heights))


def picture_of(blocks):
    """Renders blocks as the eye sees them, lower ones first: 480x640x3."""
    return view_of(blocks)[0]


def view_of(blocks):
    """Renders blocks, lower ones first. Returns the picture, 480x640x3, and the height of what each
    pixel shows, 480x640 [units]."""
    picture = np.tile(TABLE, (480, 640, 1))
    heights = np.zeros((480, 640))
    row, column = np.indices((480, 640))
    ray = EYE.pose[:3, :3] @ [
        (column.ravel() + 0.5 - 320) / EYE.intrinsics[0, 0],
        (row.ravel() + 0.5 - 240) / EYE.intrinsics[1, 1], np.ones(row.size)]
    for it in blocks:
        # Rectangles below each other form the sides. The top is drawn last.
        for height in np.linspace(it.top - it.size[2], it.top, 6):
            x, y, _ = EYE.pose[:3, 3:] + ray * (height - EYE.pose[2, 3]) / ray[2]
            x, y = x - it.position[0], y - it.position[1]
            along = abs(x * math.cos(it.yaw) + y * math.sin(it.yaw))
            across = abs(y * math.cos(it.yaw) - x * math.sin(it.yaw))
            hit = (along <= it.size[0] / 2) & (across <= it.size[1] / 2)
            if it.is_round:
                hit = np.hypot(along, across) <= it.size[0] / 2
            hit = hit.reshape(480, 640)
            picture[hit] = it.color * (1 if height == it.top else 0.7)
            heights[hit] = height
    return picture, heights


def add_ball(picture, heights, color, center, radius):
    """Renders a ball into a picture and its heights."""
    row, column = np.indices((480, 640))
    ray = np.stack([(column + 0.5 - 320) / EYE.intrinsics[0, 0],
                    (row + 0.5 - 240) / EYE.intrinsics[1, 1],
                    np.ones((480, 640))], axis=-1) @ EYE.pose[:3, :3].T
    ray /= np.linalg.norm(ray, axis=-1, keepdims=True)
    to_center = center - EYE.pose[:3, 3]
    along = ray @ to_center
    inside = radius**2 - (to_center @ to_center - along**2)
    hit = inside > 0
    point = EYE.pose[:3, 3] + ray * (along - np.sqrt(np.maximum(inside, 0)))[..., None]
    shade = 0.8 + 0.2 * (point - center)[..., 2:] / radius
    picture[hit] = (shade * color)[hit]
    heights[hit] = point[hit][:, 2]


class PerceptionTest(unittest.TestCase):
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

    def test_depth_determines_heights(self):
        _, heights = view_of([block(RED, CUBE, 1, -2), block(BLUE, CUBE, -2, -3, bottom=1.5)])
        row, column = np.indices(heights.shape).reshape(2, -1)
        ray = EYE.pose[2, :3] @ [(column + 0.5 - 320) / EYE.intrinsics[0, 0],
                                 (row + 0.5 - 240) / EYE.intrinsics[1, 1], np.ones(row.size)]
        depth = (heights - EYE.pose[2, 3]) / ray.reshape(heights.shape)
        np.testing.assert_allclose(height_map(depth, EYE), heights, atol=1e-9)
        np.testing.assert_array_equal(height_map(0 * depth, EYE), 0 * depth)

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


class NoiseTest(unittest.TestCase):
    """What the sensors measure has noise."""

    TICK = 1 / 60  # [s]

    def estimates_while(self, truths, told, noise):
        """Returns the estimates of one arm of two joints that begins at [0, 0]."""
        random = np.random.default_rng(1)
        joints = JointEstimates([np.zeros(2)])
        estimates = []
        for truth, velocities in zip(truths, told):
            arm = SimpleNamespace(joints=truth + noise * random.standard_normal(2))
            joints.correct(SimpleNamespace(timeElapsed=self.TICK, arms=[arm]), self.TICK)
            joints.remember(SimpleNamespace(arms=[SimpleNamespace(velocities=velocities)]))
            estimates.append(arm.joints)
        return np.array(estimates)

    def test_noisy_joints_are_where_the_motors_brought_them(self):
        told = np.repeat([[0, 0], [0.5, -0.5], [0, 0]], [20, 60, 20], axis=0)
        truths = np.cumsum(np.vstack([[0, 0], told[:-1]]), axis=0) * self.TICK
        pushed = truths + np.repeat([[0], [0.1]], [90, 10], axis=0)
        exact = self.estimates_while(pushed, told, 0)
        np.testing.assert_array_equal(exact, pushed)
        noisy = self.estimates_while(truths, told, 0.01)
        self.assertLess(np.abs(noisy - truths).max(), 0.004)

    def test_joints_stop_at_an_obstacle_whatever_the_motors_are_told(self):
        told = np.repeat([[0, 0], [0.2, 0]], [20, 120], axis=0)
        blocked = self.estimates_while(np.zeros((140, 2)), told, 0.01)
        self.assertLess(np.abs(blocked).max(), 0.1, "the motors were told to go to 0.4")

    def test_noisy_pictures_are_taken_repeatedly(self):
        picture = 255 * picture_of([block(RED, PLANK, 0, -2)])
        self.assertEqual(num_pictures(picture), 1)
        noise = 255 * 0.02 * np.random.default_rng(1).standard_normal(picture.shape)
        self.assertAlmostEqual(num_pictures(picture + noise), 16, delta=1)


class ClearanceTest(unittest.TestCase):
    def test_overlap_agrees_with_points_inside_both(self):
        random = np.random.default_rng(1)
        share = np.stack(np.meshgrid(*[np.linspace(-0.5, 0.5, 41)] * 2), -1).reshape(-1, 2)
        one = np.array([0.3, -0.2, 2.0, 0.7, 0.4])
        many = np.column_stack([random.uniform(-2.5, 2.5, (300, 2)),
                                random.uniform(0.5, 3, (300, 2)), random.uniform(-4, 4, 300)])
        answers = overlap(one, many)
        np.testing.assert_array_equal(overlap([one, many[0]], many),
                                      np.transpose([answers, overlap(many[0], many)]))
        for rectangle, answer in zip(many, answers):
            def has_common_point(grow):
                sides = rectangle[2:4] + grow
                c, s = np.cos(rectangle[4]), np.sin(rectangle[4])
                points = (share * sides) @ [[c, s], [-s, c]] + rectangle[:2] - one[:2]
                c, s = np.cos(one[4]), np.sin(one[4])
                inside = np.abs(points @ [[c, -s], [s, c]]) <= (one[2:4] + grow) / 2
                return inside.all(axis=1).any()

            # Points lie up to 0.08 apart, so as much larger or smaller ones bracket the truth.
            if has_common_point(-0.15):
                self.assertTrue(answer, rectangle)
            if not has_common_point(0.15):
                self.assertFalse(answer, rectangle)
        self.assertGreater(answers.sum(), 50)
        self.assertGreater((~answers).sum(), 50)

    def test_grasp_yaws_avoid_other_blocks(self):
        middle = block(RED, CUBE, 0, -2)
        left, right = block(GREEN, CUBE, -1.1, -2), block(GREEN, CUBE, 1.1, -2)
        self.assertEqual(len(grasp_yaws(middle, [])), 4)
        np.testing.assert_allclose(np.sin(grasp_yaws(middle, [left, right])), [1, -1])
        self.assertEqual(grasp_yaws(block(RED, PLANK, 0, -3.1), [middle]), [])
        self.assertTrue(is_grasp_blocked(middle, [left, right, block(BLUE, CUBE, 0, -3.1)]))
        self.assertFalse(is_grasp_blocked(middle, [block(BLUE, CUBE, 4, -2)]))


class RecordingTest(unittest.TestCase):
    def record(self, *pictures):
        """Creates a folder for the texts of a recording, with these pictures."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        (self.folder / "rgb").mkdir()
        for i, picture in enumerate(pictures):
            Image.fromarray((picture * 255).round().astype("u1")).save(self.folder / f"rgb/{i}.png")
        tilt = -(math.pi / 2 + TILT) / 2
        (self.folder / "demo.json").write_text(json.dumps({"meters_per_unit": 0.1, "eye": {
            "fx": EYE.intrinsics[0, 0], "fy": EYE.intrinsics[1, 1], "cx": 320.0, "cy": 240.0,
            "position_m": list(EYE.pose[:3, 3] / 10),
            "rotation_wxyz": [math.cos(tilt), math.sin(tilt), 0.0, 0.0]}}))

    def write(self, segment, lines):
        (self.folder / f"{segment}.txt").write_text("\n".join(lines) + "\n")

    def infer_task(self, attention=None):
        return infer_task(read_demonstration(self.folder), attention or {})


class InferenceTest(RecordingTest):
    """A plank stays; a red cube is put on it, another stays, and a blue cube is moved twice."""

    def setUp(self):
        quarter = np.array([1.0, 4, 1])  # a plank that is longer along its y axis
        self.objects = {"Plank": block(GREEN, quarter, -2, -2, yaw=0.2),
                        "Red": block(RED, CUBE, 3, -3), "Other": block(RED, CUBE, 3, -1),
                        "Blue": block(BLUE, CUBE, 1, -4)}
        self.record(picture_of(self.objects.values()))
        self.write(0, [f"0,create,{name},shape,block" for name in self.objects] + [
            f"0,move,{name},{it.position[0]},{it.position[1]},{it.position[2]},0.0,-0.0,"
            f"{math.degrees(it.yaw)}" for name, it in self.objects.items()])
        self.write(1, ["3,grasp,LeftHand,Blue", "5,move,Blue,0.0,-4.0,2.0,0.0,0.0,0.0",
                       "6,release,LeftHand", "6,move,Blue,0.0,-4.0,0.5,0.0,0.0,0.0"])
        self.write(2, ["7,grasp,AnyHand,Red", "9,release,AnyHand",
                       "9,move,Red,-2.0,-1.5,1.5,1.0E-4,0.0,95.0",
                       "10,grasp,LeftHand,Blue", "11,release,LeftHand",
                       "11,move,Blue,-2.0,-1.5,2.5,0.0,0.0,0.0"])

    def test_steps_come_in_the_order_of_building(self):
        steps, container = self.infer_task({"Blue": ["size"]})
        self.assertIsNone(container)
        self.assertEqual([step.name for step in steps], ["Plank", "Red", "Blue"])
        plank, red, blue = steps
        self.assertEqual([step.on for step in steps], [[], [0], [1]])
        np.testing.assert_allclose(plank.size, [4, 1, 1], atol=0.03)  # the longer side comes first
        self.assertLess(abs(yaw_difference(plank, 0.2 + math.pi / 2)), 1e-9)
        np.testing.assert_allclose(red.position, [-2, -1.5, 1.5])
        self.assertAlmostEqual(red.yaw, math.radians(95))
        np.testing.assert_allclose(red.color, RED)
        self.assertIsNone(blue.color, "the demonstrator specified that only its size matters")

    def test_an_order_that_matters_is_kept(self):
        steps, _ = self.infer_task()
        self.assertEqual([step.after for step in steps], [[], [], []])
        steps, _ = self.infer_task({"Red": ["color", "size", "order"]})
        self.assertEqual([step.after for step in steps], [[], [], [1]])
        state = TaskState(steps)
        state.done = [True, False, False]
        self.assertEqual(open_steps(state), [1])

    def test_what_was_not_moved_stays(self):
        steps, _ = self.infer_task()
        self.assertEqual([step.stays for step in steps], [True, False, False])

    def test_the_goal_is_what_is_made_and_kept(self):
        demo = read_demonstration(self.folder)
        steps, container = infer_task(demo, {})
        explanation = explain(demo, container)
        self.assertEqual([it.deed for it in explanation.keyframes],
                         ["", "LeftHand carries Blue", "AnyHand carries Red", "LeftHand carries Blue"])
        self.assertEqual([it.is_means for it in explanation.keyframes], [False, True, False, False])
        self.assertIn("on Blue table", explanation.keyframes[2].facts)
        self.assertEqual(explanation.goal, ["on Red Plank", "place Red Plank 0.10 0.49 84", "on Blue Red",
                                            "place Blue Red 0.00 0.00 -95"])
        page = page_of(explanation)
        self.assertIn("1. LeftHand carries Blue (only a means: nothing of it is kept). New:", page)
        self.assertEqual(page[-1], "  Blue is on Red, at (0.00, 0.00) of Red, rotated by -95 degrees.")

    def test_a_recording_without_pictures_is_reported(self):
        file = self.folder / "demo.json"
        file.write_text(json.dumps(json.loads(file.read_text()) | {"eye": None}))
        with self.assertRaisesRegex(ValueError, "has no pictures"):
            read_demonstration(self.folder)

    def test_what_cannot_be_inferred_is_reported(self):
        with self.assertRaisesRegex(FileNotFoundError, "there is no recording in .*0.txt"):
            read_demonstration(self.folder / "rgb")
        demo = read_demonstration(self.folder)
        demo.placed.clear()
        with self.assertRaisesRegex(ValueError, "no hand moved anything"):
            infer_task(demo, {})
        (self.folder / "rgb/0.png").unlink()
        with self.assertRaisesRegex(ValueError, "no picture of the demonstration shows Red entirely"):
            self.infer_task()


class UnstackingTest(RecordingTest):
    """A tower is taken apart. Its lower blocks, a half and a cube, are visible only later."""

    def setUp(self):
        tower = [block(RED, np.array([1, 1, 0.5]), -2, -2), block(GREEN, CUBE, -2, -2, bottom=0.5),
                 block(BLUE, CUBE, -2, -2, bottom=1.5)]
        apart = [block(it.color, it.size, x, -3) for it, x in zip(tower, (-2, 0, 2))]
        self.record(picture_of(tower), picture_of([*tower[:2], apart[2]]),
                    picture_of([tower[0], *apart[1:]]))
        names = ["Red", "Green", "Blue"]
        lifted = block(RED, CUBE, 3, 0, bottom=4)
        self.write(0, [f"0,create,{name},shape,block" for name in names] + [
            self.move(0, name, it) for name, it in zip(names, tower)])
        self.write(1, ["1,grasp,AnyHand,Blue", self.move(1, "Blue", lifted),
                       self.move(1, "Blue", apart[2]), "1,release,AnyHand",
                       "2,grasp,AnyHand,Green", self.move(2, "Green", lifted),
                       self.move(2, "Green", apart[1]), "2,release,AnyHand",
                       "3,grasp,AnyHand,Red", self.move(3, "Red", lifted),
                       self.move(3, "Red", apart[0]), "3,release,AnyHand"])

    @staticmethod
    def move(frame, name, it):
        return f"{frame},move,{name},{it.position[0]},{it.position[1]},{it.position[2]},0.0,0.0,0.0"

    def test_heights_follow_from_what_is_below(self):
        steps, _ = self.infer_task()
        self.assertEqual([step.name for step in steps], ["Blue", "Green", "Red"])
        for step, height in zip(steps, (1, 1, 0.5)):
            np.testing.assert_allclose(step.size, [1, 1, height], atol=0.03)
            self.assertEqual(step.on, [])


class ContainerTest(RecordingTest):
    """A blue cube is put into a box whose floor is 0.2 high."""

    def setUp(self):
        cube = block(BLUE, CUBE, 3, -3)
        self.record(picture_of([*empty_box(-1, -1, 0), cube]))
        self.write(0, ["0,create,Case,shape,box", "0,create,Blue,shape,block",
                       "0,move,Case,-1.0,-1.0,0.45,0.0,0.0,0.0",
                       "0,move,Blue,3.0,-3.0,0.5,0.0,0.0,0.0"])
        self.write(1, ["1,grasp,LeftHand,Blue", "2,release,LeftHand",
                       "2,move,Blue,0.5,-1.3,0.7,0.0,0.0,0.0"])
        self.steps, self.container = self.infer_task()

    def test_it_is_measured_where_it_stands(self):
        np.testing.assert_allclose(self.container.position, [-1, -1, 0.45], atol=0.03)
        np.testing.assert_allclose(self.container.size, [5, 2.6, 0.9], atol=0.05)
        self.assertAlmostEqual(self.container.floor, 0.2)

    def test_it_is_detected_elsewhere_with_its_content(self):
        there = block(BLUE, CUBE, 0.9, -1.6, bottom=0.2, yaw=0.3)
        picture = picture_of([*empty_box(1, -2, 0.3), there])
        found, turn = detect_container(picture, EYE, self.container)
        np.testing.assert_allclose(found.position, [1, -2, 0.45], atol=0.03)
        self.assertAlmostEqual(turn, 0.3, delta=0.02)
        [seen] = detect_blocks(picture, EYE, self.steps, found)
        self.assertAlmostEqual(seen.position[2], 0.7)
        there.position = found.position + [0, 0, 0.25]
        self.assertEqual(len(grasp_yaws(there, container_walls(found))), 4)
        there.position = found.position + [1.7 * math.cos(0.3), 1.7 * math.sin(0.3), 0.25]
        self.assertEqual(len(grasp_yaws(there, container_walls(found))), 2)


def empty_box(x, y, yaw):
    """Returns blocks that look like an open box: its rim, a dark side inside, and its floor."""
    return [block(BROWN, np.array([5, 2.6, 0.9]), x, y, yaw=yaw),
            block(0.7 * BROWN, np.array([4.6, 2.2, 0]), x, y, bottom=0.9, yaw=yaw),
            block(BROWN, np.array([4.2, 1.8, 0]), x, y, bottom=0.9, yaw=yaw)]


class LidTest(RecordingTest):
    """A lid with a knob is put beside a pot, a red cube into the pot, and the lid on the pot again."""

    def setUp(self):
        cubes = [block(RED, CUBE, 3, -3), block(RED, CUBE, -2, -2, bottom=0.2)]
        self.record(picture_of([*self.lid(-2, -2, 1.5), cubes[0]]),
                    picture_of([*pot(-2, -2), *self.lid(2, 0, 0), cubes[0]]),
                    picture_of([*self.lid(-2, -2, 1.5)]))
        self.write(0, ["0,create,Pot,shape,box", "0,create,Lid,shape,composite",
                       "0,create,Red,shape,block", "0,move,Pot,-2.0,-2.0,0.75,0.0,0.0,0.0",
                       "0,move,Lid,-2.0,-2.0,1.6,0.0,0.0,0.0", "0,move,Red,3.0,-3.0,0.5,0.0,0.0,0.0"])
        self.write(1, ["0,grasp,LeftHand,Lid", "1,move,Lid,2.0,0.0,0.1,0.0,0.0,0.0",
                       "1,release,LeftHand", "1,grasp,LeftHand,Red",
                       "2,move,Red,-2.0,-2.0,0.7,0.0,0.0,0.0", "2,release,LeftHand",
                       "2,grasp,LeftHand,Lid", "2,move,Lid,-2.0,-2.0,1.6,0.0,0.0,0.0",
                       "2,release,LeftHand"])

    def lid(self, x, y, bottom):
        return [block(BROWN * 1.5, np.array([2.8, 2.8, 0.2]), x, y, bottom=bottom),
                block(BLUE, np.array([0.6, 0.6, 0.7]), x, y, bottom=bottom + 0.2)]

    def test_a_lid_covers_what_is_inside(self):
        (red, lid), container = self.infer_task()
        self.assertEqual([red.name, red.after, lid.name, lid.after], ["Red", [], "Lid", [0]])
        self.assertTrue(lid.has_knob and lid.begins_there)
        np.testing.assert_allclose(lid.size, [2.8, 2.8, 0.2], atol=0.08)
        np.testing.assert_allclose(container.size, [2.5, 2.5, 1.5], atol=0.08)
        demo = read_demonstration(self.folder)
        infer_task(demo, {})
        self.assertIn("on Lid Pot", explain(demo, container).keyframes[0].facts)

    def test_it_is_taken_off_by_its_knob_before_anything_is_put_inside(self):
        steps, container = self.infer_task()
        scene = [*self.lid(1, -2, 1.5), block(RED, CUBE, -3, -2)]
        picture, heights = view_of(scene)
        state = TaskState(steps, container)
        seen = detect_blocks(picture, EYE, steps, heights=heights)
        find_knobs(steps, seen, picture, EYE, heights)
        [lid] = [it for it in seen if it.knob]
        np.testing.assert_allclose(held_part(lid).position, [1, -2, 2.05], atol=0.05)
        self.assertEqual(len(grasp_yaws(lid, [])), 4)
        state.known = seen
        self.assertIsNone(choose_site(state, [], picture, EYE))
        np.testing.assert_allclose(state.container.position, [1, -2, 0.75], atol=0.05)
        self.assertEqual(assess_progress(state), [])
        self.assertEqual(open_steps(state), [0])
        self.assertIs(propose_moves(state, state.steps[0], seen)[0].block, lid)


def pot(x, y):
    """Returns the walls of a pot, the far ones first, and its floor."""
    walls = [((2.5, 0.2), (0, 1.15)), ((0.2, 2.5), (1.15, 0)), ((0.2, 2.5), (-1.15, 0)),
             ((2.5, 0.2), (0, -1.15))]
    return [block(BROWN, np.array([2.3, 2.3, 0.2]), x, y),
            *(block(BROWN, np.array([*size, 1.5]), x + away[0], y + away[1]) for size, away in walls)]


class DraggingTest(RecordingTest):
    """A door with a post on it is dragged by 2 and 1; another post of the same color stays."""

    def setUp(self):
        def scene(x, y):
            yellow, red, post = BROWN * 1.5, RED * 0.7, np.array([1, 0.6, 1.2])
            return picture_of([block(red, post, 4, -4),
                               block(yellow, np.array([3.0, 2, 2]), x, y, yaw=0.5),
                               block(red, post, x, y, bottom=2, yaw=0.5)])
        self.record(scene(-2, -3), scene(0, -2))
        self.write(0, ["0,create,Door,shape,composite", "0,move,Door,-2.2,-3.1,1.9,0.0,0.0,0.0"])
        self.write(1, ["1,grasp,LeftHand,Door", "1,move,Door,-0.2,-2.1,1.9,0.0,0.0,0.0",
                       "1,release,LeftHand"])

    def test_its_post_is_the_handle(self):
        [step], container = self.infer_task()
        self.assertIsNone(container)
        np.testing.assert_allclose(step.displacement, [2, 1])
        self.assertAlmostEqual(step.top, 3.2, delta=0.05)  # by its displacement
        np.testing.assert_allclose(step.position[:2], [-2, -3], atol=0.03)
        np.testing.assert_allclose(step.size[:2], [1, 0.6], atol=0.03)

    def test_an_invisible_handle_is_reported(self):
        (self.folder / "rgb/1.png").unlink()
        with self.assertRaisesRegex(ValueError, "the handle of Door"):
            self.infer_task()

    def test_the_displacement_of_a_rotated_one_is_rotated(self):
        [step], _ = self.infer_task()
        state = TaskState([step])
        problem = choose_site(state, None, None, None)
        self.assertFalse(state.has_site)
        self.assertRegex(problem, "0 visible objects look like Door")
        state.known = [block(step.color, step.size, 3, -2, yaw=0.8)]
        choose_site(state, None, None, None)
        self.assertTrue(state.has_site)
        c, s = math.cos(0.3), math.sin(0.3)
        np.testing.assert_allclose(state.steps[0].position[:2],
                                   [3 + 2 * c - s, -2 + 2 * s + c], atol=0.01)


class RestingTest(unittest.TestCase):
    plank = block(BROWN, np.array([3, 1, 0.5]), -2, 0)

    def test_an_object_on_its_side_looks_like_another_block(self):
        for angles, size, yaw in (([0, 0, 30], [3, 1, 0.5], 30), ([90, 0, 30], [3, 0.5, 1], 30),
                                  ([-90, 0, 30], [3, 0.5, 1], 30), ([0, -90, 20], [1, 0.5, 3], 110),
                                  ([45, 0, 0], [3, 1, 0.5], 0)):
            found = resting_at(self.plank, np.array([1, 2, 3, *angles]))
            np.testing.assert_allclose(found.size, size)
            self.assertAlmostEqual(found.yaw, math.radians(yaw))
            np.testing.assert_allclose(found.position, [1, 2, 3])

    def test_turns_about_the_fingers_bring_a_block_onto_any_face(self):
        flat, side, end = np.array([[3, 1, 0.5], [3, 0.5, 1], [1, 0.5, 3]])
        self.assertEqual(turns_between(flat, flat, 2), [])
        self.assertEqual(turns_between(flat, end, 2), [1])
        self.assertEqual(turns_between(flat, side, 2), [1, 1])
        self.assertIsNone(turns_between(flat, side, 0.9))
        self.assertIsNone(turns_between(flat, np.array([2, 1, 1]), 2))

    def test_it_is_turned_if_it_does_not_look_as_wanted(self):
        goal = replace(step(block(BROWN, np.array([3, 0.5, 1]), 0, -2), []), start_size=self.plank.size)
        state = TaskState([goal])
        self.assertEqual([list(it.size) for it in state.unknown_objects], [[1, 0.5, 3], [3, 1, 0.5]])
        self.assertEqual(turning_moves(goal, [self.plank], 1.9),
                         [Move(self.plank, turns=(1, 1)), Move(self.plank)])
        there = block(BROWN, goal.size, 3, -2)
        self.assertEqual(turning_moves(goal, [self.plank, there], 1.9), [])


class TaskPlanningTest(unittest.TestCase):
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
        orders = {tuple(open_steps(TaskState(steps, order_seed=seed))) for seed in range(60)}
        self.assertEqual(len(orders), 6)
        self.assertTrue(all(sorted(order) == [0, 1, 2] for order in orders))

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

    def test_the_building_is_where_the_demonstration_moved_nothing(self):
        bases = [block(BROWN, PLANK, 1, -2, yaw=0.1), block(BROWN, CUBE, 1, 0)]
        state = TaskState([replace(step(it, []), stays=True) for it in bases])
        turned = [block(BROWN, PLANK, -2, -2, yaw=0.1 - math.pi / 2), block(BROWN, CUBE, 0, -2),
                  block(BROWN, PLANK, 3, -2, yaw=0.3)]
        state.known = turned
        choose_site(state, [], None, EYE)
        np.testing.assert_allclose([it.position for it in state.steps],
                                   [it.position for it in turned[:2]], atol=1e-9)

    def test_each_object_that_stays_determines_where_the_steps_on_it_go(self):
        plates = [replace(step(block(RED, np.array([2, 2, 0.2]), -2, 1), []), stays=True),
                  replace(step(block(BLUE, np.array([2, 2, 0.2]), 2, 1), []), stays=True)]
        steps = [*plates, step(block(GREEN, CUBE, -2, 1, bottom=0.2), [0]),
                 step(block(RED, CUBE, 2, 1.2, bottom=0.2), [1])]
        known = [block(RED, plates[0].size, -3, -2), block(BLUE, plates[0].size, 2, -3, yaw=0.3)]
        with patch("sites.is_reachable", return_value=True), patch("sites.nearest_first"):
            moved = place_by_what_stays(steps, known, [], EYE)
        np.testing.assert_allclose(moved[2].position, [-3, -2, 0.7])
        np.testing.assert_allclose(moved[3].position, [2 - 0.2 * math.sin(0.3),
                                                       -3 + 0.2 * math.cos(0.3), 0.7])

    def test_a_site_must_not_hide_needed_blocks(self):
        steps = [step(block(BLUE, CUBE, 0, -2, bottom=k), []) for k in range(3)]
        needed = block(BLUE, CUBE, 0, -0.2)
        on_unseen = block(RED, CUBE, 0, -0.2, bottom=1)
        self.assertEqual(site_cost(steps, [needed], EYE), 0.25)
        self.assertEqual(site_cost(steps, [on_unseen], EYE), 1)
        self.assertEqual(site_cost(steps, [block(RED, CUBE, 0, -0.2)], EYE), 0)
        self.assertEqual(site_cost(shifted(steps, [3, 0]), [needed], EYE), 0)

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

    def test_a_large_block_is_put_where_the_eye_sees_all_of_it(self):
        lid = block(BROWN, np.array([2.6, 2.6, 0.2]), -4, -1, bottom=1.3)
        pot = block(BROWN, np.array([2.4, 2.4, 1.3]), -4, -1)
        places = free_placements([], EYE, lid, [pot], None)
        self.assertEqual(len(places), 100)
        for place in places:
            corners = place.position + [[x, y, 0.1] for x in (-1.3, 1.3) for y in (-1.3, 1.3)]
            pixels = np.array([to_pixel(corner, EYE) for corner in corners])
            self.assertTrue(place.yaw or (0 < pixels).all() and (pixels < [640, 480]).all())

    def test_failed_grasps_are_remembered(self):
        there, goal = block(RED, CUBE, 3, -2), block(RED, CUBE, 0, -2)
        state = TaskState(self.steps)
        state.known = [goal]
        state.grasp = Grasp(there.position, 0, 0.5)
        remember_failure(state, [Action("grasp"), Action("follow"), Action("open")])
        self.assertEqual(state.known, [], "it is not where it was to go")
        self.assertEqual(num_failures(state, there), 1)
        self.assertEqual(num_failures(state, goal), 0)
        for arm, yaw, expected in (0, 0.6, True), (0, 0.5 + math.pi, False), (1, 0.5, False):
            self.assertEqual(has_failed(Grasp(there.position, arm, yaw), state.failures), expected)

    def test_fingers_stay_above_what_a_low_block_stands_on(self):
        for height in 0.5, 0.75, 1, 2:
            tips = height - grip_depth(SimpleNamespace(reach=0.75), height) - 0.75
            self.assertGreaterEqual(tips, 0.05 - 1e-9)
        self.assertEqual(grip_depth(SimpleNamespace(reach=0.75), 2), 0.2)

    def test_a_block_wider_than_the_gripper_opens_is_not_taken(self):
        wide = block(BLUE, np.array([3, 2, 1]), 0, -2)
        _, reason = plan_pick_and_place([SimpleNamespace(opening=2)], wide, wide, [], None)
        self.assertEqual(reason, "it is wider than the gripper opens")

    def test_a_point_ahead_is_in_the_middle_of_the_picture(self):
        ahead = EYE.pose[:3, 3] + 9 * EYE.pose[:3, 2]
        np.testing.assert_allclose(to_pixel(ahead, EYE), [320, 240])


if __name__ == "__main__":
    unittest.main()
