"""Proposes moves that uncover blocks, and that clear room for the hand."""

import numpy as np

from act.finger_room import grasp_yaws
from act.pushing_hands import room_to_push, way_to_push
from constants import TASK_PLANNING as C
from plan.moves import Move, distinct
from plan.obstruction import has_objects_on, is_close, is_support_known
from see.sight import is_top_hidden
from things.areas import container_at
from things.kinds import is_same_kind
from things.supports import assumed_support


def uncovering_moves(state, free, eye):
    """Returns the moves of blocks that lie on others which were never seen and which the building
    would hide, as long as blocks are missing: a list of Moves."""
    def is_missing(step):
        fits = [block for block in state.known if is_same_kind(block, step)]
        users = [it for it in state.steps if fits and is_same_kind(fits[0], it)]
        return len(fits) < len(users) or not fits

    moves = [Move(block) for block in free for support in assumed_support(block)
             if not has_objects_on(block, free) and not is_support_known(block, state.known)
             and is_top_hidden(support, state.steps, eye)]
    return moves if moves and any(map(is_missing, state.steps)) else []


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


def moves_from_place(step, free):
    """Returns the moves of blocks each of which leaves no room for the hand at the place of a step, though it may be higher
    than the fingers there: a list of Moves, of the closest first."""
    in_way = [it for it in free if is_close(it, step) and not has_objects_on(it, free) and not grasp_yaws(step, [it])]
    in_way.sort(key=lambda it: np.linalg.norm(it.position - step.position))
    return [Move(it) for it in in_way if not is_same_kind(it, step)]


def moves_from_push(state, step, free, arms):
    """Returns the moves of blocks each of which, alone, keeps an arm from pushing another one to the place of a step, where what
    is built leaves no room for fingers: a list of Moves.

    free: the known blocks that are in no step's place
    """
    built = [it for it in state.known if it not in free]
    # What goes into a container is never pushed there.
    if grasp_yaws(step, built) or container_at(state.containers, step.position):
        return []
    fits = [it for it in free if is_same_kind(it, step)]
    near = [it for it in free if is_close(it, step)]
    moves = []
    # Blocks far away obstruct nothing, so one of them stands for all.
    for pushed in [it for it in fits if it in near] + [it for it in fits if it not in near][:1]:
        around = [it for it in near if it is not pushed]
        if way_to_push(arms, step, built + around):
            return []
        in_way = [it for it in around if not has_objects_on(it, free)]
        ways = [way_to_push(arms, step, built + [other for other in around if other is not it]) for it in in_way]
        moves += [Move(it, room=room_to_push(arms, way)) for it, way in zip(in_way, ways) if way]
    return moves
