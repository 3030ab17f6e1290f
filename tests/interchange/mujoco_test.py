"""Tests what `smile export --to mjcf` writes with MuJoCo itself, which tools/get_mujoco.sh installs.

Usage: mujoco_test.py PROJECT_FOLDER, with the program in SMILE. Ends with 77 where MuJoCo is not installed.
"""

import os
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
TOWER = f"""<tabletop xmlns="{NAMESPACE}">
  <block location="(0,0,0.5)" id="A" mass="2" xspan="1" yspan="2" zspan="1"/>
  <block location="(0,0,1.5)" rotation="(0,0,30)" id="B" mass="0.5"/>
  <cylinder location="(0,0,2.5)" rotation="(90,0,0)" id="C" mass="1" radius="0.4" yspan="1"/>
  <block location="(0,0,3.5)" id="D" mass="0.1"/>
</tabletop>"""
DRAWER = f"""<tabletop xmlns="{NAMESPACE}">
  <sliderJoint location="(0,0,1.1)" rotation="(0,0,90)" min="0.5" max="3" init="1">
    <block id="Chest" location="(0,0,0)" mass="0" xspan="2" yspan="2" zspan="2"/>
    <block id="Drawer" location="(0,0,1.5)" mass="0.5" color="red"/>
  </sliderJoint>
</tabletop>"""


def export(scene, *arguments):
    """The text that the program writes for a scene, and its messages."""
    source, out = Path(FOLDER.name) / "scene.xml", Path(FOLDER.name) / "scene.mjcf.xml"
    if scene.startswith("<"):
        source.write_text(scene)
    else:
        source = PROJECT / f"scenes/{scene}.xml"
    done = subprocess.run([os.environ["SMILE"], "export", source, "--to", "mjcf", "--out", out, *arguments],
                          check=True, capture_output=True, text=True)
    return mujoco.MjModel.from_xml_path(str(out)), done.stderr


def begin(model):
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    return data


def advance(model, data, seconds):
    for _ in range(round(seconds / model.opt.timestep)):
        mujoco.mj_step(model, data)
    assert not any(warning.number for warning in data.warning), "MuJoCo warns of numbers that are not finite"


