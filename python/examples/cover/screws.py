"""Turns screws with a screwdriver. Lengths are in units, angles in radians."""
import numpy as np

from common.arm import pose_at

GRIP = 2             # height of the tool above the tip of the screwdriver that it holds
IN_HOLDER = 0.2      # heights of the tip: in the holder, ...
IN_HEAD = 1.68       # in the head of a screw, whether tight or not, ...
ABOVE_HEAD = 2.08    # where the wrist turns back, ...
CARRY = 2.1          # and on the way
DROP = 0.02          # height above its place from which the screwdriver is released
WIDE = 1.3           # opening of the gripper around the handle
STROKE = np.radians(183)  # of the wrist: half a turn, and a little more
LOOSEN, FASTEN = 4, 5     # strokes for the two turns of a screw; one more until it is surely tight


class Unreachable(Exception):
    """A pose that an arm does not reach, or not along a line."""


def plan_drive(arms, holder, screws, is_loosening, table):
    """Plans to take the screwdriver from its holder, to turn screws, and to put it back.

    `holder` and each of `screws` are x, y. Returns a Drive.
    """
    for arm in arms:
        q_others = [other.q for other in arms]
        for q_start in arm.start_postures():
            try:
                drive = Drive(arm, holder, screws, is_loosening, q_start)
            except Unreachable:
                continue
            if not any(arm.robot.first_invalid(motion, q_both=q_others, table=table)
                       for motion in drive.motions()):
                return drive
    raise RuntimeError("no arm reaches the screwdriver and the screws")


class Drive:
    """A plan of an arm to turn screws. The last joint turns the tool about its own axis."""

    def __init__(self, arm, holder, screws, is_loosening, q_start):
        self.arm, self.strokes = arm, LOOSEN if is_loosening else FASTEN
        stroke = -STROKE if is_loosening else STROKE  # clockwise, as seen from above, fastens
        # Half a stroke to each side of the middle of the joint.
        self.first = np.mean([limit[-1] for limit in arm.limits]) - stroke / 2
        q = arm.robot.inverse(arm.name, tool(holder, CARRY), q_start, any_turn=True,
                              max_iterations=300)
        if q is None:
            raise Unreachable
        to_holder = arm.move(arm.q, self.turned_back(q))
        grasp = self.line(to_holder.positions[-1], tool(holder, IN_HOLDER))
        take = self.line(grasp.positions[-1], tool(holder, CARRY))
        self.take = [to_holder, grasp, take]
        self.turns = []
        q = take.positions[-1]
        for screw in screws:
            self.turns.append(self.plan_turn(q, screw, stroke))
            q = self.turns[-1][-1].positions[-1]
        # The screwdriver is put back as it stood, by the angles at which it was taken.
        across = self.across(q, tool(holder, CARRY))
        adjust = arm.move(across.positions[-1], take.positions[-1])
        put = self.line(adjust.positions[-1], tool(holder, IN_HOLDER + DROP))
        self.put = [across, adjust, put, self.line(put.positions[-1], tool(holder, CARRY))]

    def plan_turn(self, q, screw, stroke):
        """Returns motions: to the screw; the four of a stroke; and away."""
        move = self.arm.move
        across = self.across(q, tool(screw, CARRY))
        above = self.turned_back(across.positions[-1])
        lower = self.line(above, tool(screw, ABOVE_HEAD))
        start = self.turned_back(lower.positions[-1])
        insert = self.line(start, tool(screw, IN_HEAD))
        end = insert.positions[-1].copy()
        end[-1] += stroke
        lift = self.line(end, tool(screw, ABOVE_HEAD))
        return [across, move(across.positions[-1], above), lower,
                insert, move(insert.positions[-1], end), lift, move(lift.positions[-1], start),
                self.line(start, tool(screw, CARRY))]

    def motions(self):
        """Returns all motions, each once."""
        return [*self.take, *self.put, *(motion for turn in self.turns for motion in turn)]

    def drive(self):
        """Carries out the plan."""
        arm = self.arm
        to_holder, grasp, take = self.take
        yield from arm.grip(-1, WIDE)
        yield from arm.follow(to_holder, grasp)
        yield from arm.close()
        yield from arm.follow(take)
        for turn in self.turns:
            yield from arm.follow(*turn[:3], *(self.strokes * turn[3:7]), turn[7])
        yield from arm.follow(*self.put[:-1])
        yield from arm.open(WIDE)
        yield from arm.follow(self.put[-1])
        yield from arm.go_aside()

    def turned_back(self, q):
        """Returns the angles with the last joint where a stroke begins."""
        return np.append(q[:-1], self.first)

    def across(self, q, pose):
        """Returns a motion over the table: straight, or the way that is best for the joints."""
        try:
            return self.line(q, pose)
        except Unreachable:
            robot, name = self.arm.robot, self.arm.name
            goal = robot.inverse(name, pose, q, any_turn=True, max_iterations=300)
            if goal is None:
                raise
            return self.arm.move(q, goal)

    def line(self, q, pose):
        """Returns a straight motion, on which the tool may turn about its own axis."""
        motion, _ = self.arm.robot.move_line(self.arm.name, q, pose, tool_speed=4, any_turn=True)
        if motion is None:
            raise Unreachable
        return motion


def tool(place, tip):
    """Returns the pose of a tool that holds the screwdriver, its tip over a place at a height."""
    return pose_at([*place[:2], tip + GRIP], [0, 1, 0])
