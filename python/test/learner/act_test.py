"""Tests how the arms hold and press, and where noisy joints are."""

import unittest
from types import SimpleNamespace
from unittest.mock import Mock, patch

import learner
import numpy as np

from act.actions import Action
from act.arm_clearance import is_path_over
from act.arm_points import points_from_wrist
from act.arms import Arm
from act.execution import execute_action
from act.finger_room import grasp_yaws, is_grasp_blocked
from act.joint_estimates import JointEstimates
from act.segments import at_height
from check.claims import Claim
from constants import MOTION_PLANNING, TASK_PLANNING
from plan.arm_paths import plan_path_through
from scenes import BLUE, CUBE, GREEN, PLANK, RED, block


class JointEstimatesTest(unittest.TestCase):
    """The joints are measured with noise."""

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


class PressTest(unittest.TestCase):
    """An arm of one joint presses what is at 0.5 rad, on a path of a second to 1 rad."""

    TICK = 1 / 60  # [s]

    def at(self, times):
        angles = np.clip(times, 0, 1)[:, None]
        return angles, np.zeros_like(angles)

    def test_a_press_goes_back_as_soon_as_something_stops_the_arm(self):
        path = SimpleNamespace(positions=np.array([[0.0], [1.0]]), duration=1.0, at=self.at)
        for speed in (1, 0.5):
            action = Action("press", SimpleNamespace(index=0), path)
            aux = SimpleNamespace(tickSeconds=self.TICK, variationSpeed=speed)
            q, status, num_ticks = np.zeros(1), "busy", 0
            while status == "busy" and num_ticks < 240:
                sensor = SimpleNamespace(arms=[SimpleNamespace(joints=q)], timeElapsed=self.TICK)
                motor = SimpleNamespace(arms=[SimpleNamespace()])
                status = execute_action(action, sensor, motor, aux)
                self.assertEqual(motor.ticks, 1)
                wanted = q + motor.arms[0].velocities * self.TICK
                self.assertLess(wanted[0], 0.56, "it pushes on")
                q = np.minimum(wanted, 0.5)
                num_ticks += 1
            self.assertEqual(status, "done")
            self.assertAlmostEqual(q[0], 0, delta=0.001)
            self.assertAlmostEqual(num_ticks * self.TICK, 1 / speed, delta=0.1 / speed)


class LiftTest(unittest.TestCase):
    """An arm of one joint lifts something in a second, on a path to 1 rad."""

    def test_a_lift_ends_soon_where_the_arm_does_not_keep_up(self):
        path = SimpleNamespace(positions=np.array([[0.0], [1.0]]), duration=1.0,
                               at=lambda times: (np.clip(times, 0, 1)[:, None], None))
        for share, expected in (1, "done"), (0.5, "the arm cannot lift it"):
            action, aux = Action("lift", SimpleNamespace(index=0), path), SimpleNamespace(tickSeconds=0.01, maxTicks=100)
            q, status, ticks = np.zeros(1), "busy", 1
            while status == "busy":
                sensor = SimpleNamespace(arms=[SimpleNamespace(joints=q)], timeElapsed=0.01 * ticks)
                motor = SimpleNamespace(arms=[SimpleNamespace()])
                status = execute_action(action, sensor, motor, aux)
                ticks = motor.ticks
                q = q + share * 0.01 * np.reshape(motor.arms[0].velocities, (1, -1)).sum(axis=1)
            self.assertEqual(status, expected)
        self.assertLess(action.time, 0.2)


class CaughtArmTest(unittest.TestCase):
    """An arm is stopped, and so is each of its retreats."""

    def test_one_more_picture_tells_whether_all_is_done(self):
        for claim, word in (None, "gave up: because the arm is stuck"), (Claim(True, "as seen"), "done: as seen"):
            state = SimpleNamespace(claim=None, notes=[])
            arm = SimpleNamespace(index=0)
            aux = SimpleNamespace(state=state, actions=[Action("press", arm)], num_retreats=0, joints=Mock(), tickSeconds=1 / 60,
                                  eye=None, hands=[])
            sensor = SimpleNamespace(simTime=1.0, arms=[SimpleNamespace(joints=np.zeros(1))])

            def execute(action, *_):
                return "done" if action.kind == "observe" else "an obstacle is in the way of the arm"

            def choose(*_):
                state.claim = claim
                return [Action("press", arm)]

            with (patch.multiple(learner, execute_action=execute, choose_actions=choose, tell=Mock()),
                  patch.multiple("plan.recovery", remember_failure=Mock(), retreat=lambda *_, **__: [Action("follow", arm)]),
                  patch("check.claims.print", create=True)):
                for _ in range(TASK_PLANNING.max_retreats + 2):
                    self.assertFalse(hasattr(aux, "claim"), "it does not look")
                    learner.step(sensor, SimpleNamespace(), aux)
            self.assertEqual(aux.claim, word)


