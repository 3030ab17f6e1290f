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


def overlap(one, many):
    """Returns true for each of many rectangles, Nx5, that overlaps with one: N bool. Separating
    axes: two rectangles are apart if there is a gap between them in the direction of a side."""
    one = np.asarray(one, float)
    many = np.asarray(many, float)
    offset = many[:, :2] - one[:2]
    yes = np.ones(len(many), bool)
    for yaw in (one[4], one[4] + math.pi / 2, many[:, 4], many[:, 4] + math.pi / 2):
        distance = np.abs(offset[:, 0] * np.cos(yaw) + offset[:, 1] * np.sin(yaw))
        yes &= distance < half_extent(one, yaw) + half_extent(many, yaw)
    return yes


def half_extent(rectangles, yaw):
    """Returns half the extent of rectangles in a direction [units]."""
    angle = yaw - rectangles[..., 4]
    along = rectangles[..., 2] * np.abs(np.cos(angle))
    return (along + rectangles[..., 3] * np.abs(np.sin(angle))) / 2


def gripper_clearance(blocks):
    """Returns the areas that blocks cover together with open fingers at their longer sides: Nx5."""
    rectangles = footprint(blocks, C.grip_margin)
    rectangles[:, 3] += C.open_fingers
    return rectangles


def is_inside(container, position):
    """Returns true if a position is between the sides of a Container; false for None."""
    return container is not None and overlap([*position[:2], 0, 0, 0],
                                             footprint([container], 0)).all()


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
    yaws = [place.yaw + math.pi / 2, place.yaw - math.pi / 2]
    if has_equal_sides(place):
        yaws += [place.yaw, place.yaw + math.pi]
    # Obstacles as high as the fingers, as the bar that joins them, and as the hand above it.
    tops = np.array([it.top for it in others])
    covered = footprint(others, C.margin)
    at_fingers = covered[tops > place.top - place.size[2] + C.finger_depth_margin]
    at_bar = covered[tops > place.top + C.bar_above_top]
    at_hand = covered[tops > place.top + C.hand_above_top]
    return [it for it in yaws if is_gripper_clear(place, it, at_fingers, at_bar, at_hand)]


def is_gripper_clear(place, across, at_fingers, at_bar, at_hand):
    """Returns true if the open fingers beside the block, the bar that joins them and the hand have
    room.

    across: direction from finger to finger [rad]
    """
    x, y = place.position[:2]
    offset = place.size[1] / 2 + C.finger_gap
    dx, dy = offset * math.cos(across), offset * math.sin(across)
    return not (overlap([x + dx, y + dy, *C.finger, across], at_fingers).any()
                or overlap([x - dx, y - dy, *C.finger, across], at_fingers).any()
                or overlap([x, y, *C.bar, across], at_bar).any()
                or overlap([x, y, *C.hand, across], at_hand).any())


def is_grasp_blocked(block, steps):
    """Returns true if a block lies where steps will be built, or so close that no fingers fit in
    afterwards."""
    [covered] = footprint([block], C.site_margin)
    return overlap(covered, gripper_clearance(steps)).any() or not grasp_yaws(block, steps)
