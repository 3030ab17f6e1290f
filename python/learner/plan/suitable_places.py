"""Which places suit a block that is put down there for a while."""

from act.finger_room import grasp_yaws, is_grasp_blocked
from act.reach import can_reach
from plan.obstruction import is_close
from see.sight import is_top_hidden
from things.standing import stands_on


def is_suitable(place, arms, eye, others, site):
    """Returns true if a block at a place blocks nothing of a site and no grasp of others, but of those below it, is seen,
    and can be taken again."""
    around = [it for it in others if not stands_on(place, it)]
    return not (is_grasp_blocked(place, site) or is_top_hidden(place, site, eye) or not can_reach(arms, place)
                or blocks_grasps(place, around))


def blocks_grasps(place, others):
    """Returns true if a block at a place would leave no room for the fingers at one of the others
    that can be grasped without it."""
    for block in (it for it in others if is_close(it, place)):
        rest = [it for it in others if it is not block]
        if grasp_yaws(block, rest) and not grasp_yaws(block, [*rest, place]):
            return True
    return False
