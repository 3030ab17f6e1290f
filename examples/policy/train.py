"""Trains policies on robot demonstrations that `smile generate` makes of one demonstration by hand.

    tools/get_training_packages.sh
    build/training/bin/python examples/policy/train.py OUT

Behavior cloning with action chunks: networks look at the poses of all objects and of the tools, and say to what an
arm moves, and where its tool should be in the next second, in steps of .1 s. They are trained on growing numbers of
demonstrations, and compared with the learner, which made them, and with a replay of the demonstrated motions, in
layouts that none has seen. With --pictures, further policies are told no poses: two more networks see them in pictures
of the robot's eye. Writes into the folder OUT, where the same command continues: the demonstration `shown`, the
generated demonstrations `made`, the datasets `data` and `pictures`, of each policy weights and program, the
evaluation `compared`, curve.csv and curve.svg. docs/policy.md shows the result.

Action chunks: T. Zhao et al., "Learning Fine-Grained Bimanual Manipulation with Low-Cost Hardware" (2023).
"""

import argparse
import hashlib
import json
import os
import subprocess
import sys
import time
from pathlib import Path
from typing import NamedTuple

import h5py
import jax
import jax.numpy as jnp
import numpy as np
import optax

import curve
import learning
import network
import pictures
import sight
from poses import UNIT, places

FOLDER = Path(__file__).resolve().parent
PROJECT = FOLDER.parents[1]
STEPS = 6000               # of training
HIDDEN, LAYERS = 256, 3
BATCH = 512
TEST_SEED = 500_001        # of the layouts in which policies are evaluated; demonstrations begin at 1
START_WEIGHT = 10          # of samples where both arms wait: few, but they decide
REFERENCE_REACH = 1.6      # how far from an object others are put, middle to middle [units]
ORACLE = ("--oracle", "--size", "64x48")
PICTURE = f"{sight.SIZE[1]}x{sight.SIZE[0]}"


class Samples(NamedTuple):
    """Frames as an arm sees them, one a row."""

    own: np.ndarray       # tools
    other: np.ndarray
    objects: np.ndarray
    spot: np.ndarray      # to which it moves, as it stands
    goal: np.ndarray      # the same with the yaw in which the tool arrives, or above where it has just been
    chunk: np.ndarray     # where the tool is in the next steps
    kind: np.ndarray      # whether the goal is the table, where it waits, and straight up
    side: np.ndarray
    decision: np.ndarray  # 0: none moves; 1 + k: this arm moves to target k; then those of the other arm
    turn: np.ndarray      # quarters between spot and goal
    weight: np.ndarray


def smile(options, *arguments):
    """Runs the program. It exports with this Python, and runs brains with the system's."""
    environment = os.environ | ({"SMILE_PYTHON": sys.executable} if arguments[0] == "export" else {})
    subprocess.run([options.smile, *map(str, arguments)], check=True, stdout=subprocess.DEVNULL, env=environment)


def make_data(options):
    """Demonstrates and generates what is not there yet. Returns the generated demonstrations."""
    shown, made = options.out / "shown", options.out / "made"
    if not shown.exists():
        smile(options, "run", PROJECT / f"scenes/{options.task}.xml", "--kinematic", "--commands",
              PROJECT / f"examples/{options.task}.jsonl", "--record", shown)
    smile(options, "generate", shown, "--scene", PROJECT / f"scenes/{options.task}_robot.xml", *ORACLE, "--brain",
          PROJECT / "python/examples/agents/true_poses.py", "--count", max(options.counts), "--jobs", options.jobs,
          "--out", made)
    return made


def export(options, made, name, camera, fps):
    """Exports what is not there yet. Returns the dataset."""
    data = options.out / name
    if not data.exists():
        smile(options, "export", made, "--to", "robomimic", "--camera", camera, "--fps", fps, "--no-extras",
              "--out", data)
    return data / "demo.hdf5"


def is_moving(tools, wanted):
    """Which frames to keep: a policy that sees only the present never ends a pause, so it learns only the last one."""
    moves = np.abs(np.diff(tools, axis=0)).max(axis=(1, 2)) > 0.005
    moves |= np.abs(np.diff(wanted, axis=0)).max(axis=1) > 0.005
    moves = np.append(moves, False)
    moves[np.flatnonzero(moves)[-1] + 1:][:10] = True
    return moves


