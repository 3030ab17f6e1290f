"""Rotations, told by angles about the axes of the table."""

import math

import numpy as np

from constants import TASK_MODEL as C


def rotation_of(angles):
    """Returns the rotation by angles about x, then y, then z [degrees], 3x3: its columns are the axes of
    the object."""
    rotation = np.eye(3)
    for axis, angle in enumerate(np.radians(angles)):
        c, s = math.cos(angle), math.sin(angle)
        i, j = [(1, 2), (2, 0), (0, 1)][axis]
        about = np.eye(3)
        about[[i, i, j, j], [i, j, i, j]] = c, -s, s, c
        rotation = about @ rotation
    return rotation


def upright_at_start(poses):
    """Returns the poses of an object, Nx6 as for resting_at, about axes of its own of which the third one is vertical at
    the start: an object that began on another face than its description's is told like one that began on its own."""
    axes = rotation_of(poses[0, 3:6])
    up = int(np.argmax(np.abs(axes[2])))
    if up == 2 or abs(axes[2, up]) < math.cos(math.radians(C.max_rest_degrees)):
        return poses
    along = min({0, 1, 2} - {up})
    yaw = math.degrees(math.atan2(axes[1, along], axes[0, along]))
    own = axes.T @ rotation_of([0, 0, yaw])
    return np.array([[*pose[:3], *angles_of(rotation_of(pose[3:6]) @ own)] for pose in poses])


def angles_of(rotation):
    """Returns the angles about x, then y, then z [degrees] of a rotation: see rotation_of."""
    return np.degrees([math.atan2(rotation[2, 1], rotation[2, 2]), -math.asin(np.clip(rotation[2, 0], -1, 1)),
                       math.atan2(rotation[1, 0], rotation[0, 0])])
