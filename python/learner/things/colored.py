"""The colors of things."""

import numpy as np

from constants import BLOCKS


def whole(things):
    """Returns all that has one color: things, their knobs and the parts of those of several colors, a list."""
    knobs = [it.knob for it in things if it.knob]
    return [it for it in things + knobs + sum((it.parts for it in things), []) if it.color is not None]


def of_color(things, color):
    """Returns those of some things that have exactly this color, a list."""
    return [it for it in things if it.color is not None and np.array_equal(it.color, color)]


def different_colors(things):
    """Returns the colors of some things, each once: a list."""
    found = []
    for it in things:
        if not is_among(it.color, found):
            found.append(it.color)
    return found


def is_among(color, colors):
    """Returns true if a color is exactly one of others."""
    return any(np.array_equal(color, it) for it in colors)


def is_near(color, colors):
    """Returns true if a color is the same as one of others."""
    return any(np.abs(color - it).max() < BLOCKS.same_color for it in colors)
