"""Actions of the arms, as values."""

from dataclasses import dataclass, field
from typing import Optional

import numpy as np
from smile.motion import Trajectory

from act.arms import Arm
from things.blocks import Block


@dataclass
class Grasp:
    """An attempt to take a block."""

    position: np.ndarray  # of the block's center [units]
    arm: int  # number of the arm
    yaw: float  # direction from finger to finger [rad]
    too_heavy: Optional[Block] = None  # the block, if the arm could not lift it


@dataclass
class Action:
    """An action, with the values that are needed in its next step."""

    kind: str  # 'observe': waits for a picture of the arms at rest
    #            'look': waits for a picture of the camera of an arm's hand
    #            'follow': follows a path with an arm
    #            'lift': likewise, with a block; fails as soon as the arm does not keep up
    #            'push': likewise, with a block in front of the fingers
    #            'press': likewise, until something stops it, and back
    #            'open': brings the fingers of an arm to an opening
    #            'grasp': closes the fingers on a block of a width
    arm: Arm = None
    path: Trajectory = None
    to: float = 0  # [units]
    width: float = 0  # [units]
    grasp: Optional[Grasp] = None  # which one it attempts

    time: float = 0  # since its start [s]
    opening: float = np.inf  # at which the fingers came to rest [units]
    still_time: float = 0  # since then [s]
    turn: float = np.inf  # time at which a press went back [s]
    pictures: list = field(default_factory=list)  # of the arms at rest
    noise: float = 0  # of the first of them


def ticks_within(seconds, aux):
    """Returns the number of whole ticks in some time, as far as a step can last that long."""
    return int(min(max(seconds // aux.tickSeconds, 0), aux.maxTicks))
