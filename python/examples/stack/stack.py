"""Puts the red block on the green one.

    smile run scenes/tower_robot.xml --brain python/examples/stack/stack.py

docs/tutorials/robot-program.md explains it.
"""
from smile.motion import robot_of

from motions import follow, grip, plan
from vision import find

ASIDE = [[1.3, -1, -1.19, 1.94, 0.67, 1.03, -0.5],   # angles of the left arm [rad]
         [-1.3, -1, 1.19, 1.94, -0.67, 1.03, 0.5]]   # the right arm mirrors it


def init(aux):
    aux.initJointAngles = ASIDE
    aux.channels = ["rgb", "depth"]
    aux.robot = robot_of(aux)
    aux.colors = "red", "green"


def step(sensor, motor, aux):
    if "task" not in aux:
        if "rgbVision" not in sensor:
            return  # the first picture is not here yet
        start, goal = [find(color, sensor, aux) for color in aux.colors]
        aux.task = stack(start, goal, aux.robot, motor)
        next(aux.task)
    try:
        aux.task.send(sensor)
    except StopIteration:
        print(f"{sensor.simTime:.1f} s: done")
        aux.exit = True


def stack(start, goal, robot, motor):
    """The whole task, as a generator like its parts."""
    arm, (to_block, down, up, across, lower, away) = plan(robot, ASIDE, start, goal)
    print("using the", ["left", "right"][arm], "arm")
    yield from follow(to_block, arm, motor)
    yield from follow(down, arm, motor)
    yield from grip(-1, arm, motor)
    yield from follow(up, arm, motor)
    yield from follow(across, arm, motor)
    yield from follow(lower, arm, motor)
    yield from grip(1, arm, motor)
    yield from follow(away, arm, motor)
