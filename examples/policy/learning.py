"""How a network learns: steps of AdamW on random samples, and the mean of the last weights."""

from functools import partial

import jax
import jax.numpy as jnp
import optax

LEARNING_RATE = 1e-3


def train(name, loss, sizes, samples, steps, seed, batch):
    """Returns the layers of a network, averaged over the last steps.

    name: of the network; loss(layers, key, some samples): a number; sizes: (inputs, outputs) of the layers;
    samples: a NamedTuple of arrays, whose first axes are as long.
    """
    schedule = optax.warmup_cosine_decay_schedule(0, LEARNING_RATE, steps // 10, steps)
    optimizer = optax.chain(optax.clip_by_global_norm(1.0), optax.adamw(schedule, weight_decay=1e-3))
    key = jax.random.key(seed)
    last = len(sizes) - 1
    layers = [(jax.random.normal(jax.random.fold_in(key, k), (a, b)) * (2 / a)**0.5 * (0.1 if k == last else 1),
               jnp.zeros(b)) for k, (a, b) in enumerate(sizes)]

    @partial(jax.jit, donate_argnums=0)
    def some_steps(carry, keys, samples):
        def one_step(carry, key):
            layers, state, mean = carry
            chosen = jax.random.randint(key, (batch,), 0, len(samples[0]))
            error, slope = jax.value_and_grad(loss)(layers, key, type(samples)(*(part[chosen] for part in samples)))
            change, state = optimizer.update(slope, state, layers)
            layers = optax.apply_updates(layers, change)
            return (layers, state, jax.tree.map(lambda m, p: m + 0.002 * (p - m), mean, layers)), error
        return jax.lax.scan(one_step, carry, keys)

    carry = (layers, optimizer.init(layers), jax.tree.map(jnp.copy, layers))
    for k in range(0, steps, 500):
        keys = jax.random.split(jax.random.fold_in(key, 1000 + k), min(500, steps - k))
        carry, errors = some_steps(carry, keys, samples)
    print(f"{name}: loss {float(errors.mean()):.4f}", flush=True)
    return carry[2]
