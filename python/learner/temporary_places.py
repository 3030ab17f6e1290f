"""Brings blocks to temporary places on the table."""

import math
from dataclasses import replace
from itertools import islice

import numpy as np

from areas import footprint, overlap
from blocks import has_equal_sides
from constants import CLEARANCE, TASK_PLANNING as C, numbers_of
from eye import to_pixel
from finger_room import grasp_yaws, gripper_clearance, is_grasp_blocked
from obstruction import is_close
from pick_and_place import plan_pick_and_place
from reach import can_reach
from sight import is_top_hidden
from unexplained import is_unexplained


def plan_temporary_placement(arms, eye, block, others, sites, sensor, goal, failures, left,
                             unexplained):
    """Plans the actions that bring a block to a free place on the table, within the eye's view.

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
    reason = "there is no free place on the table"
    for site in sites:
        tried = []
        for place in free_placements(arms, eye, block, others + site, goal, unexplained):
            has_yaw = [it for it in tried if it.yaw == place.yaw]
            if is_near(place, left + has_yaw) or not is_suitable(place, arms, eye, others, site):
                continue
            actions, why = plan_to_place(arms, block, place, others, sensor, goal, failures)
            if actions:
                return actions, place, None
            reason = why or reason
            tried.append(place)
            if len(tried) == C.max_place_attempts:
                break
    return [], None, reason


def is_suitable(place, arms, eye, others, site):
    """Returns true if a block at a place blocks nothing of a site and no grasp of others, is seen, and can be taken
    again."""
    return not (is_grasp_blocked(place, site) or is_top_hidden(place, site, eye) or blocks_grasps(place, others)
                or not can_reach(arms, place))


def plan_to_place(arms, block, place, others, sensor, goal, failures):
    """Plans the actions that bring a block to a place from which an arm can move it to a goal, if there is one.
    Returns actions and None; or [], and the reason if it can only be moved on from there."""
    if goal is not None and not plan_pick_and_place(arms, place, goal, others, sensor)[0]:
        return [], None
    return plan_pick_and_place(arms, block, place, others, sensor, failures)


def free_placements(arms, eye, block, taken, goal, unexplained=()):
    """Returns free places for a block on the table, within the eye's view, a list of up to
    max_places, the best first: with room for its fingers and for those of its neighbors, and away
    from the feet of the arms."""
    yaw, y, x = (it.ravel() for it in np.meshgrid(
        [0, math.pi / 2, math.pi / 4, -math.pi / 4], numbers_of(*C.place_y),
        numbers_of(*C.place_x), indexing="ij"))
    sides = np.ones_like(x)[:, None] * (block.size[:2] + C.place_margin)
    covered = np.column_stack([x, y, sides, yaw])
    free = is_free(covered, taken)
    for arm in arms:
        free &= np.hypot(x - arm.foot[0], y - arm.foot[1]) > C.foot_distance
    free[free] = ~is_unexplained(covered[free], unexplained)

    if goal is None:
        # The middle, where both arms reach, is for handovers.
        cost = np.hypot(x - block.position[0], y - block.position[1])
        cost += np.maximum(C.handover_half_width - np.abs(x), 0)
    else:
        cost = np.abs(x) + C.handover_y_cost * np.abs(y - C.handover_y)
    best = np.argsort(np.where(free, cost, np.inf), kind="stable")[:free.sum()]
    places = (replace(block, position=np.array([x[i], y[i], block.size[2] / 2]), yaw=yaw[i])
              for i in best)
    return list(islice((it for it in places if is_in_view(it, eye)), C.max_places))


def is_free(covered, taken):
    """Returns which of N areas, Nx5, have room between some blocks, with the fingers of both: N bool."""
    with_fingers = covered + [0, 0, 0, C.place_fingers, 0]
    free = np.ones(len(covered), bool)
    for rectangle in footprint(taken, CLEARANCE.site_margin):
        free &= ~overlap(rectangle, with_fingers)
    # Square blocks can also be held across the other sides.
    for rectangle in gripper_clearance([it for it in taken if not has_equal_sides(it)]):
        free &= ~overlap(rectangle, covered)
    return free


def is_near(place, left):
    """Returns true if a place is close to one of some others."""
    return any(np.linalg.norm(it.position - place.position) < C.near_place_distance for it in left)


def blocks_grasps(place, others):
    """Returns true if a block at a place would leave no room for the fingers at one of the others
    that can be grasped without it."""
    for block in (it for it in others if is_close(it, place)):
        rest = [it for it in others if it is not block]
        if grasp_yaws(block, rest) and not grasp_yaws(block, [*rest, place]):
            return True
    return False


def is_in_view(place, eye):
    """Returns true if the whole top of a block at a place is in the eye's picture."""
    along = place.size[0] / 2 * np.array([math.cos(place.yaw), math.sin(place.yaw), 0])
    across = place.size[1] / 2 * np.array([-math.sin(place.yaw), math.cos(place.yaw), 0])
    middle = np.array([*place.position[:2], place.size[2]])
    corners = [middle + a * along + b * across for a in (1, -1) for b in (1, -1)]
    pixels = np.array([to_pixel(corner, eye) for corner in corners])
    margin = C.picture_margin_pixels
    return ((pixels > margin) & (pixels < 2 * eye.intrinsics[:2, 2] - margin)).all()
