"""Replaces the fuse under a cover that four screws hold.

    smile run scenes/cover_robot.xml --brain python/examples/cover/cover.py

The screws are loosened with the screwdriver, the cover goes onto its stand, the fuse into the bin,
the good fuse into the socket, and the housing is closed again. Where these are, the program sees in
the picture of the robot's eye.
"""
import itertools
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1]))
from common.arm import plan, pose_at
from common.robot import TABLE, arms_of, init
from common.task import advance, look
from screws import plan_drive
from sight import find_bin, find_housing, find_screwdriver, find_spare, find_stand

SCREW_X, SCREW_Y = 1.55, 0.75      # of the screws, from the middle of the housing
# Heights of the tips of the fingers:
KNOB, KNOB_ON_STAND = 1.4, 1.2     # they hold the knob of the cover, ...
FUSE, FUSE_INSIDE = 0.3, 0.45      # a fuse on the table, and one in the socket or the bin
OVER, OVER_FUSE = 2.6, 2.1         # they carry the cover and a fuse
LIFT = 1                           # they lift a fuse that stands alone, which then rises on its way
DROP = 0.02                        # height above its place from which an object is released
WIDE = 0.9                         # opening of the gripper around an object of 0.4


def step(sensor, motor, aux):
    advance(replace, sensor, motor, aux)


def replace(motor, aux):
    """The whole task, as a generator like its parts."""
    arms = arms_of(aux, motor)
    sensor = yield from look(aux)
    housing, stand, screwdriver, spare, waste = [
        find(sensor, aux)
        for find in (find_housing, find_stand, find_screwdriver, find_spare, find_bin)]
    screws = [housing.at(SCREW_X * x, SCREW_Y * y, 0)
              for x, y in ((-1, 1), (1, 1), (1, -1), (-1, -1))]

    yield from plan_drive(arms, screwdriver.middle, screws, True, TABLE).drive()
    yield from carry(arms, housing, KNOB, stand, KNOB_ON_STAND, OVER)
    yield from carry(arms, housing, FUSE_INSIDE, waste, FUSE_INSIDE, OVER_FUSE)
    yield from carry(arms, spare, FUSE, housing, FUSE_INSIDE, OVER_FUSE, LIFT)
    yield from carry(arms, stand, KNOB_ON_STAND, housing, KNOB, OVER)
    yield from plan_drive(arms, screwdriver.middle, screws, False, TABLE).drive()


def carry(arms, start, start_height, goal, goal_height, over, *lower_lifts):
    """Carries an object from a place to another one, and sets it down parallel to it. Heights are
    those of the tips of the fingers. It is lifted to `over`, or lower if no arm can lift it so high
    there."""
    arm, (to_start, lower, raise_, cross, put, leave) = carrying_plan(
        arms, start, start_height, goal, goal_height, over, lower_lifts)
    print("carrying with the", arm.name, "arm")
    yield from arm.grip(-1, WIDE)
    yield from arm.follow(to_start, lower)
    yield from arm.close()
    yield from arm.follow(raise_, cross, put)
    yield from arm.open(WIDE)
    yield from arm.follow(leave)
    yield from arm.go_aside()


def carrying_plan(arms, start, start_height, goal, goal_height, over, lower_lifts):
    """Returns an arm and its motions: to the object, down, up, across, down, up.

    The fingers are at the longer sides of the object; it may be grasped, and stand, in two ways. A
    straight way keeps it level on its way across.
    """
    tip = arms[0].tip(TABLE)
    ways = itertools.product([over, *lower_lifts], ["line", "joints"], [1, -1], [1, -1])
    for lift, across, start_side, goal_side in ways:
        from_above, grasp, above, put = [
            pose_at(place.at(0, 0, height + tip), side * place.y)
            for place, height, side in [
                (start, lift, start_side), (start, start_height, start_side),
                (goal, over, goal_side), (goal, goal_height + DROP, goal_side)]]
        planned = plan(arms, [("joints", from_above), ("line", grasp), ("line", from_above),
                              (across, above), ("line", put), ("line", above)], TABLE)
        if planned:
            return planned
    raise RuntimeError("no arm can carry it")
