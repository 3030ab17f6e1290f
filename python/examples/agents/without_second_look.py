"""The learner without a second look: it plans from its first picture, and believes that each
action succeeds.

    smile imitate DEMO SCENE --brain python/examples/agents/without_second_look.py

smile: imitates
"""

import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[2] / "learner"))
import learner
from learner import step


def init(aux):
    aux.without = ["second look"]
    learner.init(aux)
