"""Plans how an arm that was stopped parks."""

import numpy as np

from act.actions import Action
from act.segments import at_height, move_joints
from constants import MOTION_PLANNING as C


def retreat(arm, q, can_rise):
    """Returns the actions of an arm that was stopped: opens the gripper, rises as far as possible,
    parks, and observes.

    q:        its joint angles [rad]
    can_rise: false if it was stopped while rising: then it parks directly
    """
    actions = [Action("open", arm, to=min(C.retreat_opening, arm.opening))]
    here = arm.forward(q)
    heights = np.arange(C.retreat_height, here[2, 3] + C.retreat_step, -C.retreat_step)
    for height in heights if can_rise else []:
        path, _ = arm.robot.move_line(arm.name, q, at_height(here, height), speed=C.retreat_speed)
        if path:
            actions.append(Action("follow", arm, path))
            q = path.positions[-1]
            break
    to_park = move_joints(arm, [q, arm.parked])
    return [*actions, Action("follow", arm, to_park), Action("observe")]
