"""Looks at what something hides from the eye: by the camera of a hand, or after an arm without one has moved aside."""

import numpy as np

from act.actions import Action, Grasp
from act.grippers import nearest_first
from check.notes import Note
from constants import TASK_PLANNING as C
from plan.arm_paths import plan_path_through
from plan.heights import transfer_height
from plan.own_arms import plan_look_aside
from see.eye import height_map
from see.unexplained import hidden_ground, is_within
from things.kinds import is_same_kind


def plan_hand_look(steps, state, free, eye, arms, sensor):
    """Plans to look at the largest part of the table that something hides from the eye, if a block that one of some steps
    needs is not known. Returns actions; [] if there is no such part, or none that was not looked at before.

    steps: their numbers
    free:  the known blocks that are in no step's place
    """
    seeing = [arm for arm in arms if arm.camera]
    is_missing = any(not any(is_same_kind(it, state.steps[k]) for it in free) for k in steps)
    if not is_missing or "depth" in state.without or len(state.hand_looks) >= C.max_hand_looks:
        return []
    hidden = hidden_ground(height_map(sensor.depthVision, eye), eye)
    hidden = hidden[~is_within(hidden, state.known, 0)]
    hidden = [it for it in sorted(hidden, key=lambda it: -(distances(hidden, it) < C.hand_look_radius).sum())
              if all(np.linalg.norm(it - other) >= C.hand_look_radius for other in state.hand_looks)]
    if not seeing and len(sensor.arms) == 1:
        return plan_look_aside(hidden, state, eye, arms[0], sensor)
    for place in hidden:
        for arm in nearest_first(seeing, place[0]):
            # The fingers are in the near half of the picture.
            height = max(C.hand_look_height, transfer_height(arm, state.known, 0, 0))
            over = arm.tool_pose([*(place - [0, C.hand_look_ahead]), height], 0)
            path = plan_path_through(arm, [over], state.known, sensor.arms[arm.index].joints)
            if path:
                state.hand_looks.append(place)
                # What fails if the arm is stopped: no grasp of a block.
                state.grasp = Grasp(over[:3, 3], arm.index, 0.0)
                state.notes.append(Note("action", "looks at (%.2f, %.2f), which something hides from the eye, with arm %s" % (
                    *place, arm.name)))
                there, back = (Action("follow", arm, it) for it in path)
                return [there, Action("look", arm), back, Action("observe")]
    return []


def distances(points, point):
    """Returns the distances of points, Nx2, from a point [units]: N numbers."""
    return np.hypot(*(points - point).T)