def targets_of(tools, objects, arm):
    """For each frame, to what an arm moves, and the yaw of its tool there.

    The number of an object, N for the table, -1 for where it waits. It moves to what it takes or puts
    something on next; but it waits as long as the other arm works in between.
    """
    at_rest = np.abs(tools[..., :3] - tools[0, :, :3]).max(axis=-1) < 0.02
    holds = tools[:, arm, 4] < network.HELD
    targets, yaws = np.full(len(tools), -1), np.zeros(len(tools))
    first = 0
    for event in np.flatnonzero(np.diff(holds)) + 1:
        away = np.linalg.norm(objects[event, :, :3] - tools[event, arm, :3], axis=-1)
        held = away.argmin()
        target = held
        if not holds[event]:
            below = np.linalg.norm(objects[event, :, :3] - objects[event, held, :3], axis=-1)
            below[held] = np.inf
            target = below.argmin() if below.min() < REFERENCE_REACH else len(objects[0])
        waits = first + np.flatnonzero(at_rest[first:event, arm] & ~at_rest[first:event, 1 - arm])
        begin = waits[-1] + 1 if len(waits) else first
        returns = begin + np.flatnonzero(at_rest[begin:event, arm] & ~np.append(True, at_rest[begin:event - 1, arm]))
        begin = returns[-1] if len(returns) else begin
        targets[begin:event], yaws[begin:event] = target, tools[event, arm, 3]
        first = event
    return targets, yaws


def rises_of(tools, arm):
    """For each frame, in which an arm rises from its last grasp or release: when that was, and when it is up; else -1."""
    holds = tools[:, arm, 4] < network.HELD
    begin, end = np.full(len(tools), -1), np.full(len(tools), -1)
    for event in np.flatnonzero(np.diff(holds)) + 1:
        is_up = tools[event:, arm, 2] > tools[event, arm, 2] + network.RISE
        up = event + int(is_up.argmax()) if is_up.any() else len(tools) - 1
        begin[event:up], end[event:up] = event, up
    return begin, end


def read_episode(demo):
    """Samples of both arms, each seen as by a left arm."""
    state, commands = demo["obs/state"][:], demo["unscaled_actions"][:]
    grippers = [7, 15]
    tools = places(demo["obs/tool_poses"], network.yaw_of_tool)
    tools[..., 3] = np.unwrap(tools[..., 3], axis=0)
    tools = np.concatenate([tools, state[:, grippers, None] / UNIT], axis=-1)
    wanted = commands[:, grippers] / UNIT
    objects = places(demo["obs/object"], network.yaw_of_object)
    moves = is_moving(tools, wanted)
    tools, wanted, objects = tools[moves], wanted[moves], objects[moves]
    steps = np.arange(len(tools))[:, None] + np.arange(network.STEPS)
    last = len(tools) - 1
    known = [targets_of(tools, objects, arm) for arm in range(2)]
    frames, count = np.arange(len(tools)), objects.shape[1]
    table, waiting = np.zeros((len(tools), 1, 4)), np.tile(tools[0, None, :, :4], (len(tools), 1, 1))
    spots = np.concatenate([objects, table, waiting], axis=1)
    samples = []
    for arm in range(2):
        targets, yaws = known[arm]
        goal = spots[frames, np.where(targets < 0, count + 1 + arm, targets)]
        turns = np.where(targets < 0, 0, np.rint((yaws - goal[:, 3]) / (np.pi / 2)))
        spot = goal.copy()
        goal[:, 3] += turns * np.pi / 2
        # Where it goes once it is up is another goal's matter.
        begin, end = rises_of(tools, arm)
        rises = begin >= 0
        goal[rises] = tools[begin[rises], arm, :4] + [0, 0, network.RISE, 0]
        until = np.where(rises, end, last)[:, None]
        later, now = np.minimum(steps + 1, until), np.minimum(steps, until)
        chunk = np.concatenate([tools[later, arm, :4] - tools[:, None, arm, :4],
                                ((wanted[now, arm] - network.OPENING) * network.OPENING_SCALE)[..., None]], axis=-1)
        rows = [tools[:, arm], tools[:, 1 - arm], objects, spot, goal, chunk]
        if arm == 1:
            rows, turns = [network.mirrored(np, it) for it in rows], -turns
        others = known[1 - arm][0]
        decision = np.where(targets >= 0, 1 + targets, np.where(others >= 0, 2 + count + others, 0))
        at_rest = (np.abs(tools[..., :3] - tools[0, :, :3]).max(axis=(1, 2)) < 0.02)
        kind = np.stack([(targets == count) & ~rises, (targets < 0) & ~rises, rises], axis=-1)
        samples.append(Samples(*rows, kind, np.full((len(tools), 1), arm), decision, turns,
                               np.where(at_rest, START_WEIGHT, 1)))
    return Samples(*(np.concatenate(both).astype(np.float32) for both in zip(*samples)))


def read(dataset):
    """Returns samples of each episode, the objects' names, and the joints at the start."""
    with h5py.File(dataset) as file:
        data = file["data"]
        names = json.loads(data.attrs["names.sim.object_poses"])[::7]
        start = data["demo_0/obs/state"][0, :16].reshape(2, 8)[:, :7]
        episodes = [read_episode(data[f"demo_{k}"]) for k in range(len(data))]
    return episodes, [name.rsplit(".", 1)[0] for name in names], start


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


def decide_loss(layers, key, s):
    own, objects, _ = displaced(key, s.own, s.objects)
    other, objects, _ = displaced(jax.random.fold_in(key, 1), s.other, objects)
    errors = optax.softmax_cross_entropy_with_integer_labels(
        network.run(jnp, layers, network.see(jnp, own, other, objects, s.side)), s.decision.astype(int))
    return (s.weight * errors).mean()


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


