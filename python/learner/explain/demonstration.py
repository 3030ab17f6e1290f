"""Reads recordings of demonstrations."""

import json
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from explain.shown_pictures import eye_of
from see.eye import Eye
from things.rotations import upright_at_start


@dataclass
class Demonstration:
    """A recording: the content of its text files (0.txt, 1.txt, ...), and the folder of its
    pictures."""

    folder: Path
    ids: list  # names of the objects
    moves: list  # of each object, Mx7: frame, x y z of its center [units], angles about x, y, z
    #              [degrees], see upright_at_start; the first row is its initial pose
    placed: list  # numbers of the released objects, in the order of release
    events: list  # all lines except moves: frame, word ('grasp', 'release', ...), list of fields
    eye: Eye  # camera of the observing robot
    appearances: dict = None  # of the objects, once they are measured
    segments: list = None  # of each event, the number of its text file; None for pictures alone
    held: set = field(default_factory=set)  # numbers of the objects that hands hold at the end
    unclear: list = field(default_factory=list)  # what was not understood of it, in words: "why A is still held at the end"

    def pose(self, n, frame):
        """Returns the pose of an object before an action of a frame: x y z [units], angles about x,
        y, z [degrees]."""
        rows = self.moves[n]
        return rows[max(np.count_nonzero(rows[:, 0] < frame) - 1, 0), 1:]


def has_texts(folder):
    """Returns true if a recording has texts; without them it has pictures alone."""
    return (Path(folder) / "0.txt").exists()


def read_demonstration(folder):
    """Reads a recording.

    Raises FileNotFoundError if the folder contains none.
    """
    folder = Path(folder)
    ids, moves, placed, events, segments = [], [], [], [], []
    held = {}  # number of the object in each hand
    segment = 0
    while (file := folder / f"{segment}.txt").exists():
        for line in file.read_text().splitlines():
            frame, event, *fields = line.split(",")
            if event == "create":
                ids.append(fields[0])
                moves.append([])
            elif event == "move":
                moves[ids.index(fields[0])].append([float(it) for it in [frame, *fields[1:7]]])
            if event != "move":
                events.append((float(frame), event, fields))
                segments.append(segment)
            if event == "grasp":
                held[fields[0]] = ids.index(fields[1])
            elif event == "release":
                placed.append(held.pop(fields[0]))
            elif event == "destroy":
                held.pop(fields[0], None)
        segment += 1
    if segment == 0:
        raise FileNotFoundError(f"there is no recording in {folder}: it has no 0.txt")
    info = json.loads((folder / "demo.json").read_text())
    moves = [np.array(rows) for rows in moves]
    moves = [np.column_stack([rows[:, 0], upright_at_start(rows[:, 1:])]) for rows in moves]
    held = set(held.values())
    unclear = [f"why {ids[n]} is still held at the end" for n in sorted(held)]
    return Demonstration(folder, ids, moves, placed, events, eye_of(info), segments=segments, held=held, unclear=unclear)
