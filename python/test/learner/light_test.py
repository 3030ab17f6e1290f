"""Tests how the learner knows things in another light than that of the demonstration."""

import unittest

import numpy as np

from check.other_light import know_colors
from check.task_state import TaskState
from scenes import BLUE, BROWN, CUBE, EYE, GREEN, PLANK, RED, block, step, view_of
from see.colors import table_color
from see.light import clear_matches, color_changes
from see.unknown_objects import segment_top_faces

YELLOW, ORANGE, PINK = np.array([1, 1, 0]), np.array([1, 0.5, 0]), np.array([1, 0.7, 0.7])


class LightTest(unittest.TestCase):
    def known(self, wanted, seen):
        """Returns the colors of wanted blocks after a look at seen ones."""
        self.state = TaskState([step(it, []) for it in wanted])
        know_colors(self.state, *self.look(seen))
        return np.array([it.color for it in self.state.steps])

    def look(self, seen):
        picture, heights = view_of(seen)
        picture = np.round(255 * picture) / 255
        return picture, EYE, heights, segment_top_faces(picture, table_color(picture), heights)

    def test_in_the_same_light_nothing_changes(self):
        wanted = [block(RED, CUBE, -2, -2), block(GREEN, CUBE, 0, -2)]
        strange = block(PINK, CUBE, 2, -2)
        np.testing.assert_array_equal(self.known(wanted, [*wanted, strange]), [RED, GREEN])
        self.assertEqual(self.state.unseen_colors, [])

    def test_colors_in_dim_light(self):
        wanted = [block(RED, CUBE, -4, -2), block(ORANGE, CUBE, 0, -2), block(BROWN, PLANK, 0, -4), block(YELLOW, CUBE, 4, -2)]
        strange = block(PINK * 0.7, CUBE, 2, -1)
        dim = [block(it.color * 0.7, it.size, *it.position[:2]) for it in wanted]
        found = self.known(wanted, [strange, *dim])
        np.testing.assert_allclose(found, [it.color for it in dim], atol=0.003)

    def test_a_color_that_has_changed_a_little_is_found_with_the_same_tolerance(self):
        wanted = [block(BROWN, PLANK, 0, -2)]
        np.testing.assert_allclose(self.known(wanted, [block(0.92 * BROWN, PLANK, 0, -2)]), [0.92 * BROWN], atol=0.003)

    def test_what_has_another_size_is_another_thing(self):
        wanted = [block(RED, CUBE, 0, -2)]
        np.testing.assert_array_equal(self.known(wanted, [block(0.8 * RED, 1.3 * CUBE, 0, -2)]), [RED])

    def test_what_is_not_clear_is_not_guessed(self):
        wanted = [block(RED, CUBE, 0, -2)]
        both = [block(np.array(it), CUBE, x, -2) for it, x in (([0.8, 0.06, 0], 0), ([0.8, 0, 0.06], 3))]
        np.testing.assert_array_equal(self.known(wanted, both), [RED])

    def test_what_was_hidden_is_found_later_and_what_was_found_is_kept(self):
        wanted = [block(RED, CUBE, -2, -2), block(BLUE, CUBE, 2, -2)]
        dim = [block(0.7 * it.color, CUBE, *it.position[:2]) for it in wanted]
        np.testing.assert_allclose(self.known(wanted, dim[:1]), [0.7 * RED, BLUE], atol=0.003)
        know_colors(self.state, *self.look([dim[1], block(RED, CUBE, 0, -4)]))
        found = [it.color for it in self.state.steps]
        np.testing.assert_allclose(found, [0.7 * RED, 0.7 * BLUE], atol=0.003)

    def test_others_of_nearly_its_color_are_not_taken_for_what_is_hidden(self):
        slabs = [block(share * RED, np.array([2.4, 1.4, 1]), x, -2) for share, x in [(0.8, -3), (0.7, 3)]]
        np.testing.assert_array_equal(self.known([block(RED, CUBE, 0, -2)], slabs), [RED])
        know_colors(self.state, *self.look([slabs[0], block(0.7 * RED, CUBE, 3, -2)]))
        np.testing.assert_allclose(self.state.steps[0].color, 0.7 * RED, atol=0.005)

    def test_the_whole_change_is_the_least(self):
        turned = [RED + [0, 0.35, 0], ORANGE + [0, 0.35, 0]]  # red becomes nearly orange, orange nearly yellow
        self.assertEqual(clear_matches(color_changes([RED, ORANGE], turned)), [0, 1])
        self.assertEqual(clear_matches(color_changes([GREEN], turned)), [None])
        self.assertEqual(clear_matches(color_changes([GREEN], [])), [None])


if __name__ == "__main__":
    unittest.main()
