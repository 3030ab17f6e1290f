"""Replaces the failed drive of a rack by the spare one.

    smile run scenes/drive_robot.xml --brain python/examples/drive/drive.py

The lamp at the failed drive is red. Its slot is switched off, the drive goes into the bin, the
spare drive into the slot, and the slot is switched on: the lamp is green. Where rack, bin and spare
drive are, the program sees in the picture of the robot's eye.
"""
import itertools
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1]))
from common.arm import plan, pose_at
from common.robot import TABLE, arms_of, init
from common.task import advance, look
from sight import SLOT_DEPTH, SLOTS, SWITCH_DEPTH, find_bin, find_rack, find_spare, lamp_at

GRASP = 1.3            # height of the tool above the bottom of a drive that it holds
RELEASED = 1.3         # opening of the gripper when the drive, 0.9 wide, is free
DROP = 0.02            # height above its place from which a drive is released
SLOT, BIN = 0.3, 0.15  # heights of the bottoms of a slot and of the bin
CARRY = 2.2            # height of the bottom of a drive that passes over others
LIFT = 0.8             # and of one that stands alone, before it rises on its way across
LOW = 1                # height of closed fingers over a button, if they cannot be as high as that
BUTTON = 0.4           # height that closed fingers go down to, to press the raised button
BUTTON_SIDE = 0.42     # from the middle of a switch to the middle of the fingers
ATTEMPTS = 4           # to bring a lamp into the wanted state


def step(sensor, motor, aux):
    advance(replace, sensor, motor, aux)


def replace(motor, aux):
    """The whole task, as a generator like its parts."""
    arms = arms_of(aux, motor)
    sensor = yield from look(aux)
    rack, waste, spare = [find(sensor, aux) for find in (find_rack, find_bin, find_spare)]
    failed = [x for x in SLOTS if lamp_at(x, rack, sensor, aux) == "failed"]
    if not failed:
        print("no drive has failed")
        return
    slot = rack.moved(failed[0], SLOT_DEPTH)
    yield from switch("off", failed[0], rack, arms, aux)
    yield from carry(slot, SLOT, waste, BIN, [CARRY], arms)
    yield from carry(spare, 0, slot, SLOT, [CARRY, LIFT], arms)
    yield from switch("ready", failed[0], rack, arms, aux)


def switch(wanted, x, rack, arms, aux):
    """Presses the switch of the slot at x until its lamp is as wanted."""
    side = BUTTON_SIDE if wanted == "off" else -BUTTON_SIDE  # of the raised button
    for _ in range(ATTEMPTS):
        sensor = yield from look(aux)
        lamp = lamp_at(x, rack, sensor, aux)
        print(f"{sensor.simTime:.1f} s: the lamp is {lamp}")
        if lamp == wanted:
            return
        yield from press(rack.moved(x + side, SWITCH_DEPTH), arms)
        side = -side  # each press raises the other button
    raise RuntimeError(f"the lamp is {lamp}, expected {wanted}")


def press(button, arms):
    """Presses a button with closed fingers."""
    tip = arms[0].tip(TABLE)
    for height, side in itertools.product([CARRY, LOW], [1, -1]):
        above, down = [pose_at(button.at(0, 0, z + tip), side * button.x) for z in (height, BUTTON)]
        planned = plan(arms, [("joints", above), ("line", down), ("line", above)], TABLE)
        if planned:
            break
        yield  # a step for each plan, so that none takes long
    else:
        raise RuntimeError("no arm reaches the switch")
    arm, motions = planned
    yield from arm.close()
    yield from arm.follow(*motions)
    yield from arm.open()
    yield from arm.go_aside()


def carry(start, start_height, goal, goal_height, lifts, arms):
    """Carries the drive that stands at a place to another one, and sets it down parallel to it. It is
    lifted to the first of several heights at which an arm can do so."""
    for path in carrying_paths(start, start_height, goal, goal_height + DROP, lifts):
        planned = plan(arms, path, TABLE)
        if planned:
            break
        yield  # a step for each plan, so that none takes long
    else:
        raise RuntimeError("no arm can carry the drive")
    arm, (to_drive, lower, raise_, cross, put, leave) = planned
    print("carrying a drive with the", arm.name, "arm")
    yield from arm.follow(to_drive, lower)
    yield from arm.close()
    yield from arm.follow(raise_, cross, put)
    yield from arm.open(RELEASED)
    yield from arm.follow(leave)
    yield from arm.go_aside()


def carrying_paths(start, start_height, goal, goal_height, lifts):
    """Yields the ways to carry a drive, the best first. A straight way does not dip on its way
    across; the left finger goes left or right of the drive."""
    for lift, across, side in itertools.product(lifts, ["line", "joints"], [1, -1]):
        from_above, grasp, above, put = [
            pose_at(place.at(0, 0, height + GRASP), side * place.x)
            for place, height in [(start, lift), (start, start_height),
                                  (goal, CARRY), (goal, goal_height)]]
        yield [("joints", from_above), ("line", grasp), ("line", from_above),
               (across, above), ("line", put), ("line", above)]
