"""Beliefs about the scene: where blocks are, also those that the eye does not see."""


def corrected(seen, verdicts):
    """Returns the known blocks after an observation, a list: those seen, and those that were known
    before and are hidden now. A block whose top is partly hidden is where it was known to be."""
    now = list(seen)
    for it in verdicts:
        if it.word != "hidden":
            continue
        if it.found is None:
            now.append(it.expected)
        else:
            now[it.found] = it.expected
    return now
