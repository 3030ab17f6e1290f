"""Blocks, and pictures of them as the eye of the robot sees them, for the tests of the learner."""

import math

import numpy as np

from check.beliefs import corrected
from check.verdicts import verdicts_on
from see.eye import Eye
from things.areas import rotated
from things.blocks import Block
from things.steps import Step

RED, GREEN, BLUE = np.eye(3)
CUBE = np.array([1.0, 1, 1])
PLANK = np.array([4.0, 1, 1])
BROWN = np.array([0.5, 0.3, 0.2])
TABLE = np.array([0.6, 0.5, 0.4])
GRAY, DARK, LIGHT = np.full(3, 0.5), np.full(3, 0.2), np.full(3, 0.85)
TILT = math.radians(56.05)  # of the robot's eye, downwards
EYE = Eye(np.array([[240 / math.tan(math.pi / 6), 0, 320], [0, 240 / math.tan(math.pi / 6), 240],
                    [0, 0, 1]]),
          np.array([[1, 0, 0, 0], [0, -math.sin(TILT), math.cos(TILT), -6.1168],
                    [0, -math.cos(TILT), -math.sin(TILT), 11.5921], [0, 0, 0, 1]]))


def block(color, size, x, y, bottom=0.0, yaw=0.0):
    return Block(color, size, np.array([x, y, bottom + size[2] / 2]), yaw)


def step(it, on):
    return Step(it.color, it.size, it.position, it.yaw, "step", on)


def picture_of(blocks):
    """Renders blocks as the eye sees them, lower ones first: 480x640x3."""
    return view_of(blocks)[0]


def view_of(blocks):
    """Renders blocks, lower ones first. Returns the picture, 480x640x3, and the height of what each
    pixel shows, 480x640 [units]."""
    picture = np.tile(TABLE, (480, 640, 1))
    heights = np.zeros((480, 640))
    row, column = np.indices((480, 640))
    ray = EYE.pose[:3, :3] @ [
        (column.ravel() + 0.5 - 320) / EYE.intrinsics[0, 0],
        (row.ravel() + 0.5 - 240) / EYE.intrinsics[1, 1], np.ones(row.size)]
    for it in blocks:
        # Rectangles below each other form the sides. The top is drawn last.
        for height in np.linspace(it.top - it.size[2], it.top, 6):
            x, y, _ = EYE.pose[:3, 3:] + ray * (height - EYE.pose[2, 3]) / ray[2]
            x, y = x - it.position[0], y - it.position[1]
            along = abs(x * math.cos(it.yaw) + y * math.sin(it.yaw))
            across = abs(y * math.cos(it.yaw) - x * math.sin(it.yaw))
            hit = (along <= it.size[0] / 2) & (across <= it.size[1] / 2)
            if it.is_round:
                hit = np.hypot(along, across) <= it.size[0] / 2
            hit = hit.reshape(480, 640)
            picture[hit] = it.color * (1 if height == it.top else 0.7)
            heights[hit] = height
    return picture, heights


def add_ball(picture, heights, color, center, radius):
    """Renders a ball into a picture and its heights."""
    row, column = np.indices((480, 640))
    ray = np.stack([(column + 0.5 - 320) / EYE.intrinsics[0, 0],
                    (row + 0.5 - 240) / EYE.intrinsics[1, 1],
                    np.ones((480, 640))], axis=-1) @ EYE.pose[:3, :3].T
    ray /= np.linalg.norm(ray, axis=-1, keepdims=True)
    to_center = center - EYE.pose[:3, 3]
    along = ray @ to_center
    inside = radius**2 - (to_center @ to_center - along**2)
    hit = inside > 0
    point = EYE.pose[:3, 3] + ray * (along - np.sqrt(np.maximum(inside, 0)))[..., None]
    shade = 0.8 + 0.2 * (point - center)[..., 2:] / radius
    picture[hit] = (shade * color)[hit]
    heights[hit] = point[hit][:, 2]


def empty_box(x, y, yaw):
    """Returns blocks that look like an open box: its rim, a dark side inside, and its floor."""
    return [block(BROWN, np.array([5, 2.6, 0.9]), x, y, yaw=yaw),
            block(0.7 * BROWN, np.array([4.6, 2.2, 0]), x, y, bottom=0.9, yaw=yaw),
            block(BROWN, np.array([4.2, 1.8, 0]), x, y, bottom=0.9, yaw=yaw)]


def thing(label, x, y, yaw=0.0, bottom=0.0):
    """Returns a dark block with a light plate on it, and a label of some color at its near end."""
    body = block(DARK, np.array([0.9, 2.2, 1.6]), x, y, bottom, yaw)
    dx, dy = rotated([0, 0.1], yaw)
    plate = block(LIGHT, np.array([0.7, 1.2, 0.1]), x + dx, y + dy, bottom + 1.6, yaw)
    dx, dy = rotated([0, -0.75], yaw)
    return [body, plate, block(label, np.array([0.9, 0.5, 0.1]), x + dx, y + dy, bottom + 1.6, yaw)]


def update_beliefs(known, seen, picture, eye, heights=None):
    """Returns the known blocks after a look at a picture."""
    return corrected(seen, verdicts_on(known, seen, picture, eye, heights))
