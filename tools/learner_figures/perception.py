"""Figures of what the learner sees: in the scene, and in a recording without texts."""

import json

import numpy as np

from drawing import INK
from explain.shown_pictures import eye_of
from explain.watching import telling
from views import faded, outlines, panels, pixels_shown, show
from watch.palette import UNKNOWN, Palette
from watch.tracking import Tracker
from watch.watched_kinds import learn_kinds
from watch.watched_pictures import codes_in, colors_of, pictures_of


def draw_see(run):
    """From a picture and its heights to blocks."""
    look, eye = run.looks[0], run.aux.eye
    drawing, left = panels(["What the eye sees", "Heights, from its depth", "Tops of one color and height: blocks"])
    show(drawing, left[0], look.picture)
    shade = np.clip(look.heights / 1.6, 0, 1)[..., None]
    show(drawing, left[1], 1 - shade * [0.85, 0.6, 0.3])
    show(drawing, left[2], faded(look.picture))
    outlines(drawing, left[2], look.seen, eye, look.picture.shape, INK)
    labels = []  # places of those that are written already
    for it in sorted(look.seen, key=lambda it: -it.top):
        x, y = pixels_shown(left[2], np.array([[*it.position[:2], it.bottom]]), eye, look.picture.shape)[0]
        y += 34
        while any(abs(x - other) < 70 and abs(y - line) < 12 for other, line in labels):
            y += 12
        labels.append((x, y))
        drawing.text(x, y, " x ".join(f"{side:.2g}" for side in it.size), anchor="middle", size=11)
    return drawing


def draw_watch(folder):
    """From pictures in which a person's arms hide a part to blocks."""
    pictures = pictures_of(folder)
    eye = eye_of(json.loads((folder / "demo.json").read_text()))
    palette = Palette(codes_in(pictures[0][1]))
    tracker = Tracker(learn_kinds(telling(pictures), palette, eye), palette, eye)
    views = []  # of each picture: how many pixels are unknown, and what was concluded
    for frame, file, is_still in pictures:
        codes = codes_in(file)
        classes = palette.classes(codes)
        tracker.update(frame, classes, is_still)
        views.append(((classes == UNKNOWN).sum(), colors_of(codes), classes,
                      [it.block for it in tracker.objects if it.block]))
    _, picture, classes, resting = max(views, key=lambda it: it[0])

    drawing, left = panels(["A picture of the demonstration", "What each pixel may be (gray: unknown)",
                            "The blocks that rest"])
    show(drawing, left[0], picture)
    shown = np.ones(picture.shape)
    shown[classes == UNKNOWN] = 0.75
    for color in palette.colors:
        top = palette.top(color)
        shown[classes == top] = color
        shown[classes == top + 1] = 0.5 * color
    show(drawing, left[1], shown)
    show(drawing, left[2], faded(picture))
    outlines(drawing, left[2], resting, eye, picture.shape, INK)
    return drawing
