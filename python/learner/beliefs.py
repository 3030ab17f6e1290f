"""Beliefs about the scene: where blocks are, also those that the eye does not see."""

from dataclasses import replace

import numpy as np

from constants import BELIEFS as C


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


def assumed_support(block):
    """Returns the support of a block that does not stand on the table, as one Block from the table
    to its bottom: something must carry it, even if it is hidden. A list, empty for a block on the
    table."""
    if block.bottom < C.min_support_height:
        return []
    x, y, _ = block.position
    return [replace(block, size=np.append(block.size[:2], block.bottom),
                    position=np.array([x, y, block.bottom / 2]))]
