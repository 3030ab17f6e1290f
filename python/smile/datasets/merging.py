"""Joins datasets that were exported in parts."""

from __future__ import annotations

import importlib
import os
import shutil
from collections.abc import Callable, Iterable
from pathlib import Path

from smile.datasets.exporting import Report, constant_of, pixels_of
from smile.datasets.layout import LayoutError, place_of
from smile.datasets.lerobot import Row, Writer, write_json
from smile.datasets.stored import Csv, Stored, Version2, Version3
from smile.datasets.target import new_folder, refuse_existing


def merge(datasets: Iterable[str | os.PathLike[str]], folder: str | os.PathLike[str], *,
          progress: Callable[[str], None] | None = None) -> Report:
    """Joins datasets of the same format in a new one, in this order.

    Episodes and tasks are numbered again, and statistics are computed again from all frames: the result
    differs from a single export of all runs only in how many films there are. The datasets remain.

    Raises ValueError if they were exported in different ways, or something is wrong in one;
    FileExistsError if there is such a folder, OSError if it cannot be written. Nothing is left of it
    then.
    """
    say = progress if progress is not None else lambda _: None
    target = Path(folder)
    refuse_existing(target)
    parts = [_stored(Path(dataset)) for dataset in datasets]
    if not parts:
        raise ValueError("there are no datasets, expected one at least")
    for part in parts:
        _require_same_kind(parts[0], part)
        part.require_sound()
    with new_folder(target) as partial:
        first = parts[0]
        writer = first.new_writer(partial)
        try:
            intrinsics: Row = {}
            for number, part in enumerate(parts):
                say(f"dataset {number + 1} of {len(parts)}: {part.folder}")
                begin = writer.num_episodes
                part.append_to(writer, partial)
                _copy_extras(part.folder / "extras", partial / "extras", begin, writer.num_episodes)
                intrinsics.update(part.about["intrinsics"])
            totals = writer.finish()
        except BaseException:
            writer.abandon()
            raise
        constant = constant_of(writer.features, totals)
        about = {**first.about, "intrinsics": intrinsics, "constant": constant}
        if isinstance(writer, Writer):
            about["pixels"] = pixels_of(writer)
        write_json(partial / first.META, about)
    return Report(target, writer.num_episodes, writer.num_frames, constant)


def _stored(folder: Path) -> Stored:
    try:
        format, _ = place_of(folder)
    except LayoutError as error:
        raise ValueError(f"{folder}: is no dataset that SMILE exported ({error})") from None
    # Imported late: these need packages of their own.
    late = {"robomimic": "robomimic", "zarr": "zarr_arrays", "mcap": "mcap_messages"}
    if format in late:
        kind: type[Stored] = importlib.import_module(f"smile.datasets.{late[format]}").StoredFile
        return kind(folder)
    tables: dict[str, type[Stored]] = {"lerobot-v3.0": Version3, "lerobot-v2.1": Version2, "csv": Csv}
    return tables[format](folder)


def _require_same_kind(first: Stored, other: Stored) -> None:
    expected, found = first.common(), other.common()
    for name, value in expected.items():
        if found.get(name) != value:
            raise ValueError(f"{other.folder}: differs from {first.folder} in {name}, expected datasets of the "
                             "same format, robot, objects, cameras and options")


def _copy_extras(extras: Path, to: Path, begin: int, end: int) -> None:
    """Copies the recordings of a dataset, of which the episodes are now `begin` to `end`."""
    for number in range(begin, end):
        recording = extras / f"episode_{number - begin:06d}"
        if recording.exists():
            copy = to / f"episode_{number:06d}"
            shutil.copytree(recording, copy)
            if recording.with_suffix(".result.json").exists():
                shutil.copy(recording.with_suffix(".result.json"), copy.with_suffix(".result.json"))
