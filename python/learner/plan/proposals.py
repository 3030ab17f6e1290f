"""Proposes the moves that bring a step's block to its place."""

import numpy as np

from act.finger_room import grasp_yaws, is_grasp_blocked
from constants import PERCEPTION, TASK_PLANNING as C
from match.meant import fitting
from plan.free_places import is_near
from plan.moves import Move, distinct
from plan.obstruction import has_objects_on, is_obstructing
from relate.relations import is_beside
from things.kinds import is_same_kind, same_color
from things.resting import turns_between


def propose_moves(state, step, free):
    """Proposes the moves that may come next for a step, the best first: a list of Moves.

    free: the known blocks that are in no step's place
    """
    fits = fitting(state.meant, state.steps.index(step), [block for block in free if is_same_kind(block, step)])
    obstructing = [block for block in free if is_obstructing(block, step)]
    blocked = [block for block in free if will_be_blocked(block, free, state.steps) and not is_aside_for(state, step, block)]

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


def will_be_blocked(block, free, steps):
    """Returns true if a block lies where no fingers fit in once the steps are built: because of them alone, or of what
    touches it, too, although there is room now."""
    beside = [it for it in free if it is not block and is_beside(it, block)]
    return is_grasp_blocked(block, steps) or bool(grasp_yaws(block, beside)) and not grasp_yaws(block, beside + steps)


def is_aside_for(state, step, block):
    """Returns true if a block was put aside for a step: what it blocks there has to wait, as the step would
    otherwise."""
    return any(state.steps[k] is step and is_near(block, [place]) for k, place in state.asides)
