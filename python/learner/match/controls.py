"""Finds where switches and buttons of the demonstration are in the scene."""

import numpy as np

from constants import PRESSES as C
from match.alignment import align
from see.colors import color_mask, table_color
from see.eye import pixels_of
from see.surfaces import is_alike, surface_of


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
