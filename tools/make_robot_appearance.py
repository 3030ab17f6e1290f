#!/usr/bin/env python3
"""Writes robots/appearance/: the appearance of Baxter and of the gripper of the 2015 program, as glTF files (docs/robot.md).

    tools/make_robot_appearance.py [FOLDER]

Everything is computed from measurements, so there is nothing to be licensed. Needs numpy.
"""

import pathlib
import sys

from appearance import baxter_arm, baxter_body, baxter_head, classic_gripper, glb
from appearance.glb import Part

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "robots" / "appearance"


def arm_part(link, pieces):
    return Part((f"left_{link}", f"right_{link}"), pieces)


def baxter():
    return [Part(("torso",), baxter_body.torso()), Part(("pedestal",), baxter_body.pedestal()),
            Part(("head",), baxter_head.head()),
            *(Part(("head",), baxter_head.face(mood), mood) for mood in baxter_head.FACES),
            *(arm_part(link.__name__, link()) for link in (
                baxter_arm.upper_shoulder, baxter_arm.lower_shoulder, baxter_arm.upper_elbow, baxter_arm.lower_elbow,
                baxter_arm.upper_forearm, baxter_arm.lower_forearm, baxter_arm.wrist))]


def classic():
    return [Part(("gripper_base",), classic_gripper.palm()),
            Part(("gripper_left_finger",), classic_gripper.left_finger()),
            Part(("gripper_right_finger",), classic_gripper.right_finger())]


if __name__ == "__main__":
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else FOLDER
    glb.write(folder / "baxter.glb", baxter())
    glb.write(folder / "classic.glb", classic())
