"""The constants of the learner, shared with its twin in Octave: learner/constants.json.

Lengths are in units, colors from 0 to 1; suffixes name other units: _rad, _s, _of_255, _pixels.
Three numbers of places and heights are a range: first, step, last.
"""

import json
from pathlib import Path
from types import SimpleNamespace

import numpy as np

_FILE = Path(__file__).resolve().parents[2] / "learner" / "constants.json"
_GROUPS = {name: SimpleNamespace(**numbers)
           for name, numbers in json.loads(_FILE.read_text()).items()}

BLOCKS = _GROUPS["blocks"]
PERCEPTION = _GROUPS["perception"]
LIGHT = _GROUPS["light"]
GAINS = _GROUPS["gains"]
BALLS = _GROUPS["balls"]
CLEARANCE = _GROUPS["clearance"]
TASK_MODEL = _GROUPS["task_model"]
WATCHING = _GROUPS["watching"]
PARTS = _GROUPS["parts"]
OUTLINES = _GROUPS["outlines"]
ALIGNMENT = _GROUPS["alignment"]
PRESSES = _GROUPS["presses"]
USES = _GROUPS["uses"]
SKYLINE = _GROUPS["skyline"]
RELATE = _GROUPS["relate"]
BELIEFS = _GROUPS["beliefs"]
BUILDING_SITE = _GROUPS["building_site"]
TASK_PLANNING = _GROUPS["task_planning"]
ARMS = _GROUPS["arms"]
MOTION_PLANNING = _GROUPS["motion_planning"]
PICTURES = _GROUPS["pictures"]
JOINT_ESTIMATES = _GROUPS["joint_estimates"]
EXECUTION = _GROUPS["execution"]


def numbers_of(first, step, last):
    """Returns all numbers of a range, including its last one."""
    return np.arange(first, last + step / 2, step)
