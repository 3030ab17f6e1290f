"""Chooses where the building goes in the scene."""

import math
from dataclasses import replace

import numpy as np

from arms import nearest_first
from beliefs import assumed_support
from blocks import has_equal_sides, is_in_place, is_same_kind, yaw_difference
from clearance import is_grasp_blocked
from constants import BUILDING_SITE as C, numbers_of
from containers import detect_container
from motion_planning import is_reachable
from sight import is_top_hidden
from steps import is_dragged


def choose_site(state, arms, picture, eye):
    """Chooses the site of the building and moves the steps there: steps for a container to where it
    is detected, dragged steps to the detected object, others to the objects that the demonstration
    did not move, or to a free site on the table. If there is no such site, state.has_site stays
    false. Returns the reason, or None."""
    try:
        carried = [step for step in state.steps if not is_dragged(step)]
        if state.container:
            carried, state.container = place_in_container(carried, state.container, picture, eye)
        elif carried:
            carried = (place_by_what_stays(carried, state.known, arms, eye)
                       or place_on_table(carried, state.known, arms, eye))
        carried = iter(carried)
        state.steps = [place_dragged(step, state.known) if is_dragged(step)
                       else next(carried) for step in state.steps]
    except NoSite as problem:
        return str(problem)
    state.has_site = True
    return None


class NoSite(Exception):
    """No site was found for the building."""


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


def place_in_container(steps, container, picture, eye):
    """Moves steps together with their container to where it is detected. Returns both."""
    found, rotation = detect_container(picture, eye, container)
    if not found:
        raise NoSite(f"the container {container.name} is not visible")
    moved = []
    for step in steps:
        displacement = rotated(step.position[:2] - container.position[:2], rotation)
        position = np.append(found.position[:2] + displacement, step.position[2])
        moved.append(replace(step, position=position, yaw=step.yaw + rotation))
    return moved, found


def rotated(v, angle):
    """Returns a vector, x y, rotated by an angle [rad]."""
    c, s = math.cos(angle), math.sin(angle)
    return np.array([v[0] * c - v[1] * s, v[0] * s + v[1] * c])


def place_by_what_stays(steps, known, arms, eye):
    """Moves steps to where the objects that the demonstration did not move are seen here, in any
    rotation. None if they are not seen in the same arrangement, or the arms do not reach."""
    anchor = next((step for step in steps if step.stays), None)
    sites = []
    for block in known if anchor else []:
        if not is_same_kind(block, anchor):
            continue
        turns = np.array([0, 1, -1, 2] if has_equal_sides(anchor) else [0, 2]) * math.pi / 2
        for rotation in yaw_difference(anchor, block.yaw) + turns:
            moved = [turned_about(anchor, step, rotation, block) for step in steps]
            stays = [step for step in moved if step.stays]
            if all(any(is_in_place(it, step) for it in known) for step in stays):
                rest = [it for it in known if not any(is_in_place(it, step) for step in stays)]
                cost = C.rotated_cost * abs(rotation) + site_cost(moved, rest, eye)
                sites.append((cost, moved))
    return first_within_reach(sites, arms)


def turned_about(anchor, step, rotation, block):
    """Returns a step as it is when its anchor is where a block is, after a rotation [rad]."""
    away = rotated(step.position[:2] - anchor.position[:2], rotation)
    position = np.append(block.position[:2] + away, step.position[2])
    return replace(step, position=position, yaw=step.yaw + rotation)


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


def site_cost(steps, known, eye):
    """Returns the cost of a site: the lengths of the blocks that are in the way there or would be
    blocked by the building; a part of those of needed blocks that it would hide; and those of
    blocks on others that may be needed and were never seen, if it would hide them."""
    cost = 0
    for block in known:
        if is_grasp_blocked(block, steps):
            cost += block.size[0]
        elif (any(is_same_kind(block, step) for step in steps)
              and is_top_hidden(block, steps, eye)):
            cost += C.hidden_cost * block.size[0]
        if any(is_top_hidden(it, steps, eye) for it in assumed_support(block)):
            cost += block.size[0]
    return cost


def first_within_reach(sites, arms):
    """Returns the steps of the cheapest site at which the nearest arm reaches each place to which
    something goes; None if there is none.

    sites: cost and steps of each
    """
    for _, steps in sorted(sites, key=lambda site: site[0]):
        if all(step.stays or is_reachable(nearest_first(arms, step.position[0])[0], step)
               for step in steps):
            return steps
    return None


def shifted(steps, displacement):
    """Returns the steps displaced by x, y [units]."""
    return [replace(step, position=step.position + [*displacement, 0]) for step in steps]
