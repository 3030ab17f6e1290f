"""Plans how a block comes to its goal: carried, pushed, or dropped into a container."""

from dataclasses import replace

import numpy as np

from act.finger_room import grasp_yaws
from plan.finger_depths import with_depth
from plan.pick_and_place import plan_pick_and_place
from plan.pushing import pushes_to
from things.areas import container_at


def plan_to_goal(state, move, others, arms, sensor):
    """Plans to bring a block to the goal of its move, or, where what it touches there leaves no room for fingers, to push it
    there, or to bring it to where it can be pushed from.

    Returns actions; the block where it will be, and why there if that is not the goal, else ""; and to where an arm would
    have to bring it.
    """
    goal, why = move.goal, ""
    if not grasp_yaws(goal, others):
        # Where the fingers have no room in a container, it is released above the rim.
        container = container_at(state.containers, goal.position)
        pushed, starts = ([], []) if container else pushes_to(arms, move.block, goal, others, sensor, state.failures)
        if pushed:
            return pushed, at_place(move.block, goal), "", goal
        if container:
            goal = raised_above(goal, container)
        elif starts:
            goal, why = starts[0], "to be pushed from there"
    actions, _ = plan_pick_and_place(arms, with_depth(move.block, state.surface), with_depth(goal, state.surface), others, sensor,
                                     state.failures, state.choices.way(sum(state.attempts) + state.num_temporary))
    return actions, at_place(move.block, goal if why else move.goal), why, goal


def at_place(block, place):
    """Returns a block at another place, that of a Block or Step."""
    return replace(block, position=place.position, yaw=place.yaw)


def raised_above(goal, container):
    """Returns a goal in a container, as high as necessary for the fingers to stay above its rim."""
    position = np.append(goal.position[:2], container.top + goal.size[2] / 2)
    return replace(goal, position=position)
