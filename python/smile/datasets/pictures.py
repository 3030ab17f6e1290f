"""Pictures of an episode, for formats without films."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from smile.datasets.features import Camera
from smile.datasets.lerobot import Row


class Pictures:
    """The pictures of a camera during an episode."""

    def __init__(self, camera: Camera) -> None:
        self.camera = camera
        self.frames: list[npt.NDArray[np.uint8]] = []

    def begin(self) -> Row:
        self.frames = []
        return {}

    def add(self, rgb: npt.NDArray[np.uint8]) -> None:
        self.frames.append(rgb)

    def end(self) -> float:
        return 0.0
