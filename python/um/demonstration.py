"""From a recording to the steps of what was built in it."""

import json
import math
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from PIL import Image

from blocks import Step
from looking import Eye, describe_face, is_color, label_regions, onto_plane, pixel_at
from places import footprint, overlap


@dataclass
class Demonstration:
    """What a recording tells: its text files (0.txt, 1.txt, ...), and where its pictures are."""

    folder: Path
    ids: list  # names of the objects
    moves: list  # of each object, Mx7: frame, x y z of its centre [units], angles about x, y, z
    #              [degrees]; the first row tells where it was at the beginning
    placed: list  # numbers of the objects that a hand let go of, in that order
    eye: Eye  # of the robot that watched


def read_demonstration(folder):
    folder = Path(folder)
    ids, moves, placed = [], [], []
    held = {}  # which object is in which hand
    segment = 0
    while (file := folder / f"{segment}.txt").exists():
        for line in file.read_text().splitlines():
            frame, event, *fields = line.split(",")
            if event == "create":
                ids.append(fields[0])
                moves.append([])
            elif event == "move":
                moves[ids.index(fields[0])].append([float(it) for it in [frame, *fields[1:7]]])
            elif event == "grasp":
                held[fields[0]] = ids.index(fields[1])
            elif event == "release":
                placed.append(held[fields[0]])
        segment += 1
    if segment == 0:
        raise FileNotFoundError(f"there is no recording in {folder}: it has no 0.txt")
    info = json.loads((folder / "demo.json").read_text())
    return Demonstration(folder, ids, [np.array(rows) for rows in moves], placed, eye_of(info))


def eye_of(info):
    eye = info["eye"]
    w, x, y, z = eye["rotation_wxyz"]  # a unit quaternion
    v = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])  # v @ a is the cross product with a
    pose = np.eye(4)
    pose[:3, :3] += 2 * w * v + 2 * v @ v
    pose[:3, 3] = np.array(eye["position_m"]) / info["meters_per_unit"]
    return Eye(np.array([[eye["fx"], 0, eye["cx"]], [0, eye["fy"], eye["cy"]], [0, 0, 1]]), pose)


def understand(demo, attention):
    """What was built, as a list of steps in the order of building, one for each object that takes
    part.

    attention: which properties of objects the demonstrator said to matter, as in aux.
    """
    steps = []
    pictures = {}  # those already read
    for n in taking_part(demo):
        name = demo.ids[n]
        color, size = measure_object(demo, n, pictures)
        if not color_matters(attention, name):
            color = None
        _, x, y, z, _, _, degrees = demo.moves[n][-1]
        yaw = math.radians(degrees)
        if size[1] > 1.1 * size[0]:
            size = size[[1, 0, 2]]
            yaw += math.pi / 2
        step = Step(color, size, np.array([x, y, z]), yaw, name, [])
        step.on = [k for k, lower in enumerate(steps) if stands_on(step, lower)]
        steps.append(step)
    return steps


def taking_part(demo):
    """Numbers of the objects that take part, in the order of building: first what was not moved but
    has something on it, then what was, in the order in which it was let go for the last time."""
    last = {n: when for when, n in enumerate(demo.placed)}
    moved = sorted(last, key=last.get)
    if not moved:
        raise ValueError("in this demonstration no hand moved anything")
    final = np.array([rows[-1, 1:4] for rows in demo.moves])
    below = []
    for n in range(len(demo.ids)):
        gap = final[moved] - final[n]
        carries = (gap[:, 2] > 0.4) & (gap[:, 2] < 1.6) & (np.hypot(gap[:, 0], gap[:, 1]) < 0.7)
        if n not in moved and carries.any():
            below.append(n)
    return below + moved


def measure_object(demo, n, pictures):
    """What an object of the demonstration looks like, from its pictures: the log tells where each
    object is in each picture, so its top can be found there.

    Returns its color, 3 numbers from 0 to 1, and its size along its own x, y and z axes [units].
    """
    height = 2 * demo.moves[n][0, 3]  # it began on the table
    for frame, *pose in worth_looking(demo.moves[n]):
        if frame not in pictures:
            pictures[frame] = read_picture(demo.folder, int(frame))
        top = measure_top(pictures[frame], demo.eye, np.array(pose), height)
        if top:
            color, sides = top
            return color, np.append(sides, height)
    raise ValueError(f"no picture of the demonstration shows {demo.ids[n]} well enough to tell "
                     "what it is")


def worth_looking(moves):
    """Moves of an object after which it may be seen as a whole: at the beginning, and where it was
    highest."""
    highest = np.argsort(-moves[:, 3], kind="stable")[:8]
    return moves[[0, *highest]]


def read_picture(folder, frame):
    """HxWx3, 0 to 1; None if there is none of this frame."""
    found = sorted(folder.glob(f"*/{frame}.png"))
    return np.asarray(Image.open(found[0]).convert("RGB")) / 255 if found else None


def measure_top(picture, eye, pose, height):
    """The color of the top of an upright object, and how long it is along the object's x and y
    axes; None if it is not seen as a whole.

    pose: x y z of its centre [units], angles about x, y, z [degrees]
    """
    top = pose[:3] + [0, 0, height / 2]
    spot = pixel_at(picture, eye, top) if picture is not None else None
    if spot is None:
        return None
    color = picture[spot]
    number = label_regions(is_color(picture, color))
    row, column = np.nonzero(number == number[spot])
    face = describe_face(*onto_plane(row, column, eye, top[2]), math.radians(pose[5]))
    is_whole = np.hypot(*(face.center - top[:2])) < 0.1 and face.misfit < 0.05
    return (color, face.sides) if is_whole else None


def stands_on(upper, lower):
    gap = (upper.top - upper.size[2]) - lower.top
    [one] = footprint([upper], 0)
    return abs(gap) < 0.1 and overlap(one, footprint([lower], 0)).any()


def color_matters(attention, name):
    """The demonstrator may have told which properties of an object matter; who tells nothing means
    all."""
    return "color" in (attention.get(name) or ["color"])
