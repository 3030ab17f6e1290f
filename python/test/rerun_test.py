"""What Rerun itself reads of an exported recording is the recording.

Usage: rerun_test.py PROJECT_FOLDER. Ends with 77 without the packages that tools/get_rerun.sh installs.
"""

import io
import sys
import tempfile
import unittest
from contextlib import redirect_stderr
from pathlib import Path
from unittest.mock import patch

PROJECT = Path(sys.argv[1])
# Before numpy: Rerun needs a newer one than Debian's.
sys.path.insert(0, str(PROJECT / "build/rerun"))
try:
    from rerun.chunk import RrdReader
except ImportError as missing:
    print(f"skipped: {missing}; tools/get_rerun.sh installs it")
    sys.exit(77)

import numpy as np
from PIL import Image

import smile
from smile.datasets import export
from smile.datasets.__main__ import main
from smile.datasets.doctor import examine

ROBOT = PROJECT / "tests/golden/recordings/imitation"
FPS, SIZE = 5, (64, 48)


class RerunTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        folder = Path(cls.folder.name) / "shown"
        export([ROBOT], folder, format="rrd", cameras={"eye": SIZE}, maps=["depth", "id"], fps=FPS, task="build")
        cls.path, cls.recording = folder / "episode_000000.rrd", smile.open(ROBOT)
        cls.columns = {}
        for chunk in RrdReader(cls.path).stream():
            batch = chunk.to_record_batch()
            for name in batch.schema.names:
                cls.columns[str(chunk.entity_path), name] = batch.column(name)
        ticks = cls.values("/sim/tick", "Scalars:scalars").ravel().astype(int)
        cls.rows = np.searchsorted(cls.recording.ticks, ticks)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    @classmethod
    def values(cls, path, name):
        return np.array(cls.columns[path, name].to_pylist())

    def picture(self, k):
        return self.recording.at(self.recording.ticks[self.rows[k]] / 60).render("eye", SIZE, ("rgb", "depth", "id"))

    def test_features_have_names_and_times_from_the_start(self):
        names = self.columns["/observation/state", "SeriesLines:names"][0].as_py()
        state = self.values("/observation/state", "Scalars:scalars")
        joints = [name for name in names if "gripper" not in name]
        expected = self.recording.joints[self.rows][:, [self.recording.joint_names.index(name) for name in joints]]
        np.testing.assert_array_equal(state[:, [names.index(name) for name in joints]], expected.astype(np.float32))
        seconds = [time.total_seconds() for time in self.columns["/observation/state", "time"].to_pylist()]
        np.testing.assert_allclose(seconds, np.arange(len(state)) / FPS, atol=1e-6)

    def test_objects_are_where_they_were(self):
        for i, id in enumerate(self.recording.object_ids):
            places = self.values(f"/world/{id}", "Transform3D:translation")[:, 0]
            turns = self.values(f"/world/{id}", "Transform3D:quaternion")[:, 0]
            poses = self.recording.poses[self.rows, i]
            np.testing.assert_allclose(places, poses[:, :3], atol=1e-6)
            np.testing.assert_allclose(turns[:, [3, 0, 1, 2]], poses[:, 3:], atol=1e-6)

    def test_shapes_of_objects_and_robot_are_in_their_frames(self):
        meshes = {path: np.array(column[0].as_py()) for (path, name), column in self.columns.items()
                  if name == "Mesh3D:vertex_positions"}
        red, = [corners for path, corners in meshes.items() if path.startswith("/world/RedBlock/")]
        np.testing.assert_allclose(np.abs(red), 0.05, atol=1e-6)
        links = {path.rsplit("/", 1)[0] for path in meshes if path.startswith("/world/robot/")}
        self.assertGreater(len(links), 10)
        for link in links:
            self.assertEqual(len(self.values(link, "Transform3D:translation")), len(self.rows))

    def test_cameras_are_where_they_look_from_and_pictures_are_lossless(self):
        camera, picture = "/world/camera/eye", self.picture(4)
        blob = bytes(self.columns[f"{camera}/image", "EncodedImage:blob"][4].as_py()[0])
        np.testing.assert_array_equal(np.array(Image.open(io.BytesIO(blob))), picture.rgb)
        for kind, archetype, dtype, expected in (("depth", "DepthImage", np.float32, picture.depth),
                                                 ("id", "SegmentationImage", np.uint16, picture.id)):
            data = bytes(self.columns[f"{camera}/{kind}", f"{archetype}:buffer"][4].as_py()[0])
            np.testing.assert_array_equal(np.frombuffer(data, dtype).reshape(picture.rgb.shape[:2]), expected)
        matrix = self.values(camera, "Pinhole:image_from_camera").reshape(3, 3).T
        np.testing.assert_allclose(matrix, picture.intrinsics, rtol=1e-6)
        np.testing.assert_allclose(self.values(camera, "Transform3D:translation")[4, 0], picture.pose[:3, 3], atol=1e-6)
        labels = {one["class_id"]: one["class_description"]["info"]["label"]
                  for one in self.columns[camera, "AnnotationContext:context"][0].as_py()[0]}
        self.assertEqual(labels, dict(enumerate(["nothing", "table", *self.recording.object_ids])))

    def test_subtasks_and_origin_are_told(self):
        subtasks = self.columns["/subtasks", "TextLog:text"].to_pylist()
        self.assertIn("RedBlock", " ".join(one[0] for one in subtasks))
        about = {name: column[0].as_py() for (path, name), column in self.columns.items()
                 if path == "/__properties/smile"}
        self.assertEqual([about["task"], about["smile/state_hash"]], [["build"], [f"{self.recording.hashes[-1]:016x}"]])

    def test_without_the_package_its_name_is_told(self):
        words = ["export", str(ROBOT), "--to", "rrd", "--out", f"{self.folder.name}/none"]
        with patch.dict(sys.modules, {"rerun": None, "smile.datasets.rerun_recording": None}), \
                redirect_stderr(io.StringIO()) as said:
            del sys.modules["smile.datasets.rerun_recording"]
            self.assertEqual(main(words), 2)
        self.assertIn("error: this format needs a Python package: ", said.getvalue())
        self.assertIn("rerun", said.getvalue())
        self.assertFalse(Path(words[-1]).exists())

    def test_it_is_no_dataset(self):
        finding, = examine(self.path.parent)
        self.assertRegex(str(finding), "is for viewers.*rerun rrd verify")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
