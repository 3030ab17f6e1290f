"""The numbers of the learner, which it shares with its twin: learner/constants.json.

Lengths are in units, colors from 0 to 1; a name says where a number has another unit: _rad, _s,
_pixels. Three numbers of places and heights are a range: first, step, last.
"""

import json
from pathlib import Path
from types import SimpleNamespace

import numpy as np

_FILE = Path(__file__).resolve().parents[2] / "learner" / "constants.json"
_GROUPS = {name: SimpleNamespace(**numbers)
           for name, numbers in json.loads(_FILE.read_text()).items()}

BLOCKS = _GROUPS["blocks"]
SEE = _GROUPS["see"]
ROOM = _GROUPS["room"]
UNDERSTAND = _GROUPS["understand"]
DECIDE = _GROUPS["decide"]
CARRY = _GROUPS["carry"]
ACT = _GROUPS["act"]


def numbers_of(first, step, last):
    """All numbers of a range, its last one with them."""
    return np.arange(first, last + step / 2, step)
