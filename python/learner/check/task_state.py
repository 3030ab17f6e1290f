"""Progress and beliefs of the learner during a task."""

from dataclasses import dataclass, field
from typing import Callable, NamedTuple, Optional

import numpy as np

from act.actions import Grasp
from check.choices import Choices
from check.claims import Claim
from see.eye import Eye
from see.surfaces import Surface
from things.blocks import Block
from things.kinds import same_size
from things.resting import on_each_face
from things.steps import start_supports_of


class Intention(NamedTuple):
    """A step that is not done yet, and for which something was done already."""

    step: int  # its number
    is_last_resort: bool  # whether no other step could be done either


@dataclass
class TaskState:
    """Progress and beliefs of the learner during a task."""

    steps: list  # of the demonstration; once a site is chosen, at their places in this scene
    containers: list = field(default_factory=list)  # of some steps; once a site is chosen, in this scene
    has_site: bool = False
    known: list = field(default_factory=list)  # beliefs: Blocks at their last seen places
    unknown_objects: list = field(default_factory=list)  # appearances of blocks of no step; their
    #                                                      places are among the known
    unexplained: np.ndarray = field(default_factory=lambda: np.zeros((0, 2)))  # as from
    #                                                                            unexplained_points
    unseen_colors: Optional[list] = None  # of things in the demonstration, not yet seen here; None: all
    done: list = field(init=False)  # whether each step's block is in its place
    attempts: list = field(init=False)  # number of times that each step's block was carried there
    num_temporary: int = 0  # number of blocks that were put at a temporary place so far
    placement_errors: dict = field(default_factory=dict)  # of a step's block: [units], [rad]
    num_blocked: int = 0  # number of successive steps for which no plan was found
    intention: Optional[Intention] = None  # the step that comes next, for which others made room
    first_failure: str = ""  # why the first of them failed
    left: list = field(default_factory=list)  # Blocks at the places from which they were put aside
    asides: list = field(default_factory=list)  # for which step a block was put aside, its number, and the Block there
    grasp: Optional[Grasp] = None  # of the current actions; its block is the last of the known
    failures: list = field(default_factory=list)  # Grasps that failed, not to be repeated
    meant: dict = field(default_factory=dict)  # as from meant_blocks, once a site is chosen
    hand_looks: list = field(default_factory=list)  # places, x y [units], that were looked at by hands, or aside
    impossible_moves: list = field(default_factory=list)  # ImpossibleMoves, where everything is now,
    impossible_among: list = field(default_factory=list)  # the Blocks known then
    moved: str = ""  # name of the last of the known, if it was moved and not seen since then
    notes: list = field(default_factory=list)  # Notes that were not told yet
    claim: Optional[Claim] = None  # about the result, at the end
    presses: list = field(default_factory=list)  # of switches and buttons, in the demonstrated order
    shown: Optional[Eye] = None  # the eye of the demonstration, which shows them
    unclear: list = field(default_factory=list)  # what was not understood of it, in words
    alignments: dict = field(default_factory=dict)  # of a control's name: Alignment of its surroundings
    surface: Optional[Surface] = None  # what the eye sees now, if something has to be put aside
    last_picture: Optional[np.ndarray] = None  # seen before the scene was still
    num_looks: int = 0  # number of pictures until then
    num_still: int = 0  # number of the last of them in which nothing moved
    without: tuple = ()  # "depth", "second look": abilities that it does not use
    choices: Choices = Choices()  # between several good ways
    see: Optional[Callable] = None  # told what is seen: from sensor, eye, and steps and tools to Blocks

    def __post_init__(self):
        self.done = [False] * len(self.steps)
        self.attempts = [0] * len(self.steps)
        self.unknown_objects += start_supports_of(self.steps)
        # What has to be turned may lie on any of its faces.
        self.unknown_objects += [
            Block(step.color, size, np.array([0, 0, size[2] / 2]), 0.0)
            for step in self.steps if step.start_size is not None
            for size in on_each_face(step.size) if not same_size(size, step.size)]
