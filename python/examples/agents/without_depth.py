"""The learner without depth: heights follow from the sizes of tops in the picture alone.

    smile imitate DEMO SCENE --brain python/examples/agents/without_depth.py

smile: imitates
"""

import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[2] / "learner"))
import learner
from learner import step


def init(aux):
    aux.without = ["depth"]
    learner.init(aux)
