"""The objects and the robot of an episode in three dimensions, for formats that viewers show."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
import numpy.typing as npt

from smile.datasets.episode import Episode
from smile.datasets.features import Camera
from smile.native import load

if TYPE_CHECKING:
    from smile import smile_simulator_native as _native
else:
    _native = load("smile_simulator_native")

WORLD = "world"


class Piece(NamedTuple):
    """A mesh of an object or a link, as the simulator tells it."""

    object: str
    frame: int
    choice: int
    """of several variants, which one is shown; -1 if it always is"""
    variant: int
    pose: npt.NDArray[np.float64]
    """(7,) in its frame: x, y, z [m] and a quaternion w, x, y, z"""
    color: npt.NDArray[np.float64]
    """(3,) 0 to 1"""
    corners: npt.NDArray[np.float64]
    """(corners, 3) [m]"""
    triangles: npt.NDArray[np.uint32]
    """(triangles, 3): indices of corners"""


class ScenePieces:
    """All meshes of an episode, and where they are in each of its frames."""

    def __init__(self, episode: Episode) -> None:
        self._ticks = episode.recording.ticks[episode.rows].astype(int).tolist()
        self.pieces = [Piece(*one) for one in _native.pieces_of(episode.recording._native)]
        self._reader = _native.FrameReader(episode.recording._native)
        frames: dict[str, set[int]] = {}
        for piece in self.pieces:
            frames.setdefault(piece.object, set()).add(piece.frame)
        # Parts that move by themselves have frames of their own.
        self.names = {piece.frame: piece.object if len(frames[piece.object]) == 1
                      else f"{piece.object}/{piece.frame}" for piece in self.pieces} | {0: WORLD}
        """of frames of reference by their numbers; 0 is the world"""

    def poses(self, frame: int, cameras: Mapping[str, npt.NDArray[Any]]) -> dict[str, npt.NDArray[np.float64]]:
        """Returns the poses of all that moves and of the cameras in the world, (7,) each, by name.

        cameras: (12,) of each camera: the upper three rows of its pose
        """
        poses, _ = self._reader.state(self._ticks[frame])
        found = {name: np.asarray(poses[number]) for number, name in sorted(self.names.items()) if number > 0}
        for name, rows in cameras.items():
            matrix = np.asarray(rows, float).reshape(3, 4)
            found[name] = np.concatenate([matrix[:, 3], quaternion_of(matrix[:, :3])])
        return found

    def shown(self, frame: int) -> dict[int, list[int]]:
        """Returns the numbers of the pieces that are visible, by their frames of reference."""
        _, variants = self._reader.state(self._ticks[frame])
        shown: dict[int, list[int]] = {}
        for number, piece in enumerate(self.pieces):
            if piece.choice < 0 or variants[piece.choice] == piece.variant:
                shown.setdefault(piece.frame, []).append(number)
        return shown


def quaternion_of(matrix: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    """Returns a rotation as a quaternion w, x, y, z."""
    # The eigenvector of the greatest eigenvalue, which is exact for a rotation and the nearest one for a
    # matrix of rounded numbers. Source: Bar-Itzhack, New method for extracting the quaternion from a
    # rotation matrix, 2000.
    m = matrix
    k = np.array([[m[0, 0] + m[1, 1] + m[2, 2], 0, 0, 0],
                  [m[2, 1] - m[1, 2], m[0, 0] - m[1, 1] - m[2, 2], 0, 0],
                  [m[0, 2] - m[2, 0], m[0, 1] + m[1, 0], m[1, 1] - m[0, 0] - m[2, 2], 0],
                  [m[1, 0] - m[0, 1], m[0, 2] + m[2, 0], m[1, 2] + m[2, 1], m[2, 2] - m[0, 0] - m[1, 1]]])
    q: npt.NDArray[np.float64] = np.linalg.eigh(k)[1][:, -1]  # of the lower triangle
    return q if q[0] >= 0 else -q


def name_of(camera: Camera) -> str:
    """Returns the name of a camera's frame of reference."""
    return f"camera/{camera.name}"
