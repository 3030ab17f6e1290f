"""What the learner claims about its result."""

from typing import NamedTuple


class Claim(NamedTuple):
    """What the learner believes about its result."""

    done: bool  # whether everything is built
    reason: str  # how accurately, or why not: one line


def end_with(claim, time, aux):
    """Ends the run of a brain at a time [s] with a Claim."""
    aux.claim = f"{'done' if claim.done else 'gave up'}: {claim.reason}"
    print(f"{time:5.1f} s: {aux.claim}")
    aux.exit = True


def give_up(state, reason):
    """Ends the task unfinished, for a reason: one line."""
    state.claim = Claim(False, reason)
