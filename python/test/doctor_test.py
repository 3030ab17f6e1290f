"""Tests the doctor of datasets: it finds each fault of a damaged copy.

Usage: doctor_test.py PROJECT_FOLDER
"""

import json
import re
import shutil
import sys
import tempfile
import unittest
from pathlib import Path

# First: it finds the packages below, or ends the test.
from exported_dataset import FPS, SIZE, Exported, imitation

import av
import h5py
import mcap.writer
import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import zarr

from smile.datasets import examine, export


class DoctorTest(Exported):
    """Each damage to a copy of the dataset is found, with advice."""

    def setUp(self):
        self.copy = self.folder / "copy"
        shutil.copytree(self.dataset, self.copy)
        self.addCleanup(shutil.rmtree, self.copy)

    def finds(self, pattern):
        found = [str(finding) for finding in examine(self.copy)]
        self.assertTrue(any(re.search(pattern, line) for line in found), (pattern, found))

    def edit_json(self, name, change):
        path = self.copy / "meta" / name
        content = json.loads(path.read_text())
        change(content)
        path.write_text(json.dumps(content))

    def edit_table(self, change, name="data/chunk-000/file-000.parquet"):
        table = pq.read_table(self.copy / name)
        pq.write_table(change(table), self.copy / name)

    def replaced(self, table, name, values):
        return table.set_column(table.column_names.index(name), name, pa.array(values, table[name].type))

    def test_finds_no_error_in_a_sound_dataset(self):
        self.assertEqual([finding for finding in examine(self.copy) if finding.is_error], [])
        self.finds("warning: action: never changes in left_s0.*--drop-constant")

    def test_finds_faults_of_the_description(self):
        self.edit_json("info.json", lambda info: info.update(total_frames=3))
        self.finds("total_frames is 3, but there are")
        self.edit_json("info.json", lambda info: info["features"].pop("timestamp"))
        self.finds("does not declare the feature timestamp")
        self.finds("has the column timestamp, which meta/info.json does not declare")
        self.edit_json("info.json", lambda info: info["features"].update(
            {"action_2": {"dtype": "float32", "shape": [2], "names": None},
             "my_image_id": {"dtype": "int64", "shape": [1], "names": None}}))
        self.finds("warning: action_2: begins with 'action'")
        self.finds("my_image_id: has 'image' in its name")
        self.finds("lacks the column action_2")
        self.edit_json("info.json", lambda info: info["features"]["observation.images.eye"].update(names=None))
        self.finds("observation.images.eye: has the names None")
        self.edit_json("info.json", lambda info: info.update(fps=0))
        self.finds("meta/info.json: fps is 0")
        self.edit_json("info.json", lambda info: info.update(codebase_version="v1.6"))
        self.finds("codebase_version is 'v1.6', expected v3.0 or v2.1; convert")

    def test_finds_what_is_missing(self):
        (self.copy / "meta/stats.json").unlink()
        self.finds("meta/stats.json: is missing")
        (self.copy / "videos/observation.images.eye/chunk-000/file-000.mp4").unlink()
        self.finds("eye/chunk-000/file-000.mp4: is missing")
        (self.copy / "data/chunk-000/file-000.parquet").unlink()
        self.finds("data/chunk-000/file-000.parquet: is missing")
        (self.copy / "meta/info.json").unlink()
        self.finds("info.json: is missing; expected the folder of a LeRobot dataset")

    def test_finds_missing_and_impossible_statistics(self):
        self.edit_json("stats.json", lambda stats: stats["action"].pop("q99"))
        self.finds("action: has no statistics q99")
        self.edit_json("stats.json", lambda stats: stats["observation.state"].update(mean=[float("nan")]))
        self.finds("observation.state: has statistics that are not finite")

    def test_finds_files_that_were_not_completed(self):
        for name in ("data/chunk-000/file-000.parquet", "videos/observation.images.eye/chunk-000/file-000.mp4"):
            path = self.copy / name
            path.write_bytes(path.read_bytes()[:2000])
        self.finds("file-000.parquet: cannot be read .*interrupted")
        self.finds("file-000.mp4: has no index of a film")

    def test_finds_a_stale_index(self):
        def change(table):
            return self.replaced(table, "dataset_from_index", [0, 17])
        self.edit_table(change, "meta/episodes/chunk-000/file-000.parquet")
        self.finds("episode 1: begins at frame 17 of the dataset, expected")

    def test_finds_frames_that_are_elsewhere_or_miscounted(self):
        self.edit_table(lambda table: table.slice(3))
        self.finds("episode 0: has .* frames in data/.*, but is listed with")
        self.edit_table(lambda table: self.replaced(table, "frame_index", [0] * len(table)))
        self.finds("episode 1: has frame_index that does not count from 0")

    def test_finds_wrong_times_tasks_and_numbers(self):
        self.edit_table(lambda table: self.replaced(table, "timestamp", np.arange(len(table)) / 9.5))
        self.finds("episode 0: has times that are not frame_index / fps")
        self.edit_table(lambda table: self.replaced(table, "task_index", [4] * len(table)))
        self.finds("has the task 4, which is not in the list")
        self.edit_table(lambda table: self.replaced(
            table, "sim.subtask_progress", [float("nan")] * len(table)))
        self.finds("numbers in sim.subtask_progress that are not finite")

    def test_finds_words_that_are_damaged(self):
        shutil.rmtree(self.copy)
        export(self.runs, self.copy, cameras=(), fps=FPS, language=True)

        def change(edit):
            def changed(table):
                rows = table["language_persistent"].to_pylist()
                edit(rows)
                return self.replaced(table, "language_persistent", rows)
            return changed
        sound = (self.copy / "data/chunk-000/file-000.parquet").read_bytes()
        for edit, message in ((lambda rows: rows[3].pop(), "differ between frames of the episode"),
                              (lambda rows: [row[2].update(timestamp=1.234) for row in rows],
                               "begin at 1.23.* s with 'put RedBlock on the table', which is the time of no frame"),
                              (lambda rows: [row[0].update(style="vqa") for row in rows], "have the style 'vqa'"),
                              (lambda rows: [row[0].update(camera="eye") for row in rows], "have the camera 'eye'")):
            (self.copy / "data/chunk-000/file-000.parquet").write_bytes(sound)
            self.edit_table(change(edit))
            self.finds("episode 0: has words in language_persistent that " + message)
        self.edit_json("info.json", lambda info: info["features"]["language_events"].update(dtype="string"))
        self.finds("language_events: has the dtype 'string'")

    def test_finds_tasks_that_are_no_index(self):
        self.edit_table(lambda table: table.replace_schema_metadata({}), "meta/tasks.parquet")
        self.finds("meta/tasks.parquet: does not declare the tasks as the index")

    def test_finds_films_that_do_not_fit(self):
        key = "videos/observation.images.eye/to_timestamp"
        def change(table):
            return self.replaced(table, key, [end + 3 for end in table[key].to_pylist()])
        self.edit_table(change, "meta/episodes/chunk-000/file-000.parquet")
        self.finds("episode 0: is .* s long, but its part of")
        self.edit_json("info.json", lambda info: info.update(fps=12))
        self.finds("has 10 pictures per second, but the dataset has 12")

    def test_finds_films_whose_pictures_are_stored_out_of_order(self):
        path = self.copy / "videos/observation.images.eye/chunk-000/file-000.mp4"
        with av.open(str(path)) as film:
            pictures = [picture.to_ndarray(format="rgb24") for picture in film.decode(video=0)]
        with av.open(str(path), "w") as film:
            stream = film.add_stream("libx264", rate=FPS, options={"bf": "2"})
            stream.width, stream.height, stream.pix_fmt = *SIZE, "yuv420p"
            for picture in pictures[:-4]:
                film.mux(stream.encode(av.VideoFrame.from_ndarray(picture, format="rgb24")))
            film.mux(stream.encode())
        self.finds("warning: .*file-000.mp4: stores pictures in another order")
        self.finds(r"episode 1: ends at picture \d+ of .*, which has only")

    def test_finds_recordings_that_were_changed(self):
        with (self.copy / "extras/episode_000001/commands.jsonl").open("a") as file:
            file.write("\n")
        self.finds("extras/episode_000001: is not the recording")

    def test_survives_any_damaged_file(self):
        files = sorted(path for path in self.copy.rglob("*") if path.is_file() and "extras" not in path.parts)
        for path in files:
            content = path.read_bytes()
            for damaged in (b"", content[:len(content) // 2], content[:-1], b"\0" * len(content)):
                path.write_bytes(damaged)
                examine(self.copy)
            path.write_bytes(content)


class OtherFormatsTest(unittest.TestCase):
    """Each damage to a dataset of robomimic, Zarr or CSV is found, with advice."""

    def exported(self, format):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        folder = Path(temporary.name)
        self.dataset = folder / "dataset"
        export([imitation(folder / "seed-0007", True)], self.dataset, format=format, cameras={"eye": SIZE}, fps=5,
               task="build")
        self.assertEqual([finding for finding in examine(self.dataset) if finding.is_error], [])

    finds = DoctorTest.finds

    @property
    def copy(self):
        return self.dataset

    def test_robomimic(self):
        self.exported("robomimic")
        self.finds("warning: actions: never changes in the dimensions 0, .*--drop-constant")
        with h5py.File(self.dataset / "demo.hdf5", "r+") as file:
            demo = file["data/demo_0"]
            demo.attrs["num_samples"] = 3
            demo["obs/short"] = np.zeros((2, 7))
            demo["obs/lost"] = np.full((len(demo["actions"]), 1), np.nan)
            demo["obs/pale_image"] = np.zeros((len(demo["actions"]), 4, 4, 3), np.float32)
            demo["actions"][0, 0] = 2
            file["data/demo_7"] = h5py.Empty("f")
            file["mask/test"] = np.array(["demo_9"], "S16")
            file["data"].attrs["total"] = 9
            del file["data"].attrs["env_args"]
        for pattern in ("demo_0: num_samples is 3, but there are", "demo_0: obs/short has 2 frames",
                        "demo_0: obs/lost has numbers that are not finite", "obs/pale_image has pictures of float32",
                        "demo_0: has actions beyond -1 to 1", "demo_7: has no actions", "mask/test: lists demo_9",
                        "demo.hdf5: total is 9, but there are", "data has no env_args"):
            self.finds(pattern)
        file = self.dataset / "demo.hdf5"
        file.write_bytes(file.read_bytes()[:5000])
        self.assertRegex(str(examine(file)[0]), "demo.hdf5: cannot be read .*cut")

    def test_zarr(self):
        self.exported("zarr")
        root = zarr.open(str(self.dataset / "replay.zarr"))
        root["data/action"][0, 0] = np.inf
        root["data/sim.tick"].resize(3)
        (self.dataset / "replay.zarr/data/eye/0.0.0.0").unlink()
        self.finds("data/action: action has numbers that are not finite")
        self.finds("data/sim.tick: has 3 frames, but the last episode ends at")
        self.finds("data/eye: lacks 1 of . chunks, which are read as zeros")
        (self.dataset / "replay.zarr/data/state/.zarray").write_text("{")
        self.finds("data/state: cannot be read .*: it is cut or damaged")
        root["meta/episode_ends"][0] = 0
        self.assertRegex(str(examine(self.dataset / "replay.zarr")[0]), "meta/episode_ends: does not ascend")
        shutil.rmtree(self.dataset / "replay.zarr/meta")
        self.finds("replay.zarr: has no data, or no meta/episode_ends")

    def test_mcap(self):
        self.exported("mcap")
        path = self.dataset / "episode_000000.mcap"
        content = path.read_bytes()
        with (self.dataset / "episode_000001.mcap").open("wb") as stream:
            writer = mcap.writer.Writer(stream, compression=mcap.writer.CompressionType.NONE)
            writer.start()
            channel = writer.register_channel("/odd", "json", 0)
            for time, data in ((5, b"{}"), (3, b'{"x": NaN}'), (6, b"[" * 100_000)):
                writer.add_message(channel, time, data, time)
            writer.finish()
        for pattern in ("/odd has messages whose times go back", "/odd has messages that are not JSON",
                        "episode_000001.mcap: differs from episode_000000.mcap in the topic"):
            self.finds(pattern)
        for damaged in (content[:-3000], content[:5000] + b"?" + content[5001:]):
            path.write_bytes(damaged)
            self.finds("episode_000000.mcap: cannot be read .*cut")

    def test_csv(self):
        self.exported("csv")
        table = self.dataset / "episode_000000.csv"
        text = table.read_text()
        for damaged, pattern in ((text.rsplit("\n", 2)[0] + "\n", "frames, but is listed with"),
                                 (text.replace("timestamp", "time", 1), "has other columns .*such as time"),
                                 (text.replace("0.0", "nan", 1), "not finite"), (text[:-30], "cannot be read"),
                                 (None, "episode_000000.csv: is missing")):
            table.unlink() if damaged is None else table.write_text(damaged)
            self.finds(pattern)
        (self.dataset / "episode_000000.observation.images.eye.mp4").write_bytes(b"cut")
        self.finds("eye.mp4: has no index of a film")
        (self.dataset / "info.json").write_text("{")
        self.finds("info.json, episodes.csv: cannot be read")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
