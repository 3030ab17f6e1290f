"""Finds cubes in the picture of the robot's eye."""
from dataclasses import dataclass

import numpy as np

CHANNELS = {"red": 0, "green": 1, "blue": 2}  # of a picture


@dataclass
class Block:
    place: np.ndarray   # x, y, z of the middle of its bottom [units]
    turn: float         # about the vertical [rad]
    size: float         # of each edge [units]


def find(color, sensor, aux):
    """Returns the cube of this color, which stands on the table; None unless its top is visible."""
    picture = sensor.rgbVision.astype(int)
    channel = CHANNELS[color]
    others = np.delete(picture, channel, axis=2).max(axis=2)
    row, column = np.nonzero(picture[:, :, channel] > 2 * others + 50)
    if row.size == 0:
        return None

    # From pixels to points: along the ray of each pixel, as far as its depth.
    ray = np.linalg.solve(aux.cameraIntrinsics, [column + 0.5, row + 0.5, np.ones(len(row))])
    point = sensor.cameraPose[:3, :3] @ (ray * sensor.depthVision[row, column])
    x, y, z = point + sensor.cameraPose[:3, 3:]

    # The points of the top face, around their middle. The fourth power of a complex number has four
    # times its angle, so the four corners of a square add up: they show how it is turned.
    size = z.max()
    top = (x + 1j * y)[z > size - 0.02]
    middle = top.mean()
    turn = np.angle(-np.mean((top - middle) ** 4)) / 4
    # Of a whole square, the mean square of these distances is a sixth of its area.
    seen = np.sqrt(6 * np.mean(abs(top - middle) ** 2))
    if abs(seen - size) > 0.15 * size:
        return None
    return Block(np.array([middle.real, middle.imag, 0]), turn, size)
