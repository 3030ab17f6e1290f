"""Tests where the building goes."""

import math
import unittest
from dataclasses import replace
from unittest.mock import patch

import numpy as np

from check.task_state import TaskState
from match.anchored_places import place_at_anchor
from match.building_site import choose_site, shifted
from match.landmarks import place_by_what_stays
from match.sites import NoSite, first_within_reach, site_cost
from scenes import BLUE, BROWN, CUBE, EYE, GREEN, PLANK, RED, block, step
from things.steps import TABLE


class SiteTest(unittest.TestCase):
    def test_the_building_is_where_the_demonstration_moved_nothing(self):
        bases = [block(BROWN, PLANK, 1, -2, yaw=0.1), block(BROWN, CUBE, 1, 0)]
        state = TaskState([replace(step(it, []), stays=True) for it in bases])
        turned = [block(BROWN, PLANK, -2, -2, yaw=0.1 - math.pi / 2), block(BROWN, CUBE, 0, -2),
                  block(BROWN, PLANK, 3, -2, yaw=0.3)]
        state.known = turned
        choose_site(state, [], None, EYE)
        np.testing.assert_allclose([it.position for it in state.steps],
                                   [it.position for it in turned[:2]], atol=1e-9)

    def test_each_object_that_stays_determines_where_the_steps_on_it_go(self):
        plates = [replace(step(block(RED, np.array([2, 2, 0.2]), -2, 1), []), stays=True),
                  replace(step(block(BLUE, np.array([2, 2, 0.2]), 2, 1), []), stays=True)]
        steps = [*plates, step(block(GREEN, CUBE, -2, 1, bottom=0.2), [0]),
                 step(block(RED, CUBE, 2, 1.2, bottom=0.2), [1])]
        known = [block(RED, plates[0].size, -3, -2), block(BLUE, plates[0].size, 2, -3, yaw=0.3)]
        with patch("match.sites.is_reachable", return_value=True), patch("match.sites.nearest_first"):
            moved = place_by_what_stays(steps, known, [], EYE)
        np.testing.assert_allclose(moved[2].position, [-3, -2, 0.7])
        np.testing.assert_allclose(moved[3].position, [2 - 0.2 * math.sin(0.3),
                                                       -3 + 0.2 * math.cos(0.3), 0.7])

    def test_where_all_is_carried_to_a_site_an_arm_reaches_what_stayed_too(self):
        base = replace(step(block(BROWN, CUBE, 0, -2), []), stays=True)
        sites = [(1, [replace(base, position=np.array([x, -2, 0.5])), step(block(RED, CUBE, x, -2, bottom=1), [0])])
                 for x in (-9, 3)]
        with (patch("match.sites.is_reachable", side_effect=lambda _, it: it.position[2] > 1 or it.position[0] > 0),
              patch("match.sites.nearest_first")):
            self.assertIs(first_within_reach(sites, []), sites[0][1])
            self.assertIs(first_within_reach(sites, [], all_carried=True), sites[1][1])

    def test_what_was_put_beside_something_goes_beside_it(self):
        wall = replace(step(block(BROWN, PLANK, 0, -2), []), stays=True, name="Wall")
        beside = replace(step(block(BLUE, CUBE, 2.8, -2), []), anchor="Wall", name="Blue")
        known = [block(BLUE, CUBE, -5, -2), block(BROWN, PLANK, -1, -3, yaw=math.pi / 2)]
        with patch("match.sites.is_reachable", return_value=True), patch("match.sites.nearest_first"):
            moved = place_at_anchor([beside, wall], known, [], EYE)
            np.testing.assert_allclose(moved[0].position, [-1, -0.2, 0.5])
            # One end is out of view: it goes beside the other one.
            moved = place_at_anchor([beside, wall], [block(BROWN, PLANK, 6.4, -2)], [], EYE)
            np.testing.assert_allclose(moved[0].position, [3.6, -2, 0.5])
            for seen, words in (([known[0]], "nothing is seen that looks like Wall, beside which Blue goes"),
                                ([block(BROWN, PLANK, 0, -8.5)], "relative to Wall, the place of Blue is out of reach or out of view")):
                with self.assertRaisesRegex(NoSite, words):
                    place_at_anchor([beside, wall], seen, [], EYE)
            with self.assertRaisesRegex(NoSite, "Wall, beside which Blue goes, could not be measured in the demonstration"):
                place_at_anchor([beside], known, [], EYE)
            on_table = replace(beside, anchor=TABLE)
            np.testing.assert_allclose(place_at_anchor([on_table], known, [], EYE)[0].position, beside.position)

    def test_a_site_must_not_hide_needed_blocks(self):
        steps = [step(block(BLUE, CUBE, 0, -2, bottom=k), []) for k in range(3)]
        needed = block(BLUE, CUBE, 0, -0.2)
        on_unseen = block(RED, CUBE, 0, -0.2, bottom=1)
        self.assertEqual(site_cost(steps, [needed], EYE), 0.25)
        self.assertEqual(site_cost(steps, [on_unseen], EYE), 1)
        self.assertEqual(site_cost(steps, [block(RED, CUBE, 0, -0.2)], EYE), 0)
        self.assertEqual(site_cost(shifted(steps, [3, 0]), [needed], EYE), 0)


if __name__ == "__main__":
    unittest.main()
