"""Room on the table, seen from above: what covers what, and where fingers fit in.

Rectangles are rows of x and y of the center, both sides [units], and how the first side is turned
[rad]: 5 numbers, Nx5 for many.
"""

import math

import numpy as np

from blocks import Block, has_equal_sides
from constants import ROOM


def footprint(blocks, margin):
    """What blocks cover, with a margin on all sides [units]: Nx5."""
    rows = [[*block.position[:2], *(block.size[:2] + 2 * margin), block.yaw] for block in blocks]
    return np.array(rows).reshape(-1, 5)


def overlap(one, many):
    """Whether a rectangle has points in common with each of many: N bool. Two rectangles are apart
    if, in the direction of one of their sides, there is a gap between them."""
    one = np.asarray(one, float)
    many = np.asarray(many, float)
    gap = many[:, :2] - one[:2]
    yes = np.ones(len(many), bool)
    for yaw in (one[4], one[4] + math.pi / 2, many[:, 4], many[:, 4] + math.pi / 2):
        apart = np.abs(gap[:, 0] * np.cos(yaw) + gap[:, 1] * np.sin(yaw))
        yes &= apart < reach(one, yaw) + reach(many, yaw)
    return yes


def reach(rectangles, yaw):
    """How far they reach from their centers in a direction [units]."""
    turn = yaw - rectangles[..., 4]
    along = rectangles[..., 2] * np.abs(np.cos(turn))
    return (along + rectangles[..., 3] * np.abs(np.sin(turn))) / 2


def grip_room(blocks):
    """What blocks cover, and with them open fingers at their longer sides: Nx5."""
    rectangles = footprint(blocks, ROOM.grip_margin)
    rectangles[:, 3] += ROOM.open_fingers
    return rectangles


def is_inside(container, position):
    """Whether a place is within the sides of a Container; none is in None."""
    return container is not None and overlap([*position[:2], 0, 0, 0],
                                             footprint([container], 0)).all()


def walls_of(container):
    """What stands around the inside of a Container, as four Blocks; none of None."""
    if container is None:
        return []
    thick = ROOM.wall  # thinner ones keep fingers off as well
    along = np.array([math.cos(container.yaw), math.sin(container.yaw), 0])
    across = np.array([-along[1], along[0], 0])
    walls = []
    for side in (1, -1):
        for axis, way in ((0, along), (1, across)):
            size = container.size.copy()
            size[axis] = thick
            off = side * (container.size[axis] - thick) / 2 * way
            walls.append(Block(container.color, size, container.position + off, container.yaw))
    return walls


def finger_turns(place, others):
    """How the fingers may be turned to hold a block at a place (a Block or Step): directions from
    finger to finger [rad], a list; they go across its longer side, and only where nothing is in
    their way."""
    turns = [place.yaw + math.pi / 2, place.yaw - math.pi / 2]
    if has_equal_sides(place):
        turns += [place.yaw, place.yaw + math.pi]
    # What is as high as the fingers, the bar that joins them, and the hand above it, must keep off
    # them.
    tops = np.array([it.top for it in others])
    covered = footprint(others, ROOM.margin)
    at_fingers = covered[tops > place.top - place.size[2] + ROOM.finger_depth_margin]
    at_bar = covered[tops > place.top + ROOM.bar_above_top]
    at_hand = covered[tops > place.top + ROOM.hand_above_top]
    return [turn for turn in turns if fits(place, turn, at_fingers, at_bar, at_hand)]


def fits(place, across, at_fingers, at_bar, at_hand):
    """Whether fingers that are open beside the block, the bar that joins them and the hand have room."""
    x, y = place.position[:2]
    gap = place.size[1] / 2 + ROOM.finger_gap
    dx, dy = gap * math.cos(across), gap * math.sin(across)
    return not (overlap([x + dx, y + dy, *ROOM.finger, across], at_fingers).any()
                or overlap([x - dx, y - dy, *ROOM.finger, across], at_fingers).any()
                or overlap([x, y, *ROOM.bar, across], at_bar).any()
                or overlap([x, y, *ROOM.hand, across], at_hand).any())


def is_walled_in(block, steps):
    """Whether a block lies on the building's site, or so near that no fingers fit in once the
    building stands."""
    [covered] = footprint([block], ROOM.site_margin)
    return overlap(covered, grip_room(steps)).any() or not finger_turns(block, steps)
