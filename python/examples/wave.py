"""Waves with both arms, and opens and closes the grippers."""
import numpy as np

PERIOD = 4   # seconds for one wave
SPEED = 0.4  # rad/s at the fastest


def init(aux):
    aux.initJointAngles = [[0, -0.5, 0, 1.0, 0, 0.5, 0]] * 2
    aux.next_report = 0  # when to print again, in seconds


def step(sensor, motor, aux):
    swing = np.cos(2 * np.pi * sensor.simTime / PERIOD)
    motor.jointVelocities[:, 0] = SPEED * swing * np.array([1, -1])
    motor.jointVelocities[:, 4] = SPEED * swing * np.array([1, -1])
    motor.gripperVelocities[:] = 0.5 * swing

    if sensor.simTime >= aux.next_report:
        print(f"{sensor.simTime:5.1f} s: left gripper at", sensor.endEffPos[0].round(2))
        aux.next_report += PERIOD
