"""What is believed when a move begins."""

from check.notes import action_note, name_of
from match.meant import follow_meant


def begin(state, k, move, place, is_temporary, actions):
    """Updates the beliefs and the progress for a move for a step, which is expected to succeed.

    k:            number of the step
    place:        the block where it will be
    is_temporary: whether that is a temporary place
    """
    if is_temporary:
        state.num_temporary += 1
        state.left.append(move.block)
        if not move.goal:
            state.asides.append((k, place))
    else:
        state.attempts[k] += 1
    follow_meant(state.meant, move.block, place)
    state.known.remove(move.block)
    state.known.append(place)
    grasp = next(action for action in actions if action.kind == "grasp")
    state.grasp = grasp.grasp
    has_name = move.goal or move.turns
    state.moved = state.steps[k].name if has_name else name_of(move.block, state.steps)
    state.notes.append(action_note(state.moved, move, place, is_temporary, grasp.arm))
