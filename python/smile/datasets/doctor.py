"""Checks of datasets, ours or another's, for the faults that users report."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt
import pyarrow as pa

from smile.datasets import language, statistics
from smile.datasets.features import DEFAULTS
from smile.datasets.layout import Layout, LayoutError, ListedEpisode, place_of, read_layout, read_table
from smile.datasets.mp4 import Film, read_film
from smile.datasets.sources import Source

# Tolerance of LeRobot for times [s].
TIME_TOLERANCE = 1e-4


class Finding(NamedTuple):
    """A fault of a dataset."""

    is_error: bool
    """False: it can be read, but may not be what was meant"""
    where: str
    """file, feature or episode"""
    message: str
    advice: str
    """what to do"""

    def __str__(self) -> str:
        return f"{'error' if self.is_error else 'warning'}: {self.where}: {self.message}; {self.advice}"


def examine(folder: Path) -> list[Finding]:
    """Checks a dataset of any format; returns the faults, in the order in which a reader would meet
    them. Those of HDF5 need h5py, those of Zarr zarr, those of MCAP mcap."""
    try:
        format, path = place_of(Path(folder))
        if not format.startswith("lerobot"):
            return list(_examiner_of(format)(path))
        layout = read_layout(path)
    except LayoutError as error:
        return [Finding(True, error.where, error.message, error.advice)]
    checks: list[Callable[[Layout], Iterator[Finding]]] = [
        _features, _counts, _statistics, _frames, find_film_faults, find_recording_faults]
    return [finding for check in checks for finding in check(layout)]


def _examiner_of(format: str) -> Callable[[Path], Iterator[Finding]]:
    # Imported late: they need this module, and packages of their own.
    from smile.datasets import array_doctor, csv_doctor, mcap_doctor
    return {"robomimic": array_doctor.examine_robomimic, "zarr": array_doctor.examine_zarr,
            "mcap": mcap_doctor.examine_mcap, "csv": csv_doctor.examine_csv}[format]


def _features(layout: Layout) -> Iterator[Finding]:
    features = layout.features
    for name, dtype in DEFAULTS.items():
        if name not in features:
            yield Finding(True, "meta/info.json", f"does not declare the feature {name}, which each dataset has",
                          f"add it with dtype {dtype}, shape [1], names null")
    for name, feature in features.items():
        is_picture = feature.get("dtype") in ("video", "image")
        if "/" in name:
            yield Finding(True, name, "has a '/' in its name", "rename the feature")
        if "image" in name and not is_picture:
            yield Finding(True, name, "has 'image' in its name but is none: LeRobot demands statistics of "
                          "pictures", "rename the feature")
        if name.startswith("action") and name != "action":
            yield Finding(False, name, "begins with 'action': policies are trained to output it, too",
                          "rename it, unless that is meant")
        if (name in language.FEATURES) != (feature.get("dtype") == language.DTYPE):
            yield Finding(True, name, f"has the dtype {feature.get('dtype')!r}: of this dtype are "
                          f"{' and '.join(language.FEATURES)}, and no others", "rename the feature, or correct it")
        names = feature.get("names")
        if is_picture and not (isinstance(names, list) and len(names) == 3
                               and names[2] in ("channel", "channels", "width")):
            yield Finding(True, name, f"has the names {names}, with which its axes cannot be told",
                          'set names to ["height", "width", "channels"]')


def _counts(layout: Layout) -> Iterator[Finding]:
    info, episodes = layout.info, layout.episodes
    for name, found in (("total_episodes", len(episodes)), ("total_tasks", len(layout.tasks)),
                        ("total_frames", sum(episode.length for episode in episodes))):
        if info.get(name) != found:
            yield Finding(True, "meta/info.json", f"{name} is {info.get(name)}, but there are {found}",
                          "correct the number, or add what is missing")
    begin = 0
    for number, episode in enumerate(episodes):
        if episode.index != number:
            yield Finding(True, f"episode {number}", f"is listed as episode {episode.index}",
                          "number the episodes from 0 in the order of the list")
            return
        if episode.begin is not None and episode.begin != begin:
            yield Finding(True, f"episode {number}", f"begins at frame {episode.begin} of the dataset, expected "
                          f"{begin}: its index is stale, as after a merge",
                          "write dataset_from_index and dataset_to_index again")
            return
        begin += episode.length


def _statistics(layout: Layout) -> Iterator[Finding]:
    advice = "compute the statistics again"
    if layout.stats is None:
        yield Finding(True, "meta/stats.json", "is missing: pictures and states cannot be normalized", advice)
        return
    # Version 2.1 has no quantiles.
    needed = statistics.NAMES if layout.info["codebase_version"] == "v3.0" else statistics.NAMES[:5]
    for name, feature in layout.features.items():
        if feature.get("dtype") in ("string", "language"):
            continue
        found = layout.stats.get(name, {})
        missing = [word for word in needed if word not in found]
        if missing:
            yield Finding(name not in DEFAULTS, name, f"has no statistics {', '.join(missing)}", advice)
            continue
        numbers = [np.asarray(found[word], float) for word in needed]
        if not all(np.all(np.isfinite(values)) for values in numbers):
            yield Finding(True, name, "has statistics that are not finite", advice)
        elif name in ("observation.state", "action"):
            yield from _constant_dimensions(name, feature, np.atleast_1d(found["std"]))


def _constant_dimensions(name: str, feature: dict[str, Any],
                         deviation: npt.NDArray[np.float64]) -> Iterator[Finding]:
    still = [str(feature["names"][i] if isinstance(feature.get("names"), list) else i)
             for i in np.flatnonzero(deviation == 0)]
    if still:
        yield Finding(False, name, f"never changes in {', '.join(still)}: policies that divide by the standard "
                      "deviation fail", "leave these out (export: --drop-constant)")


def _frames(layout: Layout) -> Iterator[Finding]:
    tables: dict[Path, Any] = {}
    begin = 0
    for episode in layout.episodes:
        if episode.data not in tables:
            try:
                # Episodes of a file follow one another: one table at a time.
                tables = {}
                tables = {episode.data: read_table(layout.folder, episode.data).combine_chunks()}
            except LayoutError as error:
                yield Finding(True, error.where, error.message, error.advice)
                tables = {episode.data: None}
            else:
                yield from _columns(layout, episode, tables[episode.data])
        if tables[episode.data] is not None:
            yield from _frames_of(layout, episode, tables[episode.data], begin)
        begin += episode.length


def _columns(layout: Layout, episode: ListedEpisode, table: Any) -> Iterator[Finding]:
    where = str(episode.data.relative_to(layout.folder))
    declared = {name for name, feature in layout.features.items() if feature.get("dtype") != "video"}
    for name in sorted(set(table.column_names) - declared):
        yield Finding(True, where, f"has the column {name}, which meta/info.json does not declare: no reader "
                      "accepts that", "declare the feature, or remove the column")
    for name in sorted(declared - set(table.column_names)):
        yield Finding(True, where, f"lacks the column {name}, which meta/info.json declares: readers find "
                      "nothing in it", "add the column, or remove the feature")


def _frames_of(layout: Layout, episode: ListedEpisode, table: Any, begin: int) -> Iterator[Finding]:
    where = f"episode {episode.index}"
    if not set(DEFAULTS) <= set(table.column_names):
        return
    rows = np.flatnonzero(table["episode_index"].to_numpy() == episode.index)
    if len(rows) != episode.length:
        yield Finding(True, where, f"has {len(rows)} frames in {episode.data.relative_to(layout.folder)}, but is "
                      f"listed with {episode.length}", "correct its place and length in the list of episodes")
        return
    is_run = len(rows) > 0 and rows[-1] - rows[0] == len(rows) - 1
    part = table.slice(rows[0], len(rows)) if is_run else table.take(rows)
    frames = part["frame_index"].to_numpy()
    if not np.array_equal(frames, np.arange(episode.length)):
        yield Finding(True, where, "has frame_index that does not count from 0", "write frame_index again")
    if not np.array_equal(part["index"].to_numpy(), begin + np.arange(episode.length)):
        yield Finding(True, where, f"has index that does not count from {begin}", "write index again")
    late = np.abs(part["timestamp"].to_numpy() - np.arange(episode.length) / layout.info["fps"])
    if late.max(initial=0) > TIME_TOLERANCE:
        yield Finding(True, where, f"has times that are not frame_index / fps, by up to {late.max():.4f} s: films "
                      "are read at other moments", "write timestamp as frame_index / fps")
    yield from _words_of_frames(layout, where, part)
    for name, feature in layout.features.items():
        if feature.get("dtype") in ("float32", "float64") and name in part.column_names:
            if not _are_finite(part[name]):
                yield Finding(True, where, f"has numbers in {name} that are not finite: losses become NaN",
                              "leave out the episode, or write these numbers again")


def _words_of_frames(layout: Layout, where: str, part: Any) -> Iterator[Finding]:
    """Checks tasks, and the words of subtasks."""
    for name in ("task_index", language.ANNOTATION):
        if name in part.column_names:
            unknown = sorted(set(np.unique(part[name].to_numpy()).tolist()) - set(layout.tasks))
            if unknown:
                found = f"task {unknown[0]}" if name == "task_index" else f"task {unknown[0]} in {name}"
                yield Finding(True, where, f"has the {found}, which is not in the list of tasks", "add the task")
    cameras = [name for name in layout.features if name.startswith("observation.images.")]
    for name in language.FEATURES:
        if name in part.column_names:
            for fault in language.faults_of(name, part[name], part["timestamp"].to_pylist(), cameras):
                yield Finding(True, where, f"has words in {name} that {fault}", "write these words again")
                break


def _are_finite(column: Any) -> bool:
    """column: of numbers, or of lists of numbers"""
    for chunk in column.chunks:
        while pa.types.is_nested(chunk.type):
            chunk = chunk.flatten()
        # A missing number becomes NaN.
        if not np.all(np.isfinite(chunk.to_numpy(zero_copy_only=False))):
            return False
    return True


def find_film_faults(layout: Layout) -> Iterator[Finding]:
    films: dict[Path, Film | None] = {}
    for episode in layout.episodes:
        for part in episode.films.values():
            where = str(part.path.relative_to(layout.folder))
            if part.path not in films:
                films[part.path] = None
                if not part.path.exists():
                    yield Finding(True, where, f"is missing, but episode {episode.index} is in it",
                                  "copy the whole folder again, or make the dataset again")
                    continue
                try:
                    films[part.path] = read_film(part.path)
                except ValueError:
                    yield Finding(True, where, "has no index of a film: its writer was interrupted, or it was cut",
                                  "make the film again")
                    continue
                yield from _film(layout, where, films[part.path])
            film = films[part.path]
            if film is not None:
                yield from _part_of_film(layout, episode, where, part.begin, part.end, film)


def _film(layout: Layout, where: str, film: Film | None) -> Iterator[Finding]:
    assert film is not None
    fps = layout.info["fps"]
    if film.seconds_per_frame is None or abs(film.seconds_per_frame - 1 / fps) > TIME_TOLERANCE:
        rate = "a rate that changes"
        if film.seconds_per_frame:
            rate = f"{1 / film.seconds_per_frame:g} pictures per second"
        yield Finding(True, where, f"has {rate}, but the dataset has {fps}", "make the film again at this rate")
    if not film.is_in_order:
        yield Finding(False, where, "stores pictures in another order than they are shown (B-frames): single "
                      "pictures are read slowly, and the wrong one by some readers",
                      "make the film again without B-frames")


def _part_of_film(layout: Layout, episode: ListedEpisode, where: str, begin: float, end: float,
                  film: Film) -> Iterator[Finding]:
    fps = layout.info["fps"]
    if abs((end - begin) * fps - episode.length) > TIME_TOLERANCE * fps:
        yield Finding(True, f"episode {episode.index}", f"is {episode.length / fps:.3f} s long, but its part of "
                      f"{where} {end - begin:.3f} s", "write from_timestamp and to_timestamp again")
    elif round(end * fps) > film.frames:
        yield Finding(True, f"episode {episode.index}", f"ends at picture {round(end * fps)} of {where}, which "
                      f"has only {film.frames}", "make the film again")
    elif abs(begin * fps - round(begin * fps)) > TIME_TOLERANCE * fps:
        yield Finding(True, f"episode {episode.index}", f"begins at {begin} s of {where}, which is between two "
                      "pictures: sums of rounded times drift", "write from_timestamp as a number of pictures / fps")


def find_recording_faults(layout: Layout) -> Iterator[Finding]:
    """Of a dataset of SMILE: the recordings that it carries are those that it was made from."""
    for episode in layout.episodes:
        folder = layout.folder / f"extras/episode_{episode.index:06d}"
        expected = episode.more.get("smile/recording_sha256")
        if expected is None or not folder.exists():
            continue
        try:
            found = Source(folder, folder, None, None).digest()
        except OSError:
            found = None
        if found != expected:
            yield Finding(True, str(folder.relative_to(layout.folder)), "is not the recording that the episode "
                          "was made from: it was changed", "take the original, or export it again")
