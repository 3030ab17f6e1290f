"""Chooses the next actions from the demonstrated steps and the beliefs about the scene."""

import math
from dataclasses import replace

import numpy as np

from actions import Action
from areas import is_inside
from beliefs import assumed_support
from building_site import choose_site
from claims import Claim, give_up
from clearing import clearing_moves, uncovering_moves
from constants import ARMS, TASK_PLANNING as C
from device_planning import choose_device, forget_fixtures, locate_controls
from eye import height_map
from failures import num_failures
from finger_room import grasp_yaws
from held_parts import with_held_parts
from kinds import is_same_kind
from looking import is_moving, observe
from making_room import room_moves
from notes import action_note, name_of, plan_notes
from obstruction import is_obstructing
from pick_and_place import plan_pick_and_place
from progress import assess_progress, open_steps
from proposals import propose_moves, turning_moves
from temporary_places import plan_temporary_placement
from turning import plan_turn
from walls import container_walls


def choose_actions(state, sensor, eye, arms):
    """Updates the beliefs from a picture and plans the next actions: a list; [] when everything is
    built or no plan is found (state.claim says which)."""
    picture = sensor.rgbVision / 255
    if state.presses and not state.has_site and is_moving(state, picture):
        return [Action("observe")]
    if not state.has_site or "second look" not in state.without:
        observe(state, sensor, picture, eye)
    heights = height_map(sensor.depthVision, eye) if state.presses else None
    if not state.has_site:
        problem = choose_site(state, arms, picture, eye) or locate_controls(state, picture, heights, eye)
        if problem:
            give_up(state, f"before it began: {problem}")
            return []
        state.notes += plan_notes(state.steps)

    used = assess_progress(state)
    if state.presses:
        forget_fixtures(state, picture, heights, eye)
        actions, reason = choose_device(state, arms, picture, heights, eye, sensor)
        if reason:
            give_up(state, f"at the {reason}")
        if actions or reason:
            return actions
    steps = open_steps(state)
    if not steps:
        distance, angle = np.max([(0, 0), *state.placement_errors.values()], axis=0)
        state.claim = Claim(True, "as seen within %.2f units and %.1f degrees" % (
            distance, math.degrees(angle)))
        return []

    # The next step in the demonstrated order; while that is blocked, one of the other open steps.
    insisted, state.insists_on = state.insists_on, None
    k = insisted if insisted in steps else steps[state.num_blocked % len(steps)]
    step = state.steps[k]
    reason = "no matching block is visible"
    if state.attempts[k] >= C.max_attempts:
        reason = f"{C.max_attempts} attempts failed"
    elif state.num_temporary >= C.max_temporary_placements:
        reason = f"blocks were put aside {C.max_temporary_placements} times already"
    else:
        free = [block for block in state.known if block not in used]
        moves = uncovering_moves(state, free, eye) + propose_moves(state, step, free)
        moves += turning_moves(step, free, max(arm.opening for arm in arms) - ARMS.opening_margin)
        moves += clearing_moves(state, moves, free)
        # When no other step can be done either: room on the table, and for fingers beside what is built.
        is_last_resort = state.num_blocked >= len(steps) or k == insisted
        if is_last_resort:
            moves += room_moves(state, step, moves, free, arms, eye, sensor)
            moves += clearing_moves(state, moves, state.known)
        for move in moves:
            if num_failures(state, move.block) >= C.max_failed_grasps:
                reason = f"{C.max_failed_grasps} grasps of a block failed"
                continue
            actions, place, is_temporary, reason = plan_move(state, step, move, eye, arms, sensor)
            if not actions:
                continue
            if is_temporary:
                state.num_temporary += 1
                state.left.append(move.block)
            else:
                state.attempts[k] += 1
            state.known.remove(move.block)
            state.known.append(place)
            state.num_blocked = 0
            state.insists_on = k if is_last_resort else None
            grasp = next(action for action in actions if action.kind == "grasp")
            state.grasp = grasp.grasp
            has_name = move.goal or move.turns
            state.moved = step.name if has_name else name_of(move.block, state.steps)
            state.notes.append(action_note(state.moved, move, place, is_temporary, grasp.arm))
            return actions
    if state.num_blocked == 0:
        state.first_failure = f"{step}: {reason}"
    state.num_blocked += 1
    if state.num_blocked > len(steps) + 1:
        give_up(state, f"at {state.first_failure}")
        return []
    return [Action("observe")]


def plan_move(state, step, move, eye, arms, sensor):
    """Plans one move: straight to its goal, if it has one and an arm reaches both places; otherwise
    to a temporary place, if necessary where a later step will be.

    Returns actions; the block where it will be, and whether that is a temporary place; and the
    reason if there are no actions.
    """
    others = with_held_parts([block for block in state.known if block is not move.block])
    others += assumed_support(move.block) + container_walls(state.container)
    container = [state.container] if state.container else []
    standing = [step for step, done in zip(state.steps, state.done) if done] + container
    sites = [state.steps + container]
    goal = move.goal
    if goal:
        # Where the fingers have no room in a container, it is released above the rim.
        if is_inside(state.container, goal.position) and not grasp_yaws(goal, others):
            goal = raised_above(goal, state.container)
        sites.append(standing)
        actions, reason = plan_pick_and_place(arms, move.block, goal, others, sensor,
                                              state.failures)
        if actions:
            place = replace(move.block, position=move.goal.position, yaw=move.goal.yaw)
            return actions, place, False, None
    elif move.turns:
        held, then = [*move.turns, None][:2]
        actions, place, reason = plan_turn(arms, eye, move.block, held, then, others, sites, sensor,
                                           state.failures, state.unexplained)
        return actions, place, True, reason
    elif is_obstructing(move.block, step):
        sites.append(standing + [step])
    left = []
    if not move.goal:
        left = [it for it in [*state.left, move.block] if is_same_kind(move.block, it)]
    if move.room:
        sites = [site + [move.room] for site in sites]
    actions, place, reason = plan_temporary_placement(arms, eye, move.block, others, sites, sensor,
                                                      goal, state.failures, left,
                                                      state.unexplained)
    return actions, place, True, reason


def raised_above(goal, container):
    """Returns a goal in a container, as high as necessary for the fingers to stay above its rim."""
    position = np.append(goal.position[:2], container.top + goal.size[2] / 2)
    return replace(goal, position=position)
