"""Places the steps of things that come back, like a cover, and what was hidden by them."""

import math
from dataclasses import replace

import numpy as np

from match.controls import locate
from match.landmarks import turned_about
from match.sites import NoSite
from things.areas import rotated
from things.kinds import is_same_kind


def place_returning(step, state):
    """Moves a step that comes back to where its block is now, and its Aside to what the scene shows of it there.
    A top that looks the same after half a turn is turned as the Alignments tell."""
    found = [block for block in state.known if is_same_kind(block, step)]
    if not found:
        raise NoSite(f"{step.name} is not visible")
    block = min(found, key=lambda it: abs(it.position[2] - step.position[2]))
    alignment = state.alignments[step.name]
    turn = -alignment.angle
    place = step.aside.place
    position = np.append(rotated(place.position[:2] - alignment.place, turn), place.position[2])
    aside = replace(step.aside, place=replace(place, position=position, yaw=place.yaw + turn))
    drives = [it for it in state.presses if it.control in state.alignments]
    angle = -state.alignments[drives[0].control].angle if drives else 0
    return replace(step, position=block.position, yaw=directed(block, step.yaw + angle), aside=aside)


def locate_asides(state, picture, heights, eye):
    """Finds where the Asides of the demonstration are in the scene. Returns a reason if one is not there, or None."""
    for step in [it for it in state.steps if it.aside]:
        found = locate(step.aside, picture, heights, eye, state.shown)
        if found is None:
            return f"the place for {step.name} is not visible"
        state.alignments[step.name] = found
    return None


def place_below(step, shown, steps):
    """Moves a step to where it must be below one of some steps that come back; shown: those as demonstrated. None if
    there is none."""
    for demonstrated, it in zip(shown, steps):
        away = np.hypot(*(step.position - demonstrated.position)[:2])
        if demonstrated.aside and away < max(demonstrated.size[:2]) / 2:
            return turned_about(demonstrated, step, it.yaw - demonstrated.yaw, it)
    return None


def directed(block, yaw):
    """Returns the yaw of a block, of the two with which it looks the same that which is nearer to another [rad]."""
    return block.yaw + math.pi * round((yaw - block.yaw) / math.pi)
