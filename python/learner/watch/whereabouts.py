"""Where blocks may be that a picture shows, and that are not known to rest there."""

import numpy as np

from constants import PERCEPTION, TASK_MODEL, WATCHING as C
from things.areas import footprint, overlap
from things.blocks import yaw_difference
from things.standing import stands_on
from watch.partial_fits import best_fit, fit_visible
from watch.watched_pictures import areas_in


def candidates(classes, view, kinds, palette):
    """Returns the Fits of blocks at new places in a picture, a list.

    classes: of its pixels, as from a Palette
    view:    ExpectedView of the blocks that rest
    kinds:   the known Kinds
    """
    found = []
    for top in sorted({palette.top(it.color) for it in kinds}):
        alike = [it for it in kinds if palette.top(it.color) == top]
        pieces = areas_in((classes == top) & ~view.explained(alike[0].color), C.min_piece_pixels)
        areas = [it for it in pieces if len(it[0]) >= PERCEPTION.min_top_pixels]
        if 1 < len(pieces) <= C.max_pieces:  # something may hide the middle
            areas.append([np.concatenate(it) for it in zip(*pieces)])
        found += [best_fit(fits(*area, top, classes, view, alike)) for area in areas]
    return [it for it in found if it]


def unclear_colors(classes, view, kinds, palette):
    """Returns the colors of which a picture shows tops that no block explains, a list. The arguments are as for candidates."""
    tops = {palette.top(it.color): it.color for it in kinds}
    return [color for top, color in sorted(tops.items(), key=lambda it: it[0])
            if areas_in((classes == top) & ~view.explained(color), PERCEPTION.min_top_pixels)]


def fits(row, column, top, classes, view, kinds):
    """Yields the Fits of some Kinds to the pixels of a top that are possible among the blocks that rest.

    top: the class of the pixels
    """
    for bottom in np.unique(np.round([0.0] + [it.top for it in view.blocks], 3)):
        for kind in kinds:
            solid = view.solid(classes, top, bottom + kind.size[2])
            fit = fit_visible(row, column, kind, bottom, solid, view.eye)
            if (fit and (bottom == 0 or any(stands_on(fit.block, it) for it in view.blocks))
                    and not any(is_in(fit.block, it) for it in view.blocks)
                    and view.shows_sides(fit.block, classes, top)):
                yield fit


def is_same_place(one, other):
    """Returns true if two Blocks are one that did not move."""
    return (one.size is other.size and np.linalg.norm(one.position - other.position) < C.same_place
            and abs(yaw_difference(one, other.yaw)) < C.same_yaw_rad)


def is_in(one, other):
    """Returns true if two Blocks would be in each other."""
    is_level = (one.bottom < other.top - TASK_MODEL.max_support_gap
                and other.bottom < one.top - TASK_MODEL.max_support_gap)
    return is_level and overlap(footprint([one], -C.max_within)[0], footprint([other], -C.max_within)).any()
