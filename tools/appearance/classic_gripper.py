"""The gripper of the 2015 program: palm and two fingers, within the boxes that collide, meters."""

import numpy as np

from .frames import ALONG_MINUS_Y
from .glb import Piece
from .materials import BRICK_RED, PALE, RUBBER_BLACK
from .modeling import (circle, extrusion, joined, mirrored, placed, rounded, rounded_box, section_at, skin, translation,
                       tube)


def box_between(low, high, corner_radius, edge_radius):
    """A rounded box between two corners, its smooth edges along z."""
    low, high = np.array(low), np.array(high)
    return placed(translation(*(low + high) / 2), rounded_box(high - low, corner_radius, edge_radius))


def palm():
    """The bar of the classic gripper, in the frame of its middle: y along it, z towards the tips.

    The motor's housing fills the space between the cuff and the fingers' rail.
    """
    housing = box_between((-0.030, -0.050, -0.0125), (0.0285, 0.050, 0.0195), 0.016, 0.006)
    plate = box_between((-0.032, -0.045, -0.0155), (0.0225, 0.045, -0.011), 0.018, 0.001)
    rail = tube([(0, -0.128, 0), (0, 0.128, 0)], 0.0135, 0, 18)
    ends = [placed(ALONG_MINUS_Y, extrusion(circle(0.0185, 24), -y - 0.006, -y + 0.006, 0.003, 2))
            for y in (-0.1245, 0.1245)]
    return [Piece(BRICK_RED, joined([housing, *ends])), Piece(PALE, plate), Piece(RUBBER_BLACK, rail)]


def left_finger():
    """The finger at +y: within the box that collides, its inner face in the plane y = 0."""
    carriage = box_between((-0.020, 0.0004, -0.075), (0.020, 0.030, -0.030), 0.006, 0.004)

    # The blade grows slim towards the tip; its inner face stays in the plane where fingers meet.
    def cut(z, half_x, y_max):
        return section_at(rounded([(-half_x, 0.0005), (half_x, 0.0005), (half_x, y_max), (-half_x, y_max)], 0.003, 3), z)

    blade = skin([cut(-0.034, 0.0165, 0.026), cut(-0.02, 0.016, 0.020), cut(0.03, 0.0145, 0.0135),
                  cut(0.070, 0.0135, 0.0115), cut(0.0744, 0.0115, 0.0095)])
    pad = box_between((-0.0185, 0.0, 0.022), (0.0185, 0.0062, 0.0750), 0.0025, 0.0025)
    return [Piece(BRICK_RED, carriage), Piece(RUBBER_BLACK, joined([blade, pad]))]


def right_finger():
    return [Piece(piece.color, mirrored(piece.surface)) for piece in left_finger()]
