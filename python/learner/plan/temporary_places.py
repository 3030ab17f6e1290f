"""Plans to bring blocks to temporary places, on the table or, where that is full, on other blocks."""

from act.reach import can_reach
from constants import TASK_PLANNING as C
from plan.free_places import free_placements, is_near
from plan.pick_and_place import plan_pick_and_place
from plan.places_on_others import places_on_others
from plan.suitable_places import is_suitable


def plan_temporary_placement(arms, eye, block, others, sites, sensor, goal, failures, left,
                             unexplained):
    """Plans the actions that bring a block to a free place on the table or on another block, within the eye's view.

    others:   obstacles, as Blocks
    sites:    lists of blocks to keep clear of, existing or planned; the first list that leaves a
              place counts
    goal:     target to which an arm must be able to move it from there, or None
    failures: Grasps that are not to be repeated
    left:     places to which it does not return, as Blocks
    unexplained: as from unexplained_points
    Returns actions, the block at that place, and None; or [], None and a reason if there is none.
    """
    if not can_reach(arms, block):
        return [], None, "no arm reaches it"
    reason, tried = "there is no free place on the table", []
    for places, site in candidates(arms, eye, block, others, sites, goal, unexplained):
        num_tried = 0
        for place in places:
            has_yaw = [it for it in tried if it.yaw == place.yaw]
            if is_near(place, left + has_yaw) or not is_suitable(place, arms, eye, others, site):
                continue
            actions, why = plan_to_place(arms, block, place, others, sensor, goal, failures)
            if actions:
                return actions, place, None
            reason = why
            tried.append(place)
            num_tried += 1
            if num_tried == C.max_place_attempts:
                break
    return [], None, reason


def candidates(arms, eye, block, others, sites, goal, unexplained):
    """Yields places to which a block may be brought, a list, and of which site they keep clear: first those on the table,
    at last those on others."""
    for site in sites:
        yield free_placements(arms, eye, block, others + site, goal, unexplained), site
    yield places_on_others(block, others, sites[0], eye), sites[0]


def plan_to_place(arms, block, place, others, sensor, goal, failures):
    """Plans the actions that bring a block to a place from which an arm can move it to a goal, if there is one.
    Returns actions and None; or [] and the reason."""
    actions, reason = plan_pick_and_place(arms, block, place, others, sensor, failures)
    if not actions or goal is None:
        return actions, reason
    onward, reason = plan_pick_and_place(arms, place, goal, others, sensor)
    return actions if onward else [], reason
