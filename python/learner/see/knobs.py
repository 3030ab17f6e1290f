"""Knobs: parts on the tops of objects, by which these are held, like that of a lid.

A knob is a Block in the frame of the object: its position is that of its middle from the object's, turned back
by the object's yaw.
"""

from dataclasses import replace

import numpy as np

from see.unknown_objects import detect_unknown_objects
from things.areas import rotated
from things.kinds import is_same_kind
from things.standing import stands_on


def find_knobs(steps, seen, picture, eye, heights):
    """Finds the knobs of seen blocks whose steps have one: adds them to the steps and the blocks."""
    for step in [it for it in steps if it.has_knob and it.knob is None]:
        for block in [it for it in seen if is_same_kind(it, step)]:
            others = detect_unknown_objects(picture, eye, seen, heights)
            on_it = [it for it in others if stands_on(it, block)]
            if on_it:
                step.knob = in_frame_of(block, on_it[0])
    add_knobs(steps, seen)


def add_knobs(steps, seen):
    """Adds the knobs that are known to seen blocks."""
    for step in steps:
        for block in [it for it in seen if step.knob and is_same_kind(it, step)]:
            block.knob = step.knob


def in_frame_of(block, part):
    """Returns a part of a block in the frame of the block."""
    away = part.position - block.position
    return replace(part, position=np.append(rotated(away[:2], -block.yaw), away[2]),
                   yaw=part.yaw - block.yaw)
