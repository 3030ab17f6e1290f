"""Tools that a demonstration used: where they were when they cut, and what that changed in its pictures."""

import re
from dataclasses import dataclass
from typing import Optional

import numpy as np

from constants import USES as C
from explain.limits import NotUnderstood
from explain.object_roles import tools_of
from explain.placed_steps import step_of
from explain.presses import Press, changes
from things.steps import Step


@dataclass(eq=False)
class Use(Press):
    """A use of a tool, which was put back afterwards."""

    tool: Step = None  # where it began and ended
    pose: np.ndarray = None  # x y z of its center when it was used [units], and its yaw then [rad]
    begin: np.ndarray = None  # x y z of its center where its straight way to there began [units]
    at: Optional[np.ndarray] = None  # x y of what it worked on, if that looks the same from all sides [units]

    def __str__(self):
        return f"use of {self.tool.name} on {self.control}"


def use_at(demo, frame, fields, after):
    """Returns the Use that a line of a demonstration describes. Its pictures are from before a hand took the tool,
    and from before a hand takes something again."""
    _, name, action, target = fields
    if action not in C.actions:
        raise NotUnderstood(f"this learner cannot {action} {target} with {name}")
    n = demo.ids.index(name)
    if n not in tools_of(demo):
        raise NotUnderstood(f"{name} was not put back after its use on {target}")
    taken = max(when for when, word, it in demo.events if word == "grasp" and it[1] == name and when < frame)
    taken_next = min((when for when, word, _ in demo.events if word == "grasp" and when > frame), default=np.inf)
    rows = demo.moves[n][demo.moves[n][:, 0] <= frame]
    tool = step_of(demo, n, demo.appearances[n], {})
    pose = np.append(rows[-1, 1:4], tool.yaw + np.radians(rows[-1, 6] - demo.moves[n][-1, 6]))
    return Use(target, after, *changes(demo, taken, taken_next, target), tool=tool, pose=pose, begin=straight(rows),
               at=place_in_chain(demo, frame, target))


def place_in_chain(demo, frame, target):
    """Returns where a chain was cut, x y: between the links that a target such as `String between link 4 and 5` names;
    None if it is something else."""
    chain, _, sides = target.partition(" between ")
    links = {f"{chain}-link{it}" for it in re.findall(r"\d+", sides)}
    places = [moves[moves[:, 0] <= frame][-1, 1:3] for name, moves in zip(demo.ids, demo.moves) if name in links]
    return np.mean(places, axis=0) if places else None


def straight(rows):
    """Returns where the straight way of an object to its last pose began: x y z. rows: as of demo.moves"""
    places = rows[:, 1:4]
    k = len(places) - 1
    while k > 0 and is_on_way(places[k - 1], places[k], places[-1]):
        k -= 1
    return places[k]


def is_on_way(place, begin, end):
    """Returns true if a straight way to an end may also have begun at an earlier place."""
    whole, part = end - place, begin - place
    length = np.linalg.norm(whole)
    deviation = np.linalg.norm(np.cross(whole, part)) / max(length, 1e-9)
    return deviation < C.max_deviation and part @ whole > 0 and not np.allclose(place, begin)
