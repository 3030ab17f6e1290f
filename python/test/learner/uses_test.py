"""Tests how tools are found, and carried to where they are used."""

import math
import unittest
from pathlib import Path
from types import SimpleNamespace

import numpy as np

from act.arms import Arm
from explain.demonstration import read_demonstration
from explain.devices import infer_devices
from explain.explanation import explain
from explain.task_model import infer_task
from match.alignment import Alignment
from match.tools import find_tool
from plan.carrying import surroundings_of
from plan.loads import belongs_to, load_of, moved_to, whole_of
from plan.there_and_back import plan_there_and_back, plan_to_take
from plan.tool_holds import tool_pose
from plan.use_planning import seen_from
from plan.ways import Way
from recordings import RecordingTest
from scenes import BLUE, BROWN, EYE, GREEN, RED, block, picture_of, view_of
from see.surfaces import surface_of
from things.areas import rotated


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
        self.assertIn("cut String Knife", explain(self.demo, []).goal)
        self.assertIsNone(use.at)

    def test_a_use_between_links_is_turned_about_their_middle(self):
        with open(Path(self.folder) / "0.txt", "a") as file:
            for n, y in ((1, -2.2), (2, -1.8), (3, 5)):
                file.write(f"0,create,String-link{n},shape,chain-link\n0,move,String-link{n},0.6,{y},1.0,0.0,0.0,0.0\n")
        demo = read_demonstration(self.folder)
        [use] = infer_devices(demo, infer_task(demo, {})[0])
        np.testing.assert_allclose(use.at, [0.6, -2])
        alignment = Alignment(0.0, np.array([5.0, 0]))
        for side, begin, end in ((0, [-6, -2, 1], [-5.4, -2, 1]), (math.pi / 2, [-4.4, -3.6, 1], [-4.4, -3, 1])):
            placed = seen_from(use, side, alignment)
            np.testing.assert_allclose(np.concatenate(placed[:2]), [*begin, *end], atol=1e-9)
            self.assertAlmostEqual(placed[2], side)

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
        arm = cartesian_arm()
        load = load_of(whole_of(points[is_tool], 0.4), pose_at([-2, -3, 0.6]))
        for x, z, is_clear, is_hand_clear in ((0.5, 2, True, True), (1.5, 2, False, True), (1.5, 4, True, True),
                                              (2.5, 3.5, True, False)):
            path = straight_path([[x, -3, z], [x, -3, z]])
            self.assertEqual(around.avoids(arm, path, load), is_clear and is_hand_clear, (x, z))
            self.assertEqual(around.avoids(arm, path), is_hand_clear, (x, z))
        # Both ends of that path are clear, but not what is between them.
        self.assertFalse(around.avoids(arm, straight_path([[0.5, -3, 2], [5.5, -3, 2]])))

    def test_a_tool_is_where_its_hold_says_whatever_the_hold(self):
        tool = block(RED, np.array([2, 0.5, 0.4]), -2, -3, yaw=0.3)
        whole = np.array([[-1, -3, 0.1], [-2.5, -2, 0.4], [-2, -3.5, 0]])
        arm = Arm(None, "left", 0, 0, None, reach=0.75)
        there = moved_to(whole, tool, np.array([3, -1, 2]), 0.7)
        for across, grip in ((0.3, 0), (1.2, 0.5)):
            load = load_of(whole, tool_pose(arm, tool, across, grip, tool.position))
            np.testing.assert_allclose(load.at(tool_pose(arm, tool, across, grip, np.array([3, -1, 2]), 0.7)), there, atol=1e-9)

    def test_the_way_leads_over_what_is_between_a_tool_and_its_work_and_back_over_it(self):
        picture, heights = view_of([block(BROWN, np.array([0.5, 0.5, 3]), 0, -3)])
        around = surroundings_of(surface_of(picture, heights, EYE).points)
        highest = around.of_arm.heights.max()
        arm = cartesian_arm()
        over, work = pose_at([-3, -3, 2]), pose_at([3, -3, 2])
        straight, any_way, high = Way(True, 0), Way(False, 0), Way(False, highest + arm.reach + 0.1)

        def plan(*ways):
            taken = plan_to_take(arm, [over, pose_at([-3, -3, 1]), over], np.array([-3, -3, 2]), arm.parked, None)
            return plan_there_and_back(arm, taken, [work], [over, over], ways, None,
                                       lambda path: around.avoids(arm, path), lambda paths: around.avoids(arm, paths[4]))

        self.assertEqual(plan(straight, any_way), [])
        path = plan(straight, any_way, high)
        for there, back in zip(path[3].positions, path[4].positions[::-1]):
            np.testing.assert_allclose(there, back)
        np.testing.assert_allclose(path[3].positions[[0, -1]], [[-3, -3, 2], [3, -3, 2]])
        self.assertAlmostEqual(path[3].positions[:, 2].max(), high.height)


def pose_at(q):
    """Returns a pose of a tool that points down, 4x4."""
    return np.array([[1, 0, 0, q[0]], [0, -1, 0, q[1]], [0, 0, -1, q[2]], [0, 0, 0, 1.0]])


def straight_path(waypoints):
    """Returns a path along straight lines through joint waypoints, which contains no other points: a second for each."""
    waypoints = np.array(waypoints, dtype=float)
    times = np.arange(len(waypoints))

    def at(seconds):
        return np.column_stack([np.interp(seconds, times, joint) for joint in waypoints.T]), None

    return SimpleNamespace(positions=waypoints, duration=times[-1], at=at)


def cartesian_arm():
    """Returns an arm whose three joint angles are the place of its tool, with its forearm above it."""
    robot = SimpleNamespace(first_invalid=lambda path, q_both, held: None,
                            move_joints=lambda name, waypoints, speed: straight_path(waypoints),
                            move_line=lambda name, q, goal, speed: (straight_path([q, goal[:3, 3]]), None),
                            limits=lambda name: (np.full(3, -10.0), np.full(3, 10.0)))
    parked = np.array([-5.0, -5, 5])
    return SimpleNamespace(robot=robot, name="left", forward=pose_at, reach=0.75, has_torso=False, parked=parked,
                           all_parked=None, starts=[parked], inverse=lambda pose, q, max_iterations: pose[:3, 3],
                           points=lambda q: q[:, None] + [[0, 0, 0], [0, -1, 3]])


if __name__ == "__main__":
    unittest.main()
