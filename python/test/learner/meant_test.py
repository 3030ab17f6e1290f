"""Tests how one of several objects that look the same is told by what it began on."""

import unittest
from dataclasses import replace
from types import SimpleNamespace

import numpy as np

from check.task_state import TaskState
from explain.start_supports import with_start_supports
from match.meant import follow_meant, meant_blocks
from plan.proposals import propose_moves
from scenes import BLUE, CUBE, GREEN, RED, block, step
from things.steps import TABLE

PLATE = np.array([2.0, 2, 0.2])


class MeantTest(unittest.TestCase):
    def setUp(self):
        # In the demonstration: red cubes on two blue plates, on a green one, and on the table.
        self.plates = [block(BLUE, PLATE, -3, 1), block(BLUE, PLATE, 3, 1), block(GREEN, PLATE, 0, 3)]
        cubes = [block(RED, CUBE, it.position[0], it.position[1], bottom=0.2) for it in self.plates] + [block(RED, CUBE, 0, 0)]
        names = ["Left", "Right", "Green", "A", "B", "C", "D"]
        moves = [np.array([[0, *it.position, 0, 0, 0]]) for it in [*self.plates, *cubes]]
        demo = SimpleNamespace(ids=names, moves=moves, appearances=dict(enumerate([*self.plates, *cubes])))
        self.steps = with_start_supports(demo, [replace(step(it, []), name=name) for it, name in zip(cubes, names[3:])])
        # Here: the plates elsewhere, the right one nearer.
        self.seen = [block(BLUE, PLATE, 2, -4), block(BLUE, PLATE, -4, -2), block(GREEN, PLATE, -1, -1)]
        self.known = self.seen + [block(RED, CUBE, it.position[0], it.position[1], bottom=0.2) for it in self.seen]
        self.known.append(block(RED, CUBE, 5, -1))

    def test_what_it_began_on_tells_an_object_from_others_like_it(self):
        self.assertEqual([it.began_on.name for it in self.steps], ["Left", "Right", "Green", TABLE])
        meant = meant_blocks(self.steps, self.known)
        self.assertEqual({k: position[0] for k, position in meant.items()}, {0: -4, 1: 2, 2: -1, 3: 5})

    def test_nothing_is_told_where_all_began_on_the_same(self):
        demo = SimpleNamespace(ids=["A", "B"], appearances={0: block(RED, CUBE, 0, 0), 1: block(RED, CUBE, 2, 0)})
        steps = [replace(step(demo.appearances[0], []), name="A")]
        self.assertEqual([it.began_on for it in with_start_supports(demo, steps)], [None])

    def test_the_meant_one_is_carried_also_after_it_was_put_aside(self):
        state = TaskState([replace(self.steps[0], position=np.array([0, -4.5, 0.5]))])
        state.known = self.known
        state.meant = meant_blocks(state.steps, self.known)
        def carried():
            return [it.block.position[0] for it in propose_moves(state, state.steps[0], state.known) if it.goal]
        self.assertEqual(carried(), [-4])
        aside = block(RED, CUBE, 6, -5)
        follow_meant(state.meant, self.known[4], aside)
        state.known[4] = aside
        self.assertEqual(carried(), [6])
        state.known.remove(aside)
        self.assertEqual(len(carried()), 3, "it was lost: any other")


if __name__ == "__main__":
    unittest.main()
