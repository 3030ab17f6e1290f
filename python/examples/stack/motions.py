"""Plans how an arm carries a block, and follows the plan."""
from itertools import product

import numpy as np

CLEARANCE = 0.2   # beside a block for each finger, and above what the arm passes over [units]
NEAR = 0.05       # beside a block for a jaw that does not move [units]
MARGIN = 0.01     # a block is released this far above the one below it [units]
SPEED = 0.3       # of the opening of a gripper [units/s]
TABLE = 100, 100  # larger than any [units]
UP = np.array([0, 0, 1])


class Arm:
    """An arm of the robot, as plans see it."""

    def __init__(self, robot, base, index, gripper):
        self.robot, self.base, self.index, self.name = robot, base, index, robot.arms[index]
        self.closed, self.open = gripper
        ready = robot.pose(self.name, "ready")  # over the table, fingers down
        if ready is None:
            raise RuntimeError('the robot has no pose "ready": smile robots add makes one')
        self.turn_about(ready)
        self.q = self.away  # where it is
        # How low the tool can be without fingers that touch the table.
        heights = np.arange(0.02, 2, 0.02)
        self.lowest = next(height for height in heights if self.at(height) is not None) + 0.03

    def turn_about(self, q):
        """Sets the postures to pass through: these angles, with the first joint turned."""
        lower, upper = (limit[0] * 0.9 for limit in self.robot.limits(self.name))
        self.postures = [np.r_[angle, q[1:]] for angle in q[0] + np.arange(-1.6, 1.7, 0.2)
                         if lower <= angle <= upper]
        self.middle = q
        # Out of the way: the first arm of a robot to the left, another one to the right.
        self.away = self.postures[-1 if self.index == 0 else 0]

    def raise_to(self, height):
        """Makes postures with the tool at this height, or as high as possible [units]."""
        for lower in np.arange(height, 0, -0.1):
            for closer in 1, 0.85, 0.7:
                q = self.at(lower, closer)
                if q is not None:
                    return self.turn_about(q)

    def places(self):
        """Returns places on the table, below the postures and closer to the robot."""
        foot = self.base[:3, 3]
        return [(foot + closer * (self.place_of(q) - foot)) * [1, 1, 0]
                for closer in (1, 0.85, 0.7) for q in self.postures]

    def at(self, height, closer=1):
        """Returns angles with the tool at this height, None if the arm would touch something."""
        foot = self.base[:3, 3]
        place = foot + closer * (self.place_of(self.middle) - foot)
        q = self.inverse(self.tool([*place[:2], height], 0), self.middle, any_turn=True)
        if q is None or not self.is_valid(self.robot.move_joints(self.name, [q])):
            return None
        return q

    def place_of(self, q):
        return self.robot.forward(self.name, q)[:3, 3]

    def near(self, place):
        """Returns the postures, first those whose tool is nearest to being above a place."""
        return sorted(self.postures,
                      key=lambda q: np.linalg.norm((self.place_of(q) - place)[:2]))

    def tool(self, place, turn, opening=0):
        """Returns the pose of the tool with the fingers down, on both sides of a place."""
        y = np.array([np.cos(turn), np.sin(turn), 0])
        pose = np.eye(4)
        pose[:3, :3] = np.array([[-y[1], y[0], 0], y, -UP]).T
        pose[:3, 3] = place - y * self.gripper_middle(opening)
        return pose

    def gripper_middle(self, opening):
        """Returns where the middle between the fingers is, along the line across them [units]."""
        return self.robot.gripper_middle(self.name, opening)

    def inverse(self, pose, q_start, any_turn=False):
        # Arms of five joints need tolerances: they cannot make up for a rounded description.
        return self.robot.inverse(self.name, pose, q_start, any_turn=any_turn,
                                  position_tolerance=1e-3, angle_tolerance=1e-3,
                                  max_iterations=500)

    def is_valid(self, motion):
        return self.robot.first_invalid(motion, table=TABLE) is None

    def through(self, q_from, q_to):
        """Plans a motion by way of postures: up, about the first joint, and down.

        None if the hand would sink on the way, where it may hit what stands there.
        """
        via = [self.near(self.place_of(q))[0] for q in (q_from, q_to)]
        motion = self.robot.move_joints(self.name, [q_from, *via, q_to])
        times = motion.duration * np.linspace(0, 1, 50)
        heights = [self.place_of(q)[2] for q in motion.at(times)[0]]
        is_high = min(heights) > min(heights[0], heights[-1]) - CLEARANCE / 2
        return motion if is_high and self.is_valid(motion) else None

    def dip(self, above, *poses):
        """Plans straight motions from a pose above to others; None if the arm cannot."""
        for q_start in self.near(above[:3, 3])[:3]:
            q, motions = self.inverse(above, q_start), []
            for pose in poses:
                motion = None
                if q is not None:
                    motion, _ = self.robot.move_line(self.name, q, pose, tool_speed=4)
                if motion is None or not self.is_valid(motion):
                    break
                motions.append(motion)
                q = motion.positions[-1]
            else:
                return motions
        return None


