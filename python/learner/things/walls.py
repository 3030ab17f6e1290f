"""The walls of containers, as blocks."""

import math

import numpy as np

from constants import CLEARANCE as C
from things.blocks import Block


def container_walls(containers):
    """Returns the walls of some Containers as Blocks, four of each."""
    return [wall for it in containers for wall in walls_of(it)]


def walls_of(container):
    """Returns the walls of a Container as four Blocks."""
    thick = C.wall  # assumed; thinner walls keep fingers away as well
    along = np.array([math.cos(container.yaw), math.sin(container.yaw), 0])
    across = np.array([-along[1], along[0], 0])
    walls = []
    for side in (1, -1):
        for axis, normal in ((0, along), (1, across)):
            size = container.size.copy()
            size[axis] = thick
            off = side * (container.size[axis] - thick) / 2 * normal
            walls.append(Block(container.color, size, container.position + off, container.yaw))
    return walls
