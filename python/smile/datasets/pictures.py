"""Pictures of an episode, for formats without films."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from smile.datasets import statistics
from smile.datasets.features import Camera
from smile.datasets.lerobot import Row

MAPS = ("depth", "id")


class Pictures:
    """The pictures of a camera during an episode."""

    def __init__(self, camera: Camera) -> None:
        self.camera = camera
        self.begin()

    def begin(self) -> Row:
        self.frames: list[npt.NDArray[np.uint8]] = []
        self.maps: dict[str, list[npt.NDArray[Any]]] = {name: [] for name in self.camera.maps}
        """of each frame: `depth` [m], float32; `id`, uint16"""
        return {}

    def add(self, rgb: npt.NDArray[np.uint8]) -> None:
        self.frames.append(rgb)

    def new_pixels(self) -> statistics.Pixels:
        return statistics.Pixels()

    def add_maps(self, depth: npt.NDArray[np.float32] | None, id: npt.NDArray[np.uint32] | None) -> None:
        """Adds those of the picture that was just added."""
        for name, values in (("depth", depth), ("id", None if id is None else id.astype(np.uint16))):
            if values is not None:
                self.maps[name].append(values)

    def end(self) -> float:
        return 0.0
