"""The words of subtasks, for each frame, as learners of language read them.

Sources: LeRobot 0.6.1, datasets/language.py, for the two columns of version 3.0; GR00T, "Data preparation", for
annotations that are numbers of tasks.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np
import pyarrow as pa

DTYPE = "language"
PERSISTENT, EVENTS = "language_persistent", "language_events"
FEATURES = {name: {"dtype": DTYPE, "shape": [1], "names": None} for name in (PERSISTENT, EVENTS)}
ANNOTATION = "annotation.sim.subtask"

STYLES = {PERSISTENT: ("subtask", "plan", "memory", "motion", "task_aug"),
          EVENTS: ("interjection", "vqa", "trace", None)}
STYLES_OF_A_CAMERA = ("vqa", "trace")

_EVENT = {"role": pa.string(), "content": pa.string(), "style": pa.string(), "camera": pa.string(),
          "tool_calls": pa.list_(pa.string())}
_STATE = {**dict(list(_EVENT.items())[:3]), "timestamp": pa.float32(), **dict(list(_EVENT.items())[3:])}
TYPES = {PERSISTENT: pa.list_(pa.struct(list(_STATE.items()))), EVENTS: pa.list_(pa.struct(list(_EVENT.items())))}


def rows_of(words: Sequence[str], begins: Sequence[int], fps: int) -> list[dict[str, Any]]:
    """Returns what holds from the begin of each subtask on: the subtask itself, and the plan, the numbered
    list of the subtasks that remain."""
    rows = []
    for number, begin in enumerate(begins):
        plan = "\n".join(f"{i}. {one}" for i, one in enumerate(words[number:], start=1))
        for style, content in (("subtask", words[number]), ("plan", plan)):
            rows.append({"role": "assistant", "content": content, "style": style,
                         "timestamp": np.float32(begin / fps), "camera": None, "tool_calls": None})
    return rows


def arrays_of(rows: Sequence[Mapping[str, Any]], length: int) -> Iterator[tuple[str, pa.Array]]:
    """Yields the columns of an episode: each frame has all rows of it, and no frame an event."""
    for name, content in ((PERSISTENT, list(rows)), (EVENTS, [])):
        yield name, pa.array([content], TYPES[name]).take(pa.array(np.zeros(length, np.int64)))


def faults_of(name: str, column: pa.ChunkedArray, times: Sequence[float], cameras: Sequence[str]) -> Iterator[str]:
    """Yields what is wrong with a column of an episode, as LeRobot would read it.

    times  of the frames [s]
    """
    array = column.combine_chunks()
    rows = array.flatten()
    if not pa.types.is_struct(rows.type):
        yield "are no rows with role, content and style"
        return
    if name == PERSISTENT:
        lengths = array.value_lengths().to_pylist()
        first = array[0].as_py() or [] if len(array) else []
        same = pa.array(np.tile(np.arange(len(first)), len(array)))
        if set(lengths) - {len(first)} or not rows.equals(rows.take(same)):
            yield "differ between frames of the episode, in which all are repeated"
            return
    else:
        first = [row for row in rows.to_pylist() if row is not None]
    known = set(np.asarray(times, np.float32).tolist())
    for row in first:
        if row.get("style") not in STYLES[name]:
            yield f"have the style {row.get('style')!r}, which is none of this column"
        elif not row.get("role"):
            yield f"have no role in {row.get('content')!r}"
        elif name == PERSISTENT and row.get("timestamp") not in known:
            yield f"begin at {row.get('timestamp')} s with {row.get('content')!r}, which is the time of no frame"
        elif row.get("camera") not in (cameras if row["style"] in STYLES_OF_A_CAMERA else [None]):
            yield f"have the camera {row.get('camera')!r} with the style {row.get('style')!r}"
