"""Whether an arm avoids blocks."""

import numpy as np

from act.arm_points import points_from_wrist
from constants import CLEARANCE, MOTION_PLANNING as C
from things.areas import footprint, overlap


def is_arm_clear(arm, q, blocks):
    """Returns true if an arm that holds its tool straight down avoids blocks from its wrist on; grasp_yaws checks the hand.

    q: its joint angles [rad]
    """
    return are_points_clear(points_from_wrist(arm, q), blocks, C.arm_radius)


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
    return are_points_clear(np.array([point]), blocks, margin)


def are_points_clear(points, blocks, margin):
    """Returns true if points, Nx3, are all above or beside blocks, with a margin [units]."""
    places = np.column_stack([points[:, :2], np.zeros((len(points), 3))])
    tops = np.array([it.top for it in blocks])
    return not (overlap(footprint(blocks, C.arm_radius), places) & (tops > points[:, 2:] - margin)).any()


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
    if not blocks:
        return True
    moments = samples(path)
    tools = np.array([arm.forward(q) for q in moments])
    along, side = np.meshgrid([arm.reach, 0, -arm.reach], np.array([-0.5, 0, 0.5]) * CLEARANCE.bar[0])
    of_hand = tools[:, :3, 3, None] + along.ravel() * tools[:, :3, 2, None] + side.ravel() * tools[:, :3, 1, None]
    return (are_points_clear(points_from_wrist(arm, moments), blocks, C.arm_radius)
            and are_points_clear(np.moveaxis(of_hand, 1, 2).reshape(-1, 3), blocks, C.clearance / 2))


def samples(path):
    """Returns the joint angles at evenly spaced times of a path, Nxn [rad], far from each other first: so what is in the
    way is found soon. (The path's own points may be only its ends.)"""
    n = C.samples_per_path
    return path.at(path.duration / (n - 1) * (np.arange(n) * C.sample_stride % n))[0]
