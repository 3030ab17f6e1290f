"""Reads the pictures of a dataset, and trains the networks of sight.py on them."""

import json
from typing import NamedTuple

import h5py
import jax
import jax.numpy as jnp
import numpy as np
import optax

import alike
import learning
import network
import sight
from poses import UNIT, places

FIND_STEPS, LOOK_STEPS = 1500, 5000
FIND_BATCH, LOOK_BATCH = 16, 64
HELD_WITHIN = 0.6    # greatest distance of what a closed gripper holds from its tool [units]
LEAST_SHARE = 0.01   # of pictures in which an object lies turned: rarer ones get no more weight
STRAIGHT = 0.2       # greatest sine of four times the yaw of what lies straight, which is 3 degrees
MARGIN = 8           # by which pieces are cut out larger than what is looked at, to displace it [px]


class Views(NamedTuple):
    """Objects as they are seen, a picture in each row."""

    cells: np.ndarray    # (rows, columns, 3), 0 to 255
    cell: np.ndarray     # (N,) in which the middle of each object is
    pieces: np.ndarray   # (N, side, side, 3) about the pixels `middles`, 0 to 255, side = PIECE + 2 MARGIN
    middles: np.ndarray  # (N, 2) in the middles of cells
    wanted: np.ndarray   # (N, OUTPUTS): what `look` should say, its shift from `middles`
    weight: np.ndarray   # (N,) 0 if a gripper holds it, else 1; for `look` more, see `balanced`


def read_views(demo, intrinsics, looks):
    """Returns the Views of an episode."""
    objects = places(demo["obs/object"], network.yaw_of_object)
    pixels = sight.pixels_of(UNIT * objects[..., :3], demo["obs/eye_pose"][0].reshape(3, 4), intrinsics)
    # Which is which of those that look alike cannot be seen: they are counted from left to right.
    order = alike.order_by(np, looks, pixels[..., 0])[..., None]
    objects, pixels = (np.take_along_axis(it, order, axis=1) for it in (objects, pixels))
    # What is beyond an edge is looked for in the nearest cell.
    height, width = sight.SIZE
    inside = np.clip(pixels, 0, [width - 1, height - 1]).astype(int) // sight.CELL
    cell = inside[..., 1] * (width // sight.CELL) + inside[..., 0]
    middles = sight.middles_of(np, cell)
    wanted = np.concatenate([(pixels - middles) / sight.SHIFT_SCALE, objects[..., 2:3],
                             *network.angles(np, objects[..., 3:4], 4)], axis=-1)
    pictures = demo["obs/eye_image"][:]
    cells = sight.cells_of(pictures.astype(np.float32)).astype(np.uint8)
    pieces = np.array([sight.pieces_of(*both, sight.PIECE + 2 * MARGIN) for both in zip(pictures, middles)])
    return Views(cells, cell, pieces, *(it.astype(np.float32) for it in (middles, wanted, ~are_held(demo, objects))))


def are_held(demo, objects):
    """(frames, N): whether a gripper holds them; fingers hide what they hold, and it goes with its tool."""
    tools = places(demo["obs/tool_poses"], network.yaw_of_tool)
    is_closed = demo["obs/state"][:][:, [7, 15]] / UNIT < network.HELD
    away = np.linalg.norm(objects[:, :, None, :3] - tools[:, None, :, :3], axis=-1)
    return ((away < HELD_WITHIN) & is_closed[:, None]).any(axis=-1)


def read(dataset, count, looks):
    """Returns the Views of the first `count` episodes. looks: as of alike.looks_of."""
    about = json.loads((dataset.parent / "smile.json").read_text())
    intrinsics = np.array(about["intrinsics"]["eye"])
    with h5py.File(dataset) as file:
        return [read_views(file[f"data/demo_{k}"], intrinsics, looks) for k in range(count)]


def balanced(views):
    """Weights with which pictures where an object lies turned count as much as those where it lies straight, if they
    are fewer.

    What is first put in its place lies turned in one picture of eight: a network that calls it straight would seldom
    be wrong.
    """
    *_, sine, cosine = np.moveaxis(views.wanted, -1, 0)
    is_turned = (abs(sine) > STRAIGHT) | (cosine < 0)
    share = (views.weight * is_turned).sum(axis=0) / np.maximum(views.weight.sum(axis=0), 1)
    rarity = np.maximum(1, (1 - share) / np.maximum(share, LEAST_SHARE))
    return views._replace(weight=(views.weight * np.where(is_turned, rarity, 1)).astype(np.float32))


def find_loss(layers, key, s):
    scores = sight.find(jnp, layers, s.cells / 255)
    errors = optax.softmax_cross_entropy_with_integer_labels(jnp.moveaxis(scores, -1, -2), s.cell)
    return (s.weight * errors).mean()


def look_loss(layers, key, s):
    """`find` may be a cell off, so pieces are displaced."""
    count = s.cell.shape
    moves = jax.random.randint(key, (*count, 2), -MARGIN, MARGIN + 1)
    cut = jax.vmap(jax.vmap(lambda piece, at: jax.lax.dynamic_slice(
        piece, (at[1] + MARGIN, at[0] + MARGIN, 0), (sight.PIECE, sight.PIECE, 3))))
    said = sight.look(jnp, layers, cut(s.pieces, moves) / 255, s.middles + moves)
    wanted = s.wanted.at[..., :2].add(-moves / sight.SHIFT_SCALE)
    return (s.weight[..., None] * jnp.abs(said - wanted)).mean()


def train_sight(views, scale, seed):
    """Returns the layers of both networks. scale: of the numbers of steps."""
    views = Views(*(np.concatenate(parts) for parts in zip(*views)))
    objects = views.cell.shape[1]
    plans = {"find": (find_loss, sight.sizes_of_find(objects), views, FIND_STEPS, FIND_BATCH),
             "look": (look_loss, sight.sizes_of_look(objects), balanced(views), LOOK_STEPS, LOOK_BATCH)}
    return {name: learning.train(name, loss, sizes, Views(*map(jnp.asarray, some)), max(1, int(scale * steps)), seed, batch)
            for name, (loss, sizes, some, steps, batch) in plans.items()}
