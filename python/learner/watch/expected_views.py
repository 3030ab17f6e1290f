"""What the eye would see of known blocks."""

import numpy as np

from constants import PERCEPTION, WATCHING as C
from watch.palette import BACKGROUND, UNKNOWN
from see.eye import pixels_in_view
from things.kinds import same_color
from watch.silhouettes import corners_of, fill, hull


class ExpectedView:
    """The pixels that would show each of some blocks."""

    def __init__(self, blocks, shape, eye):
        self.blocks = blocks
        self.eye = eye
        self._owner = np.full(shape, -1, np.int16)  # number of the block
        self._is_top = np.zeros(shape, bool)
        # The farthest first: the nearer ones hide them.
        far = np.argsort([-np.linalg.norm(it.position - eye.pose[:3, 3]) for it in blocks])
        for k in far:
            corners = pixels_in_view(corners_of(blocks[k]), eye)
            for polygon, is_top in ((hull(corners), False), (corners[:4], True)):
                pixels = fill(polygon, shape)
                self._owner[pixels] = k
                self._is_top[pixels] = is_top

    def _shows(self, is_one):
        """Returns the mask of the pixels that would show one of some blocks.

        is_one: predicate for a Block
        """
        return np.array([*map(is_one, self.blocks), False])[self._owner]  # the last one stands for none

    def top_of(self, block):
        """Returns the mask of the pixels that would show the top of a block."""
        return (self._owner == self.blocks.index(block)) & self._is_top

    def explained(self, color):
        """Returns the mask of the pixels at and next to those that would show tops of a color."""
        mask = np.pad(self._shows(lambda it: same_color(it.color, color)) & self._is_top, 1)
        return mask[1:-1, 1:-1] | mask[2:, 1:-1] | mask[:-2, 1:-1] | mask[1:-1, 2:] | mask[1:-1, :-2]

    def solid(self, classes, top, height):
        """Returns the mask of the pixels that show what a top at a height would hide: the background, sides of its
        own color, and lower blocks.

        top: the class of its pixels
        """
        is_lower = self._shows(lambda it: it.top < height - PERCEPTION.on_table)
        is_other = (classes != top) & (classes > BACKGROUND)
        return (classes == BACKGROUND) | (classes == top + 1) | is_lower & is_other

    def shows_sides(self, block, classes, top):
        """Returns true if the picture does not contradict the sides of a block at a new place."""
        corners = pixels_in_view(corners_of(block), self.eye)
        mask = np.zeros(classes.shape, bool)
        mask[fill(hull(corners), mask.shape)] = True
        mask[fill(corners[:4], mask.shape)] = False
        mask &= ~self._shows(lambda it: it.top > block.bottom + PERCEPTION.on_table)
        shown = classes[mask]
        is_possible = (shown == UNKNOWN) | (shown == top) | (shown == top + 1)
        return not len(shown) or is_possible.mean() > 1 - C.max_solid_sides
