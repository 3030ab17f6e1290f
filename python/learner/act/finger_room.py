"""Room for the gripper at a block: its fingers, the bar that joins them, and the hand."""

import math

import numpy as np

from constants import CLEARANCE as C
from things.areas import footprint, overlap
from things.blocks import has_equal_sides
from things.held_parts import held_part


def gripper_clearance(blocks):
    """Returns the areas that blocks cover together with open fingers at their longer sides: Nx5."""
    rectangles = footprint(blocks, C.grip_margin)
    rectangles[:, 3] += C.open_fingers
    return rectangles


def grasp_yaws(place, others):
    """Returns the collision-free yaws of the gripper at a place (a Block or Step): directions from
    finger to finger [rad], a list. The fingers stand beside the two longer sides and close across the
    shorter one; no other block may be in their way.

    others: obstacles, as Blocks
    """
    place = held_part(place)
    yaws = [place.yaw + math.pi / 2, place.yaw - math.pi / 2]
    if has_equal_sides(place):
        yaws += [place.yaw, place.yaw + math.pi]
    if place.is_round:
        yaws += [yaw + math.pi / 4 for yaw in yaws]
    # Obstacles as high as the fingers, as the bar that joins them, and as the hand above it.
    tops = np.array([it.top for it in others])
    covered = footprint(others, C.margin)
    at_fingers = covered[tops > place.top - place.size[2] + C.finger_depth_margin]
    # Low blocks are held closer to their tops, so that the bar is higher.
    above = max(0, C.bar_reach - place.size[2])
    at_bar = covered[tops > place.top + C.bar_above_top + above]
    at_hand = covered[tops > place.top + C.hand_above_top]
    clear = is_gripper_clear(place, yaws, at_fingers, at_bar, at_hand)
    return [yaw for yaw, is_clear in zip(yaws, clear) if is_clear]


def is_gripper_clear(place, across, at_fingers, at_bar, at_hand):
    """Returns true, N bool, if the open fingers beside the block, the bar that joins them and the
    hand have room.

    across: directions from finger to finger [rad], N numbers
    """
    x, y = place.position[:2]
    gap = place.size[1] / 2 + C.finger_gap

    def is_free(offset, size, others):
        rectangles = [[x + offset * math.cos(yaw), y + offset * math.sin(yaw), *size, yaw]
                      for yaw in across]
        return ~overlap(rectangles, others).any(axis=0)

    return (is_free(gap, C.finger, at_fingers) & is_free(-gap, C.finger, at_fingers)
            & is_free(0, C.bar, at_bar) & is_free(0, C.hand, at_hand))


def is_grasp_blocked(block, steps):
    """Returns true if a block lies where steps will be built, or so close that no fingers fit in
    afterwards."""
    [covered] = footprint([block], C.site_margin)
    return overlap(covered, gripper_clearance(steps)).any() or not grasp_yaws(block, steps)
