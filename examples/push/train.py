"""Trains a policy that pushes a puck to the place that a demonstration showed.

    tools/get_training_packages.sh
    PYTHONPATH=python:build/release/python build/training/bin/python examples/push/train.py OUT

A small network learns by PPO in `smile.gym`, with JAX and Optax on the CPU, in worlds that two threads
step. Then it acts in 100 layouts that it has not seen. Writes into the folder OUT: the demonstration,
policy.npz, curve.csv and curve.svg. docs/gym.md shows the result.

The same seed gives the same policy on one machine, with any number of threads.

PPO: J. Schulman et al., "Proximal Policy Optimization Algorithms" (2017); advantages after J. Schulman et
al., "High-Dimensional Continuous Control Using Generalized Advantage Estimation" (2016).
"""

import argparse
import csv
import time
from pathlib import Path
from typing import NamedTuple

import jax
import jax.numpy as jnp
import numpy as np
import optax

import smile
import smile.gym

FOLDER = Path(__file__).resolve().parent
WORLDS = 16
ROLLOUT = 128            # steps of each world between two updates
EPISODE = 120            # steps, of .1 s
EPOCHS, BATCHES = 8, 4
DISCOUNT, LAMBDA, CLIP = 0.98, 0.95, 0.2
LEARNING_RATE = 5e-4
ENTROPY = 0.001
HIDDEN = 64
HEIGHT = 0.042           # of the tool over the table while it pushes [m]
TEST_LAYOUTS = 100
TEST_SEED = 1_000_000    # training begins at 0, and does not come so far


def demonstrate(folder):
    """A hand puts the puck to its goal. Where it ends is the task: nothing else is on the table."""
    with smile.Simulation(smile.load(FOLDER / "push.xml", robot=None)) as sim:
        sim.record(folder, pictures=False, title="push")
        hand = sim.hand("right")
        hand.grasp("Puck")
        for position in ([-0.3, 0.15, 0.1], [0, 0.1, 0.1], [0, 0.1, 0.04]):
            hand.move_to(position)
            sim.run_until("arrived")
        hand.release()
        sim.run_until("still")
        sim.finish()


class Scene(NamedTuple):
    """What the policy and its reward look at, one row for each world."""

    joints: np.ndarray
    tool: np.ndarray     # position [m]
    puck: np.ndarray     # place on the table [m]
    velocity: np.ndarray  # of the puck [m/s]
    goal: np.ndarray     # of the puck [m]


class Pushing:
    """The task in many worlds. Actions are displacements of the tool along x and y; it stays low, and closed."""

    def __init__(self, demo, worlds, threads):
        self.envs = smile.gym.VectorEnv(worlds, threads=threads, max_episode_steps=EPISODE, task=None,
                                        demo=demo, scene=FOLDER / "push.xml", robot="tern")
        names = self.envs.envs[0].observation_names
        self._joints = [i for i, name in enumerate(names) if name.endswith(".q")]
        self._tool, self._puck, self._velocity = (
            [names.index(name) for name in columns] for columns in (
                ("arm.tool.x", "arm.tool.y", "arm.tool.z"), ("Puck.x", "Puck.y"), ("Puck.vx", "Puck.vy")))

    def scene(self, observations):
        rows = observations["observation"]
        return Scene(rows[:, self._joints], rows[:, self._tool], rows[:, self._puck],
                     rows[:, self._velocity], observations["desired_goal"][:, :2])

    def reset(self, seeds):
        self._scene = self.scene(self.envs.reset(seed=[int(seed) for seed in seeds])[0])
        return features(self._scene)

    def step(self, moves):
        """Returns features, rewards, whether episodes succeeded, and whether they ended."""
        actions = np.zeros(self.envs.action_space.shape, np.float32)
        actions[:, :2] = np.clip(moves, -1, 1)
        actions[:, 2] = np.clip((HEIGHT - self._scene.tool[:, 2]) / 0.05, -1, 1)
        actions[:, 6] = -1
        observations, _, succeeded, truncated, _ = self.envs.step(actions)
        before, self._scene = potential(self._scene), self.scene(observations)
        rewards = potential(self._scene) - before + 5.0 * succeeded - 0.02
        return features(self._scene), rewards, succeeded, succeeded | truncated


def potential(scene):
    """How far a scene is on the way: the puck near its goal, the tool near the puck, behind it."""
    to_goal, to_puck = scene.goal - scene.puck, scene.puck - scene.tool[:, :2]
    distance, reach = np.linalg.norm(to_goal, axis=1), np.linalg.norm(to_puck, axis=1)
    ahead = (to_goal * to_puck).sum(axis=1) / (distance * reach + 1e-6)
    return -10 * distance - 3 * reach + 0.5 * ahead * np.minimum(1, distance / 0.05)


