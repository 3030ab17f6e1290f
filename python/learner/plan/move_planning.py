"""Plans one move of a block: to its goal, or to a temporary place."""

from plan.finger_depths import with_depth
from plan.goal_planning import plan_to_goal
from plan.obstruction import is_obstructing
from plan.returning_moves import plan_returning, returning_step
from plan.temporary_places import plan_temporary_placement
from plan.turning import plan_turn
from things.held_parts import with_held_parts
from things.kinds import is_same_kind
from things.supports import assumed_support
from things.walls import container_walls

OUT_OF_THE_WAY = "out of the way"  # why a block is put aside


def plan_move(state, step, move, eye, arms, sensor):
    """Plans one move: straight to its goal, if it has one and an arm reaches both places; otherwise
    to a temporary place, if necessary where a later step will be.

    Returns actions; the block where it will be, and why there if that is only a temporary place, else ""; and
    the reason if there are no actions.
    """
    returning = returning_step(move.block, state)
    if returning:
        block = with_depth(move.block, state.surface)
        actions, place, reason = plan_returning(block, returning, bool(move.goal), state, arms, sensor)
        return actions, place, "" if move.goal else OUT_OF_THE_WAY, reason
    others = with_held_parts([block for block in state.known if block is not move.block])
    others += assumed_support(move.block) + container_walls(state.containers)
    standing = [*(step for step, done in zip(state.steps, state.done) if done), *state.containers]
    sites = [[*state.steps, *state.containers]]
    goal = move.goal
    if goal:
        actions, place, why, goal = plan_to_goal(state, move, others, arms, sensor)
        if actions:
            return actions, place, why, None
        sites.append(standing)
    elif move.turns:
        held, then = [*move.turns, None][:2]
        actions, place, reason = plan_turn(arms, eye, move.block, held, then, others, sites, sensor,
                                           state.failures, state.unexplained)
        return actions, place, "onto another face", reason
    elif is_obstructing(move.block, step):
        sites.append(standing + [step])
    left = state.left if goal else [*state.left, move.block]
    left = [it for it in left if is_same_kind(move.block, it)]
    if move.room:
        sites = [site + [move.room] for site in sites]
    actions, place, reason = plan_temporary_placement(arms, eye, move.block, others, sites, sensor,
                                                      goal, state.failures, left,
                                                      state.unexplained)
    return actions, place, "for the other arm" if goal else OUT_OF_THE_WAY, reason
