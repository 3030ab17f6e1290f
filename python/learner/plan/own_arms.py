"""The robot's own arms in the sight of its eye: what they look like is no object, and what they hide may be looked for."""

import numpy as np

from act.actions import Action, Grasp
from act.arm_clearance import is_path_over
from act.arm_points import points_between
from act.segments import is_path_valid, move_joints
from check.notes import Note
from constants import ARMS, MOTION_PLANNING as C, numbers_of


def plan_look_aside(place, state, eye, arms, sensor):
    """Plans to move an arm that hides a place, x y z [units], from the eye, and to look there. Returns actions; [] if none
    does, or it finds no posture to wait in meanwhile."""
    for arm in arms:
        q = sensor.arms[arm.index].joints
        if not hides(arm, q, place, eye):
            continue
        lower, upper = (limit[0] * ARMS.parked_limit for limit in arm.robot.limits(arm.name))
        for angle in sorted(numbers_of(lower, ARMS.parked_turn_rad, upper), key=lambda it: abs(it - q[0])):
            there = np.append(angle, arm.parked[1:])
            path = move_joints(arm, [q, there])
            if not hides(arm, there, place, eye) and is_path_valid(arm, path) and is_path_over(arm, path, state.known):
                state.hand_looks.append(place[:2])
                # What fails if the arm is stopped: no grasp of a block.
                state.grasp = Grasp(arm.forward(there)[:3, 3], arm.index, 0.0)
                state.notes.append(Note("action", "looks at (%.2f, %.2f), which arm %s hid from the eye" % (*place[:2], arm.name)))
                return [Action("follow", arm, path), Action("observe")]
    return []


def forget_arms(state, arms, sensor):
    """Forgets unknown objects that are parts of the arms, where these wait in view."""
    for arm in arms:
        links = points_between(arm.points(sensor.arms[arm.index].joints), C.points_per_link)
        for block in list(state.known):
            is_unknown = any(it.size is block.size for it in state.unknown_objects)
            away = np.linalg.norm(links - block.position, axis=1).min()
            if is_unknown and away < C.arm_radius + max(block.size) / 2:
                state.known.remove(block)


def hides(arm, q, place, eye):
    """Returns true if an arm at joint angles comes close to the line of sight from the eye to a place."""
    sight = eye.pose[:3, 3] - place
    points = points_between(arm.points(q), C.points_per_link) - place
    along = np.clip(points @ sight / (sight @ sight), 0, 1)
    away = np.linalg.norm(points - along[:, None] * sight, axis=1)
    return bool((away < C.arm_radius).any())
