"""A dataset of two episodes that the tests of smile.datasets share, and the packages that read it.

Imported by a test with the project's folder as its argument. Ends it with 77 without the packages that
tools/get_dataset_readers.sh installs.
"""

import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

PROJECT = Path(sys.argv[1])
READERS = PROJECT / "build/dataset_readers"
sys.path.insert(0, str(READERS))
try:
    import av  # noqa: F401
    import duckdb  # noqa: F401
    import h5py  # noqa: F401
    import mcap  # noqa: F401
    import pandas  # noqa: F401
    import pyarrow as pa
    import pyarrow.parquet as pq
    import zarr  # noqa: F401
except ImportError as missing:
    print(f"skipped: {missing}; tools/get_dataset_readers.sh installs it")
    sys.exit(77)

import smile
from smile.datasets import export

ROBOT = PROJECT / "tests/golden/recordings/imitation"
TERN = PROJECT / "tests/golden/recordings/tern"
DEMONSTRATION = PROJECT / "tests/golden/recordings/hands"
FPS, SIZE = 10, (64, 48)
CAMERAS = {"eye": SIZE, "close": (80, 60)}
SHARED = tempfile.TemporaryDirectory()


def imitation(folder, success, cause=None):
    """A folder as `smile imitate` writes it."""
    shutil.copytree(ROBOT, folder / "imitation")
    (folder / "result.json").write_text(json.dumps({"format": 2, "success": success, "cause": cause}))
    return folder


def run(*arguments, **more):
    """Runs the command line."""
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join([os.environ["PYTHONPATH"], str(READERS)])}
    return subprocess.run([sys.executable, "-m", "smile.datasets", *map(str, arguments)], text=True,
                          capture_output=True, env=environment, **more)


def files_of(folder):
    return {path.relative_to(folder): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


class Exported(unittest.TestCase):
    """Two episodes of a robot with two cameras, exported once for all tests."""

    @classmethod
    def setUpClass(cls):
        cls.folder, dataset = Path(SHARED.name), Path(SHARED.name) / "dataset"
        cls.runs, cls.dataset = [cls.folder / "seed-0007", cls.folder / "second"], dataset
        if not dataset.exists():
            for folder in cls.runs:
                imitation(folder, True)
            export(cls.runs, dataset, cameras=CAMERAS, fps=FPS, task="build a tower")
        cls.recording = smile.open(ROBOT)
        cls.info = json.loads((dataset / "meta/info.json").read_text())
        cls.table = pq.read_table(dataset / "data/chunk-000/file-000.parquet")
        cls.episodes = pq.read_table(dataset / "meta/episodes/chunk-000/file-000.parquet").to_pylist()

    def column(self, name, episode=0):
        rows = self.table.filter(pa.compute.equal(self.table["episode_index"], episode))
        return np.array(rows[name].to_pylist())

    def rows(self):
        """The rows of the recording's arrays that are frames of an episode."""
        ticks = self.recording.ticks.astype(int)
        return [int(np.flatnonzero(ticks == tick)[0]) for tick in self.column("sim.tick")]
