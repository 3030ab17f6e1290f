"""Whether an arm avoids blocks."""

import numpy as np

from areas import footprint, overlap
from constants import MOTION_PLANNING as C


def is_arm_clear(arm, q, blocks):
    """Returns true if an arm that holds its tool straight down avoids blocks from its wrist on.
    (grasp_yaws checks the hand.)

    q: its joint angles [rad]
    """
    radius = C.arm_radius
    points = arm.points(q)
    from_tool = np.linalg.norm(points - points[0], axis=1)
    points = points[np.argmax(from_tool > C.min_wrist_distance):]
    fractions = np.linspace(0, 1, C.points_per_link)[:, None]
    for one, other in zip(points, points[1:]):
        for x, y, z in one + fractions * (other - one):
            below = footprint([block for block in blocks if block.top > z - radius], radius)
            if overlap([x, y, 0, 0, 0], below).any():
                return False
    return True
