"""Points on the lines along an arm."""

import numpy as np

from constants import MOTION_PLANNING as C


def points_between(ends, number):
    """Returns a number of points, at equal distances, on each of the straight lines from one end to the next: Nx3 for the
    ends Mx3, and KxNx3 for KxMx3."""
    fractions = np.linspace(0, 1, number)[:, None]
    lines = ends[..., :-1, None, :] + fractions * np.diff(ends, axis=-2)[..., None, :]
    return lines.reshape(*ends.shape[:-2], -1, 3)


def points_from_wrist(arm, q):
    """Returns points along an arm, from its wrist to its first joint, at joint angles or several rows of them: Nx3 [units]."""
    ends = arm.points(q)
    points = points_between(ends, C.points_per_link).reshape(*ends.shape[:-2], -1, C.points_per_link, 3)
    # Keeps the lines from the first end on that is away from the tool.
    is_far = np.linalg.norm(ends - ends[..., :1, :], axis=-1) > C.min_wrist_distance
    return points[np.maximum.accumulate(is_far[..., :-1], axis=-1)].reshape(-1, 3)
