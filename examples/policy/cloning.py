"""Trains the networks that decide what moves, and move it, on demonstrations."""

from functools import partial

import jax
import jax.numpy as jnp
import numpy as np
import optax

import alike
import learning
import network
from demonstrations import Samples

HIDDEN, LAYERS = 256, 3
BATCH = 512
SITE = 0.25  # places on the table are told apart by so much [units]


def displaced(key, own, objects):
    """Displaces tools beside their paths, with what they hold. Returns tools, objects and displacements."""
    keys = jax.random.split(key, 4)
    count = own.shape[0]
    scale = jax.random.choice(keys[0], jnp.array([0, 0.05, 0.3]), (count, 1))
    # Heights tell when to grasp and to release: there, little is changed.
    move = scale * jax.random.normal(keys[1], (count, 4)) * jnp.array([1, 1, 0.1, 1])
    is_near = jnp.linalg.norm(objects[..., :3] - own[:, None, :3] + jnp.array([0, 0, 0.3]), axis=-1) < 0.4
    is_held = (is_near & (own[:, None, 4] < network.HELD))[..., None]
    noise = 0.02 * jax.random.normal(keys[3], objects.shape)
    # A gripper may be anywhere between open and closed while it closes or opens.
    opening = own[:, 4] + jax.random.uniform(keys[2], (count,), minval=-0.14, maxval=0.05)
    opening = jnp.where(own[:, 4] < network.HELD, own[:, 4], jnp.maximum(opening, network.HELD))
    own = jnp.concatenate([own[:, :4] + move, opening[:, None]], axis=-1)
    return own, objects + is_held * move[:, None] + noise, move


def renamed(key, looks, objects, decision):
    """Objects that look alike change their names. Returns the objects, and the decision with the new names."""
    count = objects.shape[1]
    old = alike.order_by(jnp, looks, jax.random.uniform(key, objects.shape[:2]))
    # The table, the last target, keeps its name.
    new = jnp.pad(jnp.argsort(old, axis=1), ((0, 0), (0, 1)), constant_values=count)
    arm, target = jnp.divmod(decision - 1, count + 1)
    decided = 1 + arm * (count + 1) + jnp.take_along_axis(new, target[:, None], axis=1)[:, 0]
    return jnp.take_along_axis(objects, old[..., None], axis=1), jnp.where(decision == 0, 0, decided)


def seen(looks, key, s):
    """What `decide` and `place` get of samples, and the decisions."""
    keys = jax.random.split(key, 3)
    own, objects, _ = displaced(keys[0], s.own, s.objects)
    other, objects, _ = displaced(keys[1], s.other, objects)
    objects, decision = renamed(keys[2], looks, objects, s.decision.astype(int))
    return network.see(jnp, own, other, objects, s.side), decision


def decide_loss(looks, layers, key, s):
    inputs, decision = seen(looks, key, s)
    errors = optax.softmax_cross_entropy_with_integer_labels(network.run(jnp, layers, inputs), decision)
    return (s.weight * errors).mean()


def place_loss(looks, layers, key, s):
    inputs, _ = seen(looks, key, s)
    errors = optax.softmax_cross_entropy_with_integer_labels(network.run(jnp, layers, inputs), s.site.astype(int))
    return (s.kind[:, 0] * errors).mean()


def turn_loss(layers, key, s):
    own, _, _ = displaced(key, s.own, s.objects)
    errors = optax.softmax_cross_entropy_with_integer_labels(
        network.run(jnp, layers, network.aim(jnp, own, s.spot, s.side)), s.turn.astype(int) + network.TURNS)
    return (s.weight * (1 - s.kind[:, 1] - s.kind[:, 2]) * errors).mean()


def move_loss(layers, key, s):
    """The chunk leads back to the path in two steps."""
    own, objects, move = displaced(key, s.own, s.objects)
    back = jnp.minimum(1, jnp.arange(1, network.STEPS + 1) / 2)[:, None] * move[:, None]
    wanted = s.chunk.at[..., :4].add(-back)
    weight = 1 / (0.3 + jnp.linalg.norm(s.chunk[:, -1, :3], axis=-1))
    errors = jnp.abs(network.chunk(jnp, layers, own, objects, s.goal, s.kind, s.side) - wanted)
    return (weight[:, None, None] * errors).mean()


def numbered(samples):
    """Returns the samples with the number of each site instead of the site, and the sites (K, 2)."""
    on_table = samples.kind[:, 0] > 0
    numbers = np.zeros(len(on_table))
    sites, numbers[on_table] = np.unique(np.rint(samples.site[on_table] / SITE), axis=0, return_inverse=True)
    # Where nothing was ever put on the table, there is one site all the same.
    return samples._replace(site=numbers), SITE * sites if len(sites) else np.zeros((1, 2))


def train(samples, looks, steps, seed):
    """Returns the layers of the four networks, and the sites. looks: as of alike.looks_of."""
    samples, sites = numbered(samples)
    one = Samples(*(part[:1] for part in samples))
    targets = samples.objects.shape[1] + 1
    all_seen = network.see(np, one.own, one.other, one.objects, one.side).shape[-1]
    decide, place = (partial(loss, looks) for loss in (decide_loss, place_loss))
    # Loss, inputs, outputs, and steps of each.
    plans = {"decide": (decide, all_seen, 1 + 2 * targets, steps),
             "place": (place, all_seen, len(sites), steps // 2),
             "turn": (turn_loss, network.aim(np, one.own, one.spot, one.side).shape[-1], 1 + 2 * network.TURNS, steps // 2),
             "move": (move_loss, network.approach(np, one.own, one.objects, one.goal, one.kind, one.side).shape[-1],
                      network.STEPS * (network.OUTPUTS + network.SHARES), steps)}
    samples = Samples(*map(jnp.asarray, samples))
    nets = {}
    for name, (loss, inputs, outputs, number) in plans.items():
        widths = [inputs, *[HIDDEN] * LAYERS, outputs]
        nets[name] = learning.train(name, loss, list(zip(widths, widths[1:])), samples, number, seed, BATCH)
    return nets, sites
