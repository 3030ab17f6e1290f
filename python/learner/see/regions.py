"""Connected regions of a picture."""

import numpy as np

from constants import PERCEPTION as C


def label_regions(mask, heights=None):
    """Labels the connected regions of a mask, HxW bool: 0 where it is false, otherwise numbers from
    1. With heights, as from height_map, a step between two pixels separates regions."""
    number = np.zeros(mask.shape, int)
    rows = np.flatnonzero(mask.any(axis=1))
    if len(rows):
        # Most masks fill a small part of the picture.
        columns = np.flatnonzero(mask.any(axis=0))
        part = np.s_[rows[0]:rows[-1] + 1, columns[0]:columns[-1] + 1]
        number[part] = labels_within(mask[part], None if heights is None else heights[part])
    return number


def labels_within(mask, heights):
    """Labels the connected regions of a mask."""
    in_column = mask[1:] & mask[:-1]
    side_by_side = mask[:, :-1] & mask[:, 1:]
    if heights is not None:
        in_column &= np.abs(np.diff(heights, axis=0)) < C.height_step
        side_by_side &= np.abs(np.diff(heights, axis=1)) < C.height_step

    # Pixels that touch in a column are a run. Counting the beginnings of runs numbers them.
    begins = mask.copy()
    begins[1:] &= ~in_column
    run = np.cumsum(begins.T).reshape(mask.T.shape).T * mask
    num_runs = run.max(initial=0)

    # Runs that touch side by side belong to one region (union-find): its first run represents it.
    left, right = run[:, :-1][side_by_side], run[:, 1:][side_by_side]
    touching = np.unique(left * (num_runs + 1) + right)
    first = list(range(num_runs + 1))

    def first_of(k):
        while first[k] != k:
            k = first[k]
        return k

    for pair in touching.tolist():
        one, other = sorted(map(first_of, divmod(pair, num_runs + 1)))
        first[other] = one
    numbers = np.unique([first_of(k) for k in range(num_runs + 1)], return_inverse=True)[1]
    return numbers[run]


def is_level(heights):
    """Returns true if the heights of some pixels, N numbers, are those of one level area above the
    table."""
    ordered = np.sort(heights)
    low, middle, high = (ordered[int(fraction * (len(ordered) - 1))] for fraction in (0.1, 0.5, 0.9))
    return middle > C.on_table and high - low < C.height_step


def is_cut(row, column, top, heights):
    """Returns true if something higher hides a part of a top face, or the border of the picture
    cuts it off: it touches pixels of higher surfaces."""
    edge = np.pad(heights > top + C.height_step, 1, constant_values=True)
    beside = np.zeros(edge.shape, bool)
    for down, right in ((0, 1), (2, 1), (1, 0), (1, 2)):
        beside[row + down, column + right] = True
    return (beside & edge).sum() >= C.min_cut_pixels
