"""Measures the places of blocks again, in pictures that show them better."""

import numpy as np

from constants import WATCHING as C
from watch.expected_views import ExpectedView
from watch.partial_fits import fit_visible
from watch.watched_pictures import areas_in


def refine(it, classes, view_without, palette):
    """Measures the place of a Tracked block again if it was just taken, or if more of its top may be visible.

    classes:      of the pixels of a picture, as from a Palette
    view_without: returns the ExpectedView of the blocks that rest, but one
    """
    it.num_looks += 1
    if it.num_looks > C.num_looks and it.seen > C.well_seen:
        return
    view = view_without(it)
    top = palette.top(it.kind.color)
    own = ExpectedView([it.block], classes.shape, view.eye).top_of(it.block)
    pieces = areas_in((classes == top) & ~view.explained(it.kind.color), C.min_piece_pixels)
    pieces = [area for area in pieces if own[area].any()]
    if not pieces:
        return
    solid = view.solid(classes, top, it.block.top)
    fit = fit_visible(*map(np.concatenate, zip(*pieces)), it.kind, it.block.bottom, solid, view.eye)
    if not fit or fit.seen < C.well_seen * it.seen:
        return
    is_surer = fit.certainty == 2 and it.seen < C.well_seen
    if not is_surer and np.linalg.norm(fit.block.position - it.block.position) > C.max_refinement:
        return
    it.block, it.seen = fit.block, fit.seen
    if it.placed:
        it.placed[-1] = (it.placed[-1][0], fit.block)
    else:
        it.start = fit.block
