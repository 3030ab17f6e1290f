"""Builds a tower of cubes with any robot: red, on it green, on it blue.

    smile run scenes/tower_robot.xml --brain python/examples/stack/stack.py

docs/tutorials/robot-program.md explains it.
"""
import numpy as np
from smile.motion import robot_of

from motions import UP, Arm, Carry, follow, grip
from vision import Block, find


def init(aux):
    robot = robot_of(aux)
    aux.hands = [Arm(robot, aux.robotBase, k, arm.gripper)
                 for k, arm in enumerate(aux.arms) if arm.gripper is not None]
    if not aux.hands:
        raise RuntimeError("the robot has no gripper")
    for arm in aux.hands:
        aux.arms[arm.index].initJoints = arm.q
    aux.channels = ["rgb", "depth"]
    aux.colors = "red", "green", "blue"  # from the bottom to the top


def step(sensor, motor, aux):
    if "task" not in aux:
        aux.task = build(aux.colors, aux.hands, motor, aux)
        next(aux.task)
    try:
        aux.task.send(sensor)
    except StopIteration:
        print(f"{sensor.simTime:.1f} s: done")
        aux.exit = True


def build(colors, arms, motor, aux):
    """The whole task, as a generator like its parts."""
    blocks = yield from look(colors, arms, motor, aux)
    for arm in arms:  # high enough to carry a block over the others
        arm.raise_to(sum(block.size for block in blocks) + arm.lowest + 0.2)
        yield from follow(arm.robot.move_joints(arm.name, [arm.q, arm.away]), arm, motor)
    plans = yield from plan_tower(blocks, arms)
    for arm, parts in plans:
        print("using the arm", arm.name)
        for width, motions in parts:
            yield from grip(width, arm, motor)
            for motion in motions:
                yield from follow(motion, arm, motor)


def look(colors, arms, motor, aux):
    """Finds the blocks. A single arm that hides some turns aside until all have been seen."""
    arm, found = arms[0], {}
    for q in arm.postures[::-2] if len(arms) == 1 else [arm.q]:
        yield from follow(arm.robot.move_joints(arm.name, [arm.q, q]), arm, motor)
        aux.imageSeconds = 0  # a picture with the next step
        sensor = yield
        while "rgbVision" not in sensor:
            sensor = yield
        aux.imageSeconds = 3600  # and no more
        for color in colors:
            found[color] = found.get(color) or find(color, sensor, aux)
        if all(found.values()):
            return [found[color] for color in colors]
    raise RuntimeError("not visible: " + ", ".join(color for color in colors if not found[color]))


def plan_tower(blocks, arms):
    """Plans the tower on the lowest block, or in a free place if no arm can build it there."""
    carries = [[Carry(arm, block) for arm in arms] for block in blocks]
    bottom = blocks[0]
    plans = plan_at(bottom.place, bottom.turn, carries, first=1)
    for place in [place for arm in arms for place in arm.places()]:
        gaps = [np.linalg.norm(place - block.place) - 1.5 * block.size for block in blocks]
        for turn in (0, np.pi / 4) if min(gaps) > 0.5 else ():
            if plans is None:
                yield  # a step has only a few seconds of wall-clock time
                plans = plan_at(place, turn, carries)
    if plans is None:
        raise RuntimeError("no arm can build the tower")
    return plans


def plan_at(place, turn, carries, first=0):
    """Plans to put blocks in a place, one on top of the other; None if no arm can."""
    plans = []
    for k, choice in enumerate(carries):
        block = choice[0].block
        goal = Block(place, turn, block.size)
        place = place + block.size * UP
        if k < first:
            continue  # is there
        plans.append(next(filter(None, (carry.to(goal) for carry in choice)), None))
        if plans[-1] is None:
            return None
    return plans
