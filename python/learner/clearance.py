"""Areas on the table, seen from above: footprints, overlaps, and clearance for the gripper.

Rectangles are rows of x and y of the center, both sides [units], and the yaw of the first side
[rad]: 5 numbers, Nx5 for many.
"""

import math

import numpy as np

from blocks import Block, has_equal_sides
from constants import CLEARANCE as C


def footprint(blocks, margin):
    """Returns the areas that blocks cover, with a margin on all sides [units]: Nx5."""
    rows = [[*block.position[:2], *(block.size[:2] + 2 * margin), block.yaw] for block in blocks]
    return np.array(rows).reshape(-1, 5)


def overlap(some, many):
    """Returns which of N rectangles overlap with which of M others: NxM bool. If some
    is a single rectangle of 5 numbers, N bool. Separating axes: two rectangles are apart if there
    is a gap between them in the direction of a side.

    some: the M others, Mx5, or 5 numbers
    many: the N rectangles, Nx5
    """
    some = np.asarray(some, float)
    many = np.asarray(many, float)
    if not len(many):
        return np.ones((0, *some.shape[:-1]), bool)
    if some.ndim == 2:
        many = many[:, None, :]
    # The offsets of the centers, and the extents of one rectangle along the sides of the other.
    x, y = many[..., 0] - some[..., 0], many[..., 1] - some[..., 1]
    angle = many[..., 4] - some[..., 4]
    c, s = np.abs(np.cos(angle)), np.abs(np.sin(angle))
    yes = np.ones(angle.shape, bool)
    # In the frames of `some`, then in those of `many`.
    for one, other in ((some, many), (many, some)):
        cos, sin = np.cos(one[..., 4]), np.sin(one[..., 4])
        yes &= 2 * np.abs(x * cos + y * sin) < one[..., 2] + other[..., 2] * c + other[..., 3] * s
        yes &= 2 * np.abs(y * cos - x * sin) < one[..., 3] + other[..., 2] * s + other[..., 3] * c
    return yes


def gripper_clearance(blocks):
    """Returns the areas that blocks cover together with open fingers at their longer sides: Nx5."""
    rectangles = footprint(blocks, C.grip_margin)
    rectangles[:, 3] += C.open_fingers
    return rectangles


def is_inside(container, position):
    """Returns true if a position is between the sides of a Container; false for None."""
    return container is not None and overlap([*position[:2], 0, 0, 0],
                                             footprint([container], 0)).all()


def rotated(v, angle):
    """Returns a vector, x y, rotated by an angle [rad]."""
    c, s = math.cos(angle), math.sin(angle)
    return np.array([v[0] * c - v[1] * s, v[0] * s + v[1] * c])


def held_part(block):
    """Returns the part by which a block is held: its knob where that is now, or the block."""
    knob = block.knob
    if knob is None:
        return block
    away = np.append(rotated(knob.position[:2], block.yaw), knob.position[2])
    return Block(knob.color, knob.size, block.position + away, block.yaw + knob.yaw)


def with_held_parts(blocks):
    """Returns blocks and their knobs, a list of Blocks."""
    return blocks + [held_part(it) for it in blocks if it.knob]


def container_walls(container):
    """Returns the walls of a Container as four Blocks; none for None."""
    if container is None:
        return []
    thick = C.wall  # assumed; thinner walls keep fingers away as well
    along = np.array([math.cos(container.yaw), math.sin(container.yaw), 0])
    across = np.array([-along[1], along[0], 0])
    walls = []
    for side in (1, -1):
        for axis, normal in ((0, along), (1, across)):
            size = container.size.copy()
            size[axis] = thick
            off = side * (container.size[axis] - thick) / 2 * normal
            walls.append(Block(container.color, size, container.position + off, container.yaw))
    return walls


def grasp_yaws(place, others):
    """Returns the collision-free yaws of the gripper at a place (a Block or Step): directions from
    finger to finger [rad], a list. The fingers close across the longer side; no other block may be
    in their way.

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
