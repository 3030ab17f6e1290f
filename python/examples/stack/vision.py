"""Finds blocks of 1 x 1 x 1 units in the picture of the robot's eye."""
import numpy as np

CHANNELS = {"red": 0, "green": 1, "blue": 2}  # of a picture


def find(color, sensor, aux):
    """Returns x, y of the center of the block of this color [units]."""
    picture = sensor.rgbVision.astype(int)
    channel = CHANNELS[color]
    others = np.delete(picture, channel, axis=2).max(axis=2)
    row, column = np.nonzero(picture[:, :, channel] > 2 * others + 50)

    # From pixels to points: along the ray of each pixel, as far as its depth.
    ray = np.linalg.solve(aux.cameraIntrinsics, [column + 0.5, row + 0.5, np.ones(len(row))])
    point = sensor.cameraPose[:3, :3] @ (ray * sensor.depthVision[row, column])
    x, y, z = point + sensor.cameraPose[:3, 3:]

    is_on_top = np.abs(z - 1) < 0.02
    if not is_on_top.any():
        raise RuntimeError(f"no {color} block is visible")
    return np.array([x[is_on_top].mean(), y[is_on_top].mean()])
