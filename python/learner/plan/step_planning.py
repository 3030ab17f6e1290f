"""Plans the next move for a step."""

from check.failures import num_failures
from check.progress import waits_for_support
from constants import ARMS, TASK_PLANNING as C
from plan.beginning import begin
from plan.clearing import clearing_moves, moves_from_place, moves_from_push, uncovering_moves
from plan.impossible_moves import forget_if_moved, remember_impossible, why_impossible
from plan.making_room import room_moves
from plan.moves import Move
from plan.obstruction import has_objects_on
from plan.move_planning import plan_move
from plan.proposals import propose_moves, turning_moves
from things.kinds import is_same_kind


def plan_step(state, k, free, is_last_resort, eye, arms, sensor):
    """Plans the first possible of the moves that may come next for a step. Returns actions and None; or [] and the
    reason if there are none.

    k:              number of the step
    free:           the known blocks that are in no step's place
    is_last_resort: whether no other step can be done either
    """
    if state.attempts[k] >= C.max_attempts:
        return [], f"{C.max_attempts} attempts failed"
    if state.num_temporary >= C.max_temporary_placements:
        return [], f"blocks were put aside {C.max_temporary_placements} times already"
    step = state.steps[k]
    reason = "no matching block is visible"
    forget_if_moved(state)
    for move in moves_for(state, k, free, is_last_resort, eye, arms, sensor):
        if num_failures(state, move.block) >= C.max_failed_grasps:
            reason = f"{C.max_failed_grasps} grasps of a block failed"
            continue
        reason = why_impossible(state, k, move)
        if reason:
            continue
        actions, place, why, reason = plan_move(state, step, move, eye, arms, sensor)
        if actions:
            begin(state, k, move, place, why, actions)
            return actions, None
        remember_impossible(state, k, move, reason)
    return [], reason


def moves_for(state, k, free, is_last_resort, eye, arms, sensor):
    """Returns the moves that may come next for step k, the best first: a list of Moves."""
    step = state.steps[k]
    if waits_for_support(state, k):
        # What it stands on was taken down, because it left no room for fingers at its block: that goes elsewhere.
        return [Move(it) for it in free if is_same_kind(it, step) and not has_objects_on(it, free)]
    moves = uncovering_moves(state, free, eye) + propose_moves(state, step, free)
    moves += turning_moves(step, free, max(arm.opening for arm in arms) - ARMS.opening_margin)
    moves += clearing_moves(state, moves, free) + moves_from_push(state, step, free, arms)
    if is_last_resort:
        # Room for the hand at its place, on the table, and for fingers beside what is built.
        moves += moves_from_place(step, free)
        moves += room_moves(state, step, moves, free, arms, eye, sensor)
        moves += clearing_moves(state, moves, state.known)
    return moves
