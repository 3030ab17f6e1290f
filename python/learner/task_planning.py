"""Chooses the next actions from the demonstrated steps and the beliefs about the scene."""

import math
from dataclasses import dataclass, field, replace
from typing import Callable, NamedTuple, Optional

import numpy as np

from beliefs import assumed_support, update_beliefs
from blocks import Block, has_equal_sides, is_in_place, is_same_kind, yaw_difference
from building_site import choose_site
from clearance import (container_walls, footprint, grasp_yaws, gripper_clearance, is_grasp_blocked,
                       overlap)
from constants import CLEARANCE, MOTION_PLANNING, PERCEPTION, TASK_PLANNING as C, numbers_of
from detection import detect_blocks
from execution import Action, Grasp
from eye import height_map, to_pixel
from motion_planning import is_reachable, plan_pick_and_place
from sight import is_top_hidden
from task_model import Container, Step
from unknown_objects import detect_unknown_objects


class Claim(NamedTuple):
    """What the learner believes about its result."""

    done: bool  # whether everything is built
    reason: str  # how accurately, or why not: one line


@dataclass
class TaskState:
    """Progress and beliefs of the learner during a task."""

    steps: list  # of the demonstration; once a site is chosen, at their places in this scene
    container: Optional[Container] = None  # of some steps; once a site is chosen, in this scene
    has_site: bool = False
    known: list = field(default_factory=list)  # beliefs: Blocks at their last seen places
    unknown_objects: list = field(default_factory=list)  # appearances of blocks of no step; their
    #                                                      places are among the known
    done: list = field(init=False)  # whether each step's block is in its place
    attempts: list = field(init=False)  # number of times that each step's block was carried there
    num_temporary: int = 0  # number of blocks that were put at a temporary place so far
    placement_errors: dict = field(default_factory=dict)  # of a step's block: [units], [rad]
    num_blocked: int = 0  # number of successive steps for which no plan was found
    first_failure: str = ""  # why the first of them failed
    left: list = field(default_factory=list)  # Blocks at the places from which they were put aside
    grasp: Optional[Grasp] = None  # of the current actions; its block is the last of the known
    failures: list = field(default_factory=list)  # Grasps that failed, not to be repeated
    claim: Optional[Claim] = None  # about the result, at the end
    without: tuple = ()  # "depth", "second look": abilities that it does not use
    see: Optional[Callable] = None  # told what is seen: from sensor, eye and steps to Blocks

    def __post_init__(self):
        self.done = [False] * len(self.steps)
        self.attempts = [0] * len(self.steps)


class Move(NamedTuple):
    """A move that may come next."""

    block: Block  # a known one
    goal: Optional[Step] = None  # None: a temporary placement


def choose_actions(state, sensor, eye, arms):
    """Updates the beliefs from a picture and plans the next actions: a list; [] when everything is
    built or no plan is found (state.claim says which)."""
    picture = sensor.rgbVision / 255
    if not state.has_site or "second look" not in state.without:
        observe(state, sensor, picture, eye)
    if not state.has_site:
        problem = choose_site(state, arms, picture, eye)
        if problem:
            give_up(state, f"before it began: {problem}")
            return []

    used = assess_progress(state)
    steps = open_steps(state)
    if not steps:
        distance, angle = np.max(list(state.placement_errors.values()), axis=0)
        state.claim = Claim(True, "as seen within %.2f units and %.1f degrees" % (
            distance, math.degrees(angle)))
        return []

    # The next step in the demonstrated order; while that is blocked, one of the other open steps.
    k = steps[state.num_blocked % len(steps)]
    step = state.steps[k]
    reason = "no matching block is visible"
    if state.attempts[k] >= C.max_attempts:
        reason = f"{C.max_attempts} attempts failed"
    elif state.num_temporary >= C.max_temporary_placements:
        reason = f"blocks were put aside {C.max_temporary_placements} times already"
    else:
        free = [block for block in state.known if block not in used]
        moves = uncovering_moves(state, free, eye) + propose_moves(state, step, free)
        for move in moves + clearing_moves(state, moves, free):
            if num_failures(state, move.block) >= C.max_failed_grasps:
                reason = f"{C.max_failed_grasps} grasps of a block failed"
                continue
            actions, place, is_temporary, reason = plan_move(state, step, move, eye, arms, sensor)
            if not actions:
                continue
            if is_temporary:
                state.num_temporary += 1
                state.left.append(move.block)
            else:
                state.attempts[k] += 1
            state.known.remove(move.block)
            state.known.append(place)
            state.num_blocked = 0
            state.grasp = next(action.grasp for action in actions if action.kind == "grasp")
            return actions
    if state.num_blocked == 0:
        state.first_failure = f"{step}: {reason}"
    state.num_blocked += 1
    if state.num_blocked > len(steps) + 1:
        give_up(state, f"at {state.first_failure}")
        return []
    return [Action("observe")]


