"""Cuts the string on which a weight hangs, with the scissors from the table.

    smile run scenes/scissors_robot.xml --brain python/examples/scissors/scissors.py

The robot takes the scissors by their grip, brings the string between their blades and closes the
gripper again, which closes the scissors: the weight falls into the box. Where scissors and string
are, the program sees in the picture of the robot's eye.
"""
import itertools
import sys
from pathlib import Path

import numpy as np

sys.path.append(str(Path(__file__).resolve().parents[1]))
from common.arm import plan, pose_at
from common.robot import TABLE, arms_of, init
from common.task import advance, look
from sight import find_scissors, find_string, is_hanging

SINKS = 3           # time after which the string has sunk and rests [s]
ON_TABLE = 0.4      # height of the middle of scissors that lie on the table
GRASP = 0.45        # height of the tool above it
LIFTED = 2, 1       # height of the middle before and after
BLADES = 2.2        # from the middle of the scissors to the string between their blades
AWAY = 3.4          # and when they are not yet there
TURN = (5, 3.4), (3, 3.4), (2.4, 4.2)  # beside the string and before it, where they turn
GRIPS = 0, 0.5, -0.5  # where the fingers take the grip, from its middle towards the blades
DROP = 0.02         # height above the table from which the scissors are released
ATTEMPTS = 3


def step(sensor, motor, aux):
    advance(cut, sensor, motor, aux)


def cut(motor, aux):
    """The whole task, as a generator like its parts."""
    arms = arms_of(aux, motor)
    sensor = yield
    while sensor.simTime < SINKS:
        sensor = yield
    for _ in range(ATTEMPTS):
        sensor = yield from look(aux)
        if not is_hanging(sensor, aux):
            print("the string is cut")
            return
        string, legs = find_string(sensor, aux)
        yield from use_scissors(find_scissors(sensor, aux), string, legs, arms)
    raise RuntimeError("the weight still hangs")


def use_scissors(scissors, string, legs, arms):
    """Takes the scissors, closes them at one of the legs of the string, and puts them back."""
    for path in cutting_paths(scissors, string, legs):
        planned = plan(arms, path, TABLE)
        if planned:
            break
        yield  # a step for each plan, so that none takes long
    else:
        raise RuntimeError("no arm can bring the scissors to the string")
    arm, motions = planned
    to_scissors, lower, raise_, turn, approach, reach, leave, back, return_, put, away = motions
    print("cutting with the", arm.name, "arm")
    yield from arm.follow(to_scissors, lower)
    yield from arm.close()
    yield from arm.follow(raise_, turn, approach, reach)
    yield from arm.close()
    yield from arm.follow(leave, back, return_, put)
    yield from arm.open()
    yield from arm.follow(away)
    yield from arm.go_aside()


def cutting_paths(scissors, string, legs):
    """Yields ways to take the scissors, cut a leg of the string, and put them back. The left finger
    goes left or right of the grip, nearer to the blades or to the rings."""
    side_of_scissors = np.sign(string.inside(scissors.middle[np.newaxis])[0, 0])
    for lifted, grip, across, side, (x, height), (beside, before) in itertools.product(
            LIFTED, GRIPS, ["line", "joints"], [1, -1], legs, TURN):
        above, grasp, put = [pose_at(scissors.at(0, grip, z + GRASP), side * scissors.x)
                             for z in (lifted, ON_TABLE, ON_TABLE + DROP)]
        turn, away, there = [pose_at(string.at(x, grip - y, height + GRASP), side * string.x)
                             for x, y in [(side_of_scissors * beside, before), (x, AWAY), (x, BLADES)]]
        yield [("joints", above), ("line", grasp), ("line", above),
               (across, turn), (across, away), ("line", there),
               ("line", away), (across, turn), (across, above), ("line", put), ("line", above)]