class ArmPointsTest(unittest.TestCase):
    """Its first two joints turn about vertical axes through x = 0 and x = q[3], the third one slides, and the fourth one turns about
    an axis along x, at y = 0 and z = 3."""

    def setUp(self):
        def jacobian(_, q):
            return np.array([[-q[1], -q[1], 0, 0], [q[0], q[0] - q[3], 0, 3 - q[2]], [0, 0, 1, q[1]],
                             [0, 0, 0, 1], [0, 0, 0, 0], [1, 1, 0, 0]])

        robot = SimpleNamespace(forward=lambda _, q: np.vstack([np.column_stack([np.eye(3), q[:3]]), [0, 0, 0, 1]]), jacobian=jacobian)
        self.arm = Arm(robot, "left", 0, 0, None)
        self.q = np.array([[3, 0.2, 2.9, 2], [5, -1, 1, 4], [2, 0, 3, 1]])

    def test_points_of_an_arm_are_on_the_axes_of_its_joints(self):
        for q, points in zip(self.q, self.arm.points(self.q)):
            np.testing.assert_allclose(points, [q[:3], [q[0], 0, 3], [q[3], 0, 3], [0, 0, 3]], atol=1e-12)

    def test_those_of_several_postures_follow_one_another_from_the_wrist_on(self):
        apart = [points_from_wrist(self.arm, q) for q in self.q]
        np.testing.assert_array_equal(points_from_wrist(self.arm, self.q), np.concatenate(apart))
        self.assertEqual([len(it) for it in apart], [MOTION_PLANNING.points_per_link * it for it in (1, 2, 1)])


class PathOverBlocksTest(unittest.TestCase):
    """A hand moves along x; its fingers, which point down, reach 0.7 below its tool, and its bar 1.3 to both sides, along y."""

    def is_over(self, height, *blocks, y=0):
        pose = np.array([[-1.0, 0, 0, 0], [0, 1, 0, y], [0, 0, -1, height], [0, 0, 0, 1]])
        arm = SimpleNamespace(reach=0.7, forward=lambda q: pose + np.outer([1, 0, 0, 0], [0, 0, 0, q[0]]),
                              points=lambda q: q[:, None] * [1, 0, 0] + [[0, y, height], [0, y, height + 5]])
        path = SimpleNamespace(duration=1.0, at=lambda times: (np.interp(times, [0, 1], [-4, 4])[:, None], None))
        return is_path_over(arm, path, blocks)

    def test_the_open_gripper_passes_over_blocks_or_beside_them(self):
        tower = block(RED, CUBE, 0.5, 0, bottom=2)
        self.assertTrue(self.is_over(3.9, tower))
        self.assertFalse(self.is_over(3.7, tower), "with its fingers")
        self.assertFalse(self.is_over(3.7, tower, y=2), "with the end of its bar")
        self.assertTrue(self.is_over(3.7, tower, y=3))
        self.assertTrue(self.is_over(3.7))

    def test_on_its_way_back_an_arm_passes_over_what_it_placed_raised_first_if_necessary(self):
        placed = block(RED, CUBE, 0, -2)
        arm = SimpleNamespace(starts=[np.zeros(1)], parked=np.zeros(1), forward=lambda q: at_height(np.eye(4), q[0]))

        def path_of(points):
            return SimpleNamespace(positions=np.array([np.ravel(it) for it in points], float))

        with (patch("plan.arm_paths.solve_poses", return_value=[np.array([3.0])]),
              patch("plan.arm_paths.move_joints", side_effect=lambda _, points: path_of(points)),
              patch("plan.arm_paths.move_line", side_effect=lambda _, before, goal: path_of([*before.positions[-1], goal[2, 3]])),
              patch("plan.arm_paths.is_arm_clear", return_value=True), patch("plan.arm_paths.is_path_valid", return_value=True),
              patch("plan.arm_paths.is_path_over",
                    side_effect=lambda _, path, obstacles: placed not in obstacles or path.positions.max() > 3.9)):
            poses = [at_height(np.eye(4), height) for height in (3, 1, 3)]
            for left, home in (([], [3, 0]), ([placed], [3, 4, 0])):
                path = plan_path_through(arm, poses, [], np.zeros(1), left)
                self.assertEqual(path[-1].positions.ravel().tolist(), home)
                self.assertEqual(len(path), 4)
            self.assertEqual(plan_path_through(arm, poses, [], np.zeros(1), taken=[placed]), [], "nor may it strike what it takes")


class FingerRoomTest(unittest.TestCase):
    def test_grasp_yaws_avoid_other_blocks(self):
        middle = block(RED, CUBE, 0, -2)
        left, right = block(GREEN, CUBE, -1.1, -2), block(GREEN, CUBE, 1.1, -2)
        self.assertEqual(len(grasp_yaws(middle, [])), 4)
        np.testing.assert_allclose(np.sin(grasp_yaws(middle, [left, right])), [1, -1])
        self.assertEqual(grasp_yaws(block(RED, PLANK, 0, -3.1), [middle]), [])
        self.assertTrue(is_grasp_blocked(middle, [left, right, block(BLUE, CUBE, 0, -3.1)]))
        self.assertFalse(is_grasp_blocked(middle, [block(BLUE, CUBE, 4, -2)]))


if __name__ == "__main__":
    unittest.main()
