"""Tests what is inferred from a demonstration: its steps, its goal, the heights of what was below others."""

import json
import math
import unittest

import numpy as np

from check.progress import open_steps
from check.task_state import TaskState
from explain.appearances import measure_objects
from explain.demonstration import read_demonstration
from explain.explanation import explain
from explain.limits import NotUnderstood
from explain.sentences import page_of
from explain.shown_pictures import select_frames
from explain.task_model import infer_task
from recordings import RecordingTest
from scenes import BLUE, CUBE, DARK, EYE, GREEN, RED, block, picture_of
from things.blocks import yaw_difference


class InferenceTest(RecordingTest):
    """A plank stays; a red cube is put on it, another stays, and a blue cube is moved twice."""

    def setUp(self):
        quarter = np.array([1.0, 4, 1])  # a plank that is longer along its y axis
        self.objects = {"Plank": block(GREEN, quarter, -2, -2, yaw=0.2),
                        "Red": block(RED, CUBE, 3, -3), "Other": block(RED, CUBE, 3, -1),
                        "Blue": block(BLUE, CUBE, 1, -4)}
        self.record(picture_of(self.objects.values()))
        self.write(0, [f"0,create,{name},shape,block" for name in self.objects] + [
            f"0,move,{name},{it.position[0]},{it.position[1]},{it.position[2]},0.0,-0.0,"
            f"{math.degrees(it.yaw)}" for name, it in self.objects.items()])
        self.write(1, ["3,grasp,LeftHand,Blue", "5,move,Blue,0.0,-4.0,2.0,0.0,0.0,0.0",
                       "6,release,LeftHand", "6,move,Blue,0.0,-4.0,0.5,0.0,0.0,0.0"])
        self.write(2, ["7,grasp,AnyHand,Red", "9,release,AnyHand",
                       "9,move,Red,-2.0,-1.5,1.5,1.0E-4,0.0,95.0",
                       "10,grasp,LeftHand,Blue", "11,release,LeftHand",
                       "11,move,Blue,-2.0,-1.5,2.5,0.0,0.0,0.0"])

    def test_steps_come_in_the_order_of_building(self):
        steps, containers = self.infer_task({"Blue": ["size"]})
        self.assertEqual(containers, [])
        self.assertEqual([step.name for step in steps], ["Plank", "Red", "Blue"])
        plank, red, blue = steps
        self.assertEqual([step.on for step in steps], [[], [0], [1]])
        np.testing.assert_allclose(plank.size, [4, 1, 1], atol=0.03)  # the longer side comes first
        self.assertLess(abs(yaw_difference(plank, 0.2 + math.pi / 2)), 1e-9)
        np.testing.assert_allclose(red.position, [-2, -1.5, 1.5])
        self.assertAlmostEqual(red.yaw, math.radians(95))
        np.testing.assert_allclose(red.color, RED)
        self.assertIsNone(blue.color, "the demonstrator specified that only its size matters")

    def test_an_order_that_matters_is_kept(self):
        steps, _ = self.infer_task()
        self.assertEqual([step.after for step in steps], [[], [], []])
        steps, _ = self.infer_task({"Red": ["color", "size", "order"]})
        self.assertEqual([step.after for step in steps], [[], [], [1]])
        state = TaskState(steps)
        state.done = [True, False, False]
        self.assertEqual(open_steps(state), [1])

    def test_what_was_not_moved_stays(self):
        steps, _ = self.infer_task()
        self.assertEqual([step.stays for step in steps], [True, False, False])

    def test_the_goal_is_what_is_made_and_kept(self):
        demo = read_demonstration(self.folder)
        steps, containers = infer_task(demo, {})
        explanation = explain(demo, containers)
        self.assertEqual([it.deed for it in explanation.keyframes],
                         ["", "LeftHand carries Blue", "AnyHand carries Red", "LeftHand carries Blue"])
        self.assertEqual([it.is_means for it in explanation.keyframes], [False, True, False, False])
        self.assertIn("on Blue table", explanation.keyframes[2].facts)
        self.assertEqual(explanation.goal, ["on Red Plank", "place Red Plank 0.10 0.49 84", "on Blue Red",
                                            "place Blue Red 0.00 0.00 -95"])
        stands = {f"on {step.name} {steps[lower].name}" for step in steps for lower in step.on}
        self.assertEqual(stands, {it for it in explanation.goal if it.startswith("on ")}, "the steps say the same")
        page = page_of(explanation)
        self.assertIn("1. LeftHand carries Blue (only a means: nothing of it is kept). New:", page)
        self.assertEqual(page[-1], "  Blue is on Red, at (0.00, 0.00) of Red, rotated by -95 degrees.")

    def test_what_was_only_put_elsewhere_belongs_to_the_nearest_object_that_stayed(self):
        lines = (self.folder / "0.txt").read_text().splitlines()
        (self.folder / "2.txt").unlink()

        def anchors(*events):
            self.write(1, events)
            steps, _ = self.infer_task()
            return [(step.name, step.anchor, step.stays) for step in steps]

        put = ["3,grasp,LeftHand,Blue", "5,move,Blue,0.0,-4.0,2.0,0.0,0.0,0.0", "6,release,LeftHand"]
        beside = [("Blue", "Red", False), ("Red", "", True)]
        self.assertEqual(anchors(*put, "6,move,Blue,2.0,-4.0,0.5,0.0,0.0,40.0"), beside)
        self.assertEqual(anchors(put[0], put[2], "6,move,Blue,2.0,-4.0,0.5,0.0,0.0,0.0"), beside, "pushed")
        self.assertEqual(anchors(*put, "6,move,Blue,3.0,-3.0,1.5,0.0,0.0,0.0"), [("Red", "", True), ("Blue", "", False)],
                         "on Red, which determines its place")
        # Two are exchanged: as they were, but for a rotation about the vertical; or not.
        other = ["7,grasp,LeftHand,Red", "9,release,LeftHand"]
        exchanged = [*put, "6,move,Blue,3.0,-3.0,0.5,0.0,0.0,0.0", *other]
        self.assertEqual(anchors(*exchanged, "9,move,Red,1.0,-4.0,0.5,0.0,0.0,0.0"),
                         [("Blue", "Other", False), ("Red", "Other", False), ("Other", "", True)])
        self.assertEqual(anchors(*exchanged, "9,move,Red,1.0,-4.0,0.5,0.0,0.0,30.0"),
                         [("Blue", "", False), ("Red", "", False)], "Red is turned relative to Blue")
        self.assertEqual(anchors(*exchanged, "9,move,Red,1.8,-4.0,0.5,0.0,0.0,0.0"),
                         [("Blue", "", False), ("Red", "", False)], "they are nearer to each other")
        # Nothing else is there.
        self.write(0, [line for line in lines if "Blue" in line])
        self.assertEqual(anchors(*put, "6,move,Blue,2.0,-4.0,0.5,0.0,0.0,40.0"), [("Blue", "the table", False)])

    def test_an_object_is_measured_where_a_pixel_shows_the_least_of_it(self):
        self.write(3, [f"{12 + k},move,Blue,-2.0,1.0,{height},0.0,0.0,0.0" for k, height in enumerate((8, 6, 3))])
        frames = select_frames(read_demonstration(self.folder), list(self.objects).index("Blue"))
        self.assertEqual(frames[0, 0], 0, "its first place comes first")
        away = EYE.pose[:3, 3] - frames[1:, 1:4]
        extents = (away**2).sum(axis=1) / away[:, 2]
        self.assertTrue((np.diff(extents) >= 0).all(), extents)
        self.assertEqual(frames[-1, 3], 8, "high and far from the eye, it is seen at a grazing angle")

    def test_a_recording_without_pictures_is_reported(self):
        file = self.folder / "demo.json"
        file.write_text(json.dumps(json.loads(file.read_text()) | {"eye": None}))
        with self.assertRaisesRegex(ValueError, "has no pictures"):
            read_demonstration(self.folder)

    def test_an_arm_over_an_object_is_not_taken_for_it(self):
        self.record(*(picture_of([it]) for it in (block(DARK, np.array([0.7, 0.9, 1]), 3, -3), block(RED, CUBE, -3, -3, bottom=1),
                                                  block(RED, CUBE, -3, -3))))
        self.write(0, ["0,create,Red,shape,block", "0,move,Red,3.0,-3.0,0.5,0.0,0.0,0.0"])
        self.write(1, ["1,grasp,LeftHand,Red", "1,move,Red,-3.0,-3.0,1.5,0.0,0.0,0.0",
                       "2,move,Red,-3.0,-3.0,0.5,0.0,0.0,0.0", "3,release,LeftHand"])
        red = measure_objects(read_demonstration(self.folder), [0])[0]
        np.testing.assert_allclose([*red.color, *red.size], [*RED, *CUBE], atol=0.03)

    def test_what_is_still_held_at_the_end_is_not_understood(self):
        self.assertEqual(read_demonstration(self.folder).unclear, [])
        self.write(3, ["12,grasp,RightHand,Other"])
        self.assertEqual(read_demonstration(self.folder).unclear, ["why Other is still held at the end"])
        self.write(3, ["12,grasp,RightHand,Blue"])
        self.assertEqual([step.name for step in self.infer_task()[0]], ["Plank", "Red"], "the rest is done")

    def test_what_cannot_be_inferred_is_reported(self):
        with self.assertRaisesRegex(FileNotFoundError, "there is no recording in .*0.txt"):
            read_demonstration(self.folder / "rgb")
        demo = read_demonstration(self.folder)
        demo.placed.clear()
        with self.assertRaisesRegex(NotUnderstood, "no hand moved anything to a place"):
            infer_task(demo, {})
        (self.folder / "rgb/0.png").unlink()
        with self.assertRaisesRegex(NotUnderstood, "no picture of the demonstration shows Red entirely"):
            self.infer_task()


