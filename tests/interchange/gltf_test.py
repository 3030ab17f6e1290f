"""Tests what `smile export --to gltf` writes: with Khronos' validator, and against the recordings themselves.

Usage: gltf_test.py PROJECT_FOLDER, with the program in SMILE. Ends with 77 where tools/get_gltf_validator.sh could
not install the validator.
"""

import json
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

PROJECT = Path(sys.argv[1])
NODE = shutil.which("node") or shutil.which("nodejs")
if NODE is None or not (PROJECT / "build/gltf_validator/node_modules/gltf-validator").exists():
    print("skipped: the validator of glTF is not installed, see tools/get_gltf_validator.sh")
    sys.exit(77)

import smile

FOLDER = tempfile.TemporaryDirectory()
GOLDEN = PROJECT / "tests/golden/recordings"
# Positions are single floats, of about a meter.
TOLERANCE = 1e-6


class Gltf:
    """A file as a viewer reads it."""

    def __init__(self, source, *arguments):
        self.path = Path(FOLDER.name) / "exported.glb"
        done = subprocess.run([os.environ["SMILE"], "export", source, "--to", "gltf", "--out", self.path, *arguments],
                              check=True, capture_output=True, text=True)
        self.said, self.bytes = done.stderr, self.path.read_bytes()
        length, = struct.unpack_from("<I", self.bytes, 12)
        self.json = json.loads(self.bytes[20:20 + length])
        self.buffer = self.bytes[28 + length:]

    def accessor(self, index):
        accessor = self.json["accessors"][index]
        view = self.json["bufferViews"][accessor["bufferView"]]
        width = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}[accessor["type"]]
        kind = {5126: "<f4", 5125: "<u4"}[accessor["componentType"]]
        values = np.frombuffer(self.buffer, kind, accessor["count"] * width, view["byteOffset"])
        return values.reshape(accessor["count"], width).astype(float)

    def node(self, name):
        index, = [i for i, node in enumerate(self.json["nodes"]) if node.get("name") == name and "mesh" not in node]
        return index

    def track(self, node, path):
        """Times and values of a node's channel; its constant value where it has none."""
        for animation in self.json.get("animations", []):
            for channel in animation["channels"]:
                if channel["target"] == {"node": node, "path": path}:
                    sampler = animation["samplers"][channel["sampler"]]
                    return self.accessor(sampler["input"])[:, 0], self.accessor(sampler["output"]), sampler
        usual = {"translation": [0, 0, 0], "rotation": [0, 0, 0, 1], "scale": [1, 1, 1]}[path]
        return np.zeros(1), np.array([self.json["nodes"][node].get(path, usual)], float), {"interpolation": "LINEAR"}

    def at(self, node, path, time):
        """The value at a time, as the specification interpolates it."""
        times, values, sampler = self.track(node, path)
        if sampler["interpolation"] == "STEP":
            return values[max(0, np.searchsorted(times, time + 1e-6, "right") - 1)]
        value = np.array([np.interp(time, times, values[:, i]) for i in range(values.shape[1])])
        return value / np.linalg.norm(value) if path == "rotation" else value

    def visible(self, node, time):
        """True if some mesh below a node has a scale other than 0."""
        if "mesh" in self.json["nodes"][node]:
            return True
        return self.at(node, "scale", time).any() and any(
            self.visible(child, time) for child in self.json["nodes"][node].get("children", []))


