"""The step in which a carried object is put where it ends."""

import math

import numpy as np

from constants import BLOCKS
from explain.object_roles import is_same_pose
from things.kinds import same_size
from things.parts import turned
from things.resting import resting_at
from things.steps import Step


def step_of(demo, n, appearance, attention):
    """Returns the Step of a carried object, at its final place; appearance: the Block at its first
    place."""
    color = appearance.color if color_matters(attention, demo.ids[n]) else None
    there = resting_at(appearance, demo.moves[n][-1, 1:])
    size, yaw, parts = there.size, there.yaw, there.parts
    if size[1] > BLOCKS.equal_sides * size[0] and not there.outline:
        size = size[[1, 0, 2]]
        yaw += math.pi / 2
        parts = turned(parts, math.pi / 2)
    began = np.append(np.sort(appearance.size[:2])[::-1], appearance.size[2]) if not there.outline else size
    return Step(color, size, there.position, yaw, demo.ids[n], [],
                start_size=None if same_size(began, size) else began, start=demo.moves[n][0, 1:4],
                form=appearance.form, has_knob=appearance.has_knob, parts=parts,
                outline=appearance.outline, knob=appearance.knob, other_knobs=appearance.other_knobs,
                begins_there=is_same_pose(demo.moves[n][0, 1:], demo.moves[n][-1, 1:]))


def color_matters(attention, name):
    """Returns true unless the demonstrator specified the properties of an object that matter,
    without color."""
    return "color" in (attention.get(name) or ["color"])
