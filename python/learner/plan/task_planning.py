"""Chooses the next actions from the demonstrated steps and the beliefs about the scene."""

import math

import numpy as np

from act.actions import Action
from check.claims import Claim, give_up
from check.looking import is_moving, observe
from check.notes import plan_notes
from check.progress import assess_progress, open_steps
from match.building_site import choose_site
from match.returning import locate_asides
from plan.device_planning import choose_device, forget_fixtures, locate_controls
from plan.drive_planning import is_driver
from plan.own_arms import forget_arm
from plan.step_choice import plan_one_of
from see.eye import height_map
from see.surfaces import surface_of


def choose_actions(state, sensor, eye, arms):
    """Updates the beliefs from a picture and plans the next actions: a list; [] when everything is
    built or no plan is found (state.claim says which)."""
    picture = sensor.rgbVision / 255
    if state.presses and not state.has_site and is_moving(state, picture):
        return [Action("observe")]
    if not state.has_site or "second look" not in state.without:
        observe(state, sensor, picture, eye)
        if len(sensor.arms) == 1:
            forget_arm(state, arms[0], sensor)
    has_asides = any(it.aside for it in state.steps)
    heights = height_map(sensor.depthVision, eye) if state.presses or has_asides else None
    state.surface = surface_of(picture, heights, eye) if has_asides else None
    if not state.has_site:
        problem = (locate_controls(state, picture, heights, eye) or locate_asides(state, picture, heights, eye)
                   or choose_site(state, arms, picture, eye))
        if problem:
            give_up(state, f"before it began: {problem}")
            return []
        state.notes += plan_notes(state.steps)

    if state.presses:
        forget_fixtures(state, picture, heights, eye)
    used = assess_progress(state)
    if state.presses:
        actions, reason = choose_device(state, arms, picture, heights, eye, sensor)
        if reason:
            give_up(state, f"at the {reason}")
        if actions or reason:
            return actions
    steps = open_steps(state)
    if not steps and state.unclear:
        give_up(state, f"not understood in the demonstration: {', '.join(state.unclear)}")
        return []
    if not steps:
        distance, angle = np.max([(0, 0), *state.placement_errors.values()], axis=0)
        state.claim = Claim(True, f"as seen within {distance:.2f} units and {math.degrees(angle):.1f} degrees")
        return []
    free = [block for block in state.known if block not in used and not is_driver(block, state)]
    return plan_one_of(steps, state, free, eye, arms, sensor)
