"""Tests how pieces are recognized whose tops are neither rectangles nor discs, and how they are held."""

import math
import unittest
from dataclasses import replace
from itertools import combinations
from types import SimpleNamespace

import numpy as np

from act.reach import is_reachable
from check.verdicts import verdicts_on
from explain.appearances import measure_objects
from explain.demonstration import read_demonstration
from explain.task_model import supports_of
from match.landmarks import groups_of
from recordings import RecordingTest
from scenes import BLUE, EYE, RED, block, picture_of, step, view_of
from see.detection import detect_blocks
from see.eye import to_pixel
from see.faces import is_polygon
from see.sight import top_points
from see.unknown_objects import detect_unknown_objects
from things.areas import rotated
from things.blocks import yaw_difference
from things.grips import grips_of
from things.held_parts import held_anyhow, held_part
from things.kinds import is_same_kind
from things.outlines import outline_of, same_outline
from things.standing import is_around


def angle(x, y, yaw=0.0, bottom=0.0, mirror=1):
    """Returns two red blocks that form an L, the far one first."""
    parts = [[0.6, 0.9, -0.3 * mirror, 0.35], [1.8, 0.6, 0.3 * mirror, -0.4]]
    blocks = []
    for along, across, dx, dy in parts:
        dx, dy = rotated([dx, dy], yaw)
        blocks.append(block(RED, np.array([along, across, 0.6]), x + dx, y + dy, bottom, yaw))
    return sorted(blocks, key=lambda it: -it.position[1])


def points_of(is_inside):
    """Returns x, y and areas of the points of a grid that are inside a shape."""
    x, y = (it.ravel() for it in np.meshgrid(np.arange(-1, 1, 0.02) + 0.01, np.arange(-1, 1, 0.02) + 0.01))
    inside = is_inside(x, y)
    return x[inside], y[inside], np.full(inside.sum(), 0.0004)


CROSS = points_of(lambda x, y: (abs(x) < 0.3) | (abs(y) < 0.3))
RING = points_of(lambda x, y: abs(np.hypot(x, y) - 0.7) < 0.2)
HEXAGON = points_of(lambda x, y: (abs(y) < 0.5 * math.sqrt(3)) & (math.sqrt(3) * abs(x) + abs(y) < math.sqrt(3)))
TRIANGLE = points_of(lambda x, y: (x > -0.4) & (x + math.sqrt(3) * abs(y) < 0.8))


