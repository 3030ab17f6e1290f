"""Chooses and plans presses of switches and buttons."""

from alignment import agreement
from arms import nearest_first
from clearance import grasp_yaws, with_held_parts
from constants import PRESSES as C
from execution import Action, Grasp
from motion_planning import at_height, has_failed, plan_path_through
from pressing import button_of, locate, looks_pressed
from surfaces import surface_of


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


def next_press(state):
    """Returns the first of the presses that are not done; None if there is none."""
    return next((it for it in state.presses if not it.done), None)


def choose_press(state, arms, picture, heights, eye, sensor):
    """Chooses the actions of the next press, if its time has come. Returns actions, and a reason if it is to be
    pressed and cannot be."""
    surface = surface_of(picture, heights, eye)
    press = next_press(state)
    while press and all(state.done[k] for k in press.after):
        where = state.alignments[press.control], surface, state.shown
        if looks_pressed(press, *where):
            press.done = True
            press = next_press(state)
            continue
        button = button_of(press, *where)
        if button is None or press.attempts >= C.max_attempts:
            return [], f"{press}: {press.attempts} attempts failed" if button else f"{press}: no button is visible"
        actions, state.grasp = plan_press(button, arms, with_held_parts(state.known), sensor, state.failures)
        press.attempts += 1
        return actions, None if actions else f"{press}: no arm reaches it"
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


def plan_press(button, arms, others, sensor, failures):
    """Plans to press a button with closed fingers from above. Returns actions and the Grasp that stands for the
    attempt, or [] and None if no arm can."""
    for arm in nearest_first(arms, button.position[0]):
        for across in grasp_yaws(button, others):
            attempt = Grasp(button.position, arm.index, across)
            if has_failed(attempt, failures):
                continue
            down = arm.tool_pose([*button.position[:2], button.bottom + C.depth + arm.reach], across)
            for height in C.heights:
                above = at_height(down, button.top + height + arm.reach)
                path = plan_path_through(arm, [above, down, above], others, sensor.arms[arm.index].joints)
                if path:
                    kinds = ["follow", "press", "follow", "follow"]
                    moves = [Action(kind, arm, it) for kind, it in zip(kinds, path)]
                    return [Action("open", arm, to=0), *moves, Action("observe")], attempt
    return [], None