def observe(state, sensor, picture, eye):
    """Updates the known blocks from a picture."""
    heights = None if "depth" in state.without else height_map(sensor.depthVision, eye)
    if state.see:
        seen = state.see(sensor, eye, state.steps)
        state.known = update_beliefs(state.known, seen, picture, eye, heights)
        return
    # The place of the container is not known before a site is chosen.
    container = state.container if state.has_site else None
    seen = detect_blocks(picture, eye, state.steps + state.unknown_objects, container, heights)
    if not state.has_site or state.num_blocked > 0:
        state.unknown_objects += detect_unknown_objects(picture, eye, seen + state.known, heights)
        seen = detect_blocks(picture, eye, state.steps + state.unknown_objects, container, heights)
    state.known = update_beliefs(state.known, seen, picture, eye, heights)


def give_up(state, reason):
    """Ends the task unfinished, for a reason: one line."""
    state.claim = Claim(False, reason)


def remember_failure(state, actions):
    """Remembers that the first of the remaining actions failed: its grasp is not repeated. Unless
    the block was released already, it is not where it was to go."""
    if any(action.kind == "open" for action in actions[1:]):
        state.known.pop()
    state.failures.append(state.grasp)


def num_failures(state, block):
    """Returns the number of failed grasps of a block at its place."""
    return sum(np.linalg.norm(grasp.position - block.position) < MOTION_PLANNING.same_place_distance
               for grasp in state.failures)


def open_steps(state):
    """Returns the numbers of the steps that are not done and whose supports are done, in
    demonstrated order."""
    return [k for k, step in enumerate(state.steps)
            if not state.done[k] and all(state.done[lower] for lower in step.on)]


def assess_progress(state):
    """Compares the known blocks with the steps: updates state.done and state.placement_errors.
    Returns the blocks that are in the place of a step, a list."""
    used = []
    for k, step in enumerate(state.steps):
        state.done[k] = False
        for block in state.known:
            if block not in used and is_in_place(block, step):
                state.placement_errors[k] = (np.linalg.norm(block.position - step.position),
                                             abs(yaw_difference(step, block.yaw)))
                state.done[k] = True
                used.append(block)
                break
    return used


def propose_moves(state, step, free):
    """Proposes the moves that may come next for a step, the best first: a list of Moves.

    free: the known blocks that are in no step's place
    """
    fits = [block for block in free if is_same_kind(block, step)]
    obstructing = [block for block in free if is_obstructing(block, step)]
    blocked = [block for block in free if is_grasp_blocked(block, state.steps)]

    # First the blocks that later steps make hard to reach, and the closest matching ones.
    def distance(block):
        if block in obstructing + blocked:
            return 0
        return np.linalg.norm(block.position - step.position)

    fits.sort(key=distance)
    moves = [Move(block) for block in distinct(obstructing + blocked) if block not in fits]
    moves += [Move(block) for block in obstructing if block in fits[1:]]
    moves += [Move(block, step) for block in fits if not set(obstructing) - {block}]
    # Then the blocks that lie on others: a matching block may be below them.
    moves += [Move(block) for block in free if block.bottom > PERCEPTION.on_table]
    # A block with others on top has to wait.
    return [move for move in moves if not has_objects_on(move.block, free)]


def uncovering_moves(state, free, eye):
    """Returns the moves of blocks that lie on others which were never seen and which the building
    would hide, as long as blocks are missing: a list of Moves."""
    def is_missing(step):
        fits = [block for block in state.known if is_same_kind(block, step)]
        users = [it for it in state.steps if fits and is_same_kind(fits[0], it)]
        return len(fits) < len(users) or not fits

    if not any(map(is_missing, state.steps)):
        return []
    return [Move(block) for block in free
            if not has_objects_on(block, free) and not is_support_known(block, state.known)
            and any(is_top_hidden(it, state.steps, eye) for it in assumed_support(block))]


def clearing_moves(state, moves, free):
    """Returns the moves of blocks that leave no room for the fingers at the blocks of other moves:
    a list of Moves, first of those that are alone in the way, then of the closest."""
    alone, closest = [], []
    for block in distinct(move.block for move in moves):
        others = [it for it in state.known if it is not block]
        if grasp_yaws(block, others):
            continue
        beside = sorted((it for it in free if it is not block and is_close(it, block)
                         and not has_objects_on(it, free)),
                        key=lambda it: np.linalg.norm(it.position - block.position))
        closest += beside[:1]
        alone += [it for it in beside[:C.max_beside]
                  if grasp_yaws(block, [other for other in others if other is not it])]
    return [Move(block) for block in distinct(alone + closest)]


def is_close(block, place):
    """Returns true if a block is so close to a place that fingers may touch both."""
    distance = np.linalg.norm(block.position - place.position)
    return distance < C.near_distance + block.size[0] / 2


def is_support_known(block, known):
    """Returns true if a block lies on a known one."""
    below = [it for it in known if abs(it.top - block.bottom) < C.max_sinking]
    return overlap(footprint([block], 0)[0], footprint(below, 0)).any()


