"""Tests what `smile export --to urdf` writes with MuJoCo's reader of URDF, which tools/get_mujoco.sh installs.

Usage: urdf_test.py PROJECT_FOLDER, with the program in SMILE. Ends with 77 where MuJoCo is not installed.
"""

import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

PROJECT = Path(sys.argv[1])
sys.path.append(str(PROJECT / "tests"))
from installed_mujoco import mujoco

import smile

FOLDER = tempfile.TemporaryDirectory()
NAMESPACE = "http://synapse.cs.umd.edu/tabletop-xml"
DRAWER = f"""<tabletop xmlns="{NAMESPACE}">
  <sliderJoint location="(0,0,1.1)" rotation="(0,0,90)" min="0.5" max="3" init="1">
    <block id="Chest" location="(0,0,0)" mass="0" xspan="2" yspan="2" zspan="2"/>
    <block id="Drawer" location="(0,0,1.5)" mass="0.5" xspan="2"/>
  </sliderJoint>
  <block id="world" location="(5,0,0.5)" rotation="(30,90,-20)"/>
</tabletop>"""
# Without these, MuJoCo drops the names of what cannot move and the folder of meshes.
COMPILER = '<mujoco><compiler fusestatic="false" strippath="false"/></mujoco>'


def export(source, *arguments):
    """The text that the program writes, its messages, and what MuJoCo reads."""
    out = Path(FOLDER.name) / "scene.urdf"
    if isinstance(source, str):
        path = Path(FOLDER.name) / "scene.xml"
        path.write_text(source)
        source = path
    done = subprocess.run([os.environ["SMILE"], "export", source, "--to", "urdf", "--out", out, *arguments],
                          check=True, capture_output=True, text=True)
    text = out.read_text()
    out.write_text(re.sub("(<robot [^>]*>)", lambda found: found[1] + COMPILER, text, count=1))
    model = mujoco.MjModel.from_xml_path(str(out))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    return text, done.stderr, model, data


class Exported(unittest.TestCase):
    def assert_is_at(self, data, name, thing):
        np.testing.assert_allclose(data.body(name).xpos, thing.position, atol=1e-9)
        self.assertGreater(abs(data.body(name).xquat @ thing.quaternion), 1 - 1e-12, name)

    def test_all_shipped_scenes_have_their_objects(self):
        scenes = sorted((PROJECT / "scenes").glob("*.xml"))
        self.assertGreater(len(scenes), 30)
        for scene in scenes:
            with self.subTest(scene.stem):
                _, _, _, data = export(scene, "--no-robot")
                with smile.Simulation(smile.load(scene, robot=None)) as sim:
                    for id in sim.object_ids:
                        if sim.objects[id].is_present:
                            self.assert_is_at(data, id, sim.objects[id])

    def test_a_drawer_has_its_mass_and_slides_between_its_limits(self):
        _, said, model, data = export(DRAWER, "--no-robot")
        self.assertIn('"world": is called "world_2"', said)
        self.assertEqual(float(model.body("Drawer").mass[0]), 0.5)
        # m (a2 + b2) / 12 of 0.2 x 0.1 x 0.1 m, sorted.
        np.testing.assert_allclose(sorted(model.body("Drawer").inertia), np.array([0.02, 0.05, 0.05]) * 0.5 / 12, rtol=1e-9)
        joint = model.joint("Chest_Drawer")
        self.assertEqual(joint.type[0], mujoco.mjtJoint.mjJNT_SLIDE)
        places = []
        for limit in joint.range:
            data.joint("Chest_Drawer").qpos[0] = limit
            mujoco.mj_kinematics(model, data)
            places.append(float(data.body("Drawer").xpos[1]))
        np.testing.assert_allclose(sorted(places), [-0.3, -0.05], atol=1e-9)
        with smile.Simulation(smile.load(Path(FOLDER.name) / "scene.xml", robot=None)) as sim:
            self.assert_is_at(data, "world_2", sim.objects["world"])

    def test_the_robot_has_its_joints(self):
        text, said, model, data = export(PROJECT / "scenes/tower.xml")
        self.assertIn("left out: friction, restitution, gravity, light and cameras: URDF has none\n", said)
        self.assertIn("<!-- left out: friction, restitution, gravity, light and cameras: URDF has none -->", text)
        with smile.Simulation(smile.load(PROJECT / "scenes/tower.xml")) as sim:
            q = sim.robot.arms["left"].q
        for name in ("s0", "s1", "e0", "e1", "w0", "w1", "w2"):
            self.assertEqual(float(data.joint(f"left_{name}").qpos[0]), 0, "it counts from where it is")
        self.assertAlmostEqual(float(model.joint("left_s0").range[1]), 1.70168 - q[0], places=5)
        # The links are where the other exported format, which has another test, puts them.
        out = Path(FOLDER.name) / "scene.mjcf.xml"
        subprocess.run([os.environ["SMILE"], "export", PROJECT / "scenes/tower.xml", "--to", "mjcf", "--out", out],
                       check=True, capture_output=True)
        other = mujoco.MjModel.from_xml_path(str(out))
        there = mujoco.MjData(other)
        mujoco.mj_forward(other, there)
        for i in range(1, other.nbody):
            name = other.body(i).name
            np.testing.assert_allclose(data.body(name).xpos, there.body(name).xpos, atol=1e-9, err_msg=name)
            if other.body(i).dofnum[0] == 0:
                continue  # of what never moves, MuJoCo guesses a mass
            np.testing.assert_allclose(model.body(name).mass, other.body(i).mass, rtol=1e-12, err_msg=name)

    def test_chains_are_reported(self):
        _, said, _, _ = export(PROJECT / "scenes/scissors.xml", "--no-robot")
        self.assertEqual(said.count(": a ball joint; its bodies are free\n"), 11)
        self.assertEqual(said.count(": a joint that closes a loop\n"), 1)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