def features(scene):
    """(worlds, n): what the network gets, of the order of 1."""
    to_goal, to_puck = scene.goal - scene.puck, scene.puck - scene.tool[:, :2]
    directions = [v / (np.linalg.norm(v, axis=1, keepdims=True) + 0.01) for v in (to_goal, to_puck)]
    return np.concatenate([scene.joints, scene.tool * [2, 2, 10], scene.puck * 2, to_goal * 4, to_puck * 4,
                           scene.velocity * 4, *directions], axis=1).astype(np.float32)


def make_network(key, inputs, outputs, last_scale):
    """Weights and biases of two hidden layers, orthogonal at first."""
    sizes, layers = (inputs, HIDDEN, HIDDEN, outputs), []
    for i, one in enumerate(jax.random.split(key, 3)):
        scale = last_scale if i == 2 else 2**0.5
        weights = jax.nn.initializers.orthogonal(scale)(one, (sizes[i], sizes[i + 1]))
        layers.append((weights, jnp.zeros(sizes[i + 1])))
    return layers


def run_network(layers, x):
    for weights, biases in layers[:-1]:
        x = jnp.tanh(x @ weights + biases)
    return x @ layers[-1][0] + layers[-1][1]


def log_probability(parameters, mean, moves):
    deviation = parameters["log_deviation"]
    z = (moves - mean) / jnp.exp(deviation)
    return (-0.5 * z**2 - deviation - 0.5 * jnp.log(2 * jnp.pi)).sum(axis=-1)


@jax.jit
def act(parameters, x, key):
    """Returns random moves, their log-probabilities and the values of the states."""
    mean = run_network(parameters["actor"], x)
    moves = mean + jnp.exp(parameters["log_deviation"]) * jax.random.normal(key, mean.shape)
    return moves, log_probability(parameters, mean, moves), run_network(parameters["critic"], x)[:, 0]


best_moves = jax.jit(lambda parameters, x: run_network(parameters["actor"], x))


def loss(parameters, batch):
    x, moves, old, advantages, returns = batch
    ratio = jnp.exp(log_probability(parameters, run_network(parameters["actor"], x), moves) - old)
    gain = jnp.minimum(ratio * advantages, jnp.clip(ratio, 1 - CLIP, 1 + CLIP) * advantages).mean()
    error = ((run_network(parameters["critic"], x)[:, 0] - returns) ** 2).mean()
    return -gain + 0.5 * error - ENTROPY * parameters["log_deviation"].sum()


optimizer = optax.chain(optax.clip_by_global_norm(0.5), optax.adam(LEARNING_RATE))


