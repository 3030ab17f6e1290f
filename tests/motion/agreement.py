"""Asks what agreement.cc asks, in Python: agreement.py URDF."""

import sys

import numpy as np
from smile.motion import Robot


def show(name, numbers):
    print(name + "".join(" %.17g" % number for number in np.ravel(numbers)))


def show_rows(name, matrix):
    for row in matrix:
        show(name, row)


def show_move(name, move):
    for time, q, v in zip(move.times, move.positions, move.velocities):
        show(name + " times", time)
        show(name + " positions", q)
        show(name + " velocities", v)
    q, v = move.at(move.duration / 3)
    show(name + " sample", q)
    show(name + " sample", v)


def configuration(robot, arm, k):
    lower, upper = robot.limits(arm)
    share = np.array([(k * 37 + i * 61) % 101 for i in range(lower.size)]) / 101.0
    return lower + share.reshape(lower.shape) * (upper - lower)


def query_arm(robot, arm):
    ready = robot.pose(arm, "untucked")
    show_rows("fingers", robot.finger_bounds(arm, 0.4))
    for k in range(40):
        goal = robot.forward(arm, configuration(robot, arm, k))
        show_rows("forward", goal)
        show_rows("jacobian", robot.jacobian(arm, configuration(robot, arm, k)))
        for any_turn in (False, True):
            q = robot.inverse(arm, goal, ready, any_turn=any_turn)
            show("inverse", [] if q is None else q)
    waypoints = [configuration(robot, arm, k) for k in range(5)]
    show_move("through", robot.move_joints(arm, waypoints, speed=0.5))
    straight = robot.move_joints(arm, waypoints[:2])
    show_move("straight", straight)
    moment = robot.first_invalid(straight, held=[[-3, -3, -0.5], [3, 3, 0.5]])
    if moment:
        show("held " + moment.reason, moment.seconds)

    for way in (1.0, 40.0):
        goal = robot.forward(arm, ready)
        goal[2, 3] += way
        move, fault = robot.move_line(arm, ready, goal, tool_speed=2)
        if fault:
            show("fault " + fault.reason, fault.fraction)
        else:
            show_move("line", move)


def query_both(robot):
    low, high = configuration(robot, "both", 3), configuration(robot, "both", 8)
    move = robot.move_joints("both", [low, high, low])
    show_move("both", move)
    moment = robot.first_invalid(move, q_both=low, table=(20, 12))
    if moment:
        show("invalid " + moment.reason, moment.seconds)


def main():
    base = [[0, -1, 0, 0.5], [1, 0, 0, -8], [0, 0, 1, 2], [0, 0, 0, 1]]
    robot = Robot(sys.argv[1], base=base, unit=0.1)
    query_arm(robot, "left")
    query_arm(robot, "right")
    query_both(robot)


main()
