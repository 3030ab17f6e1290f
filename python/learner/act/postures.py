"""Postures in which arms wait beside the table."""

import numpy as np

from act.arm_points import points_between
from constants import ARMS as C, numbers_of
from see.eye import to_pixel


def posture_aside(arm, eye, is_left):
    """Returns joint angles of an arm beside the table: its hand as high as possible, its first
    joint turned until the eye sees least of it, outward beside other arms."""
    q_high = raised(arm)
    best = None
    for angle in turns_of(arm):
        q = np.append(angle, q_high[1:])
        is_outward = (angle > q_high[0]) == is_left
        if not arm.is_valid_at(q) or arm.has_torso and not is_outward:
            continue
        cost = visible_extent(arm.points(q), eye), not is_outward, abs(angle - q_high[0])
        if best is None or cost < best[0]:
            best = cost, q
    return best[1] if best else q_high


def turns_of(arm):
    """Returns angles of an arm's first joint that turn it all around, with a distance from its limits: N numbers [rad]."""
    lower, upper = (np.clip(limit[0] * C.parked_limit, -np.pi, np.pi) for limit in arm.robot.limits(arm.name))
    return numbers_of(lower, C.parked_turn_rad, upper)


def raised(arm):
    """Returns joint angles with the tool above the place of the pose `ready`, or closer to the
    robot, as high as possible."""
    over = arm.forward(arm.ready)[:2, 3]
    for height in numbers_of(*C.parked_heights):
        for fraction in C.parked_distances:
            place = arm.foot + fraction * (over - arm.foot)
            q = arm.inverse(arm.tool_pose([*place, height], 0), arm.ready, any_turn=True)
            if q is not None and arm.is_valid_at(q):
                return q
    return arm.ready


def visible_extent(points, eye):
    """Returns how much of the lines between points is in the eye's picture: the sum of the
    distances of points on them from its border [pixels]. Beyond the border, thick links may still
    be visible."""
    size = 2 * eye.intrinsics[:2, 2]
    margin = C.parked_margin * size
    extent = 0
    for at in points_between(points, C.points_per_link):
        if (at - eye.pose[:3, 3]) @ eye.pose[:3, 2] > 0:  # in front of the eye
            pixel = to_pixel(at, eye)
            extent += max(0, min(*(pixel + margin), *(size + margin - pixel)))
    return round(extent)
