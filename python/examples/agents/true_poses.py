"""The learner, given the true poses, sizes and colors of all objects: it sees nothing itself, so small
pictures suffice, which makes it fast.

    smile imitate DEMO SCENE --oracle --size 64x48 --brain python/examples/agents/true_poses.py

It is for things that are one block or disc. A real robot does not have this information: only the
simulator has it.

smile: imitates
"""

import math
import sys
from pathlib import Path

import numpy as np

sys.path.append(str(Path(__file__).resolve().parents[2] / "learner"))
import learner
from things.blocks import Block
from learner import step


def init(aux):
    aux.see = lambda sensor, eye, steps: list(true_blocks(sensor, aux, steps).values())
    learner.init(aux)


def true_blocks(sensor, aux, steps):
    """Returns all objects that exist: a dict from names to Blocks."""
    if "objectNames" not in aux:
        raise ValueError("this brain needs the poses of all objects: use --oracle")
    shown = {step.name: step for step in steps}
    blocks = {}
    for k, name in enumerate(aux.objectNames.split("\n")):
        pose, color, form = sensor.objectPoses[:, :, k], aux.objectColors[k], "block"
        if name in shown:
            # The demonstrated color: looks may have changed it.
            form = shown[name].form
            color = color if shown[name].color is None else shown[name].color
        if not np.isnan(pose).any():
            blocks[name] = block_at(pose, aux.objectSizes[k], color, form)
    return blocks


def block_at(pose, size, color, form):
    """Returns an object as it stands: its height is along the axis that is nearest to the vertical."""
    up = int(np.abs(pose[2, :3]).argmax())
    long, short = sorted((axis for axis in range(3) if axis != up), key=lambda axis: -size[axis])
    yaw = math.atan2(pose[1, long], pose[0, long])
    return Block(np.array(color), np.array([size[long], size[short], size[up]]), pose[:3, 3].copy(), yaw, form=form)
