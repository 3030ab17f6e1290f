"""Features of a LeRobot dataset, and their columns in Parquet."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt
import pyarrow as pa

from smile.datasets import language, statistics
from smile.datasets.episode import Column

DTYPES = {"float32": pa.float32(), "int64": pa.int64(), "bool": pa.bool_()}
# Those that each dataset has, after its own. Source: LeRobot, utils/constants.py.
DEFAULTS = {"timestamp": "float32", "frame_index": "int64", "episode_index": "int64", "index": "int64",
            "task_index": "int64"}


@dataclass(frozen=True)
class Camera:
    """A camera of which films are made."""

    name: str
    width: int
    height: int
    maps: tuple[str, ...] = ()
    """what is stored of each pixel beside its color: `depth`, `id`"""

    @property
    def key(self) -> str:
        return f"observation.images.{self.name}"

    @property
    def depth_key(self) -> str:
        """of the films of its depth, in LeRobot's datasets"""
        return f"{self.key}_depth"


def feature_of(column: Column) -> dict[str, Any]:
    """Describes a column in `info.json`."""
    shape = list(column.values.shape[1:]) or [1]
    return {"dtype": str(column.values.dtype), "shape": shape, "names": column.names}


def film_feature(camera: Camera, fps: int) -> dict[str, Any]:
    """Describes the films of a camera in `info.json`."""
    return {
        "dtype": "video", "shape": [camera.height, camera.width, 3],
        "names": ["height", "width", "channels"],
        "info": {"video.height": camera.height, "video.width": camera.width, "video.codec": "h264",
                 "video.pix_fmt": "yuv420p", "video.is_depth_map": False, "video.fps": fps,
                 "video.channels": 3, "has_audio": False, "is_depth_map": False}}


def depth_feature(camera: Camera, fps: int) -> dict[str, Any]:
    """Describes the films of a camera's depth in `info.json`: a step of brightness is a millimeter."""
    return {
        "dtype": "video", "shape": [camera.height, camera.width, 1],
        "names": ["height", "width", "channels"],
        "info": {"video.height": camera.height, "video.width": camera.width, "video.codec": "hevc",
                 "video.pix_fmt": "gray12le", "video.is_depth_map": True, "video.fps": fps, "video.channels": 1, "has_audio": False,
                 "is_depth_map": True, "depth_unit": "mm", "video.depth_min": 0.0,
                 "video.depth_max": statistics.DEPTH_LEVELS[-1] / 1000, "video.shift": 0.0, "video.use_log": False}}


def features_of(columns: Mapping[str, Column], cameras: list[Camera], fps: int) -> dict[str, Any]:
    """Describes all features in `info.json`."""
    features = {camera.key: film_feature(camera, fps) for camera in cameras}
    features.update({name: feature_of(column) for name, column in columns.items()})
    features.update({name: {"dtype": dtype, "shape": [1], "names": None}
                     for name, dtype in DEFAULTS.items()})
    return features


def schema_of(features: Mapping[str, Any]) -> pa.Schema:
    """Returns the schema of the data files, without columns of language: films have no column."""
    fields = []
    for name, feature in features.items():
        if feature["dtype"] in ("video", language.DTYPE):
            continue
        kind, shape = DTYPES[feature["dtype"]], feature["shape"]
        # Readers expect a number, not a list, of a single dimension.
        fields.append(pa.field(name, kind if shape == [1] else pa.list_(kind, shape[0])))
    return pa.schema(fields)


def array_of(values: npt.NDArray[Any], kind: pa.DataType) -> pa.Array:
    """Returns values as a column of Parquet."""
    if not pa.types.is_fixed_size_list(kind):
        return pa.array(values.reshape(len(values)), kind)
    flat = pa.array(np.ascontiguousarray(values).reshape(-1), kind.value_type)
    return pa.FixedSizeListArray.from_arrays(flat, kind.list_size)
