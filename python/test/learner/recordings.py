"""Recordings of demonstrations, written for the tests of the learner."""

import json
import math
import tempfile
import unittest
from pathlib import Path

from PIL import Image

from explain.demonstration import read_demonstration
from explain.task_model import infer_task
from scenes import EYE, TILT


class RecordingTest(unittest.TestCase):
    def record(self, *pictures):
        """Creates a folder for the texts of a recording, with these pictures."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        (self.folder / "rgb").mkdir()
        for i, picture in enumerate(pictures):
            Image.fromarray((picture * 255).round().astype("u1")).save(self.folder / f"rgb/{i}.png")
        tilt = -(math.pi / 2 + TILT) / 2
        (self.folder / "demo.json").write_text(json.dumps({"meters_per_unit": 0.1, "eye": {
            "fx": EYE.intrinsics[0, 0], "fy": EYE.intrinsics[1, 1], "cx": 320.0, "cy": 240.0,
            "position_m": list(EYE.pose[:3, 3] / 10),
            "rotation_wxyz": [math.cos(tilt), math.sin(tilt), 0.0, 0.0]}}))

    def write(self, segment, lines):
        (self.folder / f"{segment}.txt").write_text("\n".join(lines) + "\n")

    def infer_task(self, attention=None):
        return infer_task(read_demonstration(self.folder), attention or {})
