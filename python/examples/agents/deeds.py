"""What replay and relative replay share: the demonstrated carries, done one after the other with the
learner's arms, without a look at the result."""

import math
import sys
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

sys.path.append(str(Path(__file__).resolve().parents[2] / "learner"))
from act.actions import Action
from act.execution import execute_action
from act.grippers import arms_for
from act.retreats import retreat
from act.robot_arms import arms_of
from constants import BLOCKS
from explain.appearances import measure_objects
from explain.demonstration import read_demonstration
from explain.task_model import infer_task
from plan.pick_and_place import plan_pick_and_place
from things.blocks import Block


@dataclass
class Carry:
    """An object that the demonstrator carried, as Blocks before and after."""

    name: str
    start: Block
    goal: Block


def prepare(aux):
    """Reads the demonstration. Returns its Carries, and its objects at the start: name -> Block."""
    demo = read_demonstration(aux.demonstration)
    appearances = measure_objects(demo, [])
    carries = []
    for k, (frame, word, fields) in enumerate(demo.events):
        if word == "grasp" and demo.ids.index(fields[1]) in appearances:
            n = demo.ids.index(fields[1])
            end = next((it[0] for it in demo.events[k + 1:] if it[1] == "grasp"), math.inf)
            poses = [demo.pose(n, frame), demo.pose(n, end)]
            if np.abs(poses[1][:3] - poses[0][:3]).max() > 0.05:
                carries.append(Carry(fields[1], *(block_at(pose, appearances[n]) for pose in poses)))
    steps, _ = infer_task(demo, aux.attention)
    arms = arms_of(aux)
    for arm in arms:
        aux.arms[arm.index].initJoints = arm.parked
    aux.hands = arms_for(steps, arms)
    aux.actions = []
    aux.num_failures = 0
    return carries, {demo.ids[n]: block_at(demo.pose(n, 0), it) for n, it in appearances.items()}


def block_at(pose, appearance):
    """Returns an object at a pose, x y z and three angles [degrees], as a Block; appearance: the same
    at its first place."""
    size = appearance.size
    yaw = math.radians(pose[5])
    if size[1] > BLOCKS.equal_sides * size[0]:
        size, yaw = size[[1, 0, 2]], yaw + math.pi / 2
    return replace(appearance, size=size, position=pose[:3], yaw=yaw)


def continue_carrying(sensor, motor, aux):
    """Does the next tick of aux.carries. aux.places: the believed places of all objects."""
    while not aux.actions and aux.carries:
        carry = aux.carries.pop(0)
        others = [it for name, it in aux.places.items() if name != carry.name]
        aux.actions, reason = plan_pick_and_place(aux.hands, carry.start, carry.goal, others, sensor)
        aux.actions = [it for it in aux.actions if it.kind != "observe"]
        if aux.actions:
            aux.places[carry.name] = carry.goal
        else:
            fail(aux, sensor, f"{carry.name}: {reason}")
    if not aux.actions:
        aux.claim = f"gave up: {aux.num_failures} failures" if aux.num_failures else "done"
        aux.exit = True
        return
    status = execute_action(aux.actions[0], sensor, motor, aux)
    if status == "done":
        aux.actions.pop(0)
    elif status != "busy":
        fail(aux, sensor, status)
        arm = aux.actions[0].arm
        aux.actions = [it for it in retreat(arm, sensor.arms[arm.index].joints,
                                            can_rise=aux.num_failures % 2 == 1)
                       if it.kind != "observe"]


def fail(aux, sensor, reason):
    """Reports a failure; after many of them, gives up."""
    print(f"{sensor.simTime:5.1f} s: {reason}")
    aux.num_failures += 1
    if aux.num_failures > 20:
        aux.carries, aux.actions = [], []
