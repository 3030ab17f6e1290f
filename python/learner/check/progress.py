"""Which steps are done, and which are next."""

import numpy as np

from things.blocks import yaw_difference
from things.kinds import is_in_place


def open_steps(state):
    """Returns the numbers of the steps that are not done and whose supports are done, in
    demonstrated order, or in that of a choice; before a press, only of those that were done before it."""
    pending = [press for press in state.presses if not press.done]
    steps = [k for k, step in enumerate(state.steps)
             if (not pending or k in pending[0].after) and not state.done[k]
             and all(state.done[lower] for lower in step.on + step.after)]
    return state.choices.ordered(steps, len(state.steps))


def waits_for_support(state, k):
    """Returns true if step k, or None, stands on one that is not done."""
    return k is not None and not all(state.done[lower] for lower in state.steps[k].on)


def assess_progress(state):
    """Compares the known blocks with the steps: updates state.done and state.placement_errors.
    Returns the blocks that are in the place of a step, a list."""
    used = []
    for k, step in enumerate(state.steps):
        state.done[k] = False
        for block in state.known:
            is_early = not all(state.done[lower] for lower in step.after)
            if block not in used and not is_early and is_in_place(block, step):
                state.placement_errors[k] = (np.linalg.norm(block.position - step.position),
                                             abs(yaw_difference(step, block.yaw)))
                state.done[k] = True
                used.append(block)
                break
    return used
