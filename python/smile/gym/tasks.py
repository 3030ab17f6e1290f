"""Tasks of environments: scene, robot and the goals that a demonstration defines."""

from __future__ import annotations

import os
import tempfile
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import smile
from smile.native import load
from smile.simulation import Model

if TYPE_CHECKING:
    from smile import smile_simulator_native as _native
else:
    _native = load("smile_simulator_native")

# Levels of random layouts, and the positions in the scene file.
LEVELS = ("scattered", "touching", "stacked", "edges", "distractors", "mixed", "fixtures", "piles",
          "scene")


class TaskSource(NamedTuple):
    """What an environment is made of."""

    name: str
    model: Model
    """the robot's scene, before its objects are laid out"""
    goals: Any
    """smile_simulator_native.GoalSpace"""
    level: str
    """of layouts, by default"""


@lru_cache(maxsize=16)
def _load(scene: str, robot: str, search: tuple[str, ...]) -> Model:
    # Models never change: environments share them.
    return smile.load(scene, robot, search)


@lru_cache(maxsize=None)
def _shipped_goals(task: str) -> Any:
    """Demonstrates a shipped task, as `smile experiment` does: the robot that stands there moves its
    arms aside, whatever robot imitates it."""
    with tempfile.TemporaryDirectory(prefix="smile-gym-") as folder:
        directory = Path(folder) / task
        _native.record_demonstration(task, "baxter", directory)
        return _native.GoalSpace(smile.open(directory)._native)


def find_task(task: str | None, demo: str | os.PathLike[str] | None,
              scene: str | os.PathLike[str] | None, robot: str | os.PathLike[str],
              search: tuple[str, ...]) -> TaskSource:
    """Returns a shipped task by name, or that of a demonstration.

    Raises ValueError if there is no such task or something is missing, SceneError if a file is not
    valid.
    """
    if task is None:
        if demo is None or scene is None:
            raise ValueError(f"demo is {demo!r} and scene {scene!r}, expected the folder of a "
                             "recording and the path of a scene file")
        recording = smile.open(demo)
        # A file may change between two environments: read each time.
        model = smile.load(scene, robot, search)
        return TaskSource(recording.title or recording.directory.name, model,
                          _native.GoalSpace(recording._native), "scattered")
    levels = dict(_native.shipped_tasks())
    if task not in levels:
        raise ValueError(f"task is {task!r}, expected one of {', '.join(levels)}")
    if demo is not None:
        raise ValueError(f"demo is {os.fspath(demo)!r} beside the task {task!r}, expected only one "
                         "of them: smile/Demonstration-v0 takes a demo")
    file = _native.data_file(f"scenes/{task}_robot.xml") if scene is None else scene
    model = _load(os.fspath(file), os.fspath(robot), search)
    return TaskSource(task, model, _shipped_goals(task), levels[task])
