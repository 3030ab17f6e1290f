"""Checks of datasets of arrays, robomimic's and Zarr's, ours or another's.

What readers do with them: robomimic 0.5.0, robomimic/utils/dataset.py; diffusion_policy,
common/replay_buffer.py.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from smile.datasets.doctor import Finding

_AGAIN = "make the dataset again"
_NUMBERS_AT_ONCE = 10_000_000


def examine_robomimic(path: Path) -> Iterator[Finding]:
    """path: of the HDF5 file"""
    return _until_damage(path.name, _robomimic(path))


def examine_zarr(path: Path) -> Iterator[Finding]:
    """path: of the folder of arrays"""
    return _until_damage(path.name, _zarr(path))


def _until_damage(where: str, findings: Iterator[Finding]) -> Iterator[Finding]:
    """Yields findings, up to one that tells of what cannot be read."""
    try:
        yield from findings
    except Exception as error:  # h5py and zarr raise nearly anything for damaged bytes
        yield Finding(True, where, f"cannot be read ({error!r}): it is cut or damaged",
                      "copy it again, or " + _AGAIN)


def _robomimic(path: Path) -> Iterator[Finding]:
    import h5py
    name = path.name
    with h5py.File(path, "r") as file:
        data = file.get("data")
        if not isinstance(data, h5py.Group) or len(data) == 0:
            yield Finding(True, name, "has no group data with episodes", _AGAIN)
            return
        yield from _environment(name, data.attrs)
        lengths = {}
        for episode in data:
            demo = data[episode]
            if not isinstance(demo, h5py.Group) or "actions" not in demo:
                yield Finding(True, episode, "has no actions", "remove the episode, or " + _AGAIN)
                continue
            lengths[episode] = len(demo["actions"])
            yield from _until_damage(episode, _episode(episode, demo, lengths[episode]))
        total = data.attrs.get("total")
        if total is not None and total != sum(lengths.values()):
            yield Finding(True, name, f"total is {total}, but there are {sum(lengths.values())} frames",
                          "correct the number, or add what is missing")
        yield from _masks(file, set(data))
        yield from _spread("actions", (data[episode]["actions"] for episode in lengths))


def _environment(name: str, attributes: Any) -> Iterator[Finding]:
    try:
        json.loads(attributes["env_args"])
    except (KeyError, ValueError, TypeError):
        yield Finding(True, name, "data has no env_args in JSON: robomimic's training begins with them",
                      "write the attribute env_args, with env_name, type and env_kwargs")


def _episode(name: str, demo: Any, length: int) -> Iterator[Finding]:
    import h5py
    expected = demo.attrs.get("num_samples")
    if expected != length:
        yield Finding(True, name, f"num_samples is {expected}, but there are {length} actions: other frames are "
                      "drawn than there are", "write num_samples again")
    if length == 0:
        yield Finding(True, name, "has no frames", "remove the episode")
    arrays: dict[str, Any] = {}
    demo.visititems(lambda path, item: arrays.update({path: item}) if isinstance(item, h5py.Dataset) else None)
    for path, array in arrays.items():
        is_per_frame = path in ("actions", "rewards", "dones", "states") or path.startswith(("obs/", "next_obs/"))
        if is_per_frame and array.shape[:1] != (length,):
            yield Finding(True, name, f"{path} has {len(array)} frames, but there are {length} actions",
                          "remove the episode, or " + _AGAIN)
        elif is_per_frame:
            yield from _numbers(name, path, array)
    if length > 0 and np.abs(demo["actions"][:]).max() > 1:
        yield Finding(False, name, "has actions beyond -1 to 1, which robomimic's policies cannot give",
                      "scale the actions to -1 to 1")


def _masks(file: Any, episodes: set[str]) -> Iterator[Finding]:
    for mask, names in file.get("mask", {}).items():
        missing = sorted({name.decode() for name in names[:]} - episodes)
        if missing:
            yield Finding(True, f"mask/{mask}", f"lists {missing[0]}, which is not there",
                          "remove it from the list")


def _zarr(path: Path) -> Iterator[Finding]:
    import zarr
    root = zarr.open_group(str(path), mode="r")
    if "data" not in root or "meta/episode_ends" not in root:
        yield Finding(True, path.name, "has no data, or no meta/episode_ends", _AGAIN)
        return
    data, ends = root["data"], root["meta/episode_ends"][:].tolist()
    if not ends or any(end <= begin for begin, end in zip([0, *ends], ends)):
        yield Finding(True, "meta/episode_ends", "does not ascend: an episode has no frames",
                      "write it again: for each episode the number of its last frame, and one more")
        return
    for key in sorted(data.array_keys()):
        yield from _until_damage(f"data/{key}", _array(data, key, ends[-1]))
    if "action" not in data:
        yield Finding(True, path.name, "has no data/action", _AGAIN)


def _array(data: Any, key: str, num_frames: int) -> Iterator[Finding]:
    where, array = f"data/{key}", data[key]
    if array.shape[:1] != (num_frames,):
        yield Finding(True, where, f"has {len(array)} frames, but the last episode ends at {num_frames}", _AGAIN)
    elif array.nchunks_initialized < array.nchunks:
        lost = array.nchunks - array.nchunks_initialized
        yield Finding(True, where, f"lacks {lost} of {array.nchunks} chunks, which are read as zeros without a word",
                      "copy the whole folder again, or " + _AGAIN)
    else:
        yield from _numbers(where, key, array)
        if key == "action" and array.ndim == 2:
            yield from _spread(where, [array])


def _numbers(where: str, name: str, array: Any) -> Iterator[Finding]:
    """array: of one row per frame"""
    if array.ndim == 4 and array.shape[3] > 1:
        if array.dtype != np.uint8 or array.shape[3] not in (3, 4):
            yield Finding(True, where, f"{name} has pictures of {array.dtype} with shape {array.shape[1:]}, expected "
                          "uint8 and height, width, channels", "convert the pictures")
        return
    if not np.issubdtype(array.dtype, np.floating):
        return
    step = max(1, _NUMBERS_AT_ONCE // max(1, int(np.prod(array.shape[1:]))))
    for begin in range(0, len(array), step):
        if not np.all(np.isfinite(array[begin:begin + step])):
            yield Finding(True, where, f"{name} has numbers that are not finite: losses become NaN",
                          "leave out the episode, or write these numbers again")
            return


def _spread(where: str, arrays: Any) -> Iterator[Finding]:
    """Finds dimensions that never change."""
    low: npt.NDArray[Any] | None = None
    high: npt.NDArray[Any] | None = None
    for array in arrays:
        rows = array[:]
        if rows.ndim == 2 and len(rows) > 0:
            low = rows.min(0) if low is None else np.minimum(low, rows.min(0))
            high = rows.max(0) if high is None else np.maximum(high, rows.max(0))
    if low is not None and high is not None and np.any(low == high):
        still = ", ".join(str(i) for i in np.flatnonzero(low == high))
        yield Finding(False, where, f"never changes in the dimensions {still}: policies that divide by the standard "
                      "deviation fail", "leave these out (export: --drop-constant)")
