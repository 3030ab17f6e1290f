#!/usr/bin/env python3
"""Measures how many steps per second the environments of smile.gym do.

    PYTHONPATH=python:build/release/python:build/gymnasium /usr/bin/python3 tools/measure_gym.py [--seconds S]

Each row: one environment, then a VectorEnv of 8 worlds with 1 and with 2 threads, which do the same actions in
turns. Of many short rounds, the best of each counts, since other programs only make it slower. `times` is 2
threads against 1.
"""

import argparse
import time

import gymnasium
import numpy as np

import smile.gym

ROWS = (("smile/Tower-v0", "tern", "joint_velocities"), ("smile/Tower-v0", "tern", "end_effector"),
        ("smile/Tower-v0", "baxter", "end_effector"), ("smile/UM-v0", "baxter", "end_effector"))
WORLDS = 8


def rates(envs, actions, worlds):
    """Resets, does all actions, and returns steps per second of wall clock and of CPU time."""
    envs.reset(seed=1)
    start, cpu = time.perf_counter(), time.process_time()
    for action in actions:
        envs.step(action)
    count = worlds * len(actions)
    return count / (time.perf_counter() - start), count / (time.process_time() - cpu)


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
        best = np.zeros(4)
        for _ in range(rounds):
            one, one_cpu = rates(single, actions[:, 0], 1)
            best = np.maximum(best, [one, *(rates(envs, actions, WORLDS)[0] for envs in vectors), one_cpu])
        print(f"{id}, {robot}, {control}: {best[0]:.0f}; {best[1]:.0f}; {best[2]:.0f}; "
              f"{best[2] / best[1]:.2f}; {best[3]:.0f}", flush=True)


if __name__ == "__main__":
    main()
