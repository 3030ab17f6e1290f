"""Tools that a demonstration turned, like screwdrivers: where they were when they turned something, and how often."""

from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from constants import USES as C
from explain.limits import NotUnderstood
from explain.object_roles import tools_of
from explain.placed_steps import step_of
from explain.presses import Press
from explain.shown_pictures import mask_around, picture_frames, read_picture


class Turns(NamedTuple):
    """Successive turns of one fastener."""

    fastener: str  # its name in the demonstration
    place: np.ndarray  # x y z of the center of the tool when they began [units]
    number: int
    is_loosening: bool


@dataclass(eq=False)
class Drive(Press):
    """All that a tool turned before it was put back. What this changes may not be visible."""

    turns: list = field(default_factory=list)
    height: float = 0.0  # of the center of the tool at which it passed over everything [units]

    def __str__(self):
        words = {it.is_loosening: ("fastening", "loosening")[it.is_loosening] for it in self.turns}
        return f"{' and '.join(words.values())} of {', '.join(it.fastener for it in self.turns)} with {self.tool.name}"


def drive_at(demo, frame, after, earlier):
    """Returns the Drive to which a use in a frame belongs; earlier: the Drives before it."""
    taken = [when for when, word, _ in demo.events if word == "grasp"]
    begin = max(when for when in taken if when < frame)
    end = min((when for when in taken if when > frame), default=np.inf)
    uses = [(when, it) for when, word, it in demo.events if word == "use" and begin < when < end]
    name = uses[0][1][1]
    n = demo.ids.index(name)
    if n not in tools_of(demo) or any(it[2] not in C.turning for _, it in uses):
        raise NotUnderstood(f"{name} was not put back after its use on {uses[0][1][3]}")
    turns = [turns_of(demo, n, [when for when, it in uses if it[3] == fastener], fastener, action == "loosen")
             for action, fastener in dict.fromkeys((it[2], it[3]) for _, it in uses)]
    names = {it.fastener for it in turns}
    known = next((it for it in earlier if any(turn.fastener in names for turn in it.turns)), None)
    picture = read_picture(demo, max(it for it in picture_frames(demo) if it <= begin))
    place = demo.pose(demo.ids.index(turns[0].fastener), begin)[:3]
    return Drive(known.control if known else turns[0].fastener, after, picture, picture,
                 mask_around(picture, demo.eye, place), tool=step_of(demo, n, demo.appearances[n], {}),
                 turns=turns, height=max(row[3] for row in demo.moves[n] if begin < row[0] <= uses[0][0]))


def turns_of(demo, n, frames, fastener, is_loosening):
    """Returns the Turns that are the uses of tool n in some frames. The tool rises and sinks with the fastener, and the
    last move before a use may be older than the way down: a hand that does not rise and sink holds it in the middle."""
    other = demo.ids.index(fastener)
    there = [[rows[rows[:, 0] <= frame][-1, 3] for rows in (demo.moves[n], demo.moves[other])] for frame in frames]
    before = demo.pose(other, frames[0])[2] + there[0][0] - there[0][1]
    heights = [before, *(it[0] for it in there[:-1])]
    place = np.append(demo.pose(n, frames[0])[:2], (min(heights) + max(heights)) / 2)
    return Turns(fastener, place, len(frames), is_loosening)
