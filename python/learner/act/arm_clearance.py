"""Whether an arm avoids blocks."""

import numpy as np

from act.arms import points_between
from constants import CLEARANCE, MOTION_PLANNING as C
from things.areas import footprint, overlap


def is_arm_clear(arm, q, blocks):
    """Returns true if an arm that holds its tool straight down avoids blocks from its wrist on; grasp_yaws checks the hand.

    q: its joint angles [rad]
    """
    return are_points_clear(points_from_wrist(arm, q), blocks, C.arm_radius)


def points_from_wrist(arm, q):
    """Returns points along an arm, from its wrist to its first joint: Nx3 [units]."""
    points = arm.points(q)
    from_tool = np.linalg.norm(points - points[0], axis=1)
    return points_between(points[np.argmax(from_tool > C.min_wrist_distance):], C.points_per_link)


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
    of_arm, of_hand = [], []
    for q in samples(path):
        tool = arm.forward(q)
        of_arm.append(points_from_wrist(arm, q))
        of_hand += [tool[:3, 3] + along * tool[:3, 2] + side * tool[:3, 1]
                    for along in (arm.reach, 0, -arm.reach) for side in np.array([-0.5, 0, 0.5]) * CLEARANCE.bar[0]]
    return (are_points_clear(np.concatenate(of_arm), blocks, C.arm_radius)
            and are_points_clear(np.array(of_hand), blocks, C.clearance / 2))


def samples(path):
    """Returns the joint angles at evenly spaced times of a path, Nxn [rad], far from each other first: so what is in the
    way is found soon. (The path's own points may be only its ends.)"""
    n = C.samples_per_path
    return path.at(path.duration / (n - 1) * (np.arange(n) * C.sample_stride % n))[0]
