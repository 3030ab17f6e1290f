"""Gymnasium environments: any recorded demonstration is a task for a robot.

    import gymnasium, smile.gym
    env = gymnasium.make("smile/Tower-v0")

docs/gym.md describes them. Needs the package gymnasium, which `import smile` does not.
"""

from __future__ import annotations

try:
    import gymnasium as _gymnasium
except ImportError as error:
    raise ImportError("smile.gym needs the package gymnasium: pip install gymnasium") from error

from smile.gym.environment import MAX_EPISODE_STEPS, Environment
from smile.gym.vector import VectorEnv

__all__ = ["IDS", "Environment", "VectorEnv"]

_TASKS = {"Tower": "tower", "Row": "row", "Bridge": "bridge", "Box": "box", "UM": "um",
          "Hatch": "hatch", "Drive": "drive", "Demonstration": None}

IDS: tuple[str, ...] = tuple(f"smile/{name}-v0" for name in _TASKS)
"""Ids for gymnasium.make() and make_vec()."""


def _register() -> None:
    for id, task in zip(IDS, _TASKS.values()):
        if id not in _gymnasium.registry:
            _gymnasium.register(id=id, entry_point="smile.gym.environment:Environment",
                                vector_entry_point="smile.gym.vector:VectorEnv",
                                kwargs={"task": task}, max_episode_steps=MAX_EPISODE_STEPS)


_register()
