"""Plans one move of a block: to its goal, or to a temporary place."""

from dataclasses import replace

import numpy as np

from act.finger_room import grasp_yaws
from plan.finger_depths import with_depth
from plan.obstruction import is_obstructing
from plan.pick_and_place import plan_pick_and_place
from plan.returning_moves import plan_returning, returning_step
from plan.temporary_places import plan_temporary_placement
from plan.turning import plan_turn
from things.areas import container_at
from things.held_parts import with_held_parts
from things.kinds import is_same_kind
from things.supports import assumed_support
from things.walls import container_walls


def plan_move(state, step, move, eye, arms, sensor):
    """Plans one move: straight to its goal, if it has one and an arm reaches both places; otherwise
    to a temporary place, if necessary where a later step will be.

    Returns actions; the block where it will be, and whether that is a temporary place; and the
    reason if there are no actions.
    """
    returning = returning_step(move.block, state)
    if returning:
        block = with_depth(move.block, state.surface)
        actions, place, reason = plan_returning(block, returning, bool(move.goal), state, arms, sensor)
        return actions, place, not move.goal, reason
    others = with_held_parts([block for block in state.known if block is not move.block])
    others += assumed_support(move.block) + container_walls(state.containers)
    standing = [*(step for step, done in zip(state.steps, state.done) if done), *state.containers]
    sites = [[*state.steps, *state.containers]]
    goal = move.goal
    if goal:
        # Where the fingers have no room in a container, it is released above the rim.
        container = container_at(state.containers, goal.position)
        if container and not grasp_yaws(goal, others):
            goal = raised_above(goal, container)
        sites.append(standing)
        actions, reason = plan_pick_and_place(arms, with_depth(move.block, state.surface),
                                              with_depth(goal, state.surface), others, sensor, state.failures,
                                              state.choices.way(sum(state.attempts) + state.num_temporary))
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
    left = state.left if move.goal else [*state.left, move.block]
    left = [it for it in left if is_same_kind(move.block, it)]
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
