"""What an arm reaches with its tool."""

import numpy as np

from act.finger_room import grasp_yaws
from constants import MOTION_PLANNING as C
from things.held_parts import held_anyhow, held_part


def solve_poses(arm, poses, q, margin=0):
    """Returns the joint angles of a sequence of tool poses, each searched from the one before, the first from q, with a
    margin from their limits [rad]: a list; [] if one has none."""
    lower, upper = arm.robot.limits(arm.name)
    found = []
    for pose in poses:
        q = arm.inverse(pose, q, max_iterations=C.ik_iterations)
        if q is None or np.minimum(q - lower, upper - q).min() < margin or not avoids_torso(arm, q):
            return []
        found.append(q)
    return found


def is_reachable(arm, place):
    """Returns true if an arm can bring its tool to 2 and 0.3 units above the middle of the part by which a block is held, at a
    place."""
    def poses(held, across):
        x, y, z = held.position
        return [arm.tool_pose([x, y, z + height], across, held.size[1])
                for height in C.reach_heights]

    return any(solve_poses(arm, poses(held_part(it), across), arm.parked)
               for it in held_anyhow(place) for across in grasp_yaws(it, []))


def avoids_torso(arm, q):
    """Returns true if joint angles of an arm, Nxn or n [rad], keep its upper arm away from the
    torso between the arms, which it would touch with its first joint at the limit that is farther
    from its parked angle."""
    if not arm.has_torso:
        return True
    lower, upper = (limit[0] for limit in arm.robot.limits(arm.name))
    first = np.atleast_2d(q)[:, 0]
    if arm.parked[0] - lower > upper - arm.parked[0]:
        return bool((first > lower + C.torso_margin_rad).all())
    return bool((first < upper - C.torso_margin_rad).all())


def can_reach(arms, place):
    """Returns true if one of the arms reaches a block's place."""
    return any(is_reachable(arm, place) for arm in arms)
