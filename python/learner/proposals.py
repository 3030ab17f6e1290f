"""Proposes the moves that may come next."""

from typing import NamedTuple, Optional

import numpy as np

from areas import footprint, overlap
from beliefs import assumed_support
from blocks import Block
from constants import PERCEPTION, TASK_PLANNING as C
from finger_room import grasp_yaws, gripper_clearance, is_grasp_blocked
from kinds import is_same_kind, same_color
from resting import turns_between
from sight import is_top_hidden
from steps import Step


class Move(NamedTuple):
    """A move that may come next."""

    block: Block  # a known one
    goal: Optional[Step] = None  # None: a temporary placement
    turns: tuple = ()  # how it has to be turned there, and again after that: as turns_between
    room: Optional[Block] = None  # another block, at the place that this move makes free for it


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
            return 0, 0
        # A thing of several colors is first taken from where it stood as high as in the demonstration.
        is_elsewhere = bool(step.parts) and abs(block.position[2] - step.start[2]) > C.max_sinking
        return is_elsewhere, np.linalg.norm(block.position - step.position)

    fits.sort(key=distance)
    moves = [Move(block) for block in distinct(obstructing + blocked) if block not in fits]
    moves += [Move(block) for block in obstructing if block in fits[1:]]
    moves += [Move(block, step) for block in fits if not set(obstructing) - {block}]
    # Then the blocks that lie on others: a matching block may be below them.
    moves += [Move(block) for block in free if block.bottom > PERCEPTION.on_table]
    # A block with others on top has to wait.
    return [move for move in moves if not has_objects_on(move.block, free)]


def turning_moves(step, free, opening):
    """Returns the moves that turn a block onto another face, if none looks as a step wants it: a list of
    Moves, first of those that need the fewest turns. Where it cannot be turned, it is put elsewhere.

    opening: of the widest gripper [units]
    """
    if step.start_size is None or any(is_same_kind(it, step) for it in free):
        return []
    moves = []
    for block in free:
        if block.is_round or not same_color(step.color, block.color) or has_objects_on(block, free):
            continue
        turns = turns_between(block.size, step.size, opening)
        moves += [Move(block, turns=tuple(turns))] if turns else []
    moves.sort(key=lambda move: len(move.turns))
    return moves + [Move(move.block) for move in moves]


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
