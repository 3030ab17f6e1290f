"""Pictures of cameras."""

from __future__ import annotations

import struct
import zlib
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt


class Picture(NamedTuple):
    """A picture of a camera. Row 0 is the top row; channels that were not requested are None.

    The camera has x right, y down, z forward. Pixel (0, 0) has its center at u = v = 0.5.
    """

    rgb: npt.NDArray[np.uint8] | None
    """(height, width, 3), sRGB"""
    depth: npt.NDArray[np.float32] | None
    """(height, width): distance along the camera's z axis [m]; 0: nothing was hit"""
    id: npt.NDArray[np.uint32] | None
    """(height, width): 1: the table, i + 2: `object_ids[i]` of the simulation, then the robot; 0: nothing"""
    intrinsics: npt.NDArray[np.float64]
    """(3, 3): focal lengths and principal point [px]"""
    pose: npt.NDArray[np.float64]
    """(4, 4): pose of the camera in the world [m]"""

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> npt.NDArray[Any]:
        if self.rgb is None:
            raise ValueError("the picture has no colors, expected the channel 'rgb'")
        return np.array(self.rgb, dtype=dtype, copy=True if copy is None else copy)

    def to_png(self) -> bytes:
        """Returns the colors as a PNG file."""
        if self.rgb is None:
            raise ValueError("the picture has no colors, expected the channel 'rgb'")
        height, width, _ = self.rgb.shape
        # Each row begins with its filter, 0 for none. Source: PNG specification, section 9.
        rows = np.zeros((height, 1 + 3 * width), np.uint8)
        rows[:, 1:] = self.rgb.reshape(height, -1)

        def chunk(kind: bytes, content: bytes) -> bytes:
            checksum = zlib.crc32(kind + content)
            return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", checksum)

        header = struct.pack(">2I5B", width, height, 8, 2, 0, 0, 0)
        return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header)
                + chunk(b"IDAT", zlib.compress(rows.tobytes(), 6)) + chunk(b"IEND", b""))

    def _repr_png_(self) -> bytes:
        return self.to_png()
