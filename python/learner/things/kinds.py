"""Kinds of blocks: which ones are alike in color, form and size."""

import numpy as np

from constants import BLOCKS, PARTS
from things.blocks import yaw_difference
from things.outlines import same_outline


def is_same_kind(block, step):
    """Returns true if a detected block has the color, the form and the size of a step; for things of several
    colors, the same parts."""
    if block.parts or step.parts:
        return block.parts is step.parts or has_parts_of(block, step, True)
    return same_color(step.color, block.color) and same_form(step, block)


def has_parts_of(one, other, is_colored):
    """Returns true if two things of several colors have the same layout of parts, also in colors if these
    count."""
    return bool(one.parts) and len(one.parts) == len(other.parts) and all(
        any(np.linalg.norm(a.position - b.position) < PARTS.same_place and same_size(a.size[:2], b.size[:2])
            and (not is_colored or same_color(a.color, b.color)) for b in other.parts) for a in one.parts)


def same_form(a, b):
    """Returns true if two blocks have the same form and size."""
    return a.form == b.form and same_size(a.size, b.size) and same_outline(a.outline, b.outline)


def same_color(wanted, color):
    """Returns true if a color is the wanted one; None accepts any."""
    return wanted is None or np.abs(wanted - color).max() < BLOCKS.same_color


def same_size(a, b):
    """Returns true if two sizes are equal within the accuracy of pictures."""
    return np.abs(a / b - 1).max() < BLOCKS.same_size


def is_in_place(block, step):
    """Returns true if a block is in the place of a step."""
    return (is_same_kind(block, step)
            and np.linalg.norm(block.position - step.position) < step.tolerance
            and abs(yaw_difference(step, block.yaw)) < BLOCKS.yaw_tolerance_rad)
