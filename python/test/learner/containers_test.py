"""Tests tasks with containers, from the demonstration to the moves: an open box, and a pot with a lid."""

import math
import unittest

import numpy as np

from act.finger_room import grasp_yaws
from check.progress import assess_progress, open_steps
from check.task_state import TaskState
from explain.demonstration import read_demonstration
from explain.explanation import explain
from explain.limits import NotUnderstood
from explain.task_model import infer_task
from match.building_site import choose_site
from match.found_places import place_in_containers
from plan.proposals import propose_moves
from recordings import RecordingTest
from scenes import BLUE, BROWN, CUBE, DARK, EYE, RED, block, empty_box, picture_of, view_of
from see.containers import detect_container
from see.detection import detect_blocks
from see.knobs import find_knobs
from things.areas import rotated
from things.held_parts import held_part
from things.walls import container_walls


class ContainerTest(RecordingTest):
    """A blue cube is put into a box whose floor is 0.2 high."""

    BEGIN = ["0,create,Case,shape,box", "0,create,Blue,shape,block", "0,move,Case,-1.0,-1.0,0.45,0.0,0.0,0.0",
             "0,move,Blue,3.0,-3.0,0.5,0.0,0.0,0.0"]
    PUT_IN = ["1,grasp,LeftHand,Blue", "2,release,LeftHand", "2,move,Blue,0.5,-1.3,0.7,0.0,0.0,0.0"]

    def setUp(self):
        cube = block(BLUE, CUBE, 3, -3)
        self.record(picture_of([*empty_box(-1, -1, 0), cube]))
        self.write(0, self.BEGIN)
        self.write(1, self.PUT_IN)
        self.steps, [self.container] = self.infer_task()

    def test_it_is_measured_where_it_stands(self):
        np.testing.assert_allclose(self.container.position, [-1, -1, 0.45], atol=0.03)
        np.testing.assert_allclose(self.container.size, [5, 2.6, 0.9], atol=0.05)
        self.assertAlmostEqual(self.container.floor, 0.2)

    def record_two_boxes(self, *things):
        cubes = [block(BLUE, CUBE, 3, -3), block(RED, CUBE, 5, -3)]
        self.record(picture_of([*empty_box(-1, -1, 0), *cubes, *things]))
        self.write(0, [*self.BEGIN, "0,create,Other,shape,box", "0,create,Red,shape,block",
                       "0,move,Other,-6.0,-1.0,0.45,0.0,0.0,90.0", "0,move,Red,5.0,-3.0,0.5,0.0,0.0,0.0"])
        self.write(1, [*self.PUT_IN, "3,grasp,LeftHand,Red", "4,release,LeftHand", "4,move,Red,-6.0,-0.5,0.8,0.0,0.0,0.0"])

    def test_each_thing_goes_with_the_box_that_it_was_put_into(self):
        self.record_two_boxes(*empty_box(-6, -1, math.pi / 2))
        (blue, red), (case, other) = self.infer_task()
        self.assertEqual([(it.name, round(it.floor, 3)) for it in (case, other)], [("Case", 0.2), ("Other", 0.3)])
        picture = picture_of([*empty_box(-1, -1, 0.3), *empty_box(-6, -2, math.pi / 2)])
        (there, red_there), found = place_in_containers([blue, red], [case, other], [], picture, EYE)
        np.testing.assert_allclose([it.position[:2] for it in found], [[-1, -1], [-6, -2]], atol=0.03)
        np.testing.assert_allclose(there.position[:2], rotated([1.5, -0.3], 0.3) + [-1, -1], atol=0.05)
        np.testing.assert_allclose(red_there.position[:2], [-6, -1.5], atol=0.05)

    def test_a_box_of_which_an_arm_hides_a_corner_is_where_the_texts_say(self):
        arm = block(DARK, np.array([1.5, 1.5, 3]), -3, -2)
        self.record_two_boxes(*empty_box(-6, -1, math.pi / 2), arm)
        _, (case, _) = self.infer_task()
        np.testing.assert_allclose([*case.position, *case.size], [-1, -1, 0.45, 5, 2.6, 0.9], atol=0.06)

    def test_what_is_put_into_something_that_no_picture_shows_is_not_understood(self):
        self.record_two_boxes()
        with self.assertRaisesRegex(NotUnderstood, "no picture of the demonstration shows on or in what Red was put"):
            self.infer_task()

    def test_it_is_detected_elsewhere_with_its_content(self):
        there = block(BLUE, CUBE, 0.9, -1.6, bottom=0.2, yaw=0.3)
        picture = picture_of([*empty_box(1, -2, 0.3), there])
        found, turn = detect_container(picture, EYE, self.container)
        np.testing.assert_allclose(found.position, [1, -2, 0.45], atol=0.03)
        self.assertAlmostEqual(turn, 0.3, delta=0.02)
        [seen] = detect_blocks(picture, EYE, self.steps, [found])
        self.assertAlmostEqual(seen.position[2], 0.7)
        there.position = found.position + [0, 0, 0.25]
        self.assertEqual(len(grasp_yaws(there, container_walls([found]))), 4)
        there.position = found.position + [1.7 * math.cos(0.3), 1.7 * math.sin(0.3), 0.25]
        self.assertEqual(len(grasp_yaws(there, container_walls([found]))), 2)


def pot(x, y):
    """Returns the walls of a pot, the far ones first, and its floor."""
    walls = [((2.5, 0.2), (0, 1.15)), ((0.2, 2.5), (1.15, 0)), ((0.2, 2.5), (-1.15, 0)),
             ((2.5, 0.2), (0, -1.15))]
    return [block(BROWN, np.array([2.3, 2.3, 0.2]), x, y),
            *(block(BROWN, np.array([*size, 1.5]), x + away[0], y + away[1]) for size, away in walls)]


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
        (red, lid), [container] = self.infer_task()
        self.assertEqual([red.name, red.after, lid.name, lid.after], ["Red", [], "Lid", [0]])
        self.assertTrue(lid.has_knob and lid.begins_there)
        np.testing.assert_allclose(lid.size, [2.8, 2.8, 0.2], atol=0.08)
        np.testing.assert_allclose(container.size, [2.5, 2.5, 1.5], atol=0.08)
        demo = read_demonstration(self.folder)
        infer_task(demo, {})
        self.assertIn("on Lid Pot", explain(demo, [container]).keyframes[0].facts)

    def test_it_is_taken_off_by_its_knob_before_anything_is_put_inside(self):
        steps, containers = self.infer_task()
        scene = [*self.lid(1, -2, 1.5), block(RED, CUBE, -3, -2)]
        picture, heights = view_of(scene)
        state = TaskState(steps, containers)
        seen = detect_blocks(picture, EYE, steps, heights=heights)
        find_knobs(steps, seen, picture, EYE, heights)
        [lid] = [it for it in seen if it.knob]
        np.testing.assert_allclose(held_part(lid).position, [1, -2, 2.05], atol=0.05)
        self.assertEqual(len(grasp_yaws(lid, [])), 4)
        state.known = seen
        self.assertIsNone(choose_site(state, [], picture, EYE))
        np.testing.assert_allclose(state.containers[0].position, [1, -2, 0.75], atol=0.05)
        self.assertEqual(assess_progress(state), [])
        self.assertEqual(open_steps(state), [0])
        self.assertIs(propose_moves(state, state.steps[0], seen)[0].block, lid)


if __name__ == "__main__":
    unittest.main()
