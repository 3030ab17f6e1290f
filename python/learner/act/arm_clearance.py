"""Whether an arm avoids blocks."""

import numpy as np

from act.arms import points_between
from constants import CLEARANCE, MOTION_PLANNING as C
from things.areas import footprint, overlap


def is_arm_clear(arm, q, blocks):
    """Returns true if an arm that holds its tool straight down avoids blocks from its wrist on.
    (grasp_yaws checks the hand.)

    q: its joint angles [rad]
    """
    radius = C.arm_radius
    points = arm.points(q)
    from_tool = np.linalg.norm(points - points[0], axis=1)
    points = points[np.argmax(from_tool > C.min_wrist_distance):]
    for x, y, z in points_between(points, C.points_per_link):
        below = footprint([block for block in blocks if block.top > z - radius], radius)
        if overlap([x, y, 0, 0, 0], below).any():
            return False
    return True


def is_hand_clear(arm, found, others, held):
    """Returns true if an arm, over and at a place where it takes or leaves a held block, touches neither the
    robot nor the table; its hand avoids the others there, and its forearm also the block.

    found: its joint angles over and at the place
    """
    if not arm.is_valid_at(found[1]):
        return False
    if not all(is_arm_clear(arm, q, [*others, held]) for q in found):
        return False
    tool = arm.forward(found[1])
    return all(is_point_clear(tool[:3, 3] + along * tool[:3, 2], others, C.arm_radius)
               for along in (arm.reach, 0, -arm.reach, -2 * arm.reach))


def is_point_clear(point, blocks, margin):
    """Returns true if a point is above or beside blocks, with a margin [units]."""
    x, y, z = point
    near = footprint([it for it in blocks if it.top > z - margin], C.arm_radius)
    return not overlap([x, y, 0, 0, 0], near).any()


def are_fingers_clear(arm, path, blocks):
    """Returns true if the fingers and the hand of an arm are over blocks, or beside them, at the points of a path, which may
    be its ends: with its margins, in between, the check would forbid most turns of planks."""
    for q in path.positions[::max(len(path.positions) // C.samples_per_path, 1)]:
        tool = arm.forward(q)
        for along in (arm.reach, 0, -arm.reach):
            if not is_point_clear(tool[:3, 3] + along * tool[:3, 2], blocks, C.clearance):
                return False
    return True


def is_path_over(arm, path, blocks):
    """Returns true if an arm with an open gripper passes over blocks, or beside them, all along a path."""
    for q in samples(path):
        tool = arm.forward(q)
        hand = [tool[:3, 3] + along * tool[:3, 2] + side * tool[:3, 1]
                for along in (arm.reach, 0, -arm.reach) for side in np.array([-0.5, 0, 0.5]) * CLEARANCE.bar[0]]
        if not is_arm_clear(arm, q, blocks) or not all(is_point_clear(it, blocks, C.clearance / 2) for it in hand):
            return False
    return True


def samples(path):
    """Returns the joint angles at evenly spaced times of a path, Nxn [rad], far from each other first: so what is in the
    way is found soon. (The path's own points may be only its ends.)"""
    n = C.samples_per_path
    return path.at(path.duration / (n - 1) * (np.arange(n) * C.sample_stride % n))[0]
