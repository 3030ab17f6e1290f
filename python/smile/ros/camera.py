"""Pictures of a real camera: sensor_msgs/Image and CameraInfo, of ROS 1 and 2."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from smile.simulation import Floats

_MOST_SIDE = 8192
_CHANNELS = {"rgb8": (3, [0, 1, 2]), "bgr8": (3, [2, 1, 0]), "rgba8": (4, [0, 1, 2]), "bgra8": (4, [2, 1, 0]), "mono8": (1, [0, 0, 0])}
"""bytes of a pixel, and which of them are red, green and blue"""
_DEPTHS = {"16UC1": ("u2", 0.001), "32FC1": ("f4", 1.0)}
"""type of a depth, and its unit [m] (REP 118)"""


def rgb_of(encoding: str, width: int, height: int, step: int, data: bytes) -> npt.NDArray[np.uint8]:
    """Returns the (height, width, 3) picture of an Image message, row 0 on top.

    step  bytes of a row

    Raises ValueError if the message contradicts itself, or its encoding is another one than 8 bits of colors or gray.
    """
    if encoding not in _CHANNELS:
        raise ValueError(f"encoding is {encoding[:40]!r}, expected one of {', '.join(_CHANNELS)}")
    count, order = _CHANNELS[encoding]
    if not (1 <= width <= _MOST_SIDE and 1 <= height <= _MOST_SIDE):
        raise ValueError(f"the picture has {width} x {height} pixels, expected 1 to {_MOST_SIDE} each")
    if step < width * count or len(data) != step * height:
        raise ValueError(f"the picture has {len(data)} bytes in rows of {step}, expected {height} rows of at least {width * count}")
    rows = np.frombuffer(data, np.uint8).reshape(height, step)[:, :width * count]
    return np.ascontiguousarray(rows.reshape(height, width, count)[:, :, order])


def depth_of(encoding: str, width: int, height: int, step: int, is_bigendian: bool, data: bytes) -> npt.NDArray[np.float32]:
    """Returns the (height, width) depths of an Image message [m], 0 where none is known; ValueError as rgb_of()."""
    if encoding not in _DEPTHS:
        raise ValueError(f"encoding is {encoding[:40]!r}, expected one of {', '.join(_DEPTHS)} for depths")
    kind, unit = _DEPTHS[encoding]
    size = np.dtype(kind).itemsize
    if not (1 <= width <= _MOST_SIDE and 1 <= height <= _MOST_SIDE) or step < width * size or len(data) != step * height:
        raise ValueError(f"the depths have {len(data)} bytes in rows of {step}, expected {height} rows of at least {width * size}")
    rows = np.frombuffer(data, np.uint8).reshape(height, step)[:, :width * size]
    depths = np.ascontiguousarray(rows).view((">" if is_bigendian else "<") + kind).astype(np.float32) * np.float32(unit)
    # Cameras report NaN or infinity where they see nothing.
    return np.where(np.isfinite(depths) & (depths > 0), depths, np.float32(0))


def intrinsics_of(model: str, K: Sequence[float], D: Sequence[float]) -> tuple[Floats, Floats]:
    """Returns the (3, 3) matrix [px] and the (5,) distortion of a CameraInfo message; ValueError if it has none."""
    if model != "plumb_bob" or len(D) != 5:
        raise ValueError(f"distortion_model is {model[:40]!r} with {len(D)} numbers, expected plumb_bob with 5")
    if len(K) != 9 or not all(math.isfinite(one) for one in [*K, *D]) or K[0] <= 0 or K[4] <= 0:
        raise ValueError(f"K is {list(K)[:9]}, expected 9 finite numbers with focal lengths above 0: the camera is not calibrated")
    return np.array(K, float).reshape(3, 3), np.array(D, float)


def info_topic_of(topic: str) -> str:
    """Returns the topic of the CameraInfo that belongs to pictures: `camera_info` beside them."""
    return topic.rpartition("/")[0] + "/camera_info"
