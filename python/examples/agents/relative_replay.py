"""Looks once, then replays each demonstrated motion relative to its reference object: the nearest one
that was already in its final place. It never looks whether it succeeded.

    smile imitate DEMO SCENE --brain python/examples/agents/relative_replay.py

smile: imitates
"""

import math
from dataclasses import replace

import numpy as np

from deeds import Action, continue_carrying, execute_action, fail, prepare

from see.detection import detect_blocks
from see.eye import height_map
from see.framing import eye_of_robot
from things.blocks import yaw_difference
from things.kinds import is_same_kind


def init(aux):
    aux.shown, aux.at_start = prepare(aux)
    aux.eye = eye_of_robot(aux)
    aux.channels = ["rgb", "depth"]
    aux.look = Action("observe")


def step(sensor, motor, aux):
    if aux.look:
        if execute_action(aux.look, sensor, motor, aux) != "done":
            return
        aux.look = None
        aux.places = match(aux, sensor)
        aux.carries = transferred(aux.shown, aux.at_start, aux.places)
    continue_carrying(sensor, motor, aux)


def match(aux, sensor):
    """Returns the seen blocks by the names of the demonstrated objects: each the nearest one that
    looks alike and is not taken yet."""
    heights = height_map(sensor.depthVision, aux.eye)
    like = list(aux.at_start.values())
    seen = detect_blocks(sensor.rgbVision / 255, aux.eye, like, heights=heights)
    places = {}
    for name, shown in aux.at_start.items():
        alike = [it for it in seen if is_same_kind(it, shown)]
        if not alike:
            fail(aux, sensor, f"no {name} is visible")
            continue
        places[name] = min(alike, key=lambda it: np.linalg.norm(it.position - shown.position))
        seen = [it for it in seen if it is not places[name]]
    return places


def transferred(shown, at_start, places):
    """Returns the Carries for this scene."""
    last = {carry.name: k for k, carry in enumerate(shown)}
    here = dict(places)
    there = dict(at_start)
    carries = []
    for k, carry in enumerate(shown):
        at_rest = [name for name in there if last.get(name, -1) < k and name in here]
        goal = carry.goal
        if at_rest:
            nearest = min(at_rest, key=lambda name: np.linalg.norm(
                there[name].position - carry.goal.position))
            goal = moved_along(carry.goal, there[nearest], here[nearest])
        there[carry.name] = carry.goal
        if carry.name in here:
            # The size that is seen, from where it is seen.
            start = here[carry.name]
            goal = replace(start, position=goal.position, yaw=goal.yaw)
            carries.append(replace(carry, start=start, goal=goal))
            here[carry.name] = goal
    return carries


def moved_along(goal, before, after):
    """Returns a goal as it is after the motion of its reference object."""
    turn = yaw_difference(before, after.yaw)
    c, s = math.cos(turn), math.sin(turn)
    x, y, z = goal.position - before.position
    away = np.array([x * c - y * s, x * s + y * c, z])
    return replace(goal, position=after.position + away, yaw=goal.yaw + turn)