class OutlinesTest(RecordingTest):
    """An L is lifted and turned."""

    def setUp(self):
        self.record(picture_of(angle(2, -3)), picture_of(angle(1, -2.5, 0.2, 1.5)))
        self.write(0, ["0,create,Angle,shape,composite", "0,move,Angle,2.0,-3.0,0.3,0.0,0.0,0.0"])
        self.write(1, ["1,grasp,LeftHand,Angle", f"1,move,Angle,1.0,-2.5,1.8,0.0,0.0,{math.degrees(0.2)}"])
        self.write(2, ["2,release,LeftHand"])
        self.kind = measure_objects(read_demonstration(self.folder), [0])[0]

    def test_a_piece_is_measured_by_its_outline_in_two_pictures(self):
        outline = self.kind.outline
        self.assertAlmostEqual(outline.area, 1.62, delta=0.05)
        self.assertEqual(outline.fold, 1)
        np.testing.assert_allclose(self.kind.size, [2.4, 1.6, 0.6], atol=0.06)
        x, y = outline.inside.T
        is_inside = (abs(x + 0.3) < 0.25) & (y > -0.65) & (y < 0.75) | (abs(y + 0.4) < 0.25) & (x > -0.55) & (x < 1.15)
        self.assertTrue(is_inside.all(), outline.inside)

    def test_a_piece_is_recognized_at_each_yaw(self):
        for yaw in -1.2, 0.3, 0.3 + math.pi:
            picture, heights = view_of(angle(-2, -3, yaw))
            [found] = detect_blocks(picture, EYE, [self.kind], heights=heights)
            np.testing.assert_allclose(found.position, [-2, -3, 0.3], atol=0.03)
            self.assertLess(abs(yaw_difference(found, yaw)), 0.02)
            self.assertTrue(is_same_kind(found, self.kind))
            self.assertTrue(all(abs(heights[tuple(np.floor(it).astype(int))] - 0.6) < 0.01 for it in pixels_of_top(found)))
            self.assertEqual(detect_unknown_objects(picture, EYE, [found], heights), [])

    def test_other_shapes_are_other_pieces(self):
        for others in angle(-2, -3, mirror=-1), [block(RED, np.array([2, 0.9, 0.6]), -2, -3)]:
            picture, heights = view_of(others)
            self.assertEqual(detect_blocks(picture, EYE, [self.kind], heights=heights), [])
        self.assertFalse(is_same_kind(block(RED, self.kind.size, -2, -3), self.kind))

    def test_what_stands_in_the_corner_of_a_piece_is_not_in_its_place(self):
        post = block(BLUE, np.array([0.6, 0.6, 1.0]), -1.69, -2.77)
        there = replace(self.kind, position=np.array([-2, -3, 0.3]), yaw=0.0)
        for blocks, word in (([*angle(-2, -3), post], "hidden"), ([post], "contradicted")):
            picture, heights = view_of(blocks)
            [verdict] = verdicts_on([there], detect_blocks(picture, EYE, [self.kind, post], heights=heights), picture, EYE, heights)
            self.assertEqual((verdict.word, verdict.found), (word, None))

    def test_a_ring_is_around_what_is_in_its_hole(self):
        ring = replace(block(RED, np.array([1.8, 1.8, 0.5]), 2, -1), outline=outline_of(*RING))
        post, far = block(BLUE, np.array([0.5, 0.5, 1.0]), 2, -1), block(BLUE, np.array([0.5, 0.5, 1.0]), 4, -1)
        below = block(BLUE, np.array([3, 3, 0.2]), 2, -1)
        on_it = replace(ring, position=ring.position + [0, 0, 0.2])
        self.assertEqual([is_around(ring, it) for it in (post, far)], [True, False])
        self.assertFalse(is_around(on_it, below), "it stands on that")
        self.assertFalse(is_around(replace(ring, outline=None), post))
        step_of_ring, step_of_post = step(ring, []), step(post, [])
        step_of_ring.outline = ring.outline
        step_of_far = step(far, [])
        self.assertEqual(supports_of([step_of_ring], [step_of_post, step_of_far]), [step_of_post])
        self.assertEqual(groups_of([step_of_post, step_of_far, step_of_ring]), [[1], [0, 2]], "each goes with its own post")

    def test_a_piece_looks_the_same_after_some_turns(self):
        for points, fold in (TRIANGLE, 3), (CROSS, 4), (HEXAGON, 6), (RING, 0):
            piece = replace(self.kind, outline=outline_of(*points), yaw=0.0)
            self.assertEqual(piece.outline.fold, fold)
            turn = 2 * math.pi / fold if fold else 1.0
            self.assertAlmostEqual(yaw_difference(piece, turn), 0)
            self.assertTrue(same_outline(piece.outline, outline_of(*rotated(points[:2], turn), points[2])))
        self.assertFalse(same_outline(outline_of(*CROSS), outline_of(*rotated(CROSS[:2], 0.5), CROSS[2])))
        self.assertEqual(yaw_difference(self.kind, self.kind.yaw + math.pi), math.pi)

    def test_a_hexagon_is_no_disc(self):
        disc = points_of(lambda x, y: np.hypot(x, y) < 0.2)
        self.assertEqual([is_polygon(*it) for it in (HEXAGON, disc)], [True, False])

    def test_a_piece_is_held_where_it_is_narrow_and_its_sides_are_parallel(self):
        held = held_part(replace(self.kind, yaw=1.0, position=np.array([3, -2, 0.3])))
        self.assertAlmostEqual(held.size[1], 0.6, delta=0.05)
        self.assertGreater(held.size[0], 1.1 * held.size[1])
        for points, width in (CROSS, 0.6), (RING, 1.8):
            grip, *_ = grips_of(*points[:2], 0.02, RED, 0.5)
            self.assertAlmostEqual(grip.size[1], width, delta=0.05)
        np.testing.assert_allclose(grip.position, 0, atol=0.05)

    def test_where_a_part_is_out_of_reach_a_piece_is_held_by_another(self):
        place = replace(self.kind, position=np.array([0, 0, 0.3]))
        ways = [held_part(it) for it in held_anyhow(place)]
        self.assertGreaterEqual(len(ways), 4)
        for one, other in combinations(ways, 2):
            turn = abs(math.remainder(one.yaw - other.yaw, math.pi))
            self.assertTrue(np.hypot(*(one.position - other.position)[:2]) > 0.4 or turn > 0.7)
        # Both legs are among them, and the hand of this arm reaches only what is on the left.
        self.assertTrue({True, False} <= {it.position[0] < 0 for it in ways if it.size[1] < 0.65})
        robot = SimpleNamespace(limits=lambda _: (np.full(3, -9), np.full(3, 9)))
        arm = SimpleNamespace(robot=robot, name="left", parked=None, has_torso=False, tool_pose=lambda point, across, opening: point,
                              inverse=lambda point, q, max_iterations: point if point[0] < limit else None)
        for limit in sorted(it.position[0] for it in ways):
            self.assertEqual(is_reachable(arm, place), any(it.position[0] < limit for it in ways), limit)


def pixels_of_top(block):
    """Returns the rows and columns that show some points of a block's top."""
    return [to_pixel(it, EYE)[::-1] for it in top_points(block)]


if __name__ == "__main__":
    unittest.main()
