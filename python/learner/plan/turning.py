"""Turns blocks onto other faces: by 90 degrees about the axis on which the fingers hold them.

The tool comes down over an edge of the block, half way between the face that is its top and the one that
will be: so the hand is above the table before and after the turn.
"""

import math
from dataclasses import replace

import numpy as np

from act.grippers import can_hold, nearest_first
from act.reach import can_reach, solve_poses
from check.failures import able_arms, has_failed
from constants import MOTION_PLANNING as C, TASK_PLANNING
from plan.free_places import free_placements
from plan.tilt import turn_height
from plan.tilted_grasps import tilted_grasps
from plan.turn_paths import plan_turn_to
from things.resting import turned


def plan_turn(arms, eye, block, held, then, others, sites, sensor, failures, unexplained):
    """Plans the actions that turn a block and put it at a free place on the table.

    held: the side by which it is held, as for resting.turned
    then: by which one it must be held for the next turn there; None for none
    others, sites, failures, unexplained: as for plan_temporary_placement
    Returns actions, the block at that place, and None; or [], None and a reason.
    """
    able, reason_of_arms = able_arms(arms, block, block.size[held], failures)
    if not able:
        return [], None, reason_of_arms
    reason = "no arm can hold it so that it can be turned"
    # Close to the limits of its joints, the hand of an arm may be folded to it: only if necessary.
    grasps = [grasp for margin in (C.tilted_limit_rad, 0)
              for arm in nearest_first(able, block.position[0])
              for grasp in tilted_grasps(arm, block, held, others, margin)
              if not has_failed(grasp.attempt, failures)]
    like = replace(block, size=turned(block.size, held))
    for site in sites if grasps else []:
        reason = "there is no free place on the table where an arm can turn it"
        num_tried = 0
        for place in free_placements(arms, eye, like, others + site, None, unexplained):
            if not (can_reach(arms, place) if then is None else can_turn(arms, place, then, others)):
                continue
            num_tried += 1
            if num_tried > TASK_PLANNING.max_place_attempts:
                break
            for grasp in grasps:
                actions = plan_turn_to(grasp, block, held, place, others, sensor)
                if actions:
                    return actions, place, None
    return [], None, reason_of_arms or reason


def can_turn(arms, block, held, others):
    """Returns true if an arm can turn a block where it is."""
    like = replace(block, size=turned(block.size, held))
    like.position = np.append(block.position[:2], block.bottom + like.size[2] / 2)
    height = turn_height(block, others)
    grasps = [grasp for arm in arms if can_hold(arm, block.size[held])
              for grasp in tilted_grasps(arm, block, held, others, C.tilted_limit_rad)]
    return any(solve_poses(grasp.arm, end, grasp.q[0], grasp.margin)
               for yaw in np.arange(4) * math.pi / 4 for grasp in grasps
               for end in grasp.ends(replace(like, yaw=yaw), height))
