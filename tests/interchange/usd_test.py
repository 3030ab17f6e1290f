"""Tests what `smile export --to usd` writes: with OpenUSD's own validators, and against scenes and recordings.

Usage: usd_test.py PROJECT_FOLDER, with the program in SMILE. Ends with 77 where tools/get_usd.sh could not install
OpenUSD.
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
sys.path.append(str(PROJECT / "build/usd"))
try:
    from pxr import Gf, Usd, UsdGeom, UsdLux, UsdPhysics, UsdShade, UsdValidation
except ImportError:
    print("skipped: OpenUSD is not installed, see tools/get_usd.sh")
    sys.exit(77)

import smile

FOLDER = tempfile.TemporaryDirectory()
GOLDEN = PROJECT / "tests/golden/recordings"
NAMESPACE = "http://synapse.cs.umd.edu/tabletop-xml"
DRAWER = f"""<tabletop xmlns="{NAMESPACE}">
  <sliderJoint location="(0,0,1.1)" rotation="(0,0,90)" min="0.5" max="3" init="1">
    <block id="Chest" location="(0,0,0)" mass="0" xspan="2" yspan="2" zspan="2"/>
    <block id="Drawer" location="(0,0,1.5)" mass="0.5" friction="0.5" restitution="0.25" xspan="2"/>
  </sliderJoint>
</tabletop>"""
COUNT = iter(range(10 ** 6))


def export(source, *arguments):
    """The stage that the program writes, and its messages. Each has a name of its own: OpenUSD keeps what it has read."""
    out = Path(FOLDER.name) / f"exported_{next(COUNT)}.usda"
    if isinstance(source, str):
        path = Path(FOLDER.name) / "scene.xml"
        path.write_text(source)
        source = path
    done = subprocess.run([os.environ["SMILE"], "export", source, "--to", "usd", "--out", out, *arguments],
                          check=True, capture_output=True, text=True)
    return Usd.Stage.Open(str(out)), done.stderr


def path_of(id):
    """The prim of an object: names of prims have letters, digits and underscores."""
    return "/World/" + re.sub("[^A-Za-z0-9_]", "_", id)


def pose(stage, path, time=0.0):
    """The place and the rotation matrix of a prim in the world."""
    matrix = np.array(UsdGeom.XformCache(Usd.TimeCode(time)).GetLocalToWorldTransform(stage.GetPrimAtPath(path)))
    return matrix[3, :3], matrix[:3, :3].T


def frame_of(stage, joint, side):
    """The place and the rotation of a joint's frame in the world, by one of its bodies."""
    body, = joint.GetRelationship(f"physics:body{side}").GetTargets()
    place, rotation = pose(stage, body)
    local = np.array(joint.GetAttribute(f"physics:localPos{side}").Get())
    turn = np.array(Gf.Matrix3d(Gf.Quatd(joint.GetAttribute(f"physics:localRot{side}").Get()))).T
    return place + rotation @ local, rotation @ turn