@jax.jit
def update(parameters, state, samples, key):
    """All epochs over the samples of one rollout."""
    count = samples[0].shape[0]

    def one_batch(carry, chosen):
        parameters, state = carry
        changes, state = optimizer.update(jax.grad(loss)(parameters, [part[chosen] for part in samples]), state)
        return (optax.apply_updates(parameters, changes), state), None

    orders = [jax.random.permutation(one, count) for one in jax.random.split(key, EPOCHS)]
    batches = jnp.concatenate(orders).reshape(EPOCHS * BATCHES, count // BATCHES)
    return jax.lax.scan(one_batch, (parameters, state), batches)[0]


class Learner:
    """A policy, and what it learns from."""

    def __init__(self, task, seed):
        self.task = task
        self.key, actor, critic = jax.random.split(jax.random.key(seed), 3)
        self.x = task.reset(range(WORLDS))
        inputs = self.x.shape[1]
        self.parameters = {"actor": make_network(actor, inputs, 2, 0.01), "critic": make_network(critic, inputs, 1, 1.0),
                           "log_deviation": jnp.full(2, -0.5)}
        self.state = optimizer.init(self.parameters)
        self.is_beginning = np.zeros(WORLDS, bool)  # the next step of a world only begins an episode
        self.outcomes = []                          # of episodes, in order

    def split_key(self):
        self.key, one = jax.random.split(self.key)
        return one

    def learn(self):
        """Acts for a while, then improves the policy."""
        rows = []
        for _ in range(ROLLOUT):
            moves, chances, values = map(np.asarray, act(self.parameters, self.x, self.split_key()))
            following, rewards, succeeded, ended = self.task.step(moves)
            rewards[self.is_beginning] = 0
            rows.append((self.x, moves, chances, values, rewards, ended, self.is_beginning))
            self.outcomes += succeeded[ended].tolist()
            self.x, self.is_beginning = following, ended
        x, moves, chances, values, rewards, ended, beginning = map(np.stack, zip(*rows))
        last = np.asarray(act(self.parameters, self.x, self.key)[2])
        advantages = advantages_of(values, rewards, ended, last)
        used = ~beginning.reshape(-1)
        # The number of samples is constant, so that the update is compiled once.
        chosen = np.resize(np.flatnonzero(used), used.size)
        normed = (advantages - advantages.mean()) / (advantages.std() + 1e-6)
        samples = [part.reshape(used.size, *part.shape[2:])[chosen].astype(np.float32)
                   for part in (x, moves, chances, normed, advantages + values)]
        self.parameters, self.state = update(self.parameters, self.state, samples, self.split_key())

    def recent_success(self):
        return float(np.mean(self.outcomes[-200:])) if self.outcomes else 0.0


def advantages_of(values, rewards, ended, last):
    """(steps, worlds): generalized advantage estimates."""
    result, following, gain = np.zeros_like(values), last, np.zeros_like(last)
    for t in reversed(range(len(values))):
        error = rewards[t] + DISCOUNT * following * ~ended[t] - values[t]
        gain = error + DISCOUNT * LAMBDA * gain * ~ended[t]
        result[t], following = gain, values[t]
    return result


def evaluate(parameters, task, layouts):
    """The share of new layouts in which the policy succeeds, without chance in its actions."""
    successes = 0
    for first in range(0, layouts, WORLDS):
        x = task.reset(range(TEST_SEED + first, TEST_SEED + first + WORLDS))
        succeeded, has_ended = np.zeros(WORLDS, bool), np.zeros(WORLDS, bool)
        for _ in range(EPISODE):
            x, _, success, ended = task.step(np.asarray(best_moves(parameters, x)))
            succeeded |= success & ~has_ended
            has_ended |= ended
        successes += int(succeeded[:layouts - first].sum())
    return successes / layouts


def write_curve(folder, rows):
    """curve.csv and curve.svg: success of the last 200 episodes against steps."""
    with open(folder / "curve.csv", "w", newline="") as file:
        csv.writer(file).writerows([("steps", "seconds", "success"), *rows])
    most = max(row[0] for row in rows)
    points = " ".join(f"{60 + 420 * steps / most:.1f},{220 - 180 * success:.1f}" for steps, _, success in rows)
    grid = "".join(f'<path d="M60 {220 - 180 * level / 4}H480" stroke="#8884"/><text x="52" y="{224 - 180 * level / 4}" '
                   f'text-anchor="end">{level / 4:.0%}</text>' for level in range(5))
    (folder / "curve.svg").write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 520 270" width="520" height="270" role="img">'
        "<title>Success in the last 200 episodes</title><style>text{font:13px sans-serif;fill:#333}"
        "@media(prefers-color-scheme:dark){text{fill:#ddd}}</style>"
        f'<text x="60" y="22">Success in the last 200 episodes</text>{grid}'
        f'<text x="60" y="240" text-anchor="middle">0</text><text x="480" y="240" text-anchor="middle">{most:,}</text>'
        f'<text x="270" y="258" text-anchor="middle">steps ({rows[-1][1]:.0f} s)</text>'
        f'<polyline points="{points}" fill="none" stroke="#1a7fc1" stroke-width="2"/></svg>\n')


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=Path)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--steps", type=int, default=1_500_000, help="at most, of all worlds together")
    parser.add_argument("--enough", type=float, default=0.97, help="success of the last 200 episodes at which to stop")
    parser.add_argument("--layouts", type=int, default=TEST_LAYOUTS)
    parser.add_argument("--threads", type=int, default=2, help="that step the worlds")
    options = parser.parse_args()

    options.out.mkdir(parents=True)
    demonstrate(options.out / "demo")
    task = Pushing(options.out / "demo", WORLDS, options.threads)
    learner, rows, start, steps = Learner(task, options.seed), [], time.monotonic(), 0
    while steps < options.steps and (len(learner.outcomes) < 200 or learner.recent_success() < options.enough):
        learner.learn()
        steps += ROLLOUT * WORLDS
        rows.append((steps, round(time.monotonic() - start, 1), round(learner.recent_success(), 3)))
        if len(rows) % 20 == 0:
            print(f"{steps} steps, {rows[-1][1]:.0f} s: success {rows[-1][2]:.0%}", flush=True)
    cpu = time.process_time()
    np.savez(options.out / "policy.npz", *jax.tree.leaves(learner.parameters["actor"]))
    write_curve(options.out, rows)
    share = evaluate(learner.parameters, task, options.layouts)
    print(f"{steps} steps in {rows[-1][1]:.0f} s, {cpu:.0f} s of CPU time; success in {share:.0%} of "
          f"{options.layouts} new layouts")


if __name__ == "__main__":
    main()
