"""What is believed when a move begins."""

from check.notes import action_note, name_of
from match.meant import follow_meant


def begin(state, k, move, place, why, actions):
    """Updates the beliefs and the progress for a move for a step, which is expected to succeed.

    k:     number of the step
    place: the block where it will be
    why:   it is brought there if that is only a temporary place, else ""
    """
    if why:
        state.num_temporary += 1
        state.left.append(move.block)
        if not move.goal:
            state.asides.append((k, place))
    else:
        state.attempts[k] += 1
    follow_meant(state.meant, move.block, place)
    state.known.remove(move.block)
    state.known.append(place)
    held = next(action for action in actions if action.grasp)
    state.grasp = held.grasp
    has_name = move.goal or move.turns
    state.moved = state.steps[k].name if has_name else name_of(move.block, state.steps)
    state.notes.append(action_note(state.moved, move, place, why, held))
