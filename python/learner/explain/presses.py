"""Switches and buttons that a demonstration pressed: what that changed in its pictures."""

from dataclasses import dataclass
from typing import Optional

import numpy as np

from constants import PRESSES as C
from explain.limits import NotUnderstood
from explain.shown_pictures import picture_frames, read_picture
from see.regions import label_regions
from things.steps import Step


@dataclass(eq=False)
class Press:
    """A press of a control."""

    control: str  # its name in the demonstration, for messages
    after: list  # numbers of the steps that were done before it
    before: np.ndarray  # picture of the demonstration before it, HxWx3
    later: np.ndarray  # and after it
    changed: np.ndarray  # mask of the pixels that it changed, HxW bool
    unchanged: Optional[np.ndarray] = None  # numbers of the regions that only other presses of the control changed,
    #                                         HxW int; 0 elsewhere
    tool: Optional[Step] = None  # that was used, in a Use
    attempts: int = 0
    grasp: Optional[object] = None  # of the last attempt
    done: bool = False

    def __str__(self):
        return f"press of {self.control}"


def place_of(control, presses):
    """Returns the mask of a rectangle around all that some press of a control changed, of the one that changed
    least: at others, something else may have moved a little."""
    best = None
    for press in [it for it in presses if it.control == control]:
        row, column = np.nonzero(press.changed)
        low = np.maximum(np.array([row.min(), column.min()]) - C.margin_pixels, 0)
        high = np.array([row.max(), column.max()]) + C.margin_pixels + 1
        if best is None or (high - low).prod() < (best[1] - best[0]).prod():
            best = low, high
    mask = np.zeros_like(presses[0].changed)
    (top, left), (bottom, right) = best
    mask[top:bottom, left:right] = True
    return mask


def unchanged_by(press, presses):
    """Returns the numbers of the regions that other presses of its control changed, and it did not: HxW int; 0
    elsewhere."""
    of_control = [it.changed for it in presses if it.control == press.control]
    return large_regions(np.any(of_control, axis=0) & ~press.changed)


def changes(demo, first, end, what):
    """Returns the last picture of a demonstration before a frame, the last one before a later frame, and the mask of
    the pixels that differ. what: it shows, for messages"""
    frames = picture_frames(demo)
    earlier = [it for it in frames if it < first]
    later = [it for it in frames if first <= it < end]
    if not earlier or not later:
        raise NotUnderstood(f"no picture of the demonstration shows what was done to {what}")
    before, after = (read_picture(demo, it[-1]) for it in (earlier, later))
    changed = large_regions(np.abs(after - before).max(axis=2) > C.min_change) > 0
    if not changed.any():
        raise NotUnderstood(f"no picture of the demonstration shows what was changed at {what}")
    return before, after, changed


def large_regions(mask):
    """Returns the numbers of the connected regions of a mask, HxW; 0 where it is false, and at thin rims, which change
    where something still moves a little."""
    number = label_regions(mask)
    return np.where(np.bincount(number.ravel())[number] < C.min_changed_pixels, 0, number)
