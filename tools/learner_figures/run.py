"""One run of the learner, with what it saw, believed and did."""

import subprocess
from dataclasses import dataclass, field
from typing import Any
from unittest.mock import patch

import learner
import smile
from check.telling import tell
from see.eye import height_map


@dataclass
class Look:
    """A picture, and what the learner concluded from it."""

    time: float  # [s]
    picture: Any  # HxWx3, 0 to 1
    heights: Any  # HxW [units]
    steps: list  # where they belong
    actions: list  # the next ones
    notes: list  # what it tells people: Notes

    @property
    def seen(self):
        """The Blocks in the first picture."""
        return next(note.found for note in self.notes if note.word == "saw")


@dataclass
class Tick:
    """The state of the hand that acts."""

    time: float  # [s]
    kind: str  # of the action
    height: float  # of the tool [units]
    opening: float  # of the gripper [units]


@dataclass
class Run:
    """A brain that is the learner and remembers what it saw, believed and did."""

    aux: Any = None
    shown_steps: list = None  # before a site is chosen
    looks: list = field(default_factory=list)
    ticks: list = field(default_factory=list)

    def init(self, aux):
        learner.init(aux)
        self.aux = aux
        self.shown_steps = list(aux.state.steps)

    def step(self, sensor, motor, aux):
        current, notes = aux.actions[0], []
        with patch.object(learner, "tell", lambda aux, seconds: notes.extend(aux.state.notes) or tell(aux, seconds)):
            learner.step(sensor, motor, aux)
        if current.kind == "observe" and current not in aux.actions[:1]:
            heights = height_map(sensor.depthVision, aux.eye)
            self.looks.append(Look(sensor.simTime, sensor.rgbVision / 255, heights, list(aux.state.steps),
                                   list(aux.actions), notes))
        if current.arm:
            sensed = sensor.arms[current.arm.index]
            self.ticks.append(Tick(sensor.simTime, current.kind, current.arm.forward(sensed.joints)[2, 3],
                                   sensed.gripper))


def record(program, project, task, folder):
    """Records the demonstration of a task. Returns its directory."""
    subprocess.run([program, "run", project / f"scenes/{task}.xml", "--kinematic", "--commands",
                    project / f"examples/{task}.jsonl", "--record", folder], check=True, stdout=subprocess.DEVNULL)
    return folder


def run(program, project, task, demo, seed, level, folder):
    """Lets the learner do a task in a layout. Returns the Run."""
    scene = folder / "layout.xml"
    subprocess.run([program, "layout", project / f"scenes/{task}_robot.xml", "--seed", str(seed), "--level", level,
                    "--out", scene], check=True, stdout=subprocess.DEVNULL)
    brain = Run()
    done = smile.imitate(demo, scene, brain, folder / "run", pictures=False)
    if not done.is_success:
        raise RuntimeError(f"the learner did not do {task} at seed {seed}")
    return brain
