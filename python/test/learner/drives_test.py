"""Tests what turns fasteners, and what is put aside until it comes back: a cover that a screw holds."""

import math
import unittest
from dataclasses import replace
from types import SimpleNamespace
from unittest.mock import patch

import numpy as np

from act.actions import Grasp
from act.arms import Arm
from check.task_state import TaskState
from constants import USES
from explain.demonstration import read_demonstration
from explain.devices import infer_devices
from explain.keyframes import deed_of
from explain.task_model import infer_task
from match.controls import locate
from match.returning import directed, place_below, place_returning
from plan.drive_planning import refined_at, was_driven
from plan.driving_hands import DrivingHand
from plan.finger_depths import with_depth
from plan.returning_moves import plan_returning
from recordings import RecordingTest
from scenes import BLUE, BROWN, DARK, EYE, GRAY, GREEN, LIGHT, RED, block, picture_of, view_of
from see.surfaces import surface_of
from things.areas import rotated

BRASS = np.array([0.85, 0.7, 0.3])
FUSE = np.array([0.8, 0.4, 0.8])


def disc(color, diameter, height, x, y, bottom):
    return replace(block(color, np.array([diameter, diameter, height]), x, y, bottom), form="disc")


def cover(x, y, z, yaw=0.0):
    """Returns a plate with a knob on it, z above the table, and the loose screw in it."""
    dx, dy = rotated([-1, 0.8], yaw)
    return [block(LIGHT, np.array([2.6, 2.2, 0.3]), x, y, z - 0.15, yaw),
            disc(BRASS, 0.6, 0.2, x + dx, y + dy, z + 0.15),
            block(GRAY, np.array([0.8, 0.4, 0.6]), x, y, z + 0.15, yaw)]


def scene(on, dead, driver=(5, -3, 0.2), spare=(0, -4)):
    """Returns a housing, its cover somewhere, the fuses, and a driver."""
    housing = [block(DARK, np.array([2.6, 2.2, 1.0]), -2, -2), block(0.7 * DARK, np.array([1.8, 1.8, 0]), -1.8, -2, 1.0)]
    things = [*housing, block(BROWN, np.array([1.4, 2, 0.8]), 3, -2), block(GREEN, FUSE, *spare),
              disc(BLUE, 0.7, 2.4, *driver)]
    return [*things[:2], *([block(RED, FUSE, *dead)] if dead else []), *things[2:], *cover(*on)]


HOME, ASIDE = (-2, -2, 1.15), (3, -2, 0.95, math.pi / 2)
PICTURES = {0: scene(HOME, None), 2: scene(HOME, None, (5, -3, 2)), 3: scene(HOME, None, (4, -3, 2)),
            6: scene(HOME, None), 8: scene((-2, -2, 2.6), (-2, -2, 0.1)), 9: scene(ASIDE, (-2, -2, 0.1)),
            12: scene(ASIDE, (-2, -2, 1.6)), 13: scene(ASIDE, (-3, -4, 1.6)), 20: scene(HOME, (-5, -4), spare=(6, -5))}
TEXT = """0,create,Cover,shape,composite
0,create,DeadFuse,shape,composite
0,create,Spare,shape,composite
0,create,Screw,shape,composite
0,create,Driver,shape,composite
0,move,Cover,-2,-2,1.15,0,0,0
0,move,DeadFuse,-2,-2,0.5,0,0,0
0,move,Spare,0,-4,0.4,0,0,0
0,move,Screw,-3,-1.2,1.3,0,0,0
0,move,Driver,5,-3,1.4,0,0,0
1,grasp,RightHand,Driver
2,move,Driver,5,-3,3.2,0,0,0
3,move,Driver,4,-3,3.2,0,0,0
4,move,Driver,-3,-1.2,3,0,0,0
4.5,move,Screw,-3,-1.2,1.4,0,0,0
4.5,move,Driver,-3,-1.2,2.9,0,0,0
4.5,use,RightHand,Driver,loosen,Screw
5,use,RightHand,Driver,loosen,Screw
5.5,move,Driver,5,-3,1.4,0,0,0
6,release,RightHand
7,grasp,RightHand,Cover
8,move,Cover,-2,-2,2.6,0,0,0
9,move,Cover,3,-2,0.95,0,0,90
10,release,RightHand
11,grasp,LeftHand,DeadFuse
12,move,DeadFuse,-2,-2,2,0,0,0
13,move,DeadFuse,-3,-4,2,0,0,0
14,move,DeadFuse,-5,-4,0.4,0,0,0
14,release,LeftHand
15,grasp,RightHand,Spare
16,move,Spare,-2,-2,0.5,0,0,0
17,release,RightHand
18,grasp,RightHand,Cover
19,move,Cover,-2,-2,1.15,0,0,0
20,release,RightHand
21,grasp,RightHand,Driver
22,move,Driver,-3,-1.2,3,0,0,0
23,use,RightHand,Driver,fasten,Screw
23.5,move,Driver,5,-3,1.4,0,0,0
24,release,RightHand"""


