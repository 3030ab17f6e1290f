"""The networks that see where blocks are in a picture: for training with JAX and for acting with numpy.

    find    in which cell of the picture the middle of each object is
    look    closer: where in a piece of the picture about it, at which height it is, and its yaw

Pictures are (…, height, width, 3), colors from 0 to 1; pixels (…, 2) are u to the right and v down, the center of the
first one at 0.5, 0.5. xp is numpy or jax.numpy.
"""

import numpy as np

SIZE = 240, 320    # of a picture, height and width [px]
CELL = 4           # `find` sees the picture in cells of so many pixels
PIECE = 32         # side of what `look` sees [px]
FILTERS = 12, 24   # of the layers of `find`, and of those of `look`; the second layer of `look` has twice as many
SHIFT_SCALE = 8    # the distance from the middle of a piece that is mapped to 1 [px]
OUTPUTS = 5        # of `look` for each object: shift u v, height [units], sine and cosine of four times the yaw


def cells_of(picture):
    """(…, rows, columns, 3): mean colors of the cells."""
    *more, height, width, _ = picture.shape
    return picture.reshape(*more, height // CELL, CELL, width // CELL, CELL, 3).mean(axis=(-4, -2))


def convolve(xp, x, layer, stride=1):
    """A layer whose outputs depend on 3x3 neighbors, zero beyond the edges, and are cut off at zero."""
    weights, biases = layer
    height, width = x.shape[-3:-1]
    padded = xp.pad(x, [(0, 0)] * (x.ndim - 3) + [(1, 1), (1, 1), (0, 0)])
    near = xp.concatenate([padded[..., i:i + height:stride, j:j + width:stride, :] for i in range(3) for j in range(3)],
                          axis=-1)
    return xp.maximum(near @ weights + biases, 0)


def find(xp, layers, cells):
    """(…, rows * columns, N): scores of the cells for each object, of which the highest has it."""
    x = cells - 0.5
    for layer in layers[:-1]:
        x = convolve(xp, x, layer)
    scores = x @ layers[-1][0] + layers[-1][1]
    return scores.reshape(*scores.shape[:-3], -1, scores.shape[-1])


def look(xp, layers, pieces, middles):
    """(…, N, OUTPUTS): of objects, from the pieces (…, N, PIECE, PIECE, 3) about the pixels `middles` (…, N, 2).

    What one piece shows is read in the same way for each object, so all learn from each other's pictures. What is hidden
    in it may follow from the others, each in its own way: a tower hides its lower blocks.
    """
    x = pieces - 0.5
    for layer in layers[:2]:
        x = convolve(xp, x, layer, stride=2)
    x = xp.concatenate([x.reshape(*x.shape[:-3], -1), middles / 100 - 1.5], axis=-1)
    x = xp.maximum(x @ layers[2][0] + layers[2][1], 0)
    shown = x @ layers[3][0] + layers[3][1]
    x = x.reshape(*x.shape[:-2], -1)
    x = xp.maximum(x @ layers[4][0] + layers[4][1], 0)
    y = x @ layers[5][0] + layers[5][1]
    return shown + y.reshape(*y.shape[:-1], -1, OUTPUTS)


def sizes_of_find(objects):
    """(inputs, outputs) of its layers."""
    first, second = FILTERS
    return [(27, first), (9 * first, second), (second, objects)]


def sizes_of_look(objects):
    first, second = FILTERS[0], 2 * FILTERS[0]
    seen = (PIECE // 4) ** 2 * second + 2
    return [(27, first), (9 * first, second), (seen, 64), (64, OUTPUTS), (64 * objects, 128), (128, OUTPUTS * objects)]


def middles_of(xp, cells):
    """(…, 2): the pixels in the middles of cells, which are counted along rows."""
    columns = SIZE[1] // CELL
    return (xp.stack([cells % columns, cells // columns], axis=-1) + 0.5) * CELL


def pieces_of(picture, middles, side):
    """(N, side, side, 3): cut out of a picture about pixels (N, 2), black beyond its edges."""
    half = side // 2
    padded = np.pad(picture, [(half, half), (half, half), (0, 0)])
    return np.array([padded[v:v + side, u:u + side] for u, v in middles.astype(int)])


def pixels_of(points, pose, intrinsics):
    """(…, 2): where a camera with a pose (4, 4) or (3, 4) in the world and intrinsics (3, 3) sees points (…, 3)."""
    seen = (points - pose[:3, 3]) @ pose[:3, :3] @ intrinsics.T
    return seen[..., :2] / seen[..., 2:]


def points_of(xp, pixels, heights, pose, intrinsics):
    """(…, 3): the points at these heights (…) that a camera sees at pixels (…, 2)."""
    rays = xp.concatenate([(pixels - intrinsics[:2, 2]) / xp.diag(intrinsics)[:2], xp.ones_like(pixels[..., :1])],
                          axis=-1) @ pose[:3, :3].T
    return pose[:3, 3] + rays * ((heights - pose[2, 3]) / rays[..., 2])[..., None]
