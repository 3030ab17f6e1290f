#!/usr/bin/env python3
"""Measures how many steps per second the environments of smile.gym do.

    PYTHONPATH=python:build/release/python:build/gymnasium /usr/bin/python3 tools/measure_gym.py [--rounds N]

Each row: one environment, then a VectorEnv of 8 worlds with 1 and with 2 threads, which do the same actions in
turns. Of many rounds of the same actions, the shortest time of each step counts, since other programs only make
it slower. `times` is 2 threads against 1.
"""

import argparse
import time

import gymnasium
import numpy as np

import smile.gym

ROWS = (("smile/Tower-v0", "tern", "joint_velocities"), ("smile/Tower-v0", "tern", "end_effector"),
        ("smile/Tower-v0", "baxter", "end_effector"), ("smile/UM-v0", "baxter", "end_effector"))
WORLDS = 8


def step_times(envs, actions):
    """Resets, does all actions, and returns the wall-clock and the CPU time of each."""
    envs.reset(seed=1)
    times = []
    for action in actions:
        start, cpu = time.perf_counter(), time.process_time()
        envs.step(action)
        times.append((time.perf_counter() - start, time.process_time() - cpu))
    return np.array(times)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=12, help="of 50 steps each (default 12)")
    rounds = parser.parse_args().rounds
    print("id, robot, control: steps/s of one; of 8 with 1 thread; with 2 threads; times; steps/CPU s of one")
    for id, robot, control in ROWS:
        arguments = {"robot": robot, "control": control}
        single = gymnasium.make(id, disable_env_checker=True, **arguments).unwrapped
        vectors = [smile.gym.VectorEnv(WORLDS, threads=threads, task=single.task, **arguments)
                   for threads in (1, 2)]
        rng = np.random.default_rng(1)
        actions = rng.uniform(-1, 1, (50, *vectors[0].action_space.shape)).astype(np.float32)
        shortest = np.full((3, len(actions), 2), np.inf)
        for _ in range(rounds):
            shortest = np.minimum(shortest, [step_times(single, actions[:, 0]),
                                             *(step_times(envs, actions) for envs in vectors)])
        one, with_one, with_two = len(actions) / shortest.sum(1) * [[1], [WORLDS], [WORLDS]]
        print(f"{id}, {robot}, {control}: {one[0]:.0f}; {with_one[0]:.0f}; {with_two[0]:.0f}; "
              f"{with_two[0] / with_one[0]:.2f}; {one[1]:.0f}", flush=True)


if __name__ == "__main__":
    main()