class UnstackingTest(RecordingTest):
    """A tower is taken apart. Its lower blocks, a half and a cube, are visible only later."""

    def setUp(self):
        tower = [block(RED, np.array([1, 1, 0.5]), -2, -2), block(GREEN, CUBE, -2, -2, bottom=0.5),
                 block(BLUE, CUBE, -2, -2, bottom=1.5)]
        apart = [block(it.color, it.size, x, -3) for it, x in zip(tower, (-2, 0, 2))]
        self.record(picture_of(tower), picture_of([*tower[:2], apart[2]]),
                    picture_of([tower[0], *apart[1:]]))
        names = ["Red", "Green", "Blue"]
        lifted = block(RED, CUBE, 3, 0, bottom=4)
        self.write(0, [f"0,create,{name},shape,block" for name in names] + [
            self.move(0, name, it) for name, it in zip(names, tower)])
        self.write(1, ["1,grasp,AnyHand,Blue", self.move(1, "Blue", lifted),
                       self.move(1, "Blue", apart[2]), "1,release,AnyHand",
                       "2,grasp,AnyHand,Green", self.move(2, "Green", lifted),
                       self.move(2, "Green", apart[1]), "2,release,AnyHand",
                       "3,grasp,AnyHand,Red", self.move(3, "Red", lifted),
                       self.move(3, "Red", apart[0]), "3,release,AnyHand"])

    @staticmethod
    def move(frame, name, it):
        return f"{frame},move,{name},{it.position[0]},{it.position[1]},{it.position[2]},0.0,0.0,0.0"

    def test_heights_follow_from_what_is_below(self):
        steps, _ = self.infer_task()
        self.assertEqual([step.name for step in steps], ["Blue", "Green", "Red"])
        for step, height in zip(steps, (1, 1, 0.5)):
            np.testing.assert_allclose(step.size, [1, 1, height], atol=0.03)
            self.assertEqual(step.on, [])


class TurningTest(RecordingTest):
    def test_what_began_on_its_side_is_laid_down(self):
        began = block(RED, np.array([3, 0.5, 1]), -2, -2, yaw=math.radians(30))
        ends = block(RED, np.array([3, 1, 0.5]), 2, -3)
        self.record(picture_of([began]), picture_of([ends]))
        self.write(0, ["0,create,Plank,shape,block", "0,move,Plank,-2.0,-2.0,0.5,90.0,0.0,30.0"])
        self.write(1, ["1,grasp,AnyHand,Plank", "1,move,Plank,2.0,-3.0,0.25,0.0,0.0,0.0", "1,release,AnyHand"])
        [[found], _] = self.infer_task()
        np.testing.assert_allclose(found.size, ends.size, atol=0.03)
        np.testing.assert_allclose(found.start_size, began.size, atol=0.03)
        self.assertAlmostEqual(yaw_difference(ends, found.yaw), 0, delta=0.02)


if __name__ == "__main__":
    unittest.main()