class Exported(unittest.TestCase):
    def test_a_tower_has_its_masses_and_stands_for_a_minute(self):
        model, said = export(TOWER, "--no-robot")
        self.assertEqual(said, "")
        self.assertEqual([float(model.body(name).mass[0]) for name in "ABCD"], [2, 0.5, 1, 0.1])
        # Of a block, m (a2 + b2) / 12 about each axis; of the cylinder, whose axis is y here, m r2 / 2 about that.
        inertia = {name: np.diag(rotated_inertia(model, name)) for name in "ABC"}
        np.testing.assert_allclose(inertia["A"], np.array([0.05, 0.02, 0.05]) * 2 / 12, rtol=1e-9)
        np.testing.assert_allclose(inertia["B"], np.array([0.02, 0.02, 0.02]) * 0.5 / 12, rtol=1e-9)
        np.testing.assert_allclose(inertia["C"], [0.01 / 12 + 0.0016 / 4, 0.0016 / 2, 0.01 / 12 + 0.0016 / 4],
                                   rtol=1e-9)
        data = begin(model)
        start = data.xpos.copy()
        advance(model, data, 60)
        self.assertLess(np.linalg.norm(data.xpos - start, axis=1).max(), 0.001)

    def test_all_shipped_scenes_load_with_their_objects(self):
        scenes = sorted(path.stem for path in (PROJECT / "scenes").glob("*.xml"))
        self.assertGreater(len(scenes), 30)
        for scene in scenes:
            with self.subTest(scene):
                model, said = export(scene, "--no-robot", "--after", "1")
                self.assertNotIn("do not hold yet", said)
                with smile.Simulation(smile.load(PROJECT / f"scenes/{scene}.xml", robot=None)) as sim:
                    sim.step(60)
                    data = begin(model)
                    for id in sim.object_ids:
                        if sim.objects[id].is_present:
                            np.testing.assert_allclose(data.body(id).xpos, sim.objects[id].position, atol=1e-9)
                advance(model, data, 0.2)

    def test_a_drawer_slides_between_its_limits(self):
        model, _ = export(DRAWER, "--no-robot")
        data = begin(model)
        np.testing.assert_allclose(data.body("Drawer").xpos, [0, -0.1, 0.26], atol=1e-12)
        for force, limit in ((-5, -0.3), (5, -0.05)):
            data.xfrc_applied[model.body("Drawer").id, 1] = force
            advance(model, data, 3)
            np.testing.assert_allclose(data.body("Drawer").xpos, [0, limit, 0.26], atol=0.001)

    def test_a_string_bears_its_weight_once_it_has_come_down(self):
        _, said = export("scissors", "--no-robot")
        self.assertIn("12 joints do not hold yet", said)
        self.assertIn('"String": a chain that tools can cut', said)
        model, said = export("scissors", "--no-robot", "--after", "4")
        self.assertNotIn("do not hold yet", said)
        data = begin(model)
        before = data.body("Weight").xpos.copy()
        advance(model, data, 5)
        self.assertLess(np.linalg.norm(data.body("Weight").xpos - before), 0.005)

    def test_its_rays_hit_what_the_cameras_see(self):
        model, _ = export("tower")
        data = begin(model)
        with smile.Simulation(smile.load(PROJECT / "scenes/tower.xml")) as sim:
            for camera in ("eye", "left_hand"):
                with self.subTest(camera):
                    depth = sim.render(camera, (64, 48), ("depth",)).depth
                    self.assertGreater((depth > 0).mean(), 0.5)
                    self.assertGreater(agreement(model, data, camera, depth), 0.97)

    def test_the_robot_turns_as_its_servos_are_told(self):
        model, _ = export("tower")
        data = begin(model)
        joint = model.joint("left_s0")
        start = float(data.joint("left_s0").qpos[0])
        advance(model, data, 5)
        self.assertLess(abs(float(data.joint("left_s0").qpos[0]) - start), 1e-3, "it holds itself up")
        data.actuator("left_s0").ctrl[0] = -0.2
        advance(model, data, 1)
        self.assertAlmostEqual(float(data.joint("left_s0").qpos[0]), start - 0.2, delta=0.02)
        self.assertAlmostEqual(float(joint.range[1]), 1.70168, places=5)


def rotated_inertia(model, name):
    """The inertia of a body along its own axes."""
    axes = np.zeros(9)
    mujoco.mju_quat2Mat(axes, model.body(name).iquat)
    axes = axes.reshape(3, 3)
    return axes @ np.diag(model.body(name).inertia) @ axes.T


def agreement(model, data, camera, depth):
    """The share of pixels at which a ray hits something as far away as the picture says, within 2 mm."""
    height, width = depth.shape[:2]
    focal = height / 2 / np.tan(np.radians(model.camera(camera).fovy[0]) / 2)
    axes, place = data.camera(camera).xmat.reshape(3, 3), data.camera(camera).xpos
    groups = np.array([0, 0, 1, 0, 0, 0], np.uint8)
    right, num = 0, 0
    for row in range(1, height, 4):
        for column in range(1, width, 4):
            ray = np.array([(column + 0.5 - width / 2) / focal, (height / 2 - row - 0.5) / focal, -1])
            hit = np.array([-1], np.int32)
            # A camera does not see the body that carries it; of nothing, a picture says 0.
            own = model.cam_bodyid[model.camera(camera).id]
            far = mujoco.mj_ray(model, data, place, axes @ ray, groups, 1, own if own > 0 else -1, hit)
            num += 1
            right += abs(max(0, far) - float(depth[row, column])) < 0.002
    return right / num


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
