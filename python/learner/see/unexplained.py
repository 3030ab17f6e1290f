"""What the eye sees above the table and recognizes as nothing."""

import numpy as np

from constants import PERCEPTION as C, TASK_PLANNING, numbers_of
from see.eye import onto_plane, to_pixel
from things.areas import footprint, overlap


def unexplained_points(known, heights, eye):
    """Returns points of visible surfaces above the table that belong to none of the known Blocks, and
    points of the table around them that are hidden: something is there, like a plate below a tower.
    Nx2 [units]. What hangs higher, like arms, is left out.

    heights: as from height_map
    """
    step = C.unexplained_pixel_step
    part = heights[::step, ::step]
    row, column = np.nonzero((part > C.on_table) & (part < C.unexplained_below))
    points = np.column_stack(onto_plane(step * row, step * column, eye, part[row, column])[:2])
    # One point for all that are close together.
    points = np.unique(np.round(points / C.unexplained_spacing), axis=0) * C.unexplained_spacing
    points = points[~is_within(points, known, C.unexplained_margin)]
    if not len(points):
        return points
    hidden = hidden_ground(heights, eye)
    away = np.array([np.hypot(*(points - it).T).min() for it in hidden])
    hidden = hidden[away < C.unexplained_extent]
    return np.concatenate([points, hidden[~is_within(hidden, known, C.unexplained_margin)]])


def hidden_ground(heights, eye):
    """Returns the points of the table, in a grid, at which the eye sees something higher: Nx2 [units]."""
    hidden = []
    for x in numbers_of(*TASK_PLANNING.place_x):
        for y in eye.near_edge + numbers_of(*TASK_PLANNING.place_depth):
            column, row = np.floor(to_pixel([x, y, 0], eye)).astype(int)
            inside = 0 <= row < heights.shape[0] and 0 <= column < heights.shape[1]
            if inside and heights[row, column] > C.on_table:
                hidden.append([x, y])
    return np.reshape(hidden, (-1, 2))


def is_within(points, blocks, margin):
    """Returns which of N points are in the areas of some Blocks, with a margin [units]: N bool."""
    return overlap(as_places(points), footprint(blocks, margin)).any(axis=0)


def is_unexplained(places, points):
    """Returns which of N places, Nx5, contain some of those points, or have them where open fingers are
    beside a block there: N bool."""
    if not len(points):
        return np.zeros(len(places), bool)
    with_fingers = places + [0, 0, 2 * C.unexplained_fingers, 2 * C.unexplained_fingers, 0]
    return overlap(as_places(points), with_fingers).sum(axis=1) >= C.min_unexplained


def as_places(points):
    """Returns points, Nx2, as areas without extent, Nx5."""
    return np.column_stack([points, np.zeros((len(points), 3))])
