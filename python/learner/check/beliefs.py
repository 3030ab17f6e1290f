"""Beliefs about the scene: where blocks are, also those that the eye does not see."""

import numpy as np

from constants import BELIEFS as C
from see.sight import top_points
from things.areas import footprint, overlap
from things.kinds import same_color


def corrected(seen, verdicts):
    """Returns the known blocks after an observation, a list: those seen, and those that were known
    before and are hidden now. A block whose top is partly hidden is where it was known to be."""
    hidden = [it for it in verdicts if it.word == "hidden"]
    known = [it.expected for it in hidden]
    found = {it.found: it.expected for it in hidden if it.found is not None}
    recognized = {it.found for it in verdicts}
    now = [found.get(k, it) for k, it in enumerate(seen) if k in recognized or not is_pieced_together(it, known)]
    return now + [it.expected for it in hidden if it.found is None]


def is_pieced_together(block, hidden):
    """Returns true if the top of a block that was seen consists of parts of the tops of blocks that are known to be there and
    partly hidden."""
    like = [it for it in hidden if same_color(it.color, block.color) and abs(it.top - block.top) < C.same_top]
    points = top_points(block)
    at = np.column_stack([points[:, :2], np.zeros((len(points), 3))])
    return bool(overlap(at, footprint(like, C.same_top)).any(axis=0).all())
