"""Grasps that failed: they are remembered, and not repeated."""

import math
from dataclasses import replace

import numpy as np

from act.grippers import can_hold
from act.path_following import CANNOT_LIFT
from constants import MOTION_PLANNING as C
from things.held_parts import held_part
from things.kinds import is_same_kind


def has_failed(grasp, failures):
    """Returns true if a grasp is about the same as one that failed."""
    for it in failures:
        turn = (grasp.yaw - it.yaw + math.pi) % (2 * math.pi) - math.pi
        if (it.arm == grasp.arm and abs(turn) < C.same_yaw_rad
                and np.linalg.norm(it.position - grasp.position) < C.same_place_distance):
            return True
    return False


def remember_failure(state, actions, status):
    """Remembers that the first of the remaining actions failed, and how: its grasp is not repeated. Unless
    the block was released already, or pushed, it is not where it was to go."""
    if status == CANNOT_LIFT:
        state.grasp.too_heavy = state.known[-1]
    if any(action.kind in ("open", "push") for action in actions[1:]):
        state.known.pop()
    state.moved = ""
    state.failures.append(state.grasp)


def is_too_heavy(block, arm, failures):
    """Returns true if an arm could not lift a block that looks like this one, on whichever face."""
    def sorted_sides(it):
        return replace(it, size=np.sort(it.size))

    return any(it.arm == arm.index and it.too_heavy and is_same_kind(sorted_sides(it.too_heavy), sorted_sides(block))
               for it in failures)


def able_arms(arms, block, width, failures, fallback="", name="it"):
    """Returns the arms that can hold a block across a width [units], and for which it is not known to be too heavy; and the reason
    to report if none of them can bring it to its place.

    failures: Grasps that failed
    fallback: the reason where no other is known
    name:     of the block in the reason
    """
    holding = [arm for arm in arms if can_hold(arm, width)]
    if not holding:
        return [], f"{name} is wider than the gripper opens"
    weak = [arm for arm in holding if is_too_heavy(block, arm, failures)]
    if len(weak) == len(holding):
        return [], f"{name} is too heavy to be lifted"
    reason = f"{name} is too heavy for the arm {weak[0].name}, and no other one can do it" if weak else fallback
    return [arm for arm in holding if arm not in weak], reason


def num_failures(state, block):
    """Returns the number of failed grasps of a block at its place."""
    return sum(np.linalg.norm(grasp.position - held_part(block).position) < C.same_place_distance
               for grasp in state.failures)
