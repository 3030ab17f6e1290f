"""A single arm in the sight of the eye: what the eye sees of it is not an object, and what it hides may be looked for."""

import numpy as np

from act.actions import Action, Grasp
from act.arm_clearance import are_points_clear, is_path_over
from act.arm_points import points_between
from act.postures import turns_of
from act.segments import is_path_valid, move_joints
from check.notes import Note
from constants import MOTION_PLANNING as C
from things.kinds import is_same_kind


def plan_look_aside(places, state, eye, arm, sensor):
    """Plans to move an arm from the line of sight to one of some places on the table, Nx2 [units], the first if possible, and
    to look there. Returns actions; [] if it hides none of them, or finds no posture to wait in meanwhile."""
    q = sensor.arms[arm.index].joints
    hidden = np.reshape(places, (-1, 2))
    hidden = hidden[hides(links_of(arm, q), hidden, eye)]
    postures = []  # the nearest first, each with the path there, and which places it shows
    for angle in sorted(turns_of(arm), key=lambda it: abs(it - q[0])) if len(hidden) else []:
        posture = np.append(angle, arm.parked[1:])
        shown = ~hides(links_of(arm, posture), hidden, eye)
        path = move_joints(arm, [q, posture])
        if shown.any() and is_path_valid(arm, path) and is_path_over(arm, path, state.known):
            postures.append((posture, path, shown))
    for k, place in enumerate(hidden):
        for posture, path, shown in postures:
            if shown[k]:
                state.hand_looks.append(place)
                # What fails if the arm is stopped: no grasp of a block.
                state.grasp = Grasp(arm.forward(posture)[:3, 3], arm.index, 0.0)
                state.notes.append(Note("action", "looks at (%.2f, %.2f), which arm %s hid from the eye" % (*place, arm.name)))
                return [Action("follow", arm, path), Action("observe")]
    return []


def forget_arm(state, arm, sensor):
    """Forgets what was taken for an object and is a part of an arm that waits in view."""
    links = links_of(arm, sensor.arms[arm.index].joints)
    for block in list(state.known):
        is_wanted = any(is_same_kind(block, step) for step in state.steps)
        if not is_wanted and not are_points_clear(links, [block], 0):
            state.known.remove(block)


def links_of(arm, q):
    """Returns points along an arm at joint angles, Nx3 [units]."""
    return points_between(arm.points(q), C.points_per_link)


def hides(links, places, eye):
    """Returns at which places on the table, Nx2 [units], an arm, points along it, comes close to the line of sight from the
    eye: N bool."""
    starts = np.column_stack([places, np.zeros(len(places))])[:, None]
    sights = eye.pose[:3, 3] - starts
    along = ((links - starts) * sights).sum(axis=2) / (sights * sights).sum(axis=2)
    away = links - starts - np.clip(along, 0, 1)[:, :, None] * sights
    return (np.linalg.norm(away, axis=2) < C.arm_radius).any(axis=1)
