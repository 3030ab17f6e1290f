"""Which colors of a picture are those of a demonstration, seen in another light."""

import numpy as np

from constants import LIGHT as C


def color_changes(wanted, seen):
    """Returns how much each of some colors must have changed to look like each seen one, NxM: the square of their
    distance, to which the hue contributes more than the brightness; inf if it is too much."""
    changes = np.full((len(wanted), len(seen)), np.inf)
    for i, color in enumerate(wanted):
        for k, other in enumerate(seen):
            sizes = np.maximum([np.linalg.norm(color), np.linalg.norm(other)], C.darkest)
            hue = ((color / sizes[0] - other / sizes[1])**2).sum()
            change = hue + (C.brightness_weight * np.log(sizes[1] / sizes[0]))**2
            if change < C.max_change:
                changes[i, k] = change
    return changes


def clear_matches(changes):
    """Returns for each row of color_changes the column that matches it, a list; None if it has none, or if it is
    not clear which. No column matches two rows. The whole change is the least possible."""
    least, columns = least_change(changes)
    for i, k in enumerate(columns):
        if k is not None:
            others = changes.copy()
            others[i, k] = np.inf
            if least_change(others)[0] - least < C.min_advantage:
                columns[i] = None
    return columns


def least_change(changes, taken=()):
    """Returns the least whole change with which each row has a column of its own, or none, which counts as much as
    the greatest change; and these columns, a list."""
    if not len(changes):
        return 0.0, []
    total, columns = least_change(changes[1:], taken)
    best = C.max_change + total, [None, *columns]
    for k in np.flatnonzero(np.isfinite(changes[0])):
        if k not in taken:
            total, columns = least_change(changes[1:], (*taken, k))
            if changes[0, k] + total < best[0]:
                best = changes[0, k] + total, [int(k), *columns]
    return best
