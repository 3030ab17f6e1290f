"""Poses of a dataset, in the numbers of network.py."""

import numpy as np

UNIT = 0.1  # [m]


def rotations(quaternions):
    """(…, 3, 3) of (…, 4): w x y z."""
    w, x, y, z = np.moveaxis(np.asarray(quaternions, float), -1, 0)
    rows = [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]
    return np.moveaxis(np.array(rows), (0, 1), (-2, -1))


def places(poses, yaw_of):
    """(frames, N, 4): x y z [units] and yaw of poses, (frames, 7 N)."""
    poses = np.asarray(poses).reshape(len(poses), -1, 7)
    turned = rotations(poses[..., 3:])
    yaws = np.array([[yaw_of(one) for one in frame] for frame in turned])
    return np.concatenate([poses[..., :3] / UNIT, yaws[..., None]], axis=-1)