class CoverTest(RecordingTest):
    demo = None  # is the same in all tests

    def setUp(self):
        if not CoverTest.demo:
            self.read_demonstration()

    def read_demonstration(self):
        self.record(*(picture_of(it) for it in PICTURES.values()))
        for k, frame in reversed(list(enumerate(PICTURES))):
            (self.folder / f"rgb/{k}.png").rename(self.folder / f"rgb/{frame}.png")
        self.write(0, TEXT.splitlines())
        CoverTest.demo = read_demonstration(self.folder)
        CoverTest.steps, _ = infer_task(self.demo, {})
        CoverTest.drives = infer_devices(self.demo, self.steps)

    def test_what_began_inside_is_measured_by_how_its_top_moves(self):
        dead, spare, lid = self.steps
        np.testing.assert_allclose(dead.size, FUSE, atol=0.05)
        np.testing.assert_allclose(lid.size, [0.8, 0.4, 1.5], atol=0.1)
        tool = self.drives[0].tool
        self.assertEqual((tool.form, spare.takes_place_of), ("disc", "DeadFuse"))
        np.testing.assert_allclose(tool.size, [0.7, 0.7, 2.4], atol=0.1)

    def test_what_comes_back_is_put_aside_where_it_was_shown_and_waits_for_the_rest(self):
        _, _, lid = self.steps
        self.assertEqual(lid.after, [0, 1])
        np.testing.assert_allclose(lid.aside.place.position, [3, -2, 0.95])
        self.assertAlmostEqual(lid.aside.height, 2.6)
        self.assertIsNone(self.steps[0].aside)

    def test_what_is_put_aside_stays_there_until_it_comes_back(self):
        lid = self.steps[2]
        # An arm that failed in each of its grasps.
        state = TaskState(self.steps, failures=[Grasp(it.position, 0, yaw) for it in (lid, lid.aside.place)
                                                for yaw in np.arange(8) * math.pi / 4])
        arm, sensor = SimpleNamespace(index=0, opening=9, reach=0.7, palm=0.75, foot=np.zeros(2)), SimpleNamespace(arms=[SimpleNamespace(joints=[])])
        reasons = [plan_returning(it, lid, is_back, state, [arm], sensor)[2]
                   for it, is_back in [(lid.aside.place, False), (lid.aside.place, True), (lid, False)]]
        no_arm = "no arm reaches both its place and its goal"
        self.assertEqual(reasons, ["it is put aside already", no_arm, no_arm])

    def test_what_comes_back_is_brought_as_high_as_shown_beside_others_or_alone(self):
        lid = self.steps[2]
        arm = Arm(SimpleNamespace(gripper_middle=lambda *_: 0), "left", 0, 9, None, reach=0.7, foot=np.zeros(2))
        for others in ([], [block(GRAY, np.array([0.5, 0.5, 3]), 5, -4)]):
            state = TaskState(self.steps)
            state.known = others
            with (patch("plan.transfers.is_beyond", return_value=False),
                  patch("plan.transfers.plan_path_through", side_effect=lambda arm, poses, *_: [*poses, "home"]) as through):
                actions, place, _ = plan_returning(lid.aside.place, lid, True, state, [arm], SimpleNamespace(arms=[SimpleNamespace(joints=[])]))
            self.assertEqual([it.kind for it in actions][-3:], ["follow", "follow", "observe"])
            np.testing.assert_allclose(place.position, lid.position)
            self.assertEqual(through.call_args[0][2], others)

    def test_loosening_is_told_from_fastening_and_turns_are_counted(self):
        first, last = self.drives
        self.assertEqual((first.after, last.after, last.control), ([], [0, 1, 2], first.control))
        [loosening], [fastening] = first.turns, last.turns
        self.assertEqual((loosening.is_loosening, loosening.number), (True, 2))
        self.assertEqual((fastening.is_loosening, fastening.number), (False, 1))
        # Half way between where it began, as much lower as the screw, and where it was after the first turn.
        np.testing.assert_allclose(loosening.place, [-3, -1.2, 2.85])
        self.assertEqual(str(first), "loosening of Screw with Driver")
        deed = deed_of("use", ["RightHand", "Driver", "fasten", "Screw"], {})
        self.assertEqual(deed, "RightHand fastens Screw with Driver")

    def test_in_another_scene_both_places_are_found_and_what_is_hidden_between(self):
        moved = [replace(it, position=it.position + [0.5, 0.3, 0]) for it in PICTURES[0]]
        picture, heights = view_of(moved)
        lid = self.steps[2]
        found = {name: locate(it, picture, heights, EYE, EYE)
                 for name, it in (("Cover", lid.aside), ("Screw", self.drives[0]))}
        seen = replace(lid, position=lid.position + [0.5, 0.3, 0], yaw=math.pi)
        state = TaskState(self.steps, known=[seen], presses=self.drives, shown=EYE, alignments=found)
        back = place_returning(lid, state)
        np.testing.assert_allclose(back.position[:2], [-1.5, -1.7], atol=1e-6)
        self.assertAlmostEqual(back.yaw, 0, delta=0.05)  # of both yaws with which the knob looks the same
        np.testing.assert_allclose(back.aside.place.position[:2], [3.5, -1.7], atol=0.05)
        hidden = place_below(self.steps[1], [lid], [back])
        np.testing.assert_allclose(hidden.position, [-1.5, -1.7, 0.5], atol=0.05)
        at = refined_at(self.drives[0], found["Screw"], surface_of(picture, heights, EYE), EYE)
        place = rotated(self.drives[0].turns[0].place[:2] - at.place, -at.angle)
        np.testing.assert_allclose(place, [-2.5, -0.9], atol=0.04)

    def test_a_drive_counts_as_done_when_its_tool_is_back(self):
        drive = replace(self.drives[0])
        state = TaskState(self.steps, known=[drive.tool])
        self.assertFalse(was_driven(drive, state))
        drive.attempts, drive.grasp = 1, object()
        self.assertTrue(was_driven(drive, state))
        state.failures.append(drive.grasp)
        self.assertFalse(was_driven(drive, state))


