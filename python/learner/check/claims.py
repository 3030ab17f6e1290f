"""What the learner claims about its result."""

from typing import NamedTuple


class Claim(NamedTuple):
    """What the learner believes about its result."""

    done: bool  # whether everything is built
    reason: str  # how accurately, or why not: one line


def give_up(state, reason):
    """Ends the task unfinished, for a reason: one line."""
    state.claim = Claim(False, reason)
