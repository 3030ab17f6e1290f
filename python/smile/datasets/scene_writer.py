"""What writers for viewers have in common: they show the scene itself, beside the features of an episode."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from smile.datasets import statistics
from smile.datasets.episode import Column, Episode
from smile.datasets.features import Camera, features_of
from smile.datasets.pictures import Pictures

MEASURED = ("observation.state", "action")


class SceneWriter:
    """A folder with a file for each episode in the making."""

    def __init__(self, folder: Path, fps: int, cameras: list[Camera], columns: Mapping[str, Column],
                 robot: str) -> None:
        self.features = features_of(columns, cameras, fps)
        self.films = {camera.key: Pictures(camera) for camera in cameras}
        self.folder, self.fps = folder, fps
        self.measured: dict[str, list[npt.NDArray[Any]]] = {name: [] for name in MEASURED if name in columns}
        """states and actions of the episodes so far"""
        self.episode: Episode | None = None
        self.intrinsics: Mapping[str, Any] = {}
        self.num_episodes = self.num_frames = 0

    def observe(self, episode: Episode, intrinsics: Mapping[str, Any]) -> None:
        """Takes the next episode, to be shown in three dimensions, and the matrices of the cameras."""
        self.episode, self.intrinsics = episode, intrinsics

    def finish(self) -> dict[str, statistics.Statistics]:
        """Returns the statistics of states and actions."""
        return {name: statistics.of_rows(np.concatenate(values)) for name, values in self.measured.items()}

    def abandon(self) -> None:
        """Does nothing: no file stays open."""