def is_obstructing(block, step):
    """Returns true if a block is in the place of a step, or where the fingers need room there."""
    [room] = gripper_clearance([step])
    return overlap(room, footprint([block], 0)).any()


def distinct(blocks):
    """Returns blocks without repetitions, a list."""
    return list(dict.fromkeys(blocks))


def has_objects_on(block, others):
    """Returns true if one of the others lies on a block."""
    higher = [it for it in others if it.bottom > block.top - C.max_sinking]
    [covered] = footprint([block], 0)
    return overlap(covered, footprint(higher, 0)).any()


def plan_move(state, step, move, eye, arms, sensor):
    """Plans one move: straight to its goal, if it has one and an arm reaches both places; otherwise
    to a temporary place, if necessary where a later step will be.

    Returns actions; the block where it will be, and whether that is a temporary place; and the
    reason if there are no actions.
    """
    others = [block for block in state.known if block is not move.block]
    others += assumed_support(move.block) + container_walls(state.container)
    container = [state.container] if state.container else []
    standing = [step for step, done in zip(state.steps, state.done) if done] + container
    sites = [state.steps + container]
    if move.goal:
        sites.append(standing)
        actions, reason = plan_pick_and_place(arms, move.block, move.goal, others, sensor,
                                              state.failures)
        if actions:
            place = replace(move.block, position=move.goal.position, yaw=move.goal.yaw)
            return actions, place, False, None
    elif is_obstructing(move.block, step):
        sites.append(standing + [step])
    left = []
    if not move.goal:
        left = [it for it in [*state.left, move.block] if is_same_kind(move.block, it)]
    actions, place, reason = plan_temporary_placement(arms, eye, move.block, others, sites, sensor,
                                                      move.goal, state.failures, left)
    return actions, place, True, reason


def plan_temporary_placement(arms, eye, block, others, sites, sensor, goal, failures, left):
    """Plans the actions that bring a block to a free place on the table, within the eye's view.

    others:   obstacles, as Blocks
    sites:    lists of blocks to keep clear of, existing or planned; the first list that leaves a
              place counts
    goal:     target to which an arm must be able to move it from there, or None
    failures: Grasps that are not to be repeated
    left:     places to which it does not return, as Blocks
    Returns actions, the block at that place, and None; or [], None and a reason if there is none.
    """
    if not can_reach(arms, block):
        return [], None, "no arm reaches it"
    reason = "there is no free place on the table"
    for site in sites:
        tried = []
        for place in free_placements(arms, block, others + site, goal):
            has_yaw = [it for it in tried if it.yaw == place.yaw]
            if (is_near(place, left + has_yaw) or not is_in_view(place, eye)
                    or is_grasp_blocked(place, site) or is_top_hidden(place, site, eye)
                    or blocks_grasps(place, others) or not can_reach(arms, place)):
                continue
            if goal is None or plan_pick_and_place(arms, place, goal, others, sensor)[0]:
                actions, reason = plan_pick_and_place(arms, block, place, others, sensor, failures)
                if actions:
                    return actions, place, None
            tried.append(place)
            if len(tried) == C.max_place_attempts:
                break
    return [], None, reason


def free_placements(arms, block, taken, goal):
    """Returns free places for a block on the table, a list of up to max_places, the best first:
    with room for its fingers and for those of its neighbors, and away from the feet of the arms."""
    yaw, y, x = (it.ravel() for it in np.meshgrid(
        [0, math.pi / 2, math.pi / 4, -math.pi / 4], numbers_of(*C.place_y),
        numbers_of(*C.place_x), indexing="ij"))
    sides = np.ones_like(x)[:, None] * (block.size[:2] + C.place_margin)
    covered = np.column_stack([x, y, sides, yaw])
    with_fingers = covered + [0, 0, 0, C.place_fingers, 0]
    free = np.ones(len(x), bool)
    for rectangle in footprint(taken, CLEARANCE.site_margin):
        free &= ~overlap(rectangle, with_fingers)
    # Square blocks can also be held across the other sides.
    for rectangle in gripper_clearance([it for it in taken if not has_equal_sides(it)]):
        free &= ~overlap(rectangle, covered)

    for arm in arms:
        free &= np.hypot(x - arm.foot[0], y - arm.foot[1]) > C.foot_distance

    if goal is None:
        # The middle, where both arms reach, is for handovers.
        cost = np.hypot(x - block.position[0], y - block.position[1])
        cost += np.maximum(C.handover_half_width - np.abs(x), 0)
    else:
        cost = np.abs(x) + C.handover_y_cost * np.abs(y - C.handover_y)
    num_places = min(C.max_places, free.sum())
    best = np.argsort(np.where(free, cost, np.inf), kind="stable")[:num_places]
    return [replace(block, position=np.array([x[i], y[i], block.size[2] / 2]), yaw=yaw[i])
            for i in best]


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


def can_reach(arms, place):
    """Returns true if one of the arms reaches a block's place."""
    return any(is_reachable(arm, place) for arm in arms)
