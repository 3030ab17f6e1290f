"""Tests datasets that are made in parts, of generations, and joined.

Usage: merging_test.py PROJECT_FOLDER
"""

import json
import shutil
import tempfile
import unittest
from pathlib import Path

# First: it finds the packages below, or ends the test.
from exported_dataset import CAMERAS, FPS, PROJECT, SIZE, ROBOT, TERN, Exported, files_of, imitation, run

import av
import h5py
import numpy as np
import pyarrow.parquet as pq
import zarr

from smile.datasets import examine, export, merge

EPISODES = Path("meta/episodes/chunk-000/file-000.parquet")
VARIATION = {"scene": "tower.xml", "level": "edges", "eye": "eye", "noise": {"joints": 0.001}}


def pictures(dataset, row, camera):
    """The pictures of an episode, as its film has them."""
    key = f"videos/observation.images.{camera}"
    name = (f"{key}/chunk-{row[f'{key}/chunk_index']:03d}/file-{row[f'{key}/file_index']:03d}.mp4")
    with av.open(str(dataset / name)) as film:
        frames = [frame.to_ndarray(format="rgb24") for frame in film.decode(video=0)]
    first = round(row[f"{key}/from_timestamp"] * FPS)
    return np.array(frames[first:first + row["length"]])


class MergeTest(Exported):
    """A merge of two datasets of one episode is the dataset of both."""

    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.out = Path(self.temporary.name)

    def export_halves(self):
        for name, run_folder in zip(("a", "b"), self.runs):
            export([run_folder], self.out / name, cameras=CAMERAS, fps=FPS, task="build a tower")
        return [self.out / "a", self.out / "b"]

    def assert_same_dataset(self, merged, halves):
        once, joined = files_of(self.dataset), files_of(merged)
        films = {name for name in once | joined if name.suffix == ".mp4"}
        self.assertEqual(set(once) - films, set(joined) - films)
        self.assertEqual([name for name in set(once) - films - {EPISODES} if once[name] != joined[name]], [])
        rows = pq.read_table(merged / EPISODES).to_pylist()
        for row, expected in zip(rows, self.episodes, strict=True):
            for name, value in expected.items():
                if not name.startswith("videos/"):
                    self.assertEqual(row[name], value, name)
        # Pictures as they were coded: which are key frames depends on where a film begins.
        for row, half in zip(rows, halves, strict=True):
            of_half = pq.read_table(half / EPISODES).to_pylist()[0]
            for camera in CAMERAS:
                np.testing.assert_array_equal(pictures(merged, row, camera), pictures(half, of_half, camera))
        self.assertEqual([finding for finding in examine(merged) if finding.is_error], [])

    def test_equals_the_export_of_all_runs(self):
        halves = self.export_halves()
        report = merge(halves, self.out / "merged")
        self.assertEqual((report.episodes, report.frames), (2, len(self.table)))
        self.assert_same_dataset(self.out / "merged", halves)

    def test_words_and_depth_are_joined(self):
        for name, options in (("v3", {"maps": ["depth"]}), ("v2", {"format": "lerobot-v2.1"})):
            for number, runs in enumerate(([self.runs[0]], [self.runs[1]], self.runs)):
                export(runs, self.out / f"{name}{number}", cameras={"eye": SIZE}, fps=FPS, language=True, **options)
            merge([self.out / f"{name}0", self.out / f"{name}1"], self.out / f"{name}joined")
            once, joined = files_of(self.out / f"{name}2"), files_of(self.out / f"{name}joined")
            films = {path for path in once | joined if path.suffix == ".mp4"}
            self.assertEqual([path for path in set(once) - films - {EPISODES} if once[path] != joined[path]], [])
            found = [str(finding) for finding in examine(self.out / f"{name}joined") if finding.is_error]
            self.assertEqual(found, [])
            self.assertEqual(len([path for path in joined if "eye_depth" in str(path)]), 2 if name == "v3" else 0)

    def test_is_associative(self):
        a, b = self.export_halves()
        merge([a, b], self.out / "ab")
        answer = run("merge", self.out / "ab", a, "--out", self.out / "aba")
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertIn("aba: 3 episodes", answer.stdout)
        merge([a, b, a], self.out / "at_once")
        first, second = files_of(self.out / "aba"), files_of(self.out / "at_once")
        self.assertEqual([name for name in second if first.get(name) != second[name]], [])

    def test_an_export_in_parts_continues_after_its_last_part(self):
        def stop_at_the_second(line):
            if line == "part from episode 1":
                raise KeyboardInterrupt
        options = {"cameras": CAMERAS, "fps": FPS, "task": "build a tower", "parts": 1}
        with self.assertRaises(KeyboardInterrupt):
            export(self.runs, self.out / "parts", progress=stop_at_the_second, **options)
        self.assertEqual([path.name for path in self.out.iterdir()], ["parts.parts"])
        lines = []
        export(self.runs, self.out / "parts", progress=lines.append, **options)
        self.assertIn("part from episode 0 is there", lines)
        self.assertEqual([path.name for path in self.out.iterdir()], ["parts"])
        self.assert_same_dataset(self.out / "parts", self.export_halves())

    def test_refuses_what_does_not_fit_and_writes_nothing(self):
        a, b = self.export_halves()
        export([TERN], self.out / "tern", cameras=CAMERAS, fps=FPS)
        export([self.runs[0]], self.out / "old", format="lerobot-v2.1", cameras=(), fps=FPS)
        for datasets, message in (([a, self.out / "tern"], "differs from .*a in robot_type"),
                                  ([a, self.out / "old"], "differs from .*a in codebase_version"),
                                  ([PROJECT / "scenes"], "is no dataset that SMILE exported"),
                                  ([], "there are no datasets")):
            with self.assertRaisesRegex(ValueError, message):
                merge(datasets, self.out / "merged")
        next((b / "data").rglob("*.parquet")).write_bytes(b"PAR1")
        with self.assertRaisesRegex(ValueError, ".*/b: .*; mend it, or export it again"):
            merge([a, b], self.out / "merged")
        self.assertEqual({path.name for path in self.out.iterdir()}, {"a", "b", "old", "tern"})


