"""Places steps at objects that are found in the scene: dragged ones, and containers."""

from dataclasses import replace

import numpy as np

from act.finger_room import grasp_yaws
from constants import BLOCKS
from match.landmarks import turned_about
from match.sites import NoSite
from see.containers import detect_container
from things.areas import container_at, rotated
from things.blocks import yaw_difference
from things.kinds import is_same_kind
from things.walls import container_walls


def place_dragged(step, known):
    """Moves a dragged step to the one known block that looks like it; rotates its displacement
    likewise."""
    found = [block for block in known if is_same_kind(block, step)]
    if len(found) != 1:
        raise NoSite(f"{len(found)} visible objects look like {step}")
    rotation = yaw_difference(step, found[0].yaw)
    displacement = rotated(step.displacement, rotation)
    return replace(step, displacement=displacement, yaw=step.yaw + rotation,
                   position=found[0].position + [*displacement, 0])


def place_in_containers(steps, containers, known, picture, eye):
    """Moves steps together with the container that each of them is in, or with the first one, to where this is detected, or, where it
    is covered from the start, to where it must be below its cover. Returns both."""
    found, moved = [], {}
    for container in containers:
        content = [it for it in steps if (container_at(containers, it.position) or containers[0]) is container]
        there, rotation = detect_container(picture, eye, container, found)
        if not there:
            there, rotation = below_cover(content, container, known)
        if not there:
            raise NoSite(f"the container {container.name} is not visible")
        found.append(there)
        moved |= {it.name: moved_with(it, container, there, rotation) for it in content}
    return [moved[it.name] for it in steps], found


def moved_with(step, container, there, rotation):
    """Returns a step where it is relative to a Container, which was found there, rotated [rad]."""
    displacement = rotated(step.position[:2] - container.position[:2], rotation)
    position = np.append(there.position[:2] + displacement, step.position[2])
    step = replace(step, position=position, yaw=step.yaw + rotation)
    # What fingers cannot put there is dropped, and lies anywhere inside.
    if not grasp_yaws(step, container_walls([there])):
        step.tolerance = BLOCKS.confined_tolerance
    return step


def below_cover(steps, container, known):
    """Returns where a Container must be below a known block that is in its final place from the start,
    like a lid, and the rotation from the demonstration [rad]; None and 0 if there is none."""
    for step in [it for it in steps if it.begins_there]:
        for block in [it for it in known if is_same_kind(it, step)]:
            rotation = yaw_difference(step, block.yaw)
            return turned_about(step, container, rotation, block), rotation
    return None, 0
