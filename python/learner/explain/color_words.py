"""Words for the colors of what pictures alone have shown."""

import numpy as np

COLORS = {"Red": (1, 0, 0), "Green": (0, 1, 0), "Blue": (0, 0, 1), "Yellow": (1, 1, 0),
          "Cyan": (0, 1, 1), "Magenta": (1, 0, 1), "Orange": (1, 0.5, 0), "Brown": (0.25, 0.16, 0.1),
          "White": (1, 1, 1), "Gray": (0.5, 0.5, 0.5), "Black": (0, 0, 0)}


def word_of(color):
    """Returns the word for the known color that is closest to one."""
    return min(COLORS, key=lambda name: np.square(color - COLORS[name]).sum())


def names_of(objects):
    """Returns names for Tracked blocks: their colors, and numbers."""
    names = []
    for it in objects:
        word = word_of(it.kind.color)
        names.append(f"{word}{1 + sum(name.rstrip('0123456789') == word for name in names)}")
    return names
