"""Plans how an arm carries a block, and follows the plan."""
import numpy as np

ABOVE = 3       # height of the tool above the table while it carries a block [units]
GRASP = 0.8     # height of the tool when it grasps a block on the table [units]
MARGIN = 0.01   # a block is released this far above the one below it [units]


def plan(robot, aside, start, goal):
    """Plans to carry a block from the table at `start` onto the block at `goal`, both x, y [units].

    Returns the index of an arm and its motions: to the block, down, up, across, down, up.
    """
    poses = [tool(start, ABOVE), tool(start, GRASP), tool(start, ABOVE),
             tool(goal, ABOVE), tool(goal, GRASP + 1 + MARGIN), tool(goal, ABOVE)]
    for index, arm in enumerate(["left", "right"]):
        q = robot.inverse(arm, poses[0], robot.pose(arm, "untucked"))
        if q is None:
            continue
        motions = [robot.move_joints(arm, [aside[index], q])]
        for pose in poses[1:]:
            motion, fault = robot.move_line(arm, motions[-1].positions[-1], pose, tool_speed=4)
            if fault:
                break
            motions.append(motion)
        if len(motions) == len(poses):
            return index, motions
    raise RuntimeError("no arm reaches both blocks")


def tool(place, height):
    """Returns the pose of the tool with the fingers straight down, left and right of a place."""
    pose = np.array([[0, 1, 0, 0], [1, 0, 0, 0], [0, 0, -1, 0], [0, 0, 0, 1.0]])
    pose[:3, 3] = [*place, height]
    return pose


def follow(motion, arm, motor):
    """Moves an arm. Each `yield` waits for the next step and returns its sensor values."""
    sensor = yield
    begin = sensor.simTime
    while sensor.simTime < begin + motion.duration + 0.3:
        q, velocity = motion.at(sensor.simTime - begin)
        motor.jointVelocities[arm] = velocity + 4 * (q - sensor.jointAngles[arm])
        sensor = yield
    motor.jointVelocities[arm] = 0


def grip(velocity, arm, motor):
    """Opens a gripper for a second, or closes it if the velocity is negative [units/s]."""
    sensor = yield
    begin = sensor.simTime
    motor.gripperVelocities[arm] = velocity
    while sensor.simTime < begin + 1:
        sensor = yield
    motor.gripperVelocities[arm] = 0
