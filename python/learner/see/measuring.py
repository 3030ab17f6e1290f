"""Measures a block of any size by its top face and the side below it."""

import numpy as np

from constants import PERCEPTION as C, numbers_of
from see.colors import is_darker_shade
from see.eye import onto_plane, pixel_at, to_pixel
from see.faces import fit_face
from things.blocks import Block


def measure_block(color, row, column, picture, eye, table, heights=None):
    """Measures the Block that has a top face, of any size; None if it is not entirely visible.
    Without heights, as from height_map, it must stand on the table."""
    if heights is None:
        top, ground = estimate_height(color, row, column, picture, eye, table), 0
    else:
        top = np.median(heights[row, column])
        ground = ground_below(color, row, column, picture, eye, heights)
    if top is None or ground is None or top - ground < C.on_table:
        return None
    face = fit_face(*onto_plane(row, column, eye, top))
    if face.misfit > C.misfit:
        return None
    return Block(color, np.append(face.sides, top - ground),
                 np.append(face.center, (top + ground) / 2), face.yaw, form="disc" if face.is_round else "block")


def ground_below(color, row, column, picture, eye, heights):
    """Returns the height of what a block stands on [units]: below the edge of its top one of its
    sides is visible, and below that the ground. None if something else hides its foot; so it is
    with the floor of a box."""
    top = np.median(heights[row, column])
    point, step = edge_toward_nadir(row, column, eye)
    row, column = np.floor(point[::-1]).astype(int)
    while 0 <= row < heights.shape[0] and 0 <= column < heights.shape[1]:
        if not is_darker_shade(picture[row, column], color):
            ground = heights[row, column]
            if ground > top - C.on_table:
                return None
            return ground if ground > C.on_table else 0
        point = point + step
        row, column = np.floor(point[::-1]).astype(int)
    return None


def estimate_height(color, row, column, picture, eye, table):
    """Estimates the height of a block on the table [units]: below the edge of its top one of its
    sides is visible, down to where the table begins. None if something else is there."""
    (u, v), _ = edge_toward_nadir(row, column, eye)
    for trial in numbers_of(*C.height_trials):
        x, y, _ = onto_plane(np.array([v - 0.5]), np.array([u - 0.5]), eye, trial)
        pixel = pixel_at(picture, eye, [x[0], y[0], 0])
        if pixel is None or not is_darker_shade(picture[pixel], color):
            break
    # The resolution of the picture allows no finer steps.
    height = round(C.heights_per_unit * trial) / C.heights_per_unit
    is_table = pixel is not None and np.abs(picture[pixel] - table).max() < C.table_tolerance
    return height if is_table and height > 0 else None


def edge_toward_nadir(row, column, eye):
    """Returns the pixel where a top ends below its middle, on the line to the nadir, the image
    point straight below the camera: u, v from the top left corner [pixels]; and half a pixel along
    this line. It may leave the top and meet it again, as at a corner."""
    nadir = to_pixel(eye.pose[:3, 3] - [0, 0, 1], eye)
    point = np.array([column.mean(), row.mean()]) + 0.5
    step = 0.5 * (nadir - point) / np.linalg.norm(nadir - point)
    pixels = set(zip(column.tolist(), row.tolist()))
    low, high = np.array([[column.min(), row.min()], [column.max() + 1, row.max() + 1]])
    end = point
    while (low <= point).all() and (point < high).all():
        if tuple(np.floor(point).astype(int).tolist()) in pixels:
            end = point + step
        point = point + step
    return end, step
