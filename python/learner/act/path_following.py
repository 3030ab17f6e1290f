"""Follows paths of the arms with feedback: to their ends, or until something stops the arm."""

import numpy as np

from act.actions import ticks_within
from constants import EXECUTION as C

CANNOT_LIFT = "the arm cannot lift it"  # how a lift ends if the arm does not keep up


def follow(action, sensor, motor, aux, chunk=C.chunk_ticks):
    """Follows a path until the measured joints have arrived, not until a fixed time. The velocities
    along the path are chunks of some ticks. After its end, each tick has feedback."""
    q = sensor.arms[action.arm.index].joints
    speed = vars(aux).get("variationSpeed", 1)
    delay = action.time - action.path.duration / speed
    status = arrival(action.path.positions[-1], q, delay)
    if status == "done":
        return status
    num_ticks = min(ticks_within(-delay, aux) + 1, chunk)
    # action.time is the end of the first of these ticks.
    wanted, _ = action.path.at(speed * (action.time + aux.tickSeconds * np.arange(num_ticks)))
    motor.ticks = num_ticks
    velocities = np.diff([q, *wanted], axis=0).T / aux.tickSeconds
    motor.arms[action.arm.index].velocities = velocities
    return status


def lift(action, sensor, motor, aux):
    """Follows a path with a block, as long as the arm keeps up: what is too heavy is not dragged away."""
    # action.time is the end of this tick.
    time = vars(aux).get("variationSpeed", 1) * (action.time - aux.tickSeconds)
    [expected], _ = action.path.at(np.array([time]))
    lag = np.abs(expected - sensor.arms[action.arm.index].joints).max()
    return CANNOT_LIFT if lag > C.max_lag_rad else follow(action, sensor, motor, aux, C.lift_ticks)


def press(action, sensor, motor, aux):
    """Follows a path to its end, or until something stops the arm, and back to its start. Each tick has feedback: an
    arm that pushes on slips off what it presses."""
    q = sensor.arms[action.arm.index].joints
    # action.time is the end of this tick.
    time = vars(aux).get("variationSpeed", 1) * np.array([action.time - aux.tickSeconds, action.time])
    (expected, wanted), _ = action.path.at(np.minimum(time, 2 * action.turn - time))
    if action.turn == np.inf and (time[0] > action.path.duration or np.abs(expected - q).max() > C.stall_rad):
        action.turn = time[0]
    status = arrival(action.path.positions[0], q, time[1] - 2 * action.turn)
    if status != "done":
        motor.arms[action.arm.index].velocities = (wanted - q) / aux.tickSeconds
    return status


def arrival(goal, q, delay):
    """Returns 'done' if the joints have arrived at the goal of a path, 'busy' if they may yet, or why they do not.

    delay: time since they should have [s]
    """
    if delay > 0 and np.abs(goal - q).max() < C.joint_tolerance_rad:
        return "done"
    return "an obstacle is in the way of the arm" if delay > C.max_delay_s else "busy"
