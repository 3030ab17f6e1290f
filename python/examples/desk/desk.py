"""Opens a drawer, a door and a lid, pushes the door to, and turns a dial: scenes/desk.xml.

    smile run scenes/desk.xml --robot tern --brain python/examples/desk/desk.py

The gripper takes each handle from above. Then the tool moves as the handle can: along a line, or
about the axis of a hinge. To push, the closed fingers go down before it instead.
"""
import numpy as np
from smile.motion import robot_of

X, Z = np.array([1, 0, 0]), np.array([0, 0, 1])
ABOVE = 1.0  # of a handle, before and after it is held [units]


def tool(place, turn):
    """Returns the pose of the tool at a place, with the fingers down and turned about z."""
    return at(place, rotation(Z, turn) @ np.diag([1, -1, -1]))


def at(place, R):
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = R, place
    return pose


def rotation(axis, angle):
    """Returns the rotation about a unit vector (Rodrigues)."""
    K = np.cross(np.eye(3), axis)
    return np.eye(3) + np.sin(angle) * K + (1 - np.cos(angle)) * K @ K


def about(pose, center, axis, angle):
    """Returns poses along an arc: `pose`, turned about an axis through a point."""
    turns = [rotation(axis, part) for part in np.linspace(0, angle, 2 + int(abs(angle) / 0.1))]
    return [at(center + R @ (pose[:3, 3] - center), R @ pose[:3, :3]) for R in turns]


# Handles and hinges as the scene has them: the pose in which each is taken, and the way it moves.
DRAWER, DOOR, LID, DIAL = (tool([-3, -2.4, 1.2], np.pi / 2), tool([3.3, -0.6, 2], 0),
                           tool([-0.9, 0.2, 1.5], 0), tool([3.4, -3.4, 0.7], np.pi))
# Before the open door, with the closed fingers along it.
PUSH = about(tool([3, -0.6, 1.6], 0), np.array([1.6, -0.6, 0]), Z, -1.3)[-1]
TASKS = {"drawer": [DRAWER, at(DRAWER[:3, 3] - [0, 1.5, 0], DRAWER[:3, :3])],
         "dial": about(DIAL, np.array([3.4, -3.4, 0]), Z, 1.5),
         "door": about(DOOR, np.array([1.6, -0.6, 0]), Z, -1.0),
         "door back": about(PUSH, np.array([1.6, -0.6, 0]), Z, 0.8),
         "lid": about(LID, np.array([-0.9, -1.5, 1]), X, 1.0)}
PUSHES = {"door back"}  # with closed fingers


def init(aux):
    aux.planner = robot_of(aux)
    aux.channels = []


def step(sensor, motor, aux):
    if "task" not in aux:
        aux.task = work(aux.planner, aux.arms[0], sensor.arms[0].joints, motor)
        next(aux.task)
    try:
        aux.task.send(sensor)
    except StopIteration:
        aux.exit = True


def work(robot, arm, q, motor):
    """The whole task. Each `yield` waits for the next step and returns its sensor values."""
    ready = robot.pose(arm.name, "ready")
    for name, poses in TASKS.items():
        if name in PUSHES:
            yield from grip(-0.5, motor)
        above = at(poses[0][:3, 3] + ABOVE * Z, poses[0][:3, :3])
        to_handle = joints_along(robot, arm.name, [above, poses[0]], ready)
        yield from follow(robot.move_joints(arm.name, [q, *to_handle[:1]]), motor)
        yield from follow(robot.move_joints(arm.name, to_handle, speed=0.3), motor)
        if name not in PUSHES:
            yield from grip(-0.5, motor)
        way = joints_along(robot, arm.name, poses, to_handle[-1])
        yield from follow(robot.move_joints(arm.name, way, speed=0.2), motor)
        print("moved the", name)
        q = way[-1]
        if name != "lid":  # it would shut
            yield from grip(0.5, motor)
            last = poses[-1]
            up = joints_along(robot, arm.name, [last, at(last[:3, 3] + ABOVE * Z, last[:3, :3])], q)
            yield from follow(robot.move_joints(arm.name, up, speed=0.3), motor)
            q = up[-1]


def joints_along(robot, arm, poses, q):
    """Returns the angles for each pose, each near those before."""
    angles = []
    for pose in poses:
        q = robot.inverse(arm, pose, q)
        if q is None:
            raise RuntimeError(f"out of reach: {pose[:3, 3].round(2)}")
        angles.append(q)
    return angles


def follow(motion, motor):
    sensor = yield
    begin = sensor.simTime
    while sensor.simTime < begin + motion.duration + 0.3:
        q, velocity = motion.at(sensor.simTime - begin)
        motor.arms[0].velocities = velocity + 4 * (q - sensor.arms[0].joints)
        sensor = yield
    motor.arms[0].velocities = 0 * velocity


def grip(velocity, motor):
    """Opens or closes the gripper until it no longer moves [units/s]."""
    sensor = yield
    moved, last = sensor.simTime, None
    motor.arms[0].gripperVelocity = velocity
    while sensor.simTime < moved + 0.3:
        if last is None or abs(sensor.arms[0].gripper - last) > 0.001:
            moved, last = sensor.simTime, sensor.arms[0].gripper
        sensor = yield
    motor.arms[0].gripperVelocity = 0