class Exported(unittest.TestCase):
    def assert_valid(self, stage):
        registry = UsdValidation.ValidationRegistry()
        context = UsdValidation.ValidationContext(registry.GetOrLoadAllValidators())
        errors = [error.GetErrorAsString() for error in context.Validate(stage)]
        self.assertEqual(errors, [])

    def assert_is_painted(self, stage):
        """That renderers see each shape in its color, whether they draw materials or display colors."""
        for prim in filter(lambda prim: prim.IsA(UsdGeom.Gprim), stage.Traverse()):
            material, _ = UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial()
            if UsdGeom.Imageable(prim).ComputePurpose() != "default":
                self.assertFalse(material, prim)
                continue
            surface, *_ = material.ComputeSurfaceSource()
            self.assertEqual(surface.GetShaderId(), "UsdPreviewSurface")
            color, = UsdGeom.Gprim(prim).GetDisplayColorAttr().Get()
            self.assertEqual(surface.GetInput("diffuseColor").Get(), color)

    def test_a_validator_finds_what_is_wrong(self):
        stage, _ = export(PROJECT / "scenes/tower.xml", "--no-robot")
        UsdPhysics.RigidBodyAPI.Apply(stage.DefinePrim("/World/materials/body", "Scope"))
        with self.assertRaises(AssertionError):
            self.assert_valid(stage)

    def test_all_shipped_scenes_are_valid_and_have_their_objects(self):
        scenes = sorted((PROJECT / "scenes").glob("*.xml"))
        self.assertGreater(len(scenes), 30)
        for scene in scenes:
            with self.subTest(scene.stem):
                stage, _ = export(scene, "--no-robot")
                self.assert_valid(stage)
                self.assert_is_painted(stage)
                self.assertEqual((UsdGeom.GetStageUpAxis(stage), UsdGeom.GetStageMetersPerUnit(stage)), ("Z", 1))
                with smile.Simulation(smile.load(scene, robot=None)) as sim:
                    for id in sim.object_ids:
                        if sim.objects[id].is_present:
                            place, _ = pose(stage, path_of(id))
                            np.testing.assert_allclose(place, sim.objects[id].position, atol=1e-9)

    def test_a_drawer_has_mass_friction_and_limits(self):
        stage, _ = export(DRAWER, "--no-robot")
        self.assert_valid(stage)
        drawer = stage.GetPrimAtPath("/World/Drawer")
        self.assertTrue(drawer.HasAPI(UsdPhysics.RigidBodyAPI))
        self.assertFalse(stage.GetPrimAtPath("/World/Chest").HasAPI(UsdPhysics.RigidBodyAPI))
        mass = UsdPhysics.MassAPI(drawer)
        self.assertEqual(mass.GetMassAttr().Get(), 0.5)
        # m (a2 + b2) / 12 of 0.2 x 0.1 x 0.1 m, from the smallest; the long axis is x.
        np.testing.assert_allclose(mass.GetDiagonalInertiaAttr().Get(), np.array([0.02, 0.05, 0.05]) * 0.5 / 12, rtol=1e-6)
        axes = Gf.Matrix3d(Gf.Quatd(mass.GetPrincipalAxesAttr().Get()))
        self.assertAlmostEqual(abs(axes[0][0]), 1, places=6)
        material, = stage.GetPrimAtPath("/World/Drawer/collision_1").GetRelationship("material:binding:physics").GetTargets()
        physical = UsdPhysics.MaterialAPI(stage.GetPrimAtPath(material))
        self.assertAlmostEqual(physical.GetDynamicFrictionAttr().Get(), 0.25, places=6)
        self.assertAlmostEqual(physical.GetRestitutionAttr().Get(), 0.25, places=6)
        rail, = [prim for prim in stage.Traverse() if prim.IsA(UsdPhysics.PrismaticJoint)]
        (p0, r0), (p1, r1) = frame_of(stage, rail, 0), frame_of(stage, rail, 1)
        np.testing.assert_allclose(r0, r1, atol=1e-6)
        offset, *aside = r0.T @ (p1 - p0)
        np.testing.assert_allclose(aside, [0, 0], atol=1e-7)
        # At y = -10 cm now; between -30 and -5 cm. One of the two bodies is static.
        sign = 1 if rail.GetRelationship("physics:body1").GetTargets()[0].name == "Drawer" else -1
        ends = [-0.1 + sign * r0[1, 0] * (rail.GetAttribute(f"physics:{limit}Limit").Get() - offset)
                for limit in ("lower", "upper")]
        np.testing.assert_allclose(sorted(ends), [-0.3, -0.05], atol=1e-6)

    def test_lamps_that_are_on_glow(self):
        stage, _ = export(PROJECT / "scenes/dock.xml", "--no-robot")
        surfaces = [UsdShade.Shader(prim) for prim in stage.Traverse() if prim.IsA(UsdShade.Shader)]
        glowing = [surface for surface in surfaces if surface.GetInput("emissiveColor")]
        self.assertTrue(0 < len(glowing) < len(surfaces))
        for surface in glowing:
            self.assertEqual(surface.GetInput("emissiveColor").Get(), surface.GetInput("diffuseColor").Get())

    def test_the_light_is_as_bright_for_a_sun_of_any_size(self):
        stage, _ = export(PROJECT / "scenes/tower.xml", "--no-robot")
        light = UsdLux.DistantLight(stage.GetPrimAtPath("/World/light"))
        self.assertTrue(light.GetNormalizeAttr().Get())
        self.assertEqual(light.GetIntensityAttr().Get(), 3)

    def test_joints_hold_what_they_join(self):
        stage, said = export(PROJECT / "scenes/scissors.xml", "--after", "4")
        self.assert_valid(stage)
        self.assertIn('"String": a chain that tools can cut', said)
        self.assertEqual([*stage.GetDefaultPrim().GetAttribute("smile:left_out").Get()],
                         [line.removeprefix("left out: ") for line in said.splitlines()])
        balls = [prim for prim in stage.Traverse() if prim.IsA(UsdPhysics.SphericalJoint)]
        self.assertEqual(len(balls), 12)
        for ball in balls:
            np.testing.assert_allclose(frame_of(stage, ball, 0)[0], frame_of(stage, ball, 1)[0], atol=1e-3)
        motors = [prim for prim in stage.Traverse() if prim.IsA(UsdPhysics.RevoluteJoint)]
        self.assertGreater(len(motors), 14)
        for motor in motors:
            (p0, r0), (p1, r1) = frame_of(stage, motor, 0), frame_of(stage, motor, 1)
            np.testing.assert_allclose(p0, p1, atol=1e-6)
            np.testing.assert_allclose(r0[:, 0], r1[:, 0], atol=1e-6, err_msg="they turn about x")
            angle = np.degrees(np.arctan2((r0.T @ r1)[2, 1], (r0.T @ r1)[2, 2]))
            self.assertGreater(angle, motor.GetAttribute("physics:lowerLimit").Get() - 0.1)
            self.assertLess(angle, motor.GetAttribute("physics:upperLimit").Get() + 0.1)

    def test_objects_move_as_in_the_recordings(self):
        for name in ("tower", "dial", "spawn", "robot_cut", "imitation"):
            with self.subTest(name):
                stage, said = export(GOLDEN / name)
                self.assertIn("left out: the hands of the demonstrator\n", said)
                self.assert_valid(stage)
                self.assertEqual(stage.GetTimeCodesPerSecond(), 60)
                recording = smile.open(GOLDEN / name)
                self.assertEqual(stage.GetEndTimeCode(), len(recording) - 1)
                for i in [*range(0, len(recording), 9), len(recording) - 1]:
                    for id, expected in zip(recording.object_ids, recording.poses[i], strict=True):
                        self.assert_is_at(stage, path_of(id), i, expected)

    def assert_is_at(self, stage, path, time, expected):
        shown = [UsdGeom.Imageable(prim).ComputeVisibility(time) == "inherited"
                 for prim in Usd.PrimRange(stage.GetPrimAtPath(path))
                 if prim.IsA(UsdGeom.Gprim) and UsdGeom.Imageable(prim).ComputePurpose() == "default"]
        self.assertEqual(any(shown), not np.isnan(expected[0]), f"{path} at {time}")
        if np.isnan(expected[0]):
            return
        place, rotation = pose(stage, path, time)
        np.testing.assert_allclose(place, expected[:3], atol=1e-9)
        right = np.array(Gf.Matrix3d(Gf.Quatd(*expected[3:]))).T
        np.testing.assert_allclose(rotation, right, atol=1e-6)

    def test_the_same_recording_gives_the_same_bytes(self):
        stages = [export(GOLDEN / "imitation")[0] for _ in range(2)]
        first, second = (Path(stage.GetRootLayer().realPath).read_bytes() for stage in stages)
        self.assertEqual(first, second)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
