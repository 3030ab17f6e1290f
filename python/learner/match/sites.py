"""Sites of a building: what they cost, and whether the arms reach them."""

from act.finger_room import grasp_yaws, is_grasp_blocked
from act.grippers import nearest_first
from act.push_ways import push_ways
from act.pushing_hands import way_to_push
from act.reach import is_reachable
from constants import BUILDING_SITE as C
from see.sight import is_top_hidden
from things.kinds import is_same_kind
from things.supports import assumed_support


class NoSite(Exception):
    """No site was found for the building."""


def site_cost(steps, known, eye):
    """Returns the cost of a site: the lengths of the blocks that are in the way there or would be
    blocked by the building; a part of those of needed blocks that it would hide; and those of
    blocks on others that may be needed and were never seen, if it would hide them."""
    cost = 0
    for block in known:
        if is_grasp_blocked(block, steps):
            cost += block.size[0]
        elif is_top_hidden(block, steps, eye) and any(is_same_kind(block, step) for step in steps):
            cost += C.hidden_cost * block.size[0]
        if any(is_top_hidden(it, steps, eye) for it in assumed_support(block)):
            cost += block.size[0]
    return cost


def first_within_reach(sites, arms, all_carried=False):
    """Returns the steps of the cheapest site at which the nearest arm reaches each place to which
    something goes; None if there is none.

    sites:       cost and steps of each
    all_carried: whether what stayed in the demonstration has to be carried there, too
    """
    for _, steps in sorted(sites, key=lambda site: site[0]):
        if all(step.stays and not all_carried or is_reachable(nearest_first(arms, step.position[0])[0], step)
               for step in steps) and can_all_be_pushed(steps, arms):
            return steps
    return None


def can_all_be_pushed(steps, arms):
    """Returns true if the arms can push each of some steps to its place where those before leave no room for fingers, as far as
    there is a way to push it."""
    return all(way_to_push(arms, step, steps[:k]) for k, step in enumerate(steps)
               if not step.stays and not grasp_yaws(step, steps[:k]) and push_ways(step, step, steps[:k]))