class HandTest(unittest.TestCase):
    def test_fingers_stay_above_what_is_beside(self):
        surface = surface_of(*view_of(cover(0, -2, 1.15)[::2]), EYE)
        knob = block(GRAY, np.array([0.8, 0.4, 1.5]), 0, -2, 0.4)
        self.assertAlmostEqual(with_depth(knob, surface).depth, 0.55, delta=0.02)
        self.assertEqual(with_depth(knob, None).depth, math.inf)

    def test_a_wrist_turns_half_a_turn_at_a_time_clockwise_to_fasten(self):
        robot = SimpleNamespace(limits=lambda _: (np.full(7, -3), np.full(7, 3.2)),
                                jacobian=lambda *_: np.outer(-np.ones(6), np.ones(7)))
        hand = DrivingHand(SimpleNamespace(robot=robot, name="left", ready=None), 0.7, 1)
        turns = SimpleNamespace(is_loosening=False, number=2)
        begin, end, number = hand.strokes(turns)
        self.assertAlmostEqual(end - begin, USES.turn_rad / 2)
        self.assertEqual(number, 5)
        self.assertAlmostEqual((begin + end) / 2, 0.1)
        turns.is_loosening = True
        self.assertEqual(hand.strokes(turns), (end, begin, 4))

    def test_a_top_that_looks_the_same_after_half_a_turn_keeps_its_direction(self):
        self.assertAlmostEqual(directed(block(GRAY, FUSE, 0, 0, yaw=0.1), 3), 0.1 + math.pi)


if __name__ == "__main__":
    unittest.main()
