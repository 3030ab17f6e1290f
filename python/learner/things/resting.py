"""How objects rest: on which of their faces, and how they get from one to another.

A block that stands on another face looks like another block: its sides are exchanged.
"""

import math
from dataclasses import replace

import numpy as np

from constants import TASK_MODEL as C
from things.kinds import same_size
from things.rotations import rotation_of


def resting_at(appearance, pose):
    """Returns an object at a pose, x y z [units] and three angles about the axes of the table, the first
    about x [degrees], as a Block that stands upright: of its own axes, the one that is vertical there
    becomes that of its height. Things of several colors count as upright: their parts are known from above
    only.

    appearance: the same as a Block that stands on its usual face, its sides along its own axes
    """
    axes = rotation_of(pose[3:6])
    up = int(np.argmax(np.abs(axes[2])))
    is_leaning = abs(axes[2, up]) < math.cos(math.radians(C.max_rest_degrees))
    if up == 2 or is_leaning or appearance.is_round or appearance.parts or appearance.outline:
        return replace(appearance, position=pose[:3], yaw=math.radians(pose[5]))
    along, across = [axis for axis in range(3) if axis != up]
    return replace(appearance, size=appearance.size[[along, across, up]], position=pose[:3],
                   yaw=math.atan2(axes[1, along], axes[0, along]))


def on_each_face(size):
    """Returns the sizes of a block on its faces, as for turned: a list."""
    return [np.append(np.sort(np.delete(size, up))[::-1], size[up]) for up in range(3)]


def turned(size, held):
    """Returns the size of a block, its longer side, its shorter one and its height, after a turn by 90
    degrees about the side by which it is held: 0 for the longer one, 1 for the shorter."""
    sides = sorted([size[held], size[2]], reverse=True)
    return np.array([*sides, size[1 - held]])


def turns_between(size, goal, opening):
    """Returns by which sides a block must be held in turn to get another size by turns, the fewest: a
    list of 0 or 1, as for turned; None if a gripper of an opening cannot."""
    ways = [([], size)]
    for turns, reached in ways:  # grows
        if same_size(reached, goal):
            return turns
        if len(turns) == C.max_turns:
            continue
        ways += [([*turns, held], turned(reached, held)) for held in (1, 0)
                 if reached[held] <= opening]
    return None