def train_all(samples, steps, seed):
    """Returns the layers of the three networks."""
    one = Samples(*(part[:1] for part in samples))
    targets = samples.objects.shape[1] + 1
    inputs = {"decide": network.see(np, one.own, one.other, one.objects, one.side).shape[-1],
              "turn": network.aim(np, one.own, one.spot, one.side).shape[-1],
              "move": network.approach(np, one.own, one.objects, one.goal, one.kind, one.side).shape[-1]}
    outputs = {"decide": 1 + 2 * targets, "turn": 1 + 2 * network.TURNS,
               "move": network.STEPS * (network.OUTPUTS + network.SHARES)}
    losses = {"decide": decide_loss, "turn": turn_loss, "move": move_loss}
    samples = Samples(*map(jnp.asarray, samples))
    nets = {}
    for name, loss in losses.items():
        widths = [inputs[name], *[HIDDEN] * LAYERS, outputs[name]]
        nets[name] = learning.train(loss, list(zip(widths, widths[1:])), samples,
                                    steps // 2 if name == "turn" else steps, seed, BATCH)
    return nets


def write_policy(path, nets, names, start):
    """Weights, and a program that acts with them."""
    arrays = {f"{net}_{kind}{k}": np.asarray(it) for net, layers in nets.items() for k, both in enumerate(layers)
              for kind, it in zip(("weights", "biases"), both)}
    np.savez(path.with_suffix(".npz"), names=names, start=start, nets=list(nets), **arrays)
    used = (path.with_suffix(".npz"), *(FOLDER / f"{name}.py" for name in ("policy", "network", "eye", "sight")))
    identity = hashlib.sha256(b"".join(it.read_bytes() for it in used)).hexdigest()
    path.with_suffix(".py").write_text(
        # `evaluate` keeps the finished runs of a program that has not changed.
        f"# With {identity}\nimport sys\n\nsys.path.append({str(FOLDER)!r})\nfrom policy import Policy\n\n"
        f"init, step = Policy({str(path.with_suffix('.npz').resolve())!r}).functions()\n")


def evaluate(options, policies):
    """Returns the summary of each brain, by its name."""
    brains = [*policies, PROJECT / "python/learner/learner.py", PROJECT / "python/examples/agents/replay.py"]
    smile(options, "evaluate", options.out / "shown", "--scene", PROJECT / f"scenes/{options.task}_robot.xml",
          "--oracle", "--size", PICTURE, "--scenes", options.layouts, "--seed", TEST_SEED,
          "--seconds", options.seconds, "--jobs", options.jobs, "--out", options.out / "compared",
          *(part for brain in brains for part in ("--brain", brain)))
    found = json.loads((options.out / "compared/evaluation.json").read_text())["brains"]
    return {one["name"]: one["summary"] for one in found}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=Path)
    parser.add_argument("--task", choices=("tower", "row"), default="tower")
    parser.add_argument("--counts", type=int, nargs="+", default=[50, 200, 1000], help="of demonstrations")
    parser.add_argument("--pictures", action="store_true", help="train policies that see pictures, too")
    parser.add_argument("--steps", type=int, default=STEPS, help="of training, of each policy")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--layouts", type=int, default=40)
    parser.add_argument("--seconds", type=int, default=60, help="limit of a run")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--smile", type=Path, default=PROJECT / "build/release/bin/smile")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)

    made = make_data(options)
    episodes, names, start = read(export(options, made, "data", "none", 60 // network.STEP_TICKS))
    views = []
    if options.pictures:
        seen = export(options, made, "pictures", f"eye:{PICTURE}", 1)
        views = pictures.read(seen, max(options.counts))
    policies = []
    for count in options.counts:
        begun = time.monotonic(), time.process_time()
        samples = Samples(*(np.concatenate(parts) for parts in zip(*episodes[:count])))
        nets = train_all(samples, options.steps, options.seed)
        policies.append(options.out / f"state_{count}.py")
        write_policy(policies[-1], nets, names, start)
        print(f"{count} demonstrations, {len(samples.own)} samples: {time.monotonic() - begun[0]:.0f} s, "
              f"{time.process_time() - begun[1]:.0f} s of CPU time", flush=True)
        if options.pictures:
            nets |= pictures.train_sight(views[:count], options.steps / STEPS, options.seed)
            policies.append(options.out / f"pictures_{count}.py")
            write_policy(policies[-1], nets, names, start)
            print(f"with the networks that see: {time.monotonic() - begun[0]:.0f} s, "
                  f"{time.process_time() - begun[1]:.0f} s of CPU time", flush=True)
    summaries = evaluate(options, policies)
    curve.write(options.out, summaries)
    for name, each in summaries.items():
        low, high = each["success_interval"]
        print(f"{name}: {each['successes']} of {each['runs']}, 95 %: {100 * low:.1f} to {100 * high:.1f} %")


if __name__ == "__main__":
    main()