class Exported(unittest.TestCase):
    def assert_valid(self, gltf):
        done = subprocess.run([NODE, PROJECT / "tests/interchange/validate_gltf.mjs", PROJECT, gltf.path],
                              check=True, capture_output=True, text=True)
        report = json.loads(done.stdout)
        self.assertEqual(report["mimeType"], "model/gltf-binary")
        issues = report["issues"]
        self.assertEqual((issues["numErrors"], issues["numWarnings"]), (0, 0), issues["messages"])

    def assert_moves_as(self, gltf, recording, ticks):
        for index, id in enumerate(recording.object_ids):
            node = gltf.node(id)
            for i in ticks:
                pose, time = recording.poses[i, index], recording.times[i]
                here = not np.isnan(pose[0])
                self.assertEqual(gltf.visible(node, time), here, f"{id} at {time} s")
                if not here:
                    continue
                np.testing.assert_allclose(gltf.at(node, "translation", time), pose[:3], atol=TOLERANCE)
                w, x, y, z = pose[3:]
                along = abs(gltf.at(node, "rotation", time) @ np.array([x, y, z, w]))
                self.assertGreater(along, 1 - 1e-6, f"{id} at {time} s")

    def test_objects_move_as_in_the_recordings(self):
        for name in ("tower", "dial", "spawn", "robot_cut", "imitation"):
            with self.subTest(name):
                gltf, recording = Gltf(GOLDEN / name), smile.open(GOLDEN / name)
                self.assert_valid(gltf)
                self.assertIn("left out: the hands of the demonstrator\n", gltf.said)
                self.assert_moves_as(gltf, recording, range(0, len(recording), 7))
                self.assert_moves_as(gltf, recording, [len(recording) - 1])

    def test_a_rate_has_fewer_keys_and_ends_with_the_last_tick(self):
        recording = smile.open(GOLDEN / "tower")
        every, some = Gltf(GOLDEN / "tower"), Gltf(GOLDEN / "tower", "--rate", "10")
        self.assertLess(len(some.bytes), len(every.bytes))
        self.assert_valid(some)
        self.assert_moves_as(some, recording, [*range(0, len(recording), 6), len(recording) - 1])
        part = Gltf(GOLDEN / "tower", "--from", "0.5", "--to-time", "1")
        longest = max(part.json["accessors"][sampler["input"]]["max"][0] for sampler in part.json["animations"][0]["samplers"])
        self.assertLessEqual(longest, 0.5)

    def test_the_robot_carries_its_cameras(self):
        gltf = Gltf(GOLDEN / "imitation")
        moving = {gltf.json["nodes"][channel["target"]["node"]].get("name")
                  for channel in gltf.json["animations"][0]["channels"]}
        self.assertIn("left_lower_forearm", moving)
        camera, = [i for i, node in enumerate(gltf.json["nodes"])
                   if "camera" in node and gltf.json["cameras"][node["camera"]]["name"] == "left_hand"]
        carrier, = [node["name"] for node in gltf.json["nodes"] if camera in node.get("children", [])]
        self.assertIn("left", carrier)
        self.assertIn(carrier, moving)

    def test_a_scene_stands_upright_in_its_colors(self):
        gltf = Gltf(PROJECT / "scenes/tower.xml", "--no-robot")
        self.assert_valid(gltf)
        self.assertNotIn("animations", gltf.json)
        x, y, z, w = gltf.json["nodes"][0]["rotation"]
        # (0, 0, 1) turned by the quaternion is up in glTF: (0, 1, 0).
        up = [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)]
        np.testing.assert_allclose(up, [0, 1, 0], atol=1e-12)
        with smile.Simulation(smile.load(PROJECT / "scenes/tower.xml", robot=None)) as sim:
            for id in sim.object_ids:
                np.testing.assert_allclose(gltf.json["nodes"][gltf.node(id)]["translation"], sim.objects[id].position,
                                           atol=TOLERANCE)
        colors = [material["pbrMetallicRoughness"]["baseColorFactor"] for material in gltf.json["materials"]]
        self.assertTrue(all(0 <= value <= 1 for color in colors for value in color))

    def test_all_shipped_scenes_are_valid(self):
        scenes = sorted((PROJECT / "scenes").glob("*.xml"))
        self.assertGreater(len(scenes), 30)
        for scene in scenes:
            with self.subTest(scene.stem):
                self.assert_valid(Gltf(scene, "--no-robot"))

    def test_the_same_recording_gives_the_same_bytes(self):
        self.assertEqual(Gltf(GOLDEN / "imitation").bytes, Gltf(GOLDEN / "imitation").bytes)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
