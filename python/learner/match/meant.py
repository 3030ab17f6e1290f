"""Which of several blocks that look the same is meant, by what it stands on at the start."""

import numpy as np

from constants import BELIEFS as C, PERCEPTION
from things.kinds import is_same_kind
from things.standing import stands_on


def meant_blocks(steps, known):
    """Returns which of the known blocks is meant by each step whose object began on something else than others like it: a
    dict from number of the step to position, without those that are not seen there."""
    pairs = [(misfit, k, i) for k, step in enumerate(steps) if step.began_on for i, block in enumerate(known)
             if is_same_kind(block, step) and (misfit := misfit_of(block, step.began_on, known)) is not None]
    meant, taken = {}, set()
    for _, k, i in sorted(pairs):
        if k not in meant and i not in taken:
            meant[k] = known[i].position
            taken.add(i)
    return meant


def misfit_of(block, support, known):
    """Returns how far what a block stands on is from where a StartSupport was, among all that look like it [units]; None if
    it stands on something else."""
    if support.like is None:
        return 0.0 if block.bottom < PERCEPTION.on_table else None
    alike = [it for it in known if is_same_kind(it, support.like)]
    below = [it for it in alike if it is not block and stands_on(block, it)]
    if not below:
        return None
    middle = np.mean([it.position[:2] for it in alike], axis=0)
    return min(np.linalg.norm(it.position[:2] - middle - support.away) for it in below)


def is_meant(meant, k, block):
    """Returns true if a block is the one that step k means."""
    return k in meant and np.linalg.norm(block.position - meant[k]) < C.same_block_distance


def fitting(meant, k, blocks):
    """Returns those of some blocks of the kind of step k that it may use: the one that is meant; or all that no other step
    means, if that is not known."""
    return ([it for it in blocks if is_meant(meant, k, it)]
            or [it for it in blocks if not any(is_meant(meant, other, it) for other in meant)])


def follow_meant(meant, block, place):
    """Notes that a block was moved to a place."""
    for k in meant:
        if is_meant(meant, k, block):
            meant[k] = place.position
