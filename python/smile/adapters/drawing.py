"""Drawings: what the studio's page draws of a simulator."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from smile.adapters.engine import Floats

# A quarter turn about x: the axis of cylinders is y in pages, and z in most simulators. w, x, y, z
Y_TO_Z = (np.sqrt(0.5), np.sqrt(0.5), 0.0, 0.0)
_NO_TURN = (1.0, 0.0, 0.0, 0.0)


@dataclass(frozen=True)
class Visual:
    """A shape in a frame, which is drawn where the frame is.

    `shape` is `block` (full lengths), `cylinder` (radius, length, sides; about y), `sphere` (radius) or `mesh` (its
    number). Lengths are in meters.
    """

    frame: int
    shape: str
    size: tuple[float, ...]
    color: str
    position: Floats = field(default_factory=lambda: np.zeros(3))
    rotation: Floats = field(default_factory=lambda: np.array(_NO_TURN))
    """w, x, y, z"""


@dataclass(frozen=True)
class Drawing:
    """All shapes of a model. Frame 0 is the world."""

    name: str
    num_frames: int
    frame_of: dict[str, int]
    """frames of the objects that hands can carry, by id"""
    visuals: list[Visual]
    meshes: list[bytes]
    center: Floats
    """what views look at [m]"""
    span: float
    """of the objects [m]"""
    left_out: list[str]
    """what is not drawn, in words"""


def color_of(rgb: Floats) -> str:
    """Returns `#rrggbb`."""
    return "#" + "".join(f"{round(255 * float(np.clip(share, 0, 1))):02x}" for share in rgb[:3])


def mesh_bytes(corners: Floats, normals: Floats) -> bytes:
    """Returns triangles as pages fetch them (docs/studio-protocol.md); (n, 3, 3) corners [m] and their normals."""
    count = 3 * len(corners)
    head = np.array([count, len(corners)], "<u4").tobytes()
    points = corners.astype("<f4").tobytes() + normals.astype("<f4").tobytes()
    return head + points + np.arange(count, dtype="<u4").tobytes()
