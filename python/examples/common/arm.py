"""An arm that follows planned motions and grips.

Actions that last for several steps of the brain are generators: each `yield` waits for the next
step and returns its sensor values. Lengths are in units, angles in radians.
"""
import numpy as np

DOWN = np.array([0, 0, -1.0])
START_POSTURES = 10  # from which plan() tries to reach the first pose
GAIN = 4             # of the error of a joint [1/s]
SETTLED = 0.002      # error of a joint at the end of a motion [rad]


def pose_at(place, across, approach=DOWN):
    """Returns the pose (4x4) of a tool at a place, from the directions `across` its fingers and of
    its `approach`, which are perpendicular."""
    pose = np.eye(4)
    y, z = np.asarray(across, float), np.asarray(approach, float)
    y, z = y / np.linalg.norm(y), z / np.linalg.norm(z)
    pose[:3, :3] = np.column_stack([np.cross(y, z), y, z])
    pose[:3, 3] = place
    return pose


def plan(arms, path, table=None):
    """Plans a path for one of several arms, see Arm.plan(): first for the arm whose hand is nearest.

    Returns the arm and its motions, or None if no arm can follow the path.
    """
    def distance(arm):
        return np.linalg.norm(path[0][1][:3, 3] - arm.robot.forward(arm.name, arm.q)[:3, 3])

    for arm in sorted(arms, key=distance):
        motions = arm.plan(path, [other.q for other in arms], table)
        if motions:
            return arm, motions
    return None


class Arm:
    """The k-th arm of a robot, which starts and waits in a posture `aside`."""

    def __init__(self, robot, aux, motor, k, aside):
        self.robot, self.k, self.name = robot, k, aux.arms[k].name
        self.limits = aux.arms[k].minJoints, aux.arms[k].maxJoints
        self.motor = motor.arms[k]
        self.aside = np.array(aside, float)
        self.q = self.aside  # angles at the end of the last motion that was followed

    def plan(self, path, q_others=None, table=None):
        """Plans motions through the poses of a path, each a pair of "joints" or "line" and a pose.

        The tool moves to a pose along a straight line, or any way that is fast for the joints.
        Returns a list of motions, or None if the arm cannot do all of them.
        """
        for q_start in self.start_postures():
            motions, q = [], self.q
            for how, pose in path:
                motion = self.motion(how, pose, q, q if motions else q_start)
                if motion is None or self.robot.first_invalid(motion, q_both=q_others, table=table):
                    break
                motions.append(motion)
                q = motion.positions[-1]
            if len(motions) == len(path):
                return motions
        return None

    def start_postures(self):
        random = np.random.default_rng(1)  # the same postures each time
        yield self.q
        yield from self.over_table()
        for _ in range(START_POSTURES):
            yield random.uniform(*self.limits)

    def over_table(self):
        """Yields the named postures with the fingers down over the table."""
        for name in "untucked", "ready":
            if self.robot.pose(self.name, name) is not None:
                yield self.robot.pose(self.name, name)

    def motion(self, how, pose, q, q_start):
        """Returns a motion from the angles q to a pose, or None."""
        if how == "line":
            return self.robot.move_line(self.name, q, pose, tool_speed=4)[0]
        goal = self.robot.inverse(self.name, pose, q_start, max_iterations=300)
        return None if goal is None else self.move(q, goal)

    def tip(self, table):
        """Returns how far the fingers reach below the tool: it is as low as they allow it."""
        q_start = next(self.over_table())
        pose = self.robot.forward(self.name, q_start)
        for pose[2, 3] in np.arange(0, 2, 0.02):
            q = self.robot.inverse(self.name, pose, q_start, max_iterations=300)
            if q is not None and not self.robot.first_invalid(
                    self.robot.move_joints(self.name, [q]), table=table):
                return pose[2, 3]
        raise RuntimeError("the tool cannot point down over the table")

    def move(self, q, goal):
        return self.robot.move_joints(self.name, [q, goal], speed=0.7)

    def follow(self, *motions):
        """Moves along planned motions, one after another."""
        sensor = yield
        for motion in motions:
            begin = sensor.simTime
            error = np.inf
            # An arm that is blocked does not settle.
            while sensor.simTime < begin + motion.duration + 1 and not (
                    sensor.simTime > begin + motion.duration and error < SETTLED):
                q, velocity = motion.at(sensor.simTime - begin)
                self.motor.velocities = velocity + GAIN * (q - sensor.arms[self.k].joints)
                sensor = yield
                error = np.abs(motion.positions[-1] - sensor.arms[self.k].joints).max()
            self.q = motion.positions[-1]
        self.motor.velocities = np.zeros(len(self.q))

    def go_aside(self):
        yield from self.follow(self.move(self.q, self.aside))

    def open(self, opening=np.inf):
        """Opens the gripper, to an opening or until it opens no further."""
        yield from self.grip(1, opening)

    def close(self):
        """Closes the gripper until it holds something. A gripper that holds a tool uses it."""
        yield from self.grip(-1, -np.inf)

    def grip(self, velocity, opening):
        sensor = yield
        begin, last_moved, last = sensor.simTime, sensor.simTime, sensor.arms[self.k].gripper
        self.motor.gripperVelocity = velocity
        while sensor.simTime < max(last_moved, begin) + 0.2 and velocity * (opening - last) > 0:
            sensor = yield
            now = sensor.arms[self.k].gripper
            if abs(now - last) > 0.001:
                last_moved = sensor.simTime
            last = now
        self.motor.gripperVelocity = 0
