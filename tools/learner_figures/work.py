"""Figures of what the learner does in the scene: where it builds, its plan, its actions, and how it checks them."""

import numpy as np

from drawing import BAD, Drawing, EXPECTED, FAINT, FOUND, INK, css
from views import GAP, HIGH, TITLE, WIDE, faded, outlines, panels, show, top_corners

TABLE = np.array([[-10, -6], [10, -6], [10, 6], [-10, 6]])  # its corners [units]


class View:
    """A view from above or from the front: where points, Nx3 [units], are in a drawing."""

    def __init__(self, left, middle=(0, 0), scale=WIDE / 22, upwards=1):
        self._axes, self._middle, self._scale = [0, upwards], middle, scale
        self._at = [left + WIDE / 2, TITLE + HIGH / 2]

    def __call__(self, points):
        return self._at + self._scale * (np.asarray(points)[:, self._axes] - self._middle) * [1, -1]


def draw_from_above(drawing, view, blocks, **style):
    """Draws the tops of blocks, the lowest first."""
    for it in sorted(blocks, key=lambda it: it.top):
        corners = top_corners(it.position, it.top, it.size, it.yaw, it.is_round)
        drawing.line(view(corners), closed=True, **({"fill": css(it.color)} | style))


def draw_match(run):
    """Where the building goes: to what stays, which is elsewhere here."""
    drawing, left = panels(["The demonstrated goal, from above", "The scene", "The goal in the scene"])
    views = [View(it) for it in left]
    for view in views:
        drawing.line(view(TABLE), FAINT, 1, closed=True)
    look = run.looks[0]
    draw_from_above(drawing, views[0], run.shown_steps)
    draw_from_above(drawing, views[1], look.seen)
    draw_from_above(drawing, views[2], [it for it in look.steps if it.stays])
    draw_from_above(drawing, views[2], [it for it in look.steps if not it.stays], color=EXPECTED, dashes="5 3")
    return drawing


def draw_plan(run):
    """The first transfer, from above and from the front."""
    look = run.looks[0]
    kinds = [it.kind for it in look.actions]
    grasp = kinds.index("grasp")
    release = grasp + kinds[grasp:].index("open")
    moves = [it.arm.forward(q)[:3, 3] for it in look.actions[grasp + 1:release] for q in it.path.positions]
    ends = [(moves[0], "grasp"), (moves[-1], "release")]
    ends_x = [it.position[0] for it in look.seen] + [point[0] for point, _ in ends]
    middle = np.array([(min(ends_x) + max(ends_x)) / 2, moves[0][1]])
    scale = WIDE / (max(ends_x) - min(ends_x) + 4)
    drawing, left = panels(["A transfer, from above", "From the front", "The actions"], below=40)
    above = View(left[0], middle, scale)
    draw_from_above(drawing, above, look.seen)
    front = View(left[1], [middle[0], 2.3], scale, upwards=2)
    drawing.line(front([[min(ends_x) - 2, 0, 0], [max(ends_x) + 2, 0, 0]]), FAINT, 3)
    for it in sorted(look.seen, key=lambda it: -it.position[1]):
        x = top_corners(it.position, it.top, it.size, it.yaw, it.is_round)[:, 0]
        box = [[x[k], 0, z] for k, z in ((x.argmin(), it.bottom), (x.argmax(), it.bottom), (x.argmax(), it.top),
                                         (x.argmin(), it.top))]
        drawing.line(front(box), fill=css(it.color), closed=True)
    for view in (above, front):
        drawing.line(view(moves), BAD, 2)
        for point, word in ends:
            (x, y), is_left = view(point[None])[0], point[0] == min(it[0][0] for it in ends)
            x, anchor = (x - 6, "end") if is_left else (x + 0.7 * scale, "start")
            drawing.text(x, y + 14, word, BAD, 11, anchor, "bold")
    for k, it in enumerate(look.actions):
        drawing.text(left[2], TITLE + 12 + 16 * k, f"{k + 1}. {words_of(it)}", size=11)
    return drawing


def words_of(action):
    """Returns an action in words."""
    if action.kind in ("follow", "lift"):
        return f"follow a path for {action.path.duration:.1f} s"
    if action.kind == "open":
        return f"open the fingers to {action.to:.2f} units"
    return {"grasp": "close the fingers on the block", "observe": "look"}[action.kind]


def draw_act(run):
    """The hand during the first transfer: how high it is, how far open, and what ends each action."""
    end = run.looks[1].time
    ticks = [it for it in run.ticks if it.time <= end]
    width, high = 3 * WIDE + 2 * GAP, 150
    drawing = Drawing(width + 2 * GAP, TITLE + high + 40)
    drawing.text(GAP, TITLE - 8, "Height of the tool and opening of the fingers, as measured", weight="bold")
    x = lambda it: GAP + width * (it.time - ticks[0].time) / (end - ticks[0].time)
    bottom = TITLE + high
    most = max(it.height for it in ticks)
    drawing.line([[GAP, bottom], [GAP + width, bottom]], FAINT)
    for before, it in zip(ticks, ticks[1:]):
        if before.kind != it.kind and {before.kind, it.kind} != {"lift", "follow"}:
            drawing.line([[x(it), TITLE], [x(it), bottom]], FAINT, 1, "3 3")
            if it.kind in ("grasp", "open"):
                drawing.text(x(it) + 3, TITLE + 10, "closes" if it.kind == "grasp" else "opens", FAINT, 11)
    drawing.line([[x(it), bottom - high * it.height / most] for it in ticks], INK, 2)
    drawing.line([[x(it), bottom - high * it.opening / most] for it in ticks], BAD, 2)
    drawing.text(GAP, bottom + 16, f"height of the tool, up to {most:.1f} units", INK, 11)
    drawing.text(GAP, bottom + 32, f"opening, up to {max(it.opening for it in ticks):.2f} units", BAD, 11)
    drawing.text(GAP + width, bottom + 16, f"{end - ticks[0].time:.0f} s", FAINT, 11, "end")
    return drawing


def draw_check(run):
    """What is expected and what is found, after three of the actions."""
    words = ("as expected", "hidden", "contradicted")
    looks = [it for it in run.looks if any(note.word in words for note in it.notes)][:3]
    drawing, left = panels([f"After {it.time:.0f} s" for it in looks], below=92)
    for x, it in zip(left, looks):
        show(drawing, x, faded(it.picture))
        verdicts = [note for note in it.notes if note.word in words]
        for note in verdicts:
            outlines(drawing, x, note.found, run.aux.eye, it.picture.shape, FOUND)
            outlines(drawing, x, note.expected, run.aux.eye, it.picture.shape, EXPECTED, "4 3")
        lines = [line for note in verdicts for line in str(note).replace(": off", ":\n off").split("\n")]
        for k, line in enumerate(lines):
            drawing.text(x + 14 * line.startswith(" "), TITLE + HIGH + 18 + 15 * k, line.strip(), size=11)
    drawing.text(GAP, TITLE + HIGH + 86, "dashed: expected", EXPECTED, 11)
    drawing.text(GAP + 110, TITLE + HIGH + 86, "solid: found", FOUND, 11)
    return drawing
