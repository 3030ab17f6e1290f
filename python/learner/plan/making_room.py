"""Makes room on the table: if no place is free for a block, others are put aside first."""

from constants import TASK_PLANNING as C
from plan.free_places import free_placements, is_free, is_near
from plan.moves import Move
from plan.obstruction import has_objects_on
from plan.suitable_places import is_suitable
from plan.temporary_places import plan_to_place
from things.areas import footprint
from things.held_parts import with_held_parts
from things.supports import assumed_support


def room_moves(state, step, moves, free, arms, eye, sensor):
    """Returns the moves that make room for the blocks of other moves, which have no free place on the table: a list
    of Moves, for the first of those blocks for which some make it. As few as possible are put aside.

    step: the next one
    free: the known blocks that are in no step's place
    """
    standing = [*(it for it, done in zip(state.steps, state.done) if done), *state.containers]
    for move in [it for it in moves if not it.turns]:
        movable = [it for it in free if it is not move.block and not has_objects_on(it, free)]
        for site in ([*state.steps, *state.containers], standing + [step]):
            place, blocks = room_for(state, move, movable, site, arms, eye, sensor)
            if blocks:
                return [Move(it, room=place) for it in blocks]
    return []


def room_for(state, move, movable, site, arms, eye, sensor):
    """Returns a place for the block of a move on the table, and those of some movable blocks that are in its way, a
    list; None and [] if there is none.

    site: blocks to keep clear of, existing or planned
    """
    block = move.block
    fixed = [it for it in state.known if it is not block and it not in movable] + assumed_support(block)
    left = [] if move.goal else [*state.left, block]
    candidates = free_placements(arms, eye, block, fixed + site, move.goal, state.unexplained)
    covered = footprint(candidates, C.place_margin / 2)
    is_clear = [is_free(covered, [it]) for it in movable]
    places = []
    for i, place in enumerate(candidates):
        in_way = [it for it, clear in zip(movable, is_clear) if not clear[i]]
        if in_way and len(in_way) <= C.max_put_aside and not is_near(place, left):
            places.append((place, in_way))
    num_tried = 0
    for place, in_way in sorted(places, key=lambda it: len(it[1])):
        others = with_held_parts(fixed + [it for it in movable if it not in in_way])
        if not is_suitable(place, arms, eye, others, site):
            continue
        if plan_to_place(arms, block, place, others, sensor, move.goal, state.failures)[0]:
            return place, in_way
        num_tried += 1
        if num_tried == C.max_place_attempts:
            break
    return None, []
