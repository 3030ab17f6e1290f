"""The index of an mp4 film, without a decoder.

Source: ISO/IEC 14496-12, sections 8.4 to 8.7.
"""

from __future__ import annotations

import struct
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple


class Film(NamedTuple):
    """The film of a file."""

    frames: int
    seconds_per_frame: float | None
    """None if it changes"""
    is_in_order: bool
    """False if pictures are stored in another order than they are shown"""


def read_film(path: Path) -> Film:
    """Reads the index. Raises ValueError if there is none: the file was not completed, or is no film."""
    content = path.read_bytes()
    try:
        for track in _boxes_at(content, (0, len(content)), b"moov", b"trak"):
            handler = next(_boxes_at(content, track, b"mdia", b"hdlr"))
            if content[handler[0] + 8:handler[0] + 12] == b"vide":
                return _film_of(content, track)
    except (struct.error, StopIteration):
        pass
    raise ValueError(f"{path}: has no index of a film, as if it had not been completed")


def _film_of(content: bytes, track: tuple[int, int]) -> Film:
    header = next(_boxes_at(content, track, b"mdia", b"mdhd"))[0]
    (timescale,) = struct.unpack_from(">I", content, header + (20 if content[header] == 1 else 12))
    table = next(_boxes_at(content, track, b"mdia", b"minf", b"stbl"))
    sizes = next(_boxes_at(content, table, b"stsz"))[0]
    (frames,) = struct.unpack_from(">I", content, sizes + 8)
    times = next(_boxes_at(content, table, b"stts"))[0]
    (entries,) = struct.unpack_from(">I", content, times + 4)
    deltas = {struct.unpack_from(">II", content, times + 8 + 8 * i)[1] for i in range(entries)}
    is_even = len(deltas) == 1 and timescale > 0
    return Film(frames, deltas.pop() / timescale if is_even else None,
                next(_boxes_at(content, table, b"ctts"), None) is None)


def _boxes_at(content: bytes, within: tuple[int, int], *path: bytes) -> Iterator[tuple[int, int]]:
    """Yields begin and end of the contents of the boxes at a path of types."""
    at, end = within
    while at + 8 <= end:
        size, kind = struct.unpack_from(">I4s", content, at)
        begin = at + 8
        if size == 1:
            (size,) = struct.unpack_from(">Q", content, begin)
            begin += 8
        elif size == 0:
            size = end - at
        if size < 8 or at + size > end:
            return
        if kind == path[0]:
            if len(path) == 1:
                yield begin, at + size
            else:
                yield from _boxes_at(content, (begin, at + size), *path[1:])
        at += size
