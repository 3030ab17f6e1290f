"""Tests what is Python's own in smile.motion: motion_test.py URDF."""

import sys
import unittest

import numpy as np
from smile import motion

URDF = sys.argv.pop()
BASE = np.array([[0.0, -1, 0, 0], [1, 0, 0, -8], [0, 0, 1, 2], [0, 0, 0, 1]])


class MotionTest(unittest.TestCase):
    def setUp(self):
        self.robot = motion.robot_of({"robot": URDF, "robotBase": BASE, "unit": 0.1})
        self.q = self.robot.pose("left", "untucked")

    def test_inverse_undoes_forward(self):
        goal = self.robot.forward("left", self.q + 0.2)
        q = self.robot.inverse("left", goal, self.q)
        self.assertEqual(q.shape, (7,))
        np.testing.assert_allclose(self.robot.forward("left", q), goal, atol=2e-6)

    def test_an_unreachable_goal_is_none(self):
        goal = self.robot.forward("left", self.q)
        goal[0, 3] = 40
        self.assertIsNone(self.robot.inverse("left", goal, self.q))
        move, fault = self.robot.move_line("left", self.q, goal)
        self.assertIsNone(move)
        self.assertLess(fault.fraction, 1)
        self.assertIn("out of reach", fault.reason)

    def test_shapes_are_those_of_brains(self):
        both = self.robot.pose("both", "untucked")
        self.assertEqual(both.shape, (2, 7))
        move = self.robot.move_joints("both", [both, both * 0.5])
        self.assertEqual(move.positions.shape, (len(move.times), 2, 7))
        q, velocities = move.at(move.duration)
        np.testing.assert_array_equal(q, both * 0.5)
        np.testing.assert_array_equal(velocities, np.zeros((2, 7)))
        times = move.duration * np.array([0, 0.3, 1])
        for all_at_once, one_by_one in zip(move.at(times), zip(*map(move.at, times))):
            self.assertEqual(all_at_once.shape, (3, 2, 7))
            np.testing.assert_array_equal(all_at_once, one_by_one)
        self.assertEqual(self.robot.jacobian("left", [list(self.q)]).shape, (6, 7))

    def test_messages_name_the_argument(self):
        def expect(message, call):
            with self.assertRaises(ValueError) as raised:
                call()
            self.assertEqual(str(raised.exception), message)

        robot, q = self.robot, self.q
        expect("q is 3, expected 7", lambda: robot.forward("left", [0, 0, 0]))
        expect("q is 7x1, expected 7", lambda: robot.forward("left", q.reshape(7, 1)))
        expect("goal is 3x3, expected 4x4", lambda: robot.inverse("left", np.eye(3), q))
        expect(
            'arm is "middle", expected left or right',
            lambda: robot.forward("middle", q),
        )
        expect("waypoints is 7, expected Kx7", lambda: robot.move_joints("left", q))
        expect(
            "speed is 2, expected above 0, at most 1",
            lambda: robot.move_joints("left", [q], speed=2),
        )
        expect("q is not finite", lambda: robot.forward("left", q * np.nan))
        expect("aux has no unit", lambda: motion.robot_of({"robot": URDF, "robotBase": BASE}))
        with self.assertRaises(ValueError):
            motion.Robot("/there/is/no/such.urdf")
        for nonsense in (None, "text", {}, [[1, 2], [3]]):
            with self.assertRaises((TypeError, ValueError)):
                robot.forward("left", nonsense)

    def test_a_path_into_the_table_is_invalid(self):
        goal = self.robot.forward("left", self.q)
        goal[2, 3] = 1.5
        above = self.robot.inverse("left", goal, self.q)
        goal[2, 3] = -0.5
        move, fault = self.robot.move_line("left", above, goal, any_turn=True)
        self.assertIsNone(fault)
        self.assertIsNone(self.robot.first_invalid(move))
        moment = self.robot.first_invalid(move, table=(20, 12))
        self.assertIn("would touch", moment.reason)
        self.assertLess(moment.seconds, move.duration)


if __name__ == "__main__":
    unittest.main()
