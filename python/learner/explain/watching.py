"""Reconstructs demonstrations from pictures alone."""

import json
from pathlib import Path

import numpy as np

from constants import WATCHING as C
from explain.color_words import names_of, word_of
from explain.demonstration import Demonstration
from explain.limits import NotUnderstood
from explain.shown_pictures import eye_of
from watch.palette import Palette
from watch.tracking import Tracker
from watch.watched_kinds import learn_kinds
from watch.watched_pictures import codes_in, pictures_of
from watch.whereabouts import unclear_colors


def watch_demonstration(folder):
    """Reconstructs a demonstration from the pictures of a recording without texts.

    Raises NotUnderstood if they show no block by itself, or none that moved.
    """
    folder = Path(folder)
    eye = eye_of(json.loads((folder / "demo.json").read_text()))
    pictures = pictures_of(folder)
    palette = Palette(codes_in(pictures[0][1]))
    kinds = learn_kinds(telling(pictures), palette, eye)
    if not kinds:
        raise NotUnderstood("no picture of the demonstration shows a block by itself")
    tracker = Tracker(kinds, palette, eye)
    for frame, file, is_still in pictures:
        classes = palette.classes(codes_in(file))
        tracker.update(frame, classes, is_still)
    demo = demonstration_of(folder, eye, [it for it in tracker.objects if it.block])
    if not demo.placed:
        raise NotUnderstood("the pictures of the demonstration show no block that moved: without texts, only upright blocks of one "
                            "color are understood")
    demo.unclear = [f"what else is {word_of(it).lower()} at the end" for it in unclear_colors(classes, tracker.view(), kinds, palette)]
    return demo


def telling(pictures):
    """Returns the files of the first picture, of those of a still scene, and of the next one after each."""
    return [file for k, (_, file, is_still) in enumerate(pictures)
            if k == 0 or is_still or pictures[k - 1][2]]


def demonstration_of(folder, eye, objects):
    """Returns a Demonstration of what Tracked blocks did: a hand takes each and puts it where it rested next. How it
    moved in between the pictures may not show: it counts as lifted."""
    demo = Demonstration(folder, names_of(objects), [], [], [], eye, {})
    deeds = []
    for n, it in enumerate(objects):
        first = it.start or it.placed[0][1]
        demo.appearances[n] = first
        demo.events.append((0, "create", [demo.ids[n]]))
        demo.moves.append([[0, *pose_of(first, 0 if it.start else C.lifted)]])
        deeds += [(frame, k, n, block) for k, (frame, block) in enumerate(it.placed)]
    # Deeds that end in the same picture are one after the other, the lower one first.
    deeds.sort(key=lambda it: (it[0], it[3].position[2], it[1]))
    for k, (frame, _, n, block) in enumerate(deeds):
        when = frame + C.between * k
        demo.events += [(when, "grasp", ["Hand", demo.ids[n]]), (when, "release", ["Hand"])]
        demo.moves[n] += [[when, *pose_of(block, C.lifted)], [when, *pose_of(block, 0)]]
        demo.placed.append(n)
    demo.moves = [np.array(rows) for rows in demo.moves]
    return demo


def pose_of(block, above):
    """Returns the pose of a Block, raised by a height: x y z [units], angles about x, y, z [degrees]."""
    return [*block.position[:2], block.position[2] + above, 0, 0, np.degrees(block.yaw)]
