"""Sees switches and buttons: where they are in the scene, and whether they were pressed."""

import numpy as np

from constants import PRESSES as C
from match.alignment import align
from see.colors import color_mask, table_color
from see.eye import pixels_of
from see.surfaces import is_alike, surface_of
from things.blocks import Block


def locate(press, picture, heights, eye, shown):
    """Finds how the scene lies in the demonstration around a control before its first press; shown: the eye of
    the demonstration. Returns an Alignment, or None."""
    surface = surface_of(picture, heights, eye)
    score, alignment = align(surface, press.before, shown, np.nonzero(press.changed))
    is_there = score > C.min_agreement and covered(press, alignment, surface, shown) > C.min_covered
    return alignment if is_there else None


def covered(press, alignment, surface, shown):
    """Returns the fraction of what the demonstration shows around a control, in cells of some pixels, that the
    scene shows as well."""
    row, column, inside = pixels_of(alignment.moved(surface.points), shown, press.before)
    seen = np.zeros(press.changed.shape, bool)
    alike = inside & is_alike(press.before[row, column], surface.colors)
    seen[row[alike], column[alike]] = True
    cells = cells_of(press.changed)
    row, column = np.nonzero(cells)
    around = np.zeros_like(cells)
    low, high = np.maximum([row.min() - C.around_cells, column.min() - C.around_cells], 0), C.around_cells + 1
    around[low[0]:row.max() + high, low[1]:column.max() + high] = True
    around &= cells_of(~color_mask(press.before, table_color(press.before)))
    return (cells_of(seen) & around).sum() / around.sum()


def cells_of(mask):
    """Returns which square cells of a mask contain something."""
    n, (height, width) = C.cell_pixels, np.array(mask.shape) // C.cell_pixels
    return mask[:n * height, :n * width].reshape(height, n, width, n).any(axis=(1, 3))


def changed_part(press, alignment, surface, shown):
    """Returns the Surface that the press changed in the demonstration, its colors before, and those after."""
    part = is_changed(press, alignment, surface.points, shown)
    row, column, _ = pixels_of(alignment.moved(surface.points[part]), shown, press.changed)
    return surface.part(part), press.before[row, column], press.later[row, column]


def is_changed(press, alignment, points, shown):
    """Returns which of N points the press changed in the demonstration: N bool."""
    row, column, inside = pixels_of(alignment.moved(points), shown, press.changed)
    return press.changed[row, column] & inside


def looks_pressed(press, alignment, surface, shown):
    """Returns true if what the press changes looks more as it did after the demonstrated press than before."""
    seen, before, later = changed_part(press, alignment, surface, shown)
    away, toward = (np.abs(seen.colors - it).max(axis=1) for it in (before, later))
    return (toward < away).sum() > (away < toward).sum()


def button_of(press, alignment, surface, shown):
    """Returns the part that sticks out most of all that the press changes, as a Block of no height: the raised
    button; None if nothing is seen there. Its bottom is how low the changed part is."""
    seen, before, later = changed_part(press, alignment, surface, shown)
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
                 np.pi / 2 - alignment.angle)
