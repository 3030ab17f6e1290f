"""Perception of scissors, string and weight. Lengths are in units."""
import numpy as np

from common.vision import Place, between, points_of, rectangle_around

GRIP, BLADES, STRING, WEIGHT = (0xd7, 0x26, 0x3d), (0xb8, 0xbe, 0xc6), (0xe0, 0x7a, 0x1f), (0xf2, 0xb1, 0x34)

GRIP_TOP = 0.8   # height of the grip of scissors on the table
CUT = 3.3, 3.7   # heights between which the string is cut
HANGING = 1.5    # the upper side of a weight that hangs is higher


def find_scissors(sensor, aux):
    """Returns the place of the scissors on the table: the middle of their grip; its depth is the
    direction of their blades."""
    grip = between(points_of(GRIP, sensor, aux), GRIP_TOP - 0.03, GRIP_TOP + 0.03)
    blades = between(points_of(BLADES, sensor, aux), 0.3, 0.6)
    if len(grip) < 50 or len(blades) < 20:
        raise RuntimeError("no scissors are visible")
    middle, (axis, _), _ = rectangle_around(grip)
    if (blades[:, :2].mean(axis=0) - middle) @ axis < 0:
        axis = -axis
    return Place(middle, axis)


def find_string(sensor, aux):
    """Returns the place of the string, whose depth is the direction across it and away from the
    robot; and where it may be cut, left and right of the weight: x from its middle, and height."""
    string = points_of(STRING, sensor, aux, is_shaded=True)
    if len(string) < 100:
        raise RuntimeError("no string is visible")
    middle, (_, across), _ = rectangle_around(string)
    place = Place(middle, across if across[1] > 0 else -across)
    cut = between(string, *CUT)
    x = place.inside(cut)[:, 0]
    return place, [(x[side].mean(), cut[side, 2].mean()) for side in (x < 0, x > 0)]


def is_hanging(sensor, aux):
    """Returns true if the weight hangs above its box."""
    weight = points_of(WEIGHT, sensor, aux)
    if len(weight) < 50:
        raise RuntimeError("no weight is visible")
    return np.median(weight[:, 2]) > HANGING
