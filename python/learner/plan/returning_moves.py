"""Plans the moves of things that come back: to where they are put aside, and back."""

from dataclasses import replace
from itertools import product

import numpy as np

from act.actions import Grasp
from act.finger_room import grasp_yaws
from act.grippers import grip_depth, nearest_first
from check.failures import able_arms, has_failed
from constants import CLEARANCE
from match.returning import directed
from plan.touching import beside_touching
from plan.transfers import plan_arm_pick_and_place
from things.kinds import is_same_kind


def returning_step(block, state):
    """Returns the step of a block that comes back; None for any other."""
    return next((it for it in state.steps if it.aside and is_same_kind(block, it)), None)


def plan_returning(block, step, is_back, state, arms, sensor):
    """Plans to put a block aside, or back. It passes over all as high as in the demonstration, and turns as there.
    Returns actions, the block where it will be, and the reason if there are no actions."""
    aside, there = step.aside.place, step if is_back else step.aside.place
    is_aside = np.linalg.norm(block.position - aside.position) < np.linalg.norm(block.position - step.position)
    if is_aside and not is_back:
        return [], None, "it is put aside already"
    block = replace(block, yaw=directed(block, aside.yaw if is_aside else step.yaw))
    place = replace(block, position=there.position, yaw=there.yaw)
    # Only what is as high as the fingers is in their way.
    others = [it for it in state.known if it.top > min(block.top, place.top) - CLEARANCE.hand_above_top
              and not is_same_kind(it, step)]
    height = step.aside.height + block.size[2] / 2
    away = beside_touching(place, others)
    able, reason = able_arms(arms, block, block.size[1], state.failures, "no arm reaches both its place and its goal")
    for arm in nearest_first(able, block.position[0]):
        tool_height = height - grip_depth(arm, block.size[2])
        for grasp_yaw, place_yaw in product(grasp_yaws(block, others), grasp_yaws(place, others)):
            turn = place_yaw - grasp_yaw - (place.yaw - block.yaw)
            attempt = Grasp(block.position, arm.index, grasp_yaw)
            if abs(np.sin(turn / 2)) > 0.01 or has_failed(attempt, state.failures):
                continue
            actions, *_ = plan_arm_pick_and_place(arm, block, grasp_yaw, place, place_yaw, tool_height, tool_height,
                                                  away, others, sensor.arms[arm.index].joints)
            if actions:
                return actions, place, None
    return [], None, reason
