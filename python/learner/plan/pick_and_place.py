"""Plans how a block is brought from one place to another: with which arm, how high, and how it is held."""

from dataclasses import replace
from itertools import product

from act.actions import Grasp
from act.finger_room import grasp_yaws
from act.grippers import nearest_first
from check.choices import Way
from check.failures import able_arms, has_failed
from constants import MOTION_PLANNING as C
from plan.heights import has_low_way, transfer_height
from plan.touching import beside_touching
from plan.transfers import plan_arm_pick_and_place
from things.held_parts import held_anyhow, held_part, is_turned_to
from things.steps import is_dragged


def plan_pick_and_place(arms, block, goal, others, sensor, failures=(), way=Way()):
    """Plans the actions that bring a block to a goal (a Block or Step) and end with an observation.

    arms:     the Arms that may do it
    others:   obstacles, as Blocks
    failures: Grasps that failed and are not to be repeated
    way:      in which it is preferably held and carried
    Returns actions and None, or [] and the reason if no arm can do it.
    """
    reason = None
    for it in held_anyhow(block):
        actions, why = plan_held_pick_and_place(arms, it, goal, others, sensor, failures, way)
        if actions:
            return actions, None
        reason = reason or why
    return [], reason


def plan_held_pick_and_place(arms, block, goal, others, sensor, failures, way):
    """Plans how a block that is held in one way is brought to a goal, see plan_pick_and_place."""
    goal = replace(goal, knob=block.knob)
    held, target = held_part(block), held_part(goal)
    at_start, at_goal = grasp_yaws(block, others), grasp_yaws(goal, others)
    if not at_start or not at_goal:
        return [], "there is no room for the fingers"
    able, reason = able_arms(arms, block, held.size[1], failures, "no arm reaches both its place and its goal")
    if not able:
        return [], reason
    away = None if is_dragged(goal) else beside_touching(target, others)
    # Ends that proved beyond reach, at the block and at the goal: the arm, the yaw of its hand, and the heights of its tool.
    beyond = set(), set()
    can_be_low = not is_dragged(goal) and not block.knob and has_low_way(block, goal, others)
    for is_low, rise, arm in product([False, True] if can_be_low else [False], way.rises(),
                                     nearest_first(able, block.position[0] + goal.position[0])):
        if is_dragged(goal):
            height = block.top + C.drag_tool_height
        else:
            height = transfer_height(arm, [*others, held], goal.bottom, target.top - goal.bottom) + rise
        # What cannot be lifted high enough to pass over all others is lifted less on a low way.
        lift = block.position[2] + block.size[2] + C.clearance if is_low else height
        q = sensor.arms[arm.index].joints
        yaws = [yaw for yaw in at_start
                if not has_failed(Grasp(held.position, arm.index, yaw), failures)]
        for place_yaw, grasp_yaw in way.ranked(list(product(at_goal, yaws))):
            ends = (arm.index, grasp_yaw, lift, height), (arm.index, place_yaw, height)
            if ends[0] in beyond[0] or ends[1] in beyond[1]:
                continue
            # The object turns with the hand; it may look the same after some turns.
            turned = replace(block, yaw=block.yaw + place_yaw - grasp_yaw)
            if (block.knob or block.parts) and not is_turned_to(turned, goal):
                continue
            actions, *are_beyond = plan_arm_pick_and_place(arm, held, grasp_yaw, target, place_yaw, height, lift,
                                                           away, others, q)
            if actions:
                return actions, None
            for known, end, is_beyond in zip(beyond, ends, are_beyond):
                if is_beyond:
                    known.add(end)
    return [], reason