class OtherFormatsTest(unittest.TestCase):
    """A merge of two datasets is, in each format, the dataset of both."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.out = Path(temporary.name)
        self.runs = [imitation(self.out / "seed-0007", True), imitation(self.out / "second", True)]

    def merged(self, format, runs, **options):
        """Returns the dataset of all runs, and the merge of datasets of one each."""
        options = {"format": format, "cameras": {"eye": SIZE}, "fps": 5, "task": "build, quickly", **options}
        export(runs, self.out / "once", **options)
        for number, one in enumerate(runs):
            export([one], self.out / f"part-{number}", **options)
        report = merge([self.out / f"part-{number}" for number in range(len(runs))], self.out / "merged")
        self.assertEqual(report.episodes, len(runs))
        return self.out / "once", self.out / "merged"

    def assert_same_files(self, once, merged):
        first, second = files_of(once), files_of(merged)
        self.assertEqual(set(first), set(second))
        self.assertEqual([name for name in first if first[name] != second[name]], [])

    def test_lerobot_v2_1(self):
        self.assert_same_files(*self.merged("lerobot-v2.1", self.runs))

    def test_csv(self):
        once, merged = self.merged("csv", self.runs)
        self.assert_same_files(once, merged)
        (self.out / "part-1/episode_000000.csv").unlink()
        with self.assertRaisesRegex(ValueError, "part-1: episode_000000.csv: is missing, but the list of episodes has it; mend it"):
            merge([self.out / "part-0", self.out / "part-1"], self.out / "again")
        self.assertFalse((self.out / "again").exists())

    def test_zarr(self):
        once, merged = self.merged("zarr", self.runs)
        self.assert_same_files(once, merged)
        zarr.open(str(self.out / "part-1/replay.zarr"))["data/sim.tick"].resize(3)
        with self.assertRaisesRegex(ValueError, "part-1: data/sim.tick: has 3 frames, but the last episode ends at"):
            merge([self.out / "part-0", self.out / "part-1"], self.out / "again")

    def test_mcap(self):
        once, merged = self.merged("mcap", self.runs)
        self.assert_same_files(once, merged)
        path = self.out / "part-1/episode_000000.mcap"
        path.write_bytes(path.read_bytes()[:-3000])
        with self.assertRaisesRegex(ValueError, "part-1: episode_000000.mcap: cannot be read .*; mend it"):
            merge([self.out / "part-0", self.out / "part-1"], self.out / "again")

    def test_robomimic(self):
        once, merged = self.merged("robomimic", self.runs)
        with h5py.File(once / "demo.hdf5") as first, h5py.File(merged / "demo.hdf5") as second:
            expected, found = self.contents(first), self.contents(second)
        self.assertEqual(set(expected), set(found))
        for name, (values, attributes) in expected.items():
            np.testing.assert_array_equal(found[name][0], values, name)
            np.testing.assert_equal(found[name][1], attributes, name)
        with h5py.File(self.out / "part-1/demo.hdf5", "r+") as file:
            file["data"].attrs["total"] = 3
        with self.assertRaisesRegex(ValueError, "part-1: demo.hdf5: total is 3, but there are"):
            merge([self.out / "part-0", self.out / "part-1"], self.out / "again")

    @staticmethod
    def contents(file):
        found = {}
        file.visititems(lambda name, item: found.update({
            name: (item[()] if isinstance(item, h5py.Dataset) else None, dict(item.attrs))}))
        return found


class GenerationTest(unittest.TestCase):
    """A folder as `smile generate` writes it: two successes and a failure."""

    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.folder = Path(self.temporary.name) / "towers"
        lines = []
        for seed, outcome, cause in ((1, "success", None), (2, "failure", {"word": "toppled", "text": "…"}),
                                     (3, "impossible", None), (1000002, "success", None)):
            place = f"{'episodes' if outcome == 'success' else 'failures'}/seed-{seed:04d}"
            has_run = outcome != "impossible"
            if has_run:
                imitation(self.folder / place, outcome == "success", cause)
            lines.append({"seed": seed, "variation": VARIATION, "outcome": outcome,
                          "recording": f"{place}/imitation" if has_run else None,
                          "result_hash": "0123" if has_run else None})
        (self.folder / "manifest.jsonl").write_text("".join(json.dumps(line) + "\n" for line in lines))

    def episodes(self, **options):
        dataset = Path(self.temporary.name) / "dataset"
        shutil.rmtree(dataset, ignore_errors=True)
        export([self.folder], dataset, cameras=(), fps=FPS, **options)
        return pq.read_table(dataset / EPISODES).to_pylist()

    def test_its_successes_are_exported_with_seed_and_variation(self):
        rows = self.episodes()
        self.assertEqual([row["smile/seed"] for row in rows], [1, 1000002])
        self.assertEqual(json.loads(rows[0]["smile/variation"]), VARIATION)

    def test_its_failures_are_exported_if_asked_for(self):
        rows = self.episodes(include_failed=True)
        self.assertEqual([(row["smile/seed"], row["smile/cause"]) for row in rows],
                         [(1, ""), (2, "toppled"), (1000002, "")])

    def test_one_that_is_not_complete_or_damaged_is_refused(self):
        (self.folder / "manifest.jsonl").write_text('{"outcome": "success"}\n')
        with self.assertRaisesRegex(ValueError, "manifest.jsonl:1: is no attempt"):
            self.episodes()
        (self.folder / "manifest.jsonl").rename(self.folder / "generation.json")
        with self.assertRaisesRegex(ValueError, "not complete"):
            self.episodes()


class OtherRunsTest(unittest.TestCase):
    def test_have_no_variation(self):
        with tempfile.TemporaryDirectory() as folder:
            export([ROBOT], Path(folder) / "dataset", cameras=(), fps=FPS)
            rows = pq.read_table(Path(folder) / "dataset" / EPISODES).to_pylist()
            self.assertEqual(rows[0]["smile/variation"], "")


if __name__ == "__main__":
    unittest.main(argv=["merging_test"])
