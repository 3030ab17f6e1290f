"""Vector environment: worlds in one process, stepped by threads."""

from __future__ import annotations

import os
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING, Any

import gymnasium
import numpy as np
import numpy.typing as npt
from gymnasium.vector import AutoresetMode
from gymnasium.vector.utils import batch_space, concatenate, create_empty_array

from smile.gym.environment import MAX_EPISODE_STEPS, Environment, Measured
from smile.native import load

if TYPE_CHECKING:
    from smile import smile_simulator_native as _native
else:
    _native = load("smile_simulator_native")

Flags = npt.NDArray[np.bool_]


class VectorEnv(gymnasium.vector.VectorEnv[dict[str, Any], npt.NDArray[np.float32], Any]):
    """N environments in one process; threads step their worlds at the same time.

    num_envs  number of environments
    threads   number of threads (default: one per core, at most num_envs); the results are the same
              with any number
    max_episode_steps  steps after which an episode is truncated
    kwargs    arguments of Environment

    Each environment is as gymnasium.make() makes it, with the seeds `seed`, `seed + 1`, …. An
    environment whose episode has ended begins the next one in the next step, which ignores its
    action and has the reward 0 (autoreset mode NEXT_STEP).
    """

    def __init__(self, num_envs: int = 1, *, threads: int | None = None,
                 max_episode_steps: int = MAX_EPISODE_STEPS, **kwargs: Any) -> None:
        for name, value in (("num_envs", num_envs), ("threads", threads),
                            ("max_episode_steps", max_episode_steps)):
            if value is not None and (not isinstance(value, int) or value < 1):
                raise ValueError(f"{name} is {value!r}, expected a whole number above 0")
        if kwargs.get("render_mode") == "human":
            raise ValueError("render_mode is 'human', expected 'rgb_array' or None for several worlds")
        self.num_envs = num_envs
        num_threads = min(threads or os.cpu_count() or 1, num_envs)
        self._max_episode_steps = max_episode_steps
        self.envs = [Environment(**kwargs) for _ in range(num_envs)]
        first = self.envs[0]
        self.metadata = {**first.metadata, "autoreset_mode": AutoresetMode.NEXT_STEP}
        self.render_mode = first.render_mode
        self.single_action_space = first.action_space
        self.single_observation_space = first.observation_space
        self.action_space = batch_space(first.action_space, num_envs)
        self.observation_space = batch_space(first.observation_space, num_envs)
        # The team steps; what Python does in threads, as resets and pictures, the pool does.
        self._team = _native.ThreadTeam(num_threads)
        self._pool = ThreadPoolExecutor(num_threads)
        self._steps = np.zeros(num_envs, int)
        self._has_ended: Flags = np.zeros(num_envs, bool)

    @property  # type: ignore[misc]
    def np_random(self) -> Any:
        """The generators of the environments."""
        return tuple(env.np_random for env in self.envs)

    @property
    def np_random_seed(self) -> Any:
        """The seeds of the environments."""
        return tuple(env.np_random_seed for env in self.envs)

    def reset(self, *, seed: int | Sequence[int | None] | None = None,
              options: dict[str, Any] | None = None) -> tuple[dict[str, Any], dict[str, Any]]:
        """Begins an episode in all environments, see Environment.reset()."""
        if seed is None or isinstance(seed, (int, np.integer)):
            seeds: list[int | None] = [None if seed is None else int(seed) + i
                                       for i in range(self.num_envs)]
        else:
            seeds = list(seed)
        if len(seeds) != self.num_envs:
            raise ValueError(f"seed has {len(seeds)} numbers, expected {self.num_envs}")
        list(self._pool.map(lambda env, one: env._restart(one, options), self.envs, seeds))
        self._steps[:] = 0
        self._has_ended[:] = False
        measured = _in_order(range(self.num_envs), [env._measure() for env in self.envs])
        return self._told(measured)

    def step(self, actions: npt.ArrayLike) -> tuple[dict[str, Any], npt.NDArray[np.float64], Flags,
                                                     Flags, dict[str, Any]]:
        """Steps all environments: actions (num_envs, n)."""
        rows = np.asarray(actions, float)
        if rows.shape != self.action_space.shape:
            raise ValueError(f"actions has shape {rows.shape}, expected {self.action_space.shape}")
        restarts = self._has_ended
        measured = self._restarted_or_stepped(rows) if restarts.any() else self._stepped(self.envs, rows)
        rewards = np.where(restarts, 0.0, self.envs[0]._rewards(measured))
        terminated = (measured.scores[:, 0] == 1) & ~restarts
        self._steps = np.where(restarts, 0, self._steps + 1)
        truncated = self._steps >= self._max_episode_steps
        self._has_ended = terminated | truncated
        observations, infos = self._told(measured)
        return observations, rewards, terminated, truncated, infos

    def _stepped(self, envs: Sequence[Environment], actions: npt.NDArray[np.float64]) -> Measured:
        return Measured(*_native.step_episodes([env._episode for env in envs], actions, self._team))

    def _restarted_or_stepped(self, actions: npt.NDArray[np.float64]) -> Measured:
        """Restarts the environments whose episodes have ended, and steps the others."""
        going, ended = np.flatnonzero(~self._has_ended), np.flatnonzero(self._has_ended)
        restarts = [self._pool.submit(self.envs[i]._restart) for i in ended]
        parts = [self._stepped([self.envs[i] for i in going], actions[going])] if going.size > 0 else []
        for i, restart in zip(ended, restarts):
            restart.result()
            parts.append(self.envs[i]._measure())
        return _in_order([*going, *ended], parts)

    def _told(self, measured: Measured) -> tuple[dict[str, Any], dict[str, Any]]:
        """Returns the observations and infos of all environments."""
        first = self.envs[0]
        observations = first._numbers(measured)
        if first._cameras:
            # Threads draw the pictures, too.
            pictures = list(self._pool.map(lambda env: env._pictures(), self.envs))
            space = first._picture_space
            batch: Any = create_empty_array(space, self.num_envs)
            batched: Any = concatenate(space, pictures, batch)
            observations.update(batched)
        infos: dict[str, Any] = {}
        for name, values in measured.infos().items():
            infos.update({name: values, f"_{name}": np.ones(self.num_envs, bool)})
        for i, refusal in enumerate(measured.refusals):
            if refusal is not None:
                infos = self._add_info(infos, {"refused": refusal}, i)
        return observations, infos

    def call(self, name: str, *args: Any, **kwargs: Any) -> tuple[Any, ...]:
        """Calls a method of each environment, or gets an attribute."""
        values = [getattr(env, name) for env in self.envs]
        return tuple(value(*args, **kwargs) if callable(value) else value for value in values)

    def get_attr(self, name: str) -> tuple[Any, ...]:
        """Returns an attribute of each environment."""
        return tuple(getattr(env, name) for env in self.envs)

    def render(self) -> tuple[Any, ...] | None:
        """Returns a picture of each environment, or None without a render_mode."""
        if self.render_mode is None:
            return None
        return tuple(self._pool.map(lambda env: env.render(), self.envs))

    def close_extras(self, **kwargs: Any) -> None:
        for env in self.envs:
            env.close()
        self._pool.shutdown()


def _in_order(indices: Sequence[int], parts: list[Measured]) -> Measured:
    """Joins what was measured of some environments, in the order of their indices."""
    order = np.argsort(indices)
    refusals = [refusal for part in parts for refusal in part.refusals]
    observations, achieved, desired, scores = (
        np.concatenate([part[column] for part in parts])[order] for column in range(4))
    refusals = [refusal for part in parts for refusal in part.refusals]
    return Measured(observations, achieved, desired, scores, [refusals[i] for i in order])
