"""Chooses the next press of a button or use of a tool."""

from constants import PRESSES as C
from explain.drives import Drive
from match.alignment import agreement
from match.controls import locate
from match.pressing import looks_pressed
from plan.drive_planning import plan_drive, was_driven
from plan.press_planning import plan_press
from plan.use_planning import plan_use
from see.surfaces import surface_of


def locate_controls(state, picture, heights, eye):
    """Finds where the controls of the demonstration are in the scene. Returns a reason if one is not there, or
    None."""
    for press in state.presses:
        if press.control not in state.alignments:
            found = locate(press, picture, heights, eye, state.shown)
            if found is None:
                return f"the surroundings of {press.control} are not visible"
            state.alignments[press.control] = found
    return None


def next_device(state):
    """Returns the first of the presses and uses that are not done; None if there is none."""
    return next((it for it in state.presses if not it.done), None)


def choose_device(state, arms, picture, heights, eye, sensor):
    """Chooses the actions of the next press or use, if its time has come. Returns actions, and a reason if it is to
    be done and cannot be."""
    surface = surface_of(picture, heights, eye)
    press = next_device(state)
    while press and all(state.done[k] for k in press.after):
        where = state.alignments[press.control], surface, state.shown
        is_drive = isinstance(press, Drive)
        if was_driven(press, state) if is_drive else looks_pressed(press, *where):
            press.done = True
            press = next_device(state)
            continue
        if press.attempts >= C.max_attempts:
            return [], f"{press}: {press.attempts} attempts failed"
        plan = plan_drive if is_drive else plan_use if press.tool else plan_press
        actions, state.grasp, reason = plan(press, *where[:2], state, arms, sensor)
        press.grasp = state.grasp
        press.attempts += 1
        return actions, f"{press}: {reason}" if reason else None
    return [], None


def forget_fixtures(state, picture, heights, eye):
    """Forgets unknown objects around controls that the demonstration shows at the same places: they are parts of
    what the controls belong to, like another switch, and not to be moved."""
    surface = surface_of(picture, heights, eye)
    for press in state.presses:
        alignment = state.alignments[press.control]
        for block in list(state.known):
            kinds = [it for it in state.unknown_objects if it.size is block.size]
            around = surface.around(block.position, block.size[:2].min() / 2, C.num_points)
            if kinds and agreement(around, alignment, press.before, state.shown) > C.min_agreement:
                state.known.remove(block)
