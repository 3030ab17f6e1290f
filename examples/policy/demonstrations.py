"""Reads demonstrations as an arm sees them: what it moves to, and how it goes on."""

import json
from typing import NamedTuple

import h5py
import numpy as np

import network
from poses import UNIT, places

START_WEIGHT = 10          # of samples where both arms wait and then one moves: few, but they decide
AT_REST = 0.02             # how far a tool that waits is from its first place, at most [units]
NEARLY_AT_REST = 0.3       # how far both are where it is decided what comes next [units]
REFERENCE_REACH = 1.6      # how far from an object others are put, middle to middle [units]


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
    site: np.ndarray      # (2,) where on the table it puts down what it holds
    weight: np.ndarray


def is_moving(tools, wanted):
    """Which frames to keep: a policy that sees only the present never ends a pause, so it learns only the last one."""
    moves = np.abs(np.diff(tools, axis=0)).max(axis=(1, 2)) > 0.005
    moves |= np.abs(np.diff(wanted, axis=0)).max(axis=1) > 0.005
    moves = np.append(moves, False)
    moves[np.flatnonzero(moves)[-1] + 1:][:10] = True
    return moves


def away_from_start(tools):
    """(frames, 2): how far tools are from their first places, along the axis in which that is most [units]."""
    return np.abs(tools[..., :3] - tools[0, :, :3]).max(axis=-1)


def targets_of(tools, objects, arm):
    """For each frame, to what an arm moves, the yaw of its tool there, and the place of what it then takes or puts.

    The number of an object, N for the table, -1 for where it waits. It moves to what it takes or puts
    something on next; but it waits as long as the other arm works in between.
    """
    at_rest = away_from_start(tools) < AT_REST
    holds = tools[:, arm, 4] < network.HELD
    targets, yaws, sites = np.full(len(tools), -1), np.zeros(len(tools)), np.zeros((len(tools), 2))
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
        sites[begin:event] = objects[event, held, :2]
        first = event
    return targets, yaws, sites


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
    at_rest = away_from_start(tools).max(axis=1) < NEARLY_AT_REST
    waiting = np.tile(tools[0, None, :, :4], (len(tools), 1, 1))
    samples = []
    for arm in range(2):
        targets, yaws, sites = known[arm]
        on_table = np.pad(sites, ((0, 0), (0, 2)))[:, None]
        spots = np.concatenate([objects, on_table, waiting], axis=1)
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
            rows, turns, sites = [network.mirrored(np, it) for it in rows], -turns, network.mirrored(np, sites)
        others = known[1 - arm][0]
        decision = np.where(targets >= 0, 1 + targets, np.where(others >= 0, 2 + count + others, 0))
        # Where both wait, what comes next is decided already: they wait for good only at the end.
        acts = np.flatnonzero(decision)
        waits = np.flatnonzero(at_rest & (frames < acts[-1]))
        decision[waits] = decision[acts[np.searchsorted(acts, waits)]]
        kind = np.stack([(targets == count) & ~rises, (targets < 0) & ~rises, rises], axis=-1)
        samples.append(Samples(*rows, kind, np.full((len(tools), 1), arm), decision, turns, sites,
                               np.where(at_rest & (decision > 0), START_WEIGHT, 1)))
    return Samples(*(np.concatenate(both).astype(np.float32) for both in zip(*samples)))


def read(dataset):
    """Returns samples of each episode, the objects' names, and the joints at the start."""
    with h5py.File(dataset) as file:
        data = file["data"]
        names = json.loads(data.attrs["names.sim.object_poses"])[::7]
        start = data["demo_0/obs/state"][0, :16].reshape(2, 8)[:, :7]
        episodes = [read_episode(data[f"demo_{k}"]) for k in range(len(data))]
    return episodes, [name.rsplit(".", 1)[0] for name in names], start
