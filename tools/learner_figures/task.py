"""Figures of what the learner understands of a demonstration: facts, and which of them are the goal."""

import math

import numpy as np

from drawing import BAD, FAINT, FOUND, INK
from explain.shown_pictures import picture_frames, read_picture
from views import HIGH, TITLE, WIDE, panels, show


def picture_before(demo, frame):
    """Returns the last picture before an action of a frame."""
    return read_picture(demo, max(it for it in picture_frames(demo) if it <= frame))


def draw_relate(demo, explanation):
    """Facts at one moment, as a graph: what stands on what."""
    facts = explanation.keyframes[0].facts
    drawing, left = panels(["The first keyframe", "Facts", "What stands on what"])
    show(drawing, left[0], picture_before(demo, 0))
    for k, fact in enumerate(facts):
        drawing.text(left[1], TITLE + 16 + 16 * k, fact, size=11)
    rows = [it.split()[1:] for it in facts if it.startswith("on ")]
    names = list(dict.fromkeys(name for row in rows for name in row if name != "table"))
    level = {}
    while len(level) < len(names):  # one above those that it stands on
        level |= {a: 1 + max(level.get(b, 0) for c, b in rows if c == a)
                  for a in names if all(b == "table" or b in level for c, b in rows if c == a)}
    across = sorted(names, key=lambda name: demo.pose(demo.ids.index(name), 0)[0])
    columns = {name: round(demo.pose(demo.ids.index(name), 0)[0], 1) for name in across}
    order = sorted(set(columns.values()))
    place = {name: np.array([left[2] + (order.index(columns[name]) + 0.5) * WIDE / len(order),
                             TITLE + HIGH - 10 - 54 * level[name]]) for name in names}
    drawing.line([[left[2], TITLE + HIGH - 14], [left[2] + WIDE, TITLE + HIGH - 14]], FAINT, 3)
    drawing.text(left[2], TITLE + HIGH, "table", FAINT, 11)
    for upper, lower in rows:
        below = place[lower] - [0, 16] if lower in place else np.array([place[upper][0], TITLE + HIGH - 16])
        drawing.arrow(place[upper] + [0, 6], below)
    for name, point in place.items():
        drawing.text(*point, name, anchor="middle", weight="bold")
    return drawing


def draw_explain(demo, explanation):
    """The deeds, and which of them are only means."""
    deeds = explanation.keyframes[1:]
    grasps = [frame for frame, word, _ in demo.events if word == "grasp"]
    drawing, left = panels([f"{k + 1}. {it.deed}" for k, it in enumerate(deeds)], below=64)
    for x, following, it in zip(left, [*grasps[1:], math.inf], deeds):
        show(drawing, x, picture_before(demo, following))
        y = TITLE + HIGH + 18
        drawing.text(x, y, "only a means: nothing of it is kept" if it.is_means else "made and kept:",
                     BAD if it.is_means else FOUND, weight="bold")
        for k, fact in enumerate([] if it.is_means else [fact for fact in it.made if fact in explanation.goal]):
            drawing.text(x, y + 16 + 16 * k, fact, INK, 11)
    return drawing
