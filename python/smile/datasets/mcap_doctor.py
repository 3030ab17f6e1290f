"""Checks of MCAP files, ours or another's."""

from __future__ import annotations

import json
import struct
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from smile.datasets.doctor import Finding

# What reading damaged bytes raises, beside McapError.
FAILURES = (struct.error, ValueError, OSError, MemoryError, OverflowError)
_CUT = "its writer was interrupted before it was finished, or it was cut"


def examine_mcap(path: Path) -> Iterator[Finding]:
    """path: of a file, or of a folder of files"""
    files = [path] if path.is_file() else sorted(path.glob("*.mcap"))
    topics: set[str] | None = None
    for file in files:
        found: set[str] = set()
        yield from _file(file, found)
        if topics is not None and found and found != topics:
            odd = sorted(found ^ topics)[0]
            yield Finding(True, file.name, f"differs from {files[0].name} in the topic {odd}: episodes of a dataset "
                          "have the same", "add the topic, or remove the episode")
        topics = topics or found


def _file(path: Path, topics: set[str]) -> Iterator[Finding]:
    """topics: those of the file are added"""
    from mcap.exceptions import McapError, UnsupportedCompressionError
    from mcap.reader import SeekingReader
    counts: dict[int, int] = {}
    latest: dict[int, int] = {}
    late: set[str] = set()
    bad: set[str] = set()
    with path.open("rb") as stream:
        try:
            # No record is longer than the file, whatever it says.
            reader = SeekingReader(stream, validate_crcs=True, record_size_limit=path.stat().st_size)
            summary = reader.get_summary()
            for schema, channel, message in reader.iter_messages(log_time_order=False):
                topics.add(channel.topic)
                counts[channel.id] = counts.get(channel.id, 0) + 1
                if message.log_time < latest.get(channel.id, 0):
                    late.add(channel.topic)
                latest[channel.id] = message.log_time
                if channel.message_encoding == "json" and not _are_numbers(message.data):
                    bad.add(channel.topic)
        except UnsupportedCompressionError as error:
            yield Finding(True, path.name, f"cannot be read ({error})", "install that package: zstandard or lz4")
            return
        except (McapError, *FAILURES) as error:
            yield Finding(True, path.name, f"cannot be read ({error!r}): {_CUT}",
                          "remove the episode, or make it again")
            return
    if not counts:
        yield Finding(True, path.name, "has no messages", "remove the episode")
    elif summary is None or summary.statistics is None:
        yield Finding(False, path.name, f"has no summary: {_CUT}; viewers must read all of it",
                      "complete it: mcap recover")
    elif summary.statistics.channel_message_counts != counts:
        yield Finding(True, path.name, "has another number of messages than its summary says", "make it again")
    for topic in sorted(late):
        yield Finding(True, path.name, f"{topic} has messages whose times go back", "write it again in order of time")
    for topic in sorted(bad):
        yield Finding(True, path.name, f"{topic} has messages that are not JSON, or numbers that are not finite",
                      "leave out the episode, or write these messages again")


def _are_numbers(data: bytes) -> bool:
    def refuse(word: str) -> Any:
        raise ValueError(word)
    try:
        json.loads(data, parse_constant=refuse)
    except (ValueError, RecursionError):
        return False
    return True
