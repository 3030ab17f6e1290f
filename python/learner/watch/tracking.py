"""Tracks the blocks of a demonstration from picture to picture."""

import numpy as np

from constants import WATCHING as C
from watch.palette import BACKGROUND
from watch.expected_views import ExpectedView
from watch.refining import refine
from watch.tracked import Tracked, believe, doubt, take_away
from watch.whereabouts import candidates, is_in, is_same_place


class Tracker:
    """The blocks of a demonstration, as far as the pictures have shown them."""

    def __init__(self, kinds, palette, eye):
        self.objects = []  # Tracked
        self._kinds, self._palette, self._eye = kinds, palette, eye
        self._free = None  # pixels that showed the background in some picture
        self._was_still = True  # whether the scene was still in the previous picture
        self._before = []  # blocks that seemed to rest in the previous picture

    def update(self, frame, classes, is_still):
        """Continues with a picture: its classes of pixels, and whether the scene was still."""
        is_first = self._free is None
        is_settled = is_first or is_still or self._was_still
        self._was_still = is_still
        if is_first:
            self._free = np.zeros(classes.shape, bool)
        take_away(self._resting(), classes, self.view(), self._palette)
        doubt(self._resting())
        before, self._before = self._before, []
        while True:
            found = candidates(classes, self.view(), self._kinds, self._palette)
            if not is_still and not is_first:
                rested = [it for it in found if any(is_same_place(it.block, other) for other in before)]
                self._before += [it.block for it in found if it not in rested]
                found = rested
            if not found:
                break
            # Of those that are seen as well, the first one: sums differ by their rounding.
            self._place(frame, max(found, key=lambda it: round(it.seen, 6)), is_first)
        believe(self.objects)
        if is_settled:
            for it in self._resting():
                refine(it, classes, self.view, self._palette)
        self._free |= classes == BACKGROUND

    def _resting(self):
        return [it for it in self.objects if it.block]

    def view(self, but=None):
        """Returns what the eye would see of all blocks that rest, but one."""
        return ExpectedView([it.block for it in self._resting() if it is not but], self._free.shape, self._eye)

    def _place(self, frame, fit, is_first):
        """Takes note of a block at a new place."""
        began = is_first or self._began_there(fit.block)
        held = [it for it in self.objects if not it.block and it.kind is fit.kind]
        doubted = [it for it in held if it.doubted and is_same_place(it.doubted[1], fit.block)]
        if doubted:
            it, frame = doubted[0], doubted[0].doubted[0]
        elif held and not began:
            it = min(held, key=lambda it: it.doubted is not None)
        else:
            it = Tracked(fit.kind, fit.block if began else None, None)
            self.objects.append(it)
        it.block, it.seen, it.num_looks = fit.block, fit.seen, 0
        if doubted or not began:
            it.placed.append((frame, fit.block))

    def _began_there(self, block):
        """Returns true if no picture contradicts that a block was at its place from the start."""
        if any(it.start and is_in(block, it.start) for it in self.objects):
            return False
        top = ExpectedView([block], self._free.shape, self._eye).top_of(block)
        return self._free[top].mean() < C.max_free
