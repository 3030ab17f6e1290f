"""Pictures in a row, and outlines of blocks in them."""

import math

import numpy as np

from drawing import Drawing
from see.eye import pixels_in_view

WIDE, HIGH, GAP, TITLE = 300, 165, 12, 24  # of a picture, and around it [pixels]


def panels(titles, below=0):
    """Returns a Drawing with room for pictures in a row, each under its title, and the left edge of each."""
    drawing = Drawing(len(titles) * (WIDE + GAP) + GAP, TITLE + HIGH + GAP + below)
    left = [GAP + k * (WIDE + GAP) for k in range(len(titles))]
    for x, title in zip(left, titles):
        drawing.text(x, TITLE - 8, title, weight="bold")
    return drawing, left


def top_corners(position, top, size, yaw, is_round=False):
    """Returns the outline of a top, Nx3 [units]."""
    angles = np.arange(24) * math.pi / 12 if is_round else np.array([1, 3, 5, 7]) * math.pi / 4
    reach = 0.5 if is_round else math.sqrt(0.5)
    x, y = reach * size[0] * np.cos(angles), reach * size[1] * np.sin(angles)
    c, s = math.cos(yaw), math.sin(yaw)
    return np.column_stack([position[0] + c * x - s * y, position[1] + s * x + c * y, np.full(len(x), top)])


def show(drawing, left, picture):
    """Draws the lower part of a picture, which shows the table."""
    drawing.picture(picture[-round(picture.shape[1] * HIGH / WIDE):], left, TITLE, WIDE, HIGH)


def pixels_shown(left, points, eye, shape):
    """Returns where points, Nx3 [units], are in a drawing that shows a picture of some shape, Nx2 [pixels]."""
    scale = WIDE / shape[1]
    return pixels_in_view(points, eye) * scale + [left, TITLE + HIGH - scale * shape[0]]


def outlines(drawing, left, blocks, eye, shape, color, dashes=""):
    """Draws the outlines of the tops of blocks over a picture."""
    for it in blocks:
        corners = top_corners(it.position, it.top, it.size, it.yaw, it.is_round)
        drawing.line(pixels_shown(left, corners, eye, shape), color, 2, dashes, closed=True)


def faded(picture):
    """Returns a picture with less contrast, on which outlines are visible."""
    return 0.45 + 0.55 * picture
