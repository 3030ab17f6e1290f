"""Switches and buttons that a demonstration pressed: what that changed in its pictures."""

from dataclasses import dataclass, field

import numpy as np

from constants import PRESSES as C
from demonstration import read_picture
from regions import label_regions


@dataclass(eq=False)
class Press:
    """A press of a control."""

    control: str  # its name in the demonstration, for messages
    after: list  # numbers of the steps that were done before it
    before: np.ndarray  # picture of the demonstration before it, HxWx3
    later: np.ndarray  # and after it
    changed: np.ndarray  # mask of the pixels that it changed, HxW bool
    attempts: int = 0
    done: bool = False

    def __str__(self):
        return f"press of {self.control}"


def infer_presses(demo, steps):
    """Returns the Presses of a demonstration, in their order, as far as the pictures show what they changed.
    Raises ValueError if they show nothing."""
    placed = set()  # names of the objects that were released so far for the last time
    last = {n: k for k, n in enumerate(demo.placed)}
    presses, num_released = [], 0
    for frame, word, fields in demo.events:
        if word == "release":
            n = demo.placed[num_released]
            if last[n] == num_released:
                placed.add(demo.ids[n])
            num_released += 1
        if word in ("trigger", "press"):
            control = fields[1] if word == "trigger" else fields[0]
            after = [k for k, step in enumerate(steps) if step.stays or step.name in placed]
            presses.append(press_at(demo, frame, control, after))
    for press in presses:
        press.changed &= place_of(press.control, presses)
    return presses


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


def press_at(demo, frame, control, after):
    """Returns the Press of a control at a frame of a demonstration."""
    later = read_picture(demo, frame)
    earlier = [it for it in range(int(frame)) if read_picture(demo, it) is not None]
    if later is None or not earlier:
        raise ValueError(f"no picture of the demonstration shows how {control} was pressed")
    before = read_picture(demo, earlier[-1])
    number = label_regions(np.abs(later - before).max(axis=2) > C.min_change)
    sizes = np.bincount(number.ravel())
    # Thin rims change where something still moves a little.
    changed = (number > 0) & (sizes[number] >= C.min_changed_pixels)
    if not changed.any():
        raise ValueError(f"no picture of the demonstration shows what the press of {control} changed")
    return Press(control, after, before, later, changed)
