"""Chooses where the building goes in the scene."""

from dataclasses import replace

import numpy as np

from areas import rotated
from blocks import yaw_difference
from constants import BLOCKS, BUILDING_SITE as C, numbers_of
from containers import detect_container
from finger_room import grasp_yaws
from kinds import is_same_kind
from landmarks import place_by_what_stays, place_of_other, turned_about
from sites import NoSite, first_within_reach, site_cost
from steps import is_dragged
from walls import container_walls


def choose_site(state, arms, picture, eye):
    """Chooses the site of the building and moves the steps there: steps for a container to where it
    is detected, dragged steps to the detected object, others to the objects that the demonstration
    did not move, or to a free site on the table. If there is no such site, state.has_site stays
    false. Returns the reason, or None."""
    try:
        replacing = [step for step in state.steps if step.takes_place_of]
        carried = [step for step in state.steps if not is_dragged(step) and step not in replacing]
        if state.container:
            carried, state.container = place_in_container(carried, state.container, state.known,
                                                          picture, eye)
        elif carried:
            carried = (place_by_what_stays(carried, state.known, arms, eye)
                       or place_on_table(carried, state.known, arms, eye))
        carried = iter(carried)
        state.steps = [place_dragged(step, state.known) if is_dragged(step)
                       else place_of_other(step, state.steps, state.known) if step in replacing
                       else next(carried) for step in state.steps]
    except NoSite as problem:
        return str(problem)
    state.has_site = True
    return None


def place_dragged(step, known):
    """Moves a dragged step to the one known block that looks like it; rotates its displacement
    likewise."""
    found = [block for block in known if is_same_kind(block, step)]
    if len(found) != 1:
        raise NoSite(f"{len(found)} visible objects look like {step}")
    rotation = yaw_difference(step, found[0].yaw)
    displacement = rotated(step.displacement, rotation)
    return replace(step, displacement=displacement, yaw=step.yaw + rotation,
                   position=found[0].position + [*displacement, 0])


def place_in_container(steps, container, known, picture, eye):
    """Moves steps together with their container to where it is detected, or, where it is covered from
    the start, to where it must be below its cover. Returns both."""
    found, rotation = detect_container(picture, eye, container)
    if not found:
        found, rotation = below_cover(steps, container, known)
    if not found:
        raise NoSite(f"the container {container.name} is not visible")
    moved = []
    for step in steps:
        displacement = rotated(step.position[:2] - container.position[:2], rotation)
        position = np.append(found.position[:2] + displacement, step.position[2])
        step = replace(step, position=position, yaw=step.yaw + rotation)
        # What fingers cannot put there is dropped, and lies anywhere inside.
        if not grasp_yaws(step, container_walls(found)):
            step.tolerance = BLOCKS.confined_tolerance
        moved.append(step)
    return moved, found


def below_cover(steps, container, known):
    """Returns where a Container must be below a known block that is in its final place from the start,
    like a lid, and the rotation from the demonstration [rad]; None and 0 if there is none."""
    for step in [it for it in steps if it.begins_there]:
        for block in [it for it in known if is_same_kind(it, step)]:
            rotation = yaw_difference(step, block.yaw)
            return turned_about(step, container, rotation, block), rotation
    return None, 0


def place_on_table(steps, known, arms, eye):
    """Moves steps to the site with the lowest cost at which the nearest arm reaches each place."""
    demonstrated = np.array([step.position[:2] for step in steps])
    center = (demonstrated.min(axis=0) + demonstrated.max(axis=0)) / 2
    sites = []
    for y in numbers_of(*C.y):
        for x in numbers_of(*C.x):
            moved = shifted(steps, [x, y] - center)
            # Far from the robot the building occludes little; close to it the arms reach more.
            cost = C.far_cost * abs(y - C.best_y)
            cost += C.side_cost * abs(x) + site_cost(moved, known, eye)
            sites.append((cost, moved))
    moved = first_within_reach(sites, arms)
    if not moved:
        raise NoSite("the building is not within reach anywhere on the table")
    return moved


def shifted(steps, displacement):
    """Returns the steps displaced by x, y [units]."""
    return [replace(step, position=step.position + [*displacement, 0]) for step in steps]
