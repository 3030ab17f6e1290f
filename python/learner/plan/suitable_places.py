"""Which places suit a block that is put down there for a while, and which arms can go on with it."""

from dataclasses import replace

from act.finger_room import grasp_yaws, is_grasp_blocked
from act.reach import reaching
from plan.obstruction import is_close
from see.sight import is_top_hidden
from things.standing import stands_on
from things.steps import is_dragged


def is_suitable(place, arms, onward, eye, others, site):
    """Returns true if a block at a place blocks nothing of a site and no grasp of others, but of those below it, is seen,
    and can be reached by one of the arms, and by one of those that bring it on, see onward_arms."""
    around = [it for it in others if not stands_on(place, it)]
    return not (is_grasp_blocked(place, site) or is_top_hidden(place, site, eye) or not reaching(arms, place)
                or not reaching(onward, place) or blocks_grasps(place, around))


def blocks_grasps(place, others):
    """Returns true if a block at a place would leave no room for the fingers at one of the others
    that can be grasped without it."""
    for block in (it for it in others if is_close(it, place)):
        rest = [it for it in others if it is not block]
        if grasp_yaws(block, rest) and not grasp_yaws(block, [*rest, place]):
            return True
    return False


def onward_arms(arms, block, goal):
    """Returns the arms that can bring a block to a goal from wherever it is put: those that surely reach it there; all if none
    does, if it is dragged there, or if there is no goal (None)."""
    if goal is None or is_dragged(goal):
        return arms
    return reaching(arms, replace(block, position=goal.position, yaw=goal.yaw)) or arms
