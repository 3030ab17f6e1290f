"""Chooses where the building goes in the scene."""

from dataclasses import replace

import numpy as np

from constants import BUILDING_SITE as C, numbers_of
from match.anchored_places import place_at_anchor
from match.found_places import place_dragged, place_in_containers
from match.landmarks import place_by_what_stays, place_of_other
from match.meant import meant_blocks
from match.returning import place_below, place_returning
from match.sites import NoSite, first_within_reach, site_cost
from see.framing import is_on_table
from things.steps import is_dragged


def choose_site(state, arms, picture, eye):
    """Chooses the site of the building and moves the steps there: steps for a container to where it
    is detected, dragged steps to the detected object, steps with an anchor to their place beside it,
    others to the objects that the demonstration did not move, or to a free site on the table. If there
    is no such site, state.has_site stays false. Returns the reason, or None."""
    try:
        replacing = [step for step in state.steps if step.takes_place_of]
        returning = {step.name: place_returning(step, state) for step in state.steps if step.aside}
        carried = [step for step in state.steps
                   if not is_dragged(step) and step not in replacing and not step.aside]
        if state.containers:
            carried, state.containers = place_in_containers(carried, state.containers, state.known, picture, eye)
        elif carried and carried[0].anchor:
            carried = place_at_anchor(carried, state.known, arms, eye)
        elif carried:
            carried = (place_by_what_stays(carried, state.known, arms, eye)
                       or place_on_table(carried, state.known, arms, eye))
        carried = iter(carried)
        shown, back = [it for it in state.steps if it.aside], list(returning.values())
        state.steps = [place_dragged(step, state.known) if is_dragged(step)
                       else place_below(step, shown, back) or place_of_other(step, state.steps, state.known)
                       if step in replacing
                       else returning[step.name] if step.aside else next(carried) for step in state.steps]
    except NoSite as problem:
        return str(problem)
    state.has_site = True
    state.meant = meant_blocks(state.steps, state.known)
    return None


def place_on_table(steps, known, arms, eye):
    """Moves steps to the site with the lowest cost at which the nearest arm reaches each place."""
    for depths in (C.depth, C.near_depth):
        moved = first_within_reach(sites_at(steps, numbers_of(*depths), known, eye), arms, all_carried=True)
        if moved:
            return moved
    raise NoSite("the building is not within reach anywhere on the table")


def sites_at(steps, depths, known, eye):
    """Returns sites on the table, cost and steps of each, at some distances from its near edge [units]."""
    demonstrated = np.array([step.position[:2] for step in steps])
    center = (demonstrated.min(axis=0) + demonstrated.max(axis=0)) / 2
    sites = []
    for depth in depths:
        for x in numbers_of(*C.x):
            moved = shifted(steps, [x, eye.near_edge + depth] - center)
            # Far from the robot the building occludes little; close to it the arms reach more.
            cost = C.far_cost * abs(depth - C.best_depth)
            cost += C.side_cost * abs(x) + site_cost(moved, known, eye)
            if all(is_on_table(step, eye) for step in moved):
                sites.append((cost, moved))
    return sites


def shifted(steps, displacement):
    """Returns the steps displaced by x, y [units]."""
    return [replace(step, position=step.position + [*displacement, 0]) for step in steps]
