"""The networks that the policy consists of: for training with JAX and for acting with numpy.

    decide  which arm moves now, and to what: to an object, to the table, or to where it waits
    place   where on the table it puts down what it holds
    turn    with which of the quarter turns it arrives there
    move    where its tool is in the next second

An arm sees the world as a left arm does: a right arm sees it in a mirror. A tool and an object are rows of
x, y, z [units] and yaw [rad]; a tool's fifth number is its opening [units]. A goal is what an arm moves to, with
the yaw in which the tool arrives. xp is numpy or jax.numpy.
"""

import math

import numpy as np

STEPS = 10       # of .1 s in a chunk
STEP_TICKS = 6   # of the simulator in a step
OUTPUTS = 5      # of a step: displacement x y z [units] and yaw [rad] since the chunk began; opening
SHARES = 3       # of a step: of the way to the goal in the plane, of the height, and of the turn
TURNS = 4        # quarter turns in either direction
HELD = 1.05      # openings below are those of a gripper that holds a block [units]
RISE = 1.0       # straight up, after the gripper has closed or opened, before the tool goes anywhere else [units]
OPENING, OPENING_SCALE = 1.1, 5  # the opening that is mapped to 0, and by how much others are


def run(xp, layers, x):
    for weights, biases in layers[:-1]:
        x = x @ weights + biases
        x = x / (1 + xp.exp(-x))
    return x @ layers[-1][0] + layers[-1][1]


def see(xp, own, other, objects, side):
    """(…, n): what `decide` and `place` get. own, other: (…, 5); objects: (…, N, 4); side: (…, 1) 0 or 1, of the arm."""
    parts = [*tool(xp, own), *tool(xp, other), side]
    for k in range(objects.shape[-2]):
        for reference in (own, other, *(objects[..., before, :] for before in range(k))):
            parts += relation(xp, reference, objects[..., k, :], (1, 0.2), 0)
    return xp.concatenate(parts, axis=-1)


def aim(xp, own, target, side):
    """(…, n): what `turn` gets. target: (…, 4) of the goal, its yaw within an eighth of a turn."""
    parts = [*tool(xp, own), side, target[..., :3] / 5, target[..., 3:4], *angles(xp, target[..., 3:4], 4),
             *relation(xp, own, target, (), 4)]
    return xp.concatenate(parts, axis=-1)


def approach(xp, own, objects, goal, kind, side):
    """(…, n): what `move` gets. kind: (…, 3) 1 for the table, 1 for where it waits, 1 for straight up.

    Of the objects it sees only the nearest, to leave it without a touch.
    """
    away = ((objects[..., :3] - own[..., None, :3]) ** 2).sum(axis=-1)
    nearest = xp.take_along_axis(objects, away.argmin(axis=-1)[..., None, None], axis=-2)[..., 0, :]
    return xp.concatenate([*tool(xp, own), kind, side, *relation(xp, own, goal, (1, 0.2, 0.05), 1),
                           xp.tanh((goal[..., 3:4] - own[..., 3:4]) / 0.2), *relation(xp, own, nearest, (1, 0.2), 4)],
                          axis=-1)


def chunk(xp, layers, own, objects, goal, kind, side):
    """(…, STEPS, OUTPUTS): what `move` wants.

    A displacement is a share of the way to the goal, and a rest: "onto it, at that height" is the same
    output wherever the goal is, which a few demonstrations teach precisely.
    """
    y = run(xp, layers, approach(xp, own, objects, goal, kind, side))
    y = y.reshape(*y.shape[:-1], STEPS, OUTPUTS + SHARES)
    way = (goal - own[..., :4])[..., None, :]
    shares = xp.concatenate([y[..., OUTPUTS:OUTPUTS + 1], y[..., OUTPUTS:]], axis=-1)
    return xp.concatenate([y[..., :4] + shares * way, y[..., 4:OUTPUTS]], axis=-1)


def tool(xp, one):
    return [one[..., :3] / 5, one[..., 3:4], *angles(xp, one[..., 3:4], 1), one[..., 4:] - OPENING,
            xp.tanh((one[..., 4:] - OPENING) / 0.05)]


def relation(xp, reference, thing, scales, symmetry):
    """Where a thing is relative to another one, coarsely and finely; symmetry: turns that look alike in a full one."""
    away = thing[..., :3] - reference[..., :3]
    turn = thing[..., 3:4] - reference[..., 3:4]
    return [away / 5, *(xp.tanh(away / scale) for scale in scales), *([turn] if symmetry == 1 else []),
            *(angles(xp, turn, symmetry) if symmetry else [])]


def angles(xp, yaw, symmetry):
    return [xp.sin(symmetry * yaw), xp.cos(symmetry * yaw)]


def mirrored(xp, rows):
    """Tools or objects in a mirror: x and yaw change their signs."""
    return rows * xp.asarray([-1, 1, 1, -1, 1][:rows.shape[-1]], rows.dtype)


def seen_by(tools, objects, arm):
    """The world as an arm sees it: its own tool, the other one, objects, and its side."""
    own, other = tools[arm], tools[1 - arm]
    if arm == 1:
        own, other, objects = (mirrored(np, it) for it in (own, other, objects))
    return own, other, objects, np.array([float(arm)])


def upright(yaw):
    """The same yaw of a block within an eighth of a turn: (-pi/4, pi/4]."""
    return yaw - math.pi / 2 * round(yaw / (math.pi / 2))


def yaw_of_tool(rotation):
    """Direction from finger to finger, seen from above [rad]; rotation: 3x3."""
    return math.atan2(rotation[1, 1], rotation[0, 1])


def yaw_of_object(rotation):
    """Direction of its horizontal axes within an eighth of a turn [rad]."""
    up = abs(rotation[2]).argmax()
    axis = rotation[:, (up + 1) % 3]
    return upright(math.atan2(axis[1], axis[0]))