class Carry:
    """Plans of an arm to take a block and to put it somewhere."""

    def __init__(self, arm, block):
        self.arm, self.block, self.take = arm, block, None
        # Jaws of which one is fixed push the block to that one: it should be near.
        wide, near = (min(block.size + 2 * gap, arm.open) for gap in (CLEARANCE, NEAR))
        self.opening = wide - abs(arm.gripper_middle(wide) - arm.gripper_middle(near))
        # Heights of the tool above the bottom of a block, to grasp it and to pass over it.
        self.grasp = max(block.size / 2, arm.lowest)
        self.over = max(block.size + arm.lowest, self.grasp + CLEARANCE) + 0.05
        if self.opening < block.size + 0.02:
            return
        for down, self.up in self.dips(block, self.grasp, near, near):
            to_block = arm.through(arm.away, down.positions[0])
            if to_block:
                self.take = [to_block, down]
                return

    def dips(self, place, height, before, after):
        """Plans motions down to a place of the block, and up again, from high above if possible.

        `before`, `after`: widths at which the place is in the middle of the gripper.
        """
        for over, quarter in product((self.over + 2 * CLEARANCE, self.over), range(4)):
            turn = place.turn + quarter * np.pi / 2  # a cube looks the same
            motions = self.arm.dip(self.arm.tool(place.place + over * UP, turn, before),
                                   self.arm.tool(place.place + height * UP, turn, before),
                                   self.arm.tool(place.place + over * UP, turn, after))
            if motions:
                yield motions

    def to(self, goal):
        """Plans to carry the block to the place and turn of `goal`, another Block.

        Returns the arm, and for each width of the gripper the motions after it: to the block and
        down; up, across and down; up and away. None if the arm cannot.
        """
        if self.take is None:
            return None
        for lower, leave in self.dips(goal, self.grasp + MARGIN, self.block.size, self.opening):
            across = self.arm.through(self.up.positions[-1], lower.positions[0])
            back = self.arm.through(leave.positions[-1], self.arm.away)
            if across and back:
                return self.arm, [(self.opening, self.take),
                                  (self.arm.closed, [self.up, across, lower]),
                                  (self.opening, [leave, back])]
        return None


def follow(motion, arm, motor):
    """Moves an arm. Each `yield` waits for the next step and returns its sensor values."""
    sensor = yield
    begin = sensor.simTime
    while sensor.simTime < begin + motion.duration + 0.3:
        q, velocity = motion.at(sensor.simTime - begin)
        motor.arms[arm.index].velocities = velocity + 4 * (q - sensor.arms[arm.index].joints)
        sensor = yield
    motor.arms[arm.index].velocities = 0 * velocity
    arm.q = motion.positions[-1]


def grip(opening, arm, motor):
    """Opens or closes a gripper until it is at an opening [units], or no longer moves."""
    sensor = yield
    moved, last = sensor.simTime, None
    while sensor.simTime < moved + 0.3:
        now = sensor.arms[arm.index].gripper
        if last is None or abs(now - last) > 0.001:
            moved, last = sensor.simTime, now
        motor.arms[arm.index].gripperVelocity = np.clip(5 * (opening - now), -SPEED, SPEED)
        sensor = yield
    motor.arms[arm.index].gripperVelocity = 0
