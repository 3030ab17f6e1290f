"""Checks a hand and what it carries along a path against what the eye sees."""

from dataclasses import dataclass

import numpy as np

from act.arm_clearance import samples
from act.arm_points import points_between
from constants import MOTION_PLANNING, SKYLINE as C
from plan.skyline import Skyline, skyline_of


@dataclass
class Surroundings:
    """What a hand and its load must avoid, as widened skylines."""

    of_load: Skyline
    of_arm: Skyline

    def avoids(self, arm, path, load=None):
        """Returns true if an arm, from its fingers on, and its load pass over them on a path."""
        moments = samples(path)
        tools = []
        # What an arm carries is more often in the way than the arm itself, and is tested faster.
        for q in moments:
            tools.append(arm.forward(q))
            if load and not self.of_load.is_below(load.at(tools[-1])):
                return False
        return self.of_arm.is_below(hand_and_forearm(arm, moments, np.array(tools)))


def surroundings_of(points):
    """Returns the Surroundings that visible points are, Nx3 [units]."""
    skyline = skyline_of(points + [0, 0, C.margin])
    return Surroundings(skyline.widened(C.margin), skyline.widened(MOTION_PLANNING.arm_radius))


def hand_and_forearm(arm, q, tools):
    """Returns the lowest points of an arm at rows of joint angles, from its hand to its first joint, and its fingertips, Mx3.

    tools: its poses there, Nx4x4
    """
    fingers = tools[:, None, :3, 3] + np.array([[arm.reach], [0]]) * tools[:, None, :3, 2]
    links = points_between(arm.points(q), MOTION_PLANNING.points_per_link)
    return np.concatenate([fingers.reshape(-1, 3), links.reshape(-1, 3) - [0, 0, MOTION_PLANNING.arm_radius]])
