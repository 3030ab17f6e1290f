"""Sees what a press of a switch or button changes, and whether it was pressed."""

import numpy as np

from constants import PRESSES as C
from see.eye import pixels_of
from see.surfaces import is_alike
from things.blocks import Block


def shown_part(mask, press, alignment, surface, shown):
    """Returns the Surface that a mask of the pixels of the demonstration shows, its colors before a press, and those
    after."""
    part = is_within(mask, alignment, surface.points, shown)
    row, column, _ = pixels_of(alignment.moved(surface.points[part]), shown, mask)
    return surface.part(part), press.before[row, column], press.later[row, column]


def is_within(mask, alignment, points, shown):
    """Returns which of N points a mask of the pixels of the demonstration shows: N bool."""
    row, column, inside = pixels_of(alignment.moved(points), shown, mask)
    return mask[row, column] & inside


def looks_pressed(press, alignment, surface, shown):
    """Returns true if what the press changes looks more as it did after the demonstrated press than before, and what
    only other presses of the control change, as after it, too: a second lamp may be on."""
    seen, before, later = shown_part(press.changed, press, alignment, surface, shown)
    away, toward = (np.abs(seen.colors - it).max(axis=1) for it in (before, later))
    if (toward < away).sum() <= (away < toward).sum():
        return False
    for n in range(1, press.unchanged.max() + 1):
        seen, _, later = shown_part(press.unchanged == n, press, alignment, surface, shown)
        if is_alike(seen.colors, later).sum() < len(later) / 2:
            return False
    return True


def button_of(press, alignment, surface, shown):
    """Returns the part that sticks out most of all that the press changes, as a Block of no height: the raised
    button; None if nothing is seen there. Its bottom is how low the changed part is. Closed fingers side by side are
    to lie along it, so that they touch nothing else."""
    seen, before, later = shown_part(press.changed, press, alignment, surface, shown)
    seen = seen.part(is_alike(before, seen.colors) | is_alike(later, seen.colors))
    if not len(seen.points):
        return None
    top = seen.points[:, 2].max()
    edge = seen.points[seen.points[:, 2] > top - C.edge_depth].mean(axis=0)
    near = surface.around(edge, C.button_radius, len(surface.points)).points
    raised = near[(near[:, 2] > top - C.edge_depth) & (near[:, 2] < top + C.edge_depth)]
    low, high = seen.points[:, 2].min(), np.median(raised[:, 2])
    size = np.array([C.finger_width, C.finger_width, high - low])
    return Block(seen.colors.mean(axis=0), size, np.append(raised[:, :2].mean(axis=0), (low + high) / 2),
                 longer_direction(raised[:, :2]) - np.pi / 2)


def longer_direction(points):
    """Returns the direction in which N points, Nx2, extend most [rad]."""
    x, y = (points - points.mean(axis=0)).T
    return np.arctan2(2 * (x * y).sum(), (x * x - y * y).sum()) / 2
