"""Places steps by the objects that the demonstration did not move."""

import math
from dataclasses import replace

import numpy as np

from constants import BUILDING_SITE as C
from match.sites import NoSite, first_within_reach, site_cost
from things.areas import rotated
from things.blocks import has_equal_sides, yaw_difference
from things.kinds import is_in_place, is_same_kind
from things.standing import is_placed_by


def place_by_what_stays(steps, known, arms, eye):
    """Moves steps to where the objects that the demonstration did not move are seen here, in any
    rotation. If they are not seen in the same arrangement, each of them determines where the steps
    on it go. None if they are not seen, or the arms do not reach."""
    whole = first_within_reach(sites_by_anchor(steps, known, eye), arms)
    if whole:
        return whole
    moved = {}
    free = list(known)
    for group in groups_of(steps):
        placed = first_within_reach(sites_by_anchor([steps[k] for k in group], free, eye), arms)
        if not placed:
            return None
        moved.update(zip(group, placed))
        # Of objects that look alike, each carries one group.
        free = [it for it in free if not any(is_in_place(it, step) for step in placed if step.stays)]
    return [moved[k] for k in range(len(steps))]


def groups_of(steps):
    """Returns the numbers of the steps that stand on each other or are around each other, directly or not: a list of lists."""
    groups = []
    for k, step in enumerate(steps):
        below = [group for group in groups if any(is_placed_by(step, steps[j]) for j in group)]
        groups = [group for group in groups if group not in below]
        groups.append(sorted(sum(below, [k])))
    return groups


def sites_by_anchor(steps, known, eye):
    """Returns the sites at which known blocks are where steps stay: a list of cost and steps."""
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
    return sites


def turned_about(anchor, step, rotation, block):
    """Returns a step as it is when its anchor is where a block is, after a rotation [rad]."""
    away = rotated(step.position[:2] - anchor.position[:2], rotation)
    position = np.append(block.position[:2] + away, step.position[2])
    return replace(step, position=position, yaw=step.yaw + rotation)


def place_of_other(step, steps, known):
    """Moves a step that takes the place of another object to where that is now: the known block that looks like
    it and stands most nearly as high as it did."""
    other = next(it for it in steps if it.name == step.takes_place_of)
    found = [block for block in known if is_same_kind(block, other)]
    if not found:
        raise NoSite(f"no visible object looks like {other}, whose place {step.name} takes")
    block = min(found, key=lambda it: abs(it.position[2] - other.start[2]))
    return replace(step, position=np.append(block.position[:2], step.position[2]),
                   yaw=step.yaw + yaw_difference(step, block.yaw))
