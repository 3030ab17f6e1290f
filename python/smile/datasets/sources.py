"""Runs that are exported: recordings, with their results if they were imitations."""

from __future__ import annotations

import hashlib
import json
import re
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any


@dataclass(frozen=True)
class Source:
    """A recording, and what is known about it."""

    path: Path
    """as given"""
    recording: Path
    """folder of the recording"""
    result: dict[str, Any] | None
    """`result.json` of an imitation (docs/results.md)"""
    seed: int | None
    """of its layout, if an evaluation or a generation made it"""
    variation: dict[str, Any] | None = None
    """circumstances that a generation drew (docs/generation.md)"""

    @property
    def is_success(self) -> bool | None:
        """None if it is not known."""
        if self.result is None:
            return None
        # Earlier versions of the program called it so.
        return bool(self.result.get("success", self.result.get("rebuilt", False)))

    @property
    def cause(self) -> str:
        """Reason of a failure, in a word; empty if there is none."""
        cause = (self.result or {}).get("cause")
        return str(cause["word"]) if isinstance(cause, dict) and "word" in cause else ""

    def robot_name(self) -> str:
        """Returns the name of the recording's robot; `none` without one."""
        robot = self._info().get("robot")
        return str(robot["name"]) if robot else "none"

    def corrects(self) -> dict[str, Any] | None:
        """Returns which `recording` it corrects and from which time on (`seconds`); None for another one."""
        corrects: dict[str, Any] | None = self._info().get("corrects")
        return corrects

    def _info(self) -> dict[str, Any]:
        info: dict[str, Any] = json.loads((self.recording / "demo.json").read_text())
        return info

    def digest(self) -> str:
        """Returns the identity of the recording: SHA-256 of its scene, commands and trace."""
        whole = hashlib.sha256()
        for name in ("scene.xml", "commands.jsonl", "trace.bin"):
            content = (self.recording / name).read_bytes()
            whole.update(f"{name} {len(content)}\n".encode())
            whole.update(content)
        return whole.hexdigest()


def find_sources(path: Path, include_failed: bool) -> list[Source]:
    """Finds the recordings of a run, see find_source(), or of a folder that `smile generate` wrote: its
    episodes, and its failures only if asked for.

    Raises ValueError if it is neither.
    """
    manifest = path / "manifest.jsonl"
    if not manifest.exists():
        if (path / "generation.json").exists():
            raise ValueError(f"{path}: is a generation that is not complete; continue it with the same command")
        return [find_source(path)]
    sources = []
    for number, line in enumerate(manifest.read_text().splitlines(), 1):
        try:
            attempt = json.loads(line)
            is_wanted = attempt["outcome"] == "success" or include_failed
            if is_wanted and attempt["recording"] is not None and attempt["result_hash"] is not None:
                source = find_source(path / Path(attempt["recording"]).parent)
                sources.append(replace(source, variation=attempt["variation"]))
        except (KeyError, TypeError, json.JSONDecodeError) as error:
            raise ValueError(f"{manifest}:{number}: is no attempt ({error!r}); see `smile generate --help`") from None
    return sources


def find_source(path: Path) -> Source:
    """Finds the recording of a run.

    path  a recording, or a folder that `smile imitate`, `experiment` or `evaluate` wrote, with
          `result.json` and the recording `imitation`

    Raises ValueError if it is neither.
    """
    recording, result_file = path, path.parent / "result.json"
    if not (path / "demo.json").exists():
        recording, result_file = path / "imitation", path / "result.json"
        if not (recording / "demo.json").exists():
            if result_file.exists():
                raise ValueError(f"{path}: has a result, but its recording was not kept; see `smile evaluate "
                                 "--help`")
            found = "is no recording" if path.is_dir() else "does not exist"
            raise ValueError(f"{path}: {found}, expected the folder of a recording or of an imitation")
    result = None
    if recording.name == "imitation" and result_file.exists():
        try:
            result = json.loads(result_file.read_text())
        except ValueError as error:
            raise ValueError(f"{result_file}: {error}") from None
        if not isinstance(result, dict):
            raise ValueError(f"{result_file}: is no result, expected an object")
    seed = re.fullmatch(r"seed-(\d+)", result_file.parent.name) if result is not None else None
    return Source(path, recording, result, int(seed[1]) if seed else None)
