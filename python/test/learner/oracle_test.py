"""Tests what the oracle of python/examples/agents is told, and what it sees itself."""

import sys
import unittest
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np

sys.path.append(str(Path(__file__).resolve().parents[2] / "examples/agents"))
from check.looking import observe
from check.task_state import TaskState
from oracle import is_only_part
from scenes import EYE, RED, block, picture_of, step


class OracleTest(unittest.TestCase):
    def test_what_is_known_by_its_handle_alone_it_sees_itself(self):
        shown = step(block(RED, np.array([2, 1, 0.5]), 0, 0), [])
        self.assertFalse(is_only_part(shown, {}))
        for size, is_part in (([2, 1, 0.5], False), ([2, 0.5, 1], False), ([4, 1, 0.5], True)):
            told = {shown.name: replace(block(RED, np.array([2, 1, 0.5]), 5, 5), size=np.array(size))}
            self.assertEqual(is_only_part(shown, told), is_part, size)

    def test_it_is_asked_for_steps_and_tools(self):
        shown, tool = step(block(RED, np.ones(3), 0, 0), []), block(RED, np.ones(3), 3, 0)
        asked = []
        state = TaskState([shown], presses=[SimpleNamespace(tool=tool), SimpleNamespace(tool=None)], without=("depth",),
                          see=lambda sensor, eye, wanted: asked.extend(wanted) or [])
        observe(state, None, picture_of([]), EYE)
        self.assertEqual([id(it) for it in asked], [id(shown), id(tool)])


if __name__ == "__main__":
    unittest.main()
