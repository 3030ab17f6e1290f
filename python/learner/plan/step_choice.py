"""Chooses for which step something is done next."""

from act.actions import Action
from check.claims import give_up
from check.progress import waits_for_support
from check.task_state import Intention
from plan.hand_looks import plan_hand_look
from plan.step_planning import plan_step


def plan_one_of(steps, state, free, eye, arms, sensor):
    """Plans the next of some steps in the demonstrated order; while that is blocked, one of the others, next time.
    Returns actions; [] if all are blocked.

    steps: their numbers
    free:  the known blocks that are in no step's place
    """
    intention, state.intention = state.intention, None
    is_next = intention and (intention.step in steps or waits_for_support(state, intention.step))
    k = intention.step if is_next else steps[state.num_blocked % len(steps)]
    is_last_resort = is_next and intention.is_last_resort or state.num_blocked >= len(steps)
    actions, reason = plan_step(state, k, free, is_last_resort, eye, arms, sensor)
    if actions:
        state.num_blocked = 0
        # What was put aside, or handed over, was for this step: it goes on.
        state.intention = Intention(k, is_last_resort) if k in steps else None
        return actions
    if is_next and not is_last_resort:
        return plan_one_of(steps, state, free, eye, arms, sensor)
    if state.num_blocked == 0:
        state.first_failure = f"{state.steps[k]}: {reason}"
    state.num_blocked += 1
    if state.num_blocked > len(steps) + 1:
        actions = plan_hand_look(steps, state, free, eye, arms, sensor)
        if actions:
            state.num_blocked = 0
            return actions
        give_up(state, f"at {state.first_failure}")
    return [] if state.claim else [Action("observe")]
