"""Checks of folders of tables and films, as csv_films writes them."""

from __future__ import annotations

import csv
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from smile.datasets.csv_films import EPISODES, Writer, header_of
from smile.datasets.doctor import Finding, find_film_faults, find_recording_faults
from smile.datasets.layout import FilmPart, Layout, ListedEpisode
from smile.datasets.lerobot import path_of

_AGAIN = "copy the whole folder again, or make the dataset again"


def examine_csv(folder: Path) -> Iterator[Finding]:
    layout = Layout(folder, {})
    try:
        layout.info = json.loads((folder / "info.json").read_text())
        layout.episodes = list(_episodes(layout))
    except (OSError, ValueError, KeyError, TypeError) as error:
        yield Finding(True, f"info.json, {EPISODES}", f"cannot be read ({error!r})", _AGAIN)
        return
    for name, found in (("total_episodes", len(layout.episodes)),
                        ("total_frames", sum(episode.length for episode in layout.episodes))):
        if layout.info.get(name) != found:
            yield Finding(True, "info.json", f"{name} is {layout.info.get(name)}, but there are {found}",
                          "correct the number, or add what is missing")
    header = header_of(layout.features)
    for episode in layout.episodes:
        yield from _table(episode, header)
    yield from find_film_faults(layout)
    yield from find_recording_faults(layout)


def _episodes(layout: Layout) -> Iterator[ListedEpisode]:
    with (layout.folder / EPISODES).open(newline="") as file:
        for row in csv.DictReader(file):
            number, length = int(row["episode_index"]), int(row["length"])
            films = {key: FilmPart(layout.folder / path_of(Writer.FILMS, number, key), 0, length / layout.info["fps"])
                     for key in layout.film_keys}
            more: dict[str, Any] = {name: value for name, value in row.items() if value}
            yield ListedEpisode(number, length, layout.folder / path_of(Writer.DATA, number), None, films, more)


def _table(episode: ListedEpisode, header: list[str]) -> Iterator[Finding]:
    where = episode.data.name
    try:
        with episode.data.open(newline="") as file:
            found, *rows = csv.reader(file)
        numbers = np.array(rows, float).reshape(len(rows), -1)
    except FileNotFoundError:
        yield Finding(True, where, "is missing, but the list of episodes has it", _AGAIN)
        return
    except (OSError, ValueError) as error:
        yield Finding(True, where, f"cannot be read ({error}): its writer was interrupted, or it was cut", _AGAIN)
        return
    if found != header:
        odd = sorted(set(found) ^ set(header)) or ["their order"]
        yield Finding(True, where, f"has other columns than info.json declares, such as {odd[0]}",
                      "declare the feature, or write the table again")
    if len(rows) != episode.length:
        yield Finding(True, where, f"has {len(rows)} frames, but is listed with {episode.length}", _AGAIN)
    elif not np.all(np.isfinite(numbers)):
        yield Finding(True, where, "has numbers that are not finite: losses become NaN",
                      "leave out the episode, or write these numbers again")
