"""Tests datasets: what other programs read in them is what was recorded.

Usage: datasets_test.py PROJECT_FOLDER
"""

import io
import json
import os
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

# First: it finds the packages below, or ends the test.
from exported_dataset import (
    CAMERAS, DEMONSTRATION, FPS, PROJECT, READERS, ROBOT, SHARED, SIZE, TERN, Exported, files_of, imitation, run)

import av
import duckdb
import h5py
import mcap.reader
import numpy as np
import pandas
import pyarrow.parquet as pq
import zarr
from mcap_protobuf.decoder import DecoderFactory

import smile
from smile.datasets import examine, export
from smile.datasets.episode import rotation_between


class ColumnsTest(Exported):
    def test_what_pyarrow_reads_is_the_trace(self):
        rows = self.rows()
        names = self.info["features"]["observation.state"]["names"]
        state = self.column("observation.state")
        self.assertEqual(state.shape, (len(rows), len(names)))
        for i, name in enumerate(names):
            if not name.endswith("_gripper"):
                joint = self.recording.joint_names.index(name)
                np.testing.assert_array_equal(state[:, i],
                                              self.recording.joints[rows, joint].astype(np.float32))
        np.testing.assert_array_equal(self.column("sim.object_poses").reshape(len(rows), -1, 7),
                                      self.recording.poses[rows].astype(np.float32))
        np.testing.assert_array_equal(self.column("observation.state", 1), state)

    def test_a_recording_is_a_pandas_table(self):
        table = self.recording.table()
        self.assertEqual(table.index.name, "tick")
        id, joint = self.recording.object_ids[1], self.recording.joint_names[2]
        np.testing.assert_array_equal(table[[f"{id}.x", f"{id}.qz"]], self.recording.poses[:, 1, [0, 6]])
        np.testing.assert_array_equal(table[joint], self.recording.joints[:, 2])

    def test_times_are_exact_and_a_frame_apart(self):
        ticks = self.column("sim.tick")
        self.assertEqual(set(np.diff(ticks)), {60 // FPS})
        np.testing.assert_array_equal(self.column("timestamp"), (np.arange(len(ticks)) / FPS).astype(np.float32))
        np.testing.assert_array_equal(self.table["index"].to_numpy(), np.arange(len(self.table)))

    def test_a_position_is_where_the_joint_is_at_the_next_frame(self):
        names = self.info["features"]["action"]["names"]
        joints = [i for i, name in enumerate(names) if not name.endswith("_gripper")]
        state, action = self.column("observation.state"), self.column("action")
        np.testing.assert_array_equal(action[:-1, joints], state[1:, joints])
        self.assertGreater(np.ptp(action, axis=0).max(), 0.1)
        # Nothing jumps, though the robot was put into its first pose.
        self.assertLess(np.abs(action - state).max() * FPS, 5)

    def test_a_gripper_goes_on_closing_on_what_it_holds(self):
        gripper = self.info["features"]["action"]["names"].index("right_gripper")
        state, action = self.column("observation.state")[:, gripper], self.column("action")[:, gripper]
        closes = state[1:] < state[:-1] - 1e-4
        self.assertTrue(closes.any())
        self.assertTrue((action[:-1][closes] < state[:-1][closes]).all())

    def test_declares_what_is_in_the_files_and_hides_the_truth_from_policies(self):
        features = self.info["features"]
        films = {name for name, feature in features.items() if feature["dtype"] == "video"}
        self.assertEqual(set(features) - films, set(self.table.column_names))
        self.assertEqual({name for name in features if name.startswith("observation")},
                         {"observation.state", "observation.images.eye", "observation.images.close"})
        self.assertEqual([name for name in features if name.startswith("action")], ["action"])

    def test_the_end_is_marked_with_its_success(self):
        for name in ("next.done", "next.success"):
            self.assertEqual(np.flatnonzero(self.column(name)).tolist(), [len(self.rows()) - 1])

    def test_subtasks_end_where_something_is_taken_or_placed(self):
        row = self.episodes[0]
        names, ends = row["sparse_subtask_names"], row["sparse_subtask_end_frames"]
        self.assertRegex(names[0], "^take .*Block$")
        self.assertEqual((ends[-1], row["sparse_subtask_start_frames"][1:]), (row["length"], ends[:-1]))
        held = self.column("sim.object_held")
        thing = self.info["features"]["sim.object_held"]["names"].index(names[0].removeprefix("take "))
        self.assertEqual(held[ends[0] - 1:ends[0] + 1, thing].tolist()[-1], 1)
        self.assertEqual(held[:ends[0] - 1].max(), 0)


class OtherReadersTest(Exported):
    def test_duckdb_reads_the_same(self):
        found = duckdb.sql(f"""select episode_index, count(*), sum(action[3]), max(timestamp)
            from '{self.dataset}/data/*/*.parquet' group by 1 order by 1""").fetchall()
        for episode, (number, length, total, end) in enumerate(found):
            action = self.column("action", episode)
            self.assertEqual((number, length, end), (episode, len(action), np.float32((length - 1) / FPS)))
            self.assertAlmostEqual(total, action[:, 2].sum(dtype=float), places=5)
        self.assertEqual(len(found), 2)

    def test_each_episode_is_a_row_group(self):
        file = pq.ParquetFile(self.dataset / "data/chunk-000/file-000.parquet")
        self.assertEqual([file.metadata.row_group(i).num_rows for i in range(file.num_row_groups)],
                         [row["length"] for row in self.episodes])

    def test_pandas_finds_tasks_by_their_words(self):
        tasks = pandas.read_parquet(self.dataset / "meta/tasks.parquet")
        self.assertEqual((tasks.index.name, tasks.iloc[0].name), ("task", "build a tower"))

    def test_statistics_are_those_of_the_columns(self):
        stats = json.loads((self.dataset / "meta/stats.json").read_text())
        self.assertEqual(set(stats), set(self.info["features"]))
        values = np.array(self.table["action"].to_pylist())
        np.testing.assert_allclose(stats["action"]["std"], values.std(axis=0), atol=1e-6)
        np.testing.assert_allclose(stats["action"]["q99"], np.quantile(values, 0.99, axis=0), atol=1e-6)
        self.assertEqual(stats["action"]["count"], [len(values)])
        self.assertEqual(np.shape(stats["observation.images.eye"]["q01"]), (3, 1, 1))
        self.assertEqual(np.shape(self.episodes[1]["stats/observation.images.eye/mean"]), (3, 1, 1))


class FilmsTest(Exported):
    def test_a_film_shows_the_frames_at_their_times(self):
        rows, key = self.rows(), "observation.images.eye"
        with av.open(str(self.dataset / f"videos/{key}/chunk-000/file-000.mp4")) as film:
            pictures = list(film.decode(video=0))
        self.assertEqual(len(pictures), 2 * len(rows))
        self.assertEqual([round(picture.time * FPS, 6) for picture in pictures], list(range(2 * len(rows))))
        second = self.episodes[1]
        self.assertEqual((second[f"videos/{key}/from_timestamp"], second[f"videos/{key}/to_timestamp"]),
                         (len(rows) / FPS, 2 * len(rows) / FPS))
        for number in (0, len(rows) // 3, len(rows) - 1, len(rows) + 5):
            drawn = self.recording[rows[number % len(rows)]].render("eye", SIZE).rgb.astype(int)
            shown = pictures[number].to_ndarray(format="rgb24").astype(int)
            self.assertEqual(shown.shape, (SIZE[1], SIZE[0], 3))
            # Of 255; edges of blocks are blurred, as color has half the resolution.
            self.assertLess(np.abs(shown - drawn).mean(), 3, number)

    def test_cameras_are_where_the_pictures_were_drawn(self):
        picture = self.recording[self.rows()[4]].render("eye", SIZE)
        np.testing.assert_allclose(self.column("sim.camera_pose.eye")[4].reshape(3, 4), picture.pose[:3], atol=1e-6)
        about = json.loads((self.dataset / "meta/smile.json").read_text())
        np.testing.assert_array_equal(about["intrinsics"]["eye"], picture.intrinsics)


class OriginTest(Exported):
    def test_each_episode_replays_from_the_dataset(self):
        copy = smile.open(self.dataset / "extras/episode_000001")
        self.assertEqual(self.episodes[1]["smile/state_hash"], f"{copy.hashes[-1]:016x}")
        copy.verify()

    def test_episodes_name_their_seed(self):
        self.assertEqual([row["smile/seed"] for row in self.episodes], [7, None])

    def test_the_same_runs_give_the_same_bytes(self):
        export(self.runs, self.folder / "again", cameras=CAMERAS, fps=FPS, task="build a tower")
        first, second = files_of(self.dataset), files_of(self.folder / "again")
        self.assertEqual(set(first), set(second))
        self.assertEqual([name for name in first if first[name] != second[name]], [])


class Version2Test(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.dataset = Path(SHARED.name) / "version2"
        export([ROBOT, ROBOT], cls.dataset, format="lerobot-v2.1", cameras={"eye": SIZE}, fps=FPS)

    def lines(self, name):
        return [json.loads(line) for line in (self.dataset / "meta" / name).read_text().splitlines()]

    def test_each_episode_has_a_table_and_a_film(self):
        info = json.loads((self.dataset / "meta/info.json").read_text())
        self.assertEqual((info["codebase_version"], info["total_videos"], info["total_chunks"]), ("v2.1", 2, 1))
        for row in self.lines("episodes.jsonl"):
            number = {"episode_chunk": 0, "episode_index": row["episode_index"]}
            table = pq.read_table(self.dataset / info["data_path"].format(**number))
            self.assertEqual(table.num_rows, row["length"])
            self.assertEqual(set(table["episode_index"].to_pylist()), {row["episode_index"]})
            key = "observation.images.eye"
            with av.open(str(self.dataset / info["video_path"].format(video_key=key, **number))) as film:
                times = [picture.time for picture in film.decode(video=0)]
            np.testing.assert_allclose(times, table["timestamp"].to_numpy(), atol=1e-4)
        self.assertEqual(self.lines("tasks.jsonl"), [{"task_index": 0, "task": "tower_robot"}])
        self.assertEqual(len(self.lines("episodes_stats.jsonl")), 2)

    def test_the_parts_of_a_modality_cover_states_and_actions(self):
        info = json.loads((self.dataset / "meta/info.json").read_text())
        modality = json.loads((self.dataset / "meta/modality.json").read_text())
        for part, key in (("state", "observation.state"), ("action", "action")):
            covered = [i for one in modality[part].values() for i in range(one["start"], one["end"])]
            self.assertEqual(covered, list(range(info["features"][key]["shape"][0])))
        self.assertEqual(list(modality["state"]),
                         ["left_arm", "left_gripper", "right_arm", "right_gripper", "others"])

    def test_the_doctor_reads_it(self):
        self.assertEqual([str(finding) for finding in examine(self.dataset) if finding.is_error], [])
        copy = Path(SHARED.name) / "damaged2"
        shutil.copytree(self.dataset, copy)
        self.addCleanup(shutil.rmtree, copy)
        (copy / "videos/chunk-000/observation.images.eye/episode_000001.mp4").unlink()
        (copy / "data/chunk-000/episode_000000.parquet").write_bytes(b"PAR1")
        found = "\n".join(map(str, examine(copy)))
        self.assertIn("episode_000001.mp4: is missing", found)
        self.assertIn("episode_000000.parquet: cannot be read", found)
        (copy / "meta/episodes.jsonl").unlink()
        self.assertRegex(str(examine(copy)[0]), "meta/episodes.jsonl: is missing")


class LanguageTest(unittest.TestCase):
    """Each frame has the words of its subtask, which begin when the one before has ended."""

    WORDS = ["take RedBlock", "put RedBlock on the table", "finish"]

    def exported(self, name, **options):
        folder = Path(SHARED.name) / name
        export([ROBOT, ROBOT], folder, cameras=(), fps=FPS, language=True, **options)
        self.assertEqual([str(finding) for finding in examine(folder) if finding.is_error], [])
        return folder

    def test_rows_hold_from_the_event_on_that_ended_the_subtask_before(self):
        folder = self.exported("language")
        table = pq.read_table(folder / "data/chunk-000/file-000.parquet").to_pylist()
        times = {event["kind"]: event["tick"] for event in smile.open(ROBOT).events}
        for row in table:
            # As LeRobot does: the last row of a style that has begun.
            begun = [one for one in row["language_persistent"] if one["timestamp"] <= row["timestamp"]]
            active = {one["style"]: one["content"] for one in begun}
            done = sum(row["sim.tick"] > times[kind] for kind in ("gripper_holds", "gripper_let_go"))
            self.assertEqual(active["subtask"], self.WORDS[done])
            self.assertEqual(active["plan"].split("\n")[0], f"1. {self.WORDS[done]}")
            self.assertEqual(active["plan"].count("\n"), 2 - done)
            self.assertEqual(row["language_events"], [])
        info = json.loads((folder / "meta/info.json").read_text())
        self.assertEqual(info["features"]["language_persistent"],
                         {"dtype": "language", "shape": [1], "names": None})

    def test_annotations_of_version_2_are_numbers_of_tasks(self):
        folder = self.exported("language2", format="lerobot-v2.1")
        lines = (folder / "meta/tasks.jsonl").read_text().splitlines()
        tasks = {row["task_index"]: row["task"] for row in map(json.loads, lines)}
        modality = json.loads((folder / "meta/modality.json").read_text())["annotation"]
        for row in pq.read_table(folder / "data/chunk-000/episode_000001.parquet").to_pylist():
            self.assertEqual(tasks[row[modality["sim.subtask"]["original_key"]]], self.WORDS[row["sim.subtask"]])
            self.assertEqual(tasks[row["task_index"]], "tower_robot")

    def test_words_say_where_things_were_put(self):
        folder = Path(SHARED.name) / "words"
        export([PROJECT / "tests/golden/recordings/um"], folder, cameras=(), fps=FPS)
        row, = pq.read_table(folder / "meta/episodes/chunk-000/file-000.parquet").to_pylist()
        actions = smile.open(PROJECT / "tests/golden/recordings/um").actions
        shown = [one.words.split(" ", 2)[2].replace("takes", "take").replace("puts", "put") for one in actions]
        self.assertEqual([words for words in row["smile/subtask_words"] if words != "finish"], shown)

    def test_other_formats_are_refused_and_have_the_words_of_episodes(self):
        with self.assertRaisesRegex(ValueError, "format 'zarr', expected lerobot-v3.0 or lerobot-v2.1"):
            self.exported("no", format="zarr")
        folder = Path(SHARED.name) / "words_zarr"
        export([ROBOT], folder, format="zarr", cameras=(), fps=FPS)
        episode, = zarr.open(str(folder / "replay.zarr"), mode="r").attrs["episodes"]
        self.assertEqual(episode["smile/subtask_words"], self.WORDS)


class RobomimicTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(SHARED.name) / "robomimic"
        export([ROBOT, ROBOT], cls.folder, format="robomimic", cameras={"eye": SIZE}, fps=FPS,
               action="joint_velocity")
        cls.file = h5py.File(cls.folder / "demo.hdf5", swmr=True, libver="latest")
        cls.addClassCleanup(cls.file.close)
        cls.demo = cls.file["data/demo_1"]
        cls.length = int(cls.demo.attrs["num_samples"])

    def test_has_what_robomimic_demands(self):
        self.assertEqual(set(self.file["data"]), {"demo_0", "demo_1"})
        self.assertEqual(self.file["data"].attrs["total"], 2 * self.length)
        arguments = json.loads(self.file["data"].attrs["env_args"])
        self.assertEqual((type(arguments["type"]), type(arguments["env_kwargs"])), (int, dict))
        self.assertEqual([name.decode() for name in self.file["mask/train"]], ["demo_0", "demo_1"])
        for name in ("actions", "dones", "rewards", "states", "obs/state", "obs/eye_image", "obs/object"):
            self.assertEqual(len(self.demo[name]), self.length, name)
        self.assertEqual(np.abs(self.demo["actions"]).max(), 1)

    def test_pictures_and_scaled_actions_are_those_of_the_recording(self):
        recording = smile.open(ROBOT)
        tick = int(self.demo["states"][3, 0])
        picture = recording.at(tick / 60).render("eye", SIZE)
        np.testing.assert_array_equal(self.demo["obs/eye_image"][3], picture.rgb)
        np.testing.assert_allclose(self.demo["obs/eye_pose"][3].reshape(3, 4), picture.pose[:3], atol=1e-6)
        attributes = self.file["data"].attrs
        action = self.demo["actions"][:] * attributes["action_scale"] + attributes["action_offset"]
        moved = np.diff(self.demo["obs/state"][:], axis=0) * FPS
        joints = [i for i, name in enumerate(json.loads(attributes["names.action"])) if "gripper" not in name]
        np.testing.assert_allclose(action[:-1, joints], moved[:, joints], atol=1e-4)

    def test_mimicgen_finds_poses_targets_and_ends_of_subtasks(self):
        info = self.demo["datagen_info"]
        self.assertEqual(info.attrs["arm"], "right")
        np.testing.assert_array_equal(info["target_pose"][:-1], info["eef_pose"][1:])
        rotation = info["eef_pose"][5][:3, :3]
        np.testing.assert_allclose(rotation @ rotation.T, np.eye(3), atol=1e-5)
        first = json.loads(self.demo.attrs["sparse_subtask_names"])[0]
        signal = info["subtask_term_signals"][first.replace(" ", "_")][:]
        end = json.loads(self.demo.attrs["sparse_subtask_end_frames"])[0]
        self.assertEqual(np.flatnonzero(signal).tolist(), list(range(end, self.length)))
        # What is taken is then at the tool.
        held = info["object_poses"][first.removeprefix("take ")][end][:3, 3]
        self.assertLess(np.linalg.norm(held - info["eef_pose"][end][:3, 3]), 0.1)

    def test_refuses_runs_without_actions(self):
        with self.assertRaisesRegex(ValueError, "robomimic needs actions, but no robot moves"):
            export([DEMONSTRATION], self.folder / "none", format="robomimic", cameras=())
        self.assertFalse((self.folder / "none").exists())


class ZarrTest(unittest.TestCase):
    def test_arrays_of_all_episodes_follow_one_another(self):
        folder = Path(SHARED.name) / "zarr"
        export([ROBOT, ROBOT], folder, format="zarr", cameras={"eye": SIZE}, fps=5, task="build")
        root = zarr.open(str(folder / "replay.zarr"), mode="r")
        ends = root["meta/episode_ends"][:].tolist()
        self.assertEqual((len(ends), ends[1]), (2, 2 * ends[0]))
        for name, array in root["data"].arrays():
            self.assertEqual(len(array), ends[1], name)
        recording = smile.open(ROBOT)
        tick = int(root["data/sim.tick"][ends[0] + 3])
        np.testing.assert_array_equal(root["data/eye"][ends[0] + 3], recording.at(tick / 60).render("eye", SIZE).rgb)
        joints = [i for i, name in enumerate(root.attrs["names"]["action"]) if "gripper" not in name]
        np.testing.assert_array_equal(root["data/action"][:ends[0] - 1][:, joints],
                                      root["data/state"][1:ends[0]][:, joints])
        self.assertEqual([one["task"] for one in root.attrs["episodes"]], ["build", "build"])


class McapTest(unittest.TestCase):
    """What the mcap package reads, with Foxglove's own messages, is the recording."""

    @classmethod
    def setUpClass(cls):
        folder = Path(SHARED.name) / "mcap"
        export([ROBOT], folder, format="mcap", cameras={"eye": SIZE}, fps=5, task="build")
        cls.path, cls.recording, cls.messages = folder / "episode_000000.mcap", smile.open(ROBOT), {}
        with cls.path.open("rb") as stream:
            for _, channel, message, decoded in mcap.reader.make_reader(
                    stream, decoder_factories=[JsonDecoder(), DecoderFactory()]).iter_decoded_messages():
                cls.messages.setdefault(channel.topic, []).append((message.log_time, decoded))
        ticks = [values["value"] for _, values in cls.messages["/sim/tick"]]
        cls.rows = np.searchsorted(cls.recording.ticks, ticks)

    def test_features_and_joints_have_times_from_the_start(self):
        state = self.messages["/observation/state"]
        self.assertEqual([time for time, _ in state], [k * 200_000_000 for k in range(len(state))])
        joints = [name for name in state[0][1] if "gripper" not in name]
        expected = self.recording.joints[self.rows][:, [self.recording.joint_names.index(name) for name in joints]]
        np.testing.assert_array_equal([[values[name] for name in joints] for _, values in state],
                                      expected.astype(np.float32))
        third = {joint.name: joint.position for joint in self.messages["/joint_states"][3][1].joints}
        self.assertEqual(third, state[3][1])

    def test_frames_are_where_the_objects_and_cameras_are(self):
        for k, row in enumerate(self.rows):
            frames = {one.child_frame_id: one for one in self.messages["/tf"][k][1].transforms}
            for i, id in enumerate(self.recording.object_ids):
                p, q = frames[id].translation, frames[id].rotation
                np.testing.assert_allclose([p.x, p.y, p.z, q.w, q.x, q.y, q.z], self.recording.poses[row, i],
                                           atol=1e-12)
        p, q = frames["camera/eye"].translation, frames["camera/eye"].rotation
        pose = self.recording.at(self.recording.ticks[row] / 60).render("eye", SIZE).pose
        np.testing.assert_allclose([p.x, p.y, p.z], pose[:3, 3], atol=1e-6)
        np.testing.assert_allclose(rotated(q, [0, 0, 1]), pose[:3, 2], atol=1e-6)

    def test_shapes_are_shown_once_in_their_frames(self):
        (_, update), = self.messages["/scene"]
        entities = {entity.id: entity for entity in update.entities}
        self.assertEqual(set(entities) & {"world", "RedBlock"}, {"world", "RedBlock"})
        block, = entities["RedBlock"].triangles
        corners = np.array([[point.x, point.y, point.z] for point in block.points])
        np.testing.assert_allclose(np.abs(corners), 0.05, atol=1e-6)
        self.assertEqual((len(block.indices), entities["RedBlock"].frame_id), (36, "RedBlock"))
        frames = {one.child_frame_id for one in self.messages["/tf"][0][1].transforms}
        self.assertEqual({entity.frame_id for entity in update.entities} - frames, {"world"})

    def test_pictures_are_lossless(self):
        _, image = self.messages["/camera/eye/image"][4]
        with av.open(io.BytesIO(image.data)) as png:
            found = next(png.decode(video=0)).to_ndarray(format="rgb24")
        picture = self.recording.at(self.recording.ticks[self.rows[4]] / 60).render("eye", SIZE)
        np.testing.assert_array_equal(found, picture.rgb)
        np.testing.assert_allclose(self.messages["/camera/eye/calibration"][4][1].K, picture.intrinsics.ravel())

    def test_has_the_subtasks_and_the_origin(self):
        with self.path.open("rb") as stream:
            metadata = {one.name: one.metadata for one in mcap.reader.make_reader(stream).iter_metadata()}["smile"]
        names = json.loads(metadata["sparse_subtask_names"])
        self.assertEqual([log.message for _, log in self.messages["/subtasks"]], names)
        self.assertEqual((metadata["task"], metadata["smile/state_hash"]),
                         ("build", f"{self.recording.hashes[-1]:016x}"))


class JsonDecoder:
    """Decodes messages in JSON, as viewers do."""

    def decoder_for(self, encoding, schema):
        return json.loads if encoding == "json" and schema.encoding == "jsonschema" else None


def rotated(q, v):
    """Rotates a vector by a quaternion of Foxglove's."""
    axis = np.array([q.x, q.y, q.z])
    return np.asarray(v) + 2 * np.cross(axis, np.cross(axis, v) + q.w * np.asarray(v))


class MapsTest(unittest.TestCase):
    """Depth and numbers of objects are those that the simulator draws, without loss."""

    def test_in_each_format_that_keeps_numbers(self):
        recording, folder = smile.open(ROBOT), Path(SHARED.name) / "maps"
        for format in ("robomimic", "zarr", "mcap"):
            export([ROBOT], folder / format, format=format, cameras={"eye": SIZE}, fps=5, maps=["id", "depth"])
            self.assertEqual([finding for finding in examine(folder / format) if finding.is_error], [])
        with h5py.File(folder / "robomimic/demo.hdf5") as file:
            obs, tick = file["data/demo_0/obs"], int(file["data/demo_0/states"][3, 0])
            found = {"robomimic": [obs[f"eye_{name}"][3, :, :, 0] for name in ("depth", "id")]}
        data = zarr.open(str(folder / "zarr/replay.zarr"), mode="r")["data"]
        found["zarr"] = [data[f"eye_{name}"][3] for name in ("depth", "id")]
        with (folder / "mcap/episode_000000.mcap").open("rb") as stream:
            messages = mcap.reader.make_reader(stream, decoder_factories=[DecoderFactory()]).iter_decoded_messages(
                ["/camera/eye/depth", "/camera/eye/id"])
            images = [decoded for _, _, message, decoded in messages if message.log_time == 600_000_000]
        self.assertEqual([image.encoding for image in images], ["32FC1", "mono16"])
        found["mcap"] = [np.frombuffer(image.data, kind).reshape(image.height, image.width)
                         for image, kind in zip(images, ("<f4", "<u2"))]
        expected = recording.at(tick / 60).render("eye", SIZE, channels=("depth", "id"))
        for format, (depth, id) in found.items():
            np.testing.assert_array_equal(depth, expected.depth, format)
            np.testing.assert_array_equal(id, expected.id, format)

    def test_films_of_depth_are_exact_to_half_a_millimeter(self):
        recording, folder, key = smile.open(ROBOT), Path(SHARED.name) / "depth", "observation.images.eye_depth"
        export([ROBOT, ROBOT], folder, cameras={"eye": (66, 46)}, fps=5, maps=["depth"])
        self.assertEqual([str(finding) for finding in examine(folder) if finding.is_error], [])
        feature = json.loads((folder / "meta/info.json").read_text())["features"][key]
        about = feature["info"]
        self.assertEqual((feature["shape"], about["is_depth_map"], about["depth_unit"]), ([46, 66, 1], True, "mm"))
        with av.open(str(folder / f"videos/{key}/chunk-000/file-000.mp4")) as film:
            self.assertEqual((film.streams.video[0].codec.name, film.streams.video[0].format.name),
                             (about["video.codec"], about["video.pix_fmt"]))
            frames = [(frame.time, frame.to_ndarray(format="gray12le")) for frame in film.decode(video=0)]
        ticks = pq.read_table(folder / "data/chunk-000/file-000.parquet")["sim.tick"].to_pylist()
        self.assertEqual([round(5 * time, 6) for time, _ in frames], list(range(len(ticks))))
        # As LeRobot 0.6 does.
        scale = (about["video.depth_max"] - about["video.depth_min"]) / 4095
        for (_, levels), tick in list(zip(frames, ticks, strict=True))[::7]:
            drawn = recording.at(tick / 60).render("eye", (66, 46), channels=("depth",)).depth
            self.assertGreater(drawn.max(), 0.5)
            self.assertLess(np.abs(levels * scale + about["video.depth_min"] - drawn).max(), 0.0005 + 1e-6)
        stats = json.loads((folder / "meta/stats.json").read_text())[key]
        self.assertEqual(stats["max"], [[[max(int(levels.max()) for _, levels in frames)]]])

    def test_films_keep_no_numbers_of_objects(self):
        with self.assertRaisesRegex(ValueError, "expected robomimic or zarr or mcap or rrd for id: readers of the others"):
            export([ROBOT], Path(SHARED.name) / "no", maps=["depth", "id"])
        with self.assertRaisesRegex(ValueError, "expected .* or lerobot-v3.0 for depth"):
            export([ROBOT], Path(SHARED.name) / "no", maps=["depth"], format="lerobot-v2.1")
        with self.assertRaisesRegex(ValueError, "size is 32x8, expected at least 16x16"):
            export([ROBOT], Path(SHARED.name) / "no", maps=["depth"], cameras={"eye": (32, 8)})
        with self.assertRaisesRegex(ValueError, "maps is .*'deep'.*, expected some of depth, id"):
            export([ROBOT], Path(SHARED.name) / "no", format="zarr", maps=["deep"])


class CsvTest(unittest.TestCase):
    def test_tables_and_films_of_each_episode_read_back(self):
        folder = Path(SHARED.name) / "csv"
        export([ROBOT, ROBOT], folder, format="csv", cameras={"eye": SIZE}, fps=5, task="build, quickly")
        episodes = pandas.read_csv(folder / "episodes.csv")
        self.assertEqual(episodes["tasks"].map(json.loads).tolist(), [["build, quickly"]] * 2)
        recording = smile.open(ROBOT)
        for number, length in enumerate(episodes["length"]):
            table = pandas.read_csv(folder / f"episode_{number:06d}.csv")
            rows = np.searchsorted(recording.ticks, table["sim.tick"])
            joint = recording.joints[rows, recording.joint_names.index("right_s1")]
            np.testing.assert_array_equal(table["observation.state.right_s1"].astype(np.float32),
                                          joint.astype(np.float32))
            self.assertEqual((len(table), table["next.done"].sum()), (length, 1))
            with av.open(str(folder / f"episode_{number:06d}.observation.images.eye.mp4")) as film:
                self.assertEqual(sum(1 for _ in film.decode(video=0)), length)


class ActionsTest(unittest.TestCase):
    def test_velocities_and_displacements_lead_to_the_next_frame(self):
        with tempfile.TemporaryDirectory() as folder:
            columns = {}
            for action in ("joint_velocity", "end_effector"):
                export([TERN], Path(folder) / action, cameras=(), fps=60, action=action)
                table = pq.read_table(Path(folder) / action / "data/chunk-000/file-000.parquet")
                columns[action] = np.array(table["action"].to_pylist())
            state = np.array(table["observation.state"].to_pylist())
            joints = [i for i in range(state.shape[1]) if i != 6]  # the gripper follows its command
            np.testing.assert_allclose(np.diff(state, axis=0)[:, joints] * 60,
                                       columns["joint_velocity"][:-1, joints], atol=1e-3)
            # The tool at the end is where the displacements lead.
            sim = smile.Simulation(smile.open(TERN).model)
            arm, poses = sim.robot.arms["arm"], []
            for row in (0, -1):
                arm.set_q(state[row, :6])
                poses.append(arm.tool_pose)
            moved = columns["end_effector"][:-1].sum(axis=0)
            np.testing.assert_allclose(moved[:3], poses[1][:3] - poses[0][:3], atol=1e-4)

    def test_rotations_are_the_shorter_ones_in_the_world(self):
        half = np.sqrt(0.5)
        before = np.array([[1, 0, 0, 0], [half, half, 0, 0], [1, 0, 0, 0]], float)
        after = np.array([[half, 0, 0, half], [half, half, 0, 0], [-half, 0, 0, half]])
        np.testing.assert_allclose(rotation_between(before, after),
                                   [[0, 0, np.pi / 2], [0, 0, 0], [0, 0, -np.pi / 2]], atol=1e-12)


class DemonstrationTest(unittest.TestCase):
    def test_a_demonstration_has_objects_and_no_robot(self):
        with tempfile.TemporaryDirectory() as folder:
            dataset = Path(folder) / "dataset"
            export([DEMONSTRATION], dataset, cameras=(), fps=20)
            table = pq.read_table(dataset / "data/chunk-000/file-000.parquet")
            self.assertEqual([name for name in table.column_names if name.startswith(("observation", "action"))], [])
            held = np.array(table["sim.object_held"].to_pylist())
            self.assertEqual(set(held.flat), {0, 1})
            self.assertEqual(examine(dataset), [])


class RefusalsTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def assert_nothing_left(self):
        self.assertEqual([path.name for path in self.folder.iterdir() if path.name.startswith("dataset")], [])

    def refuse(self, pattern, runs=(ROBOT,), error=ValueError, **options):
        with self.assertRaisesRegex(error, pattern):
            export(runs, self.folder / "dataset", **{"cameras": (), **options})
        self.assert_nothing_left()

    def test_what_cannot_be_exported_is_refused_before_anything_is_written(self):
        self.refuse('imitation: camera is "nose", expected eye', cameras=("nose",))
        self.refuse("fps is 25, expected one of 1, 2", fps=25)
        self.refuse("size is 65x48, expected even", cameras=("eye",), size=(65, 48))
        self.refuse("action is 'dance', expected joint_position or", action="dance")
        self.refuse("format is 'rlds', expected lerobot", format="rlds")
        self.refuse("there are no runs", runs=())
        self.refuse("scenes: is no recording", runs=[PROJECT / "scenes"])
        self.refuse("nowhere: does not exist", runs=[PROJECT / "nowhere"])
        self.refuse("has other objects", runs=[ROBOT, PROJECT / "tests/golden/recordings/um"])
        self.refuse("has another robot", runs=[PROJECT / "tests/golden/recordings/robot", TERN])

    def test_a_failed_run_is_exported_only_if_asked_for(self):
        failed = imitation(self.folder / "failed", False, {"word": "toppled", "text": "…"})
        self.refuse(r"failed: failed \(toppled\)", runs=[failed])
        export([failed], self.folder / "dataset", cameras=(), include_failed=True)
        table = pq.read_table(self.folder / "dataset/data/chunk-000/file-000.parquet")
        self.assertFalse(any(table["next.success"].to_pylist()))

    def test_a_correction_tells_from_which_frame_on_another_actor_took_over(self):
        corrected = self.folder / "corrected"
        shutil.copytree(ROBOT, corrected)
        info = json.loads((corrected / "demo.json").read_text())
        (corrected / "demo.json").write_text(json.dumps(info | {"corrects": {"recording": "imitation", "seconds": 1.5}}))
        export([ROBOT, corrected], self.folder / "dataset", cameras=(), fps=10)
        table = pq.read_table(self.folder / "dataset/data/chunk-000/file-000.parquet").to_pandas()
        flags = [list(episode["intervention"]) for _, episode in table.groupby("episode_index")]
        self.assertFalse(any(flags[0]))
        self.assertEqual(flags[1], [k >= 15 for k in range(len(flags[1]))])
        episodes = pq.read_table(next((self.folder / "dataset/meta/episodes").rglob("*.parquet")))
        self.assertEqual(episodes["smile/corrects"].to_pylist(), ["", "imitation"])

    def test_a_folder_that_exists_stays_as_it_is(self):
        (self.folder / "mine").mkdir()
        (self.folder / "mine/notes.txt").write_text("important")
        with self.assertRaisesRegex(FileExistsError, "exists, expected a new folder"):
            export([ROBOT], self.folder / "mine", cameras=())
        self.assertEqual([path.name for path in (self.folder / "mine").iterdir()], ["notes.txt"])

    def test_what_is_interrupted_leaves_nothing(self):
        def interrupt(_):
            raise KeyboardInterrupt
        self.refuse("", error=KeyboardInterrupt, progress=interrupt)

    def test_the_rest_of_a_killed_export_is_removed_by_the_next(self):
        (self.folder / "dataset.partial").mkdir()
        (self.folder / "dataset.partial/half").write_text("")
        export([TERN], self.folder / "dataset", cameras=())
        self.assertEqual({path.name for path in self.folder.iterdir()}, {"dataset"})
        self.assertFalse((self.folder / "dataset/half").exists())

    def test_a_full_disk_is_reported_and_leaves_nothing(self):
        def small_files():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (30_000, 30_000))
        for camera in ("none", "eye"):
            answer = run("export", ROBOT, "--out", self.folder / "dataset", "--camera", camera, "--fps", 10,
                         "--no-extras", preexec_fn=small_files)
            self.assertEqual(answer.returncode, 2, answer)
            self.assertRegex(answer.stderr, "error: .*File too large")
            self.assertNotIn("Traceback", answer.stderr)
            self.assert_nothing_left()


class CommandLineTest(unittest.TestCase):
    def test_the_document_works(self):
        """Runs docs/datasets.md as tests/docs runs the others, which need no packages."""
        text = (PROJECT / "docs/datasets.md").read_text()
        with tempfile.TemporaryDirectory() as folder:
            for name in ("scenes", "examples", "python", "robots", "tests"):
                (Path(folder) / name).symlink_to(PROJECT / name)
            blocks = re.findall(r"^```(\w+)( [\w.]+)?\n(.*?)^```$", text, re.DOTALL | re.MULTILINE)
            environment = {**os.environ, "PYTHONPATH": f"{os.environ['PYTHONPATH']}:{READERS}"}
            printed = ""
            for language, purpose, content in blocks:
                if purpose.strip().count("."):
                    (Path(folder) / purpose.strip()).write_text(content)
                elif language == "sh":
                    content = re.sub(r"^export PYTHONPATH.*|^python3 -m pip.*", "", content, flags=re.MULTILINE)
                    content = content.replace("./run", os.environ["SMILE"]).replace("python3 ", sys.executable + " ")
                    answer = subprocess.run(["bash", "-ec", content], cwd=folder, text=True, env=environment,
                                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
                    printed = answer.stdout
                    self.assertEqual(answer.returncode, 0, content + printed)
                elif purpose.strip() == "output":
                    for line in content.splitlines():
                        pattern = ".*".join(map(re.escape, line.split("…")))
                        self.assertRegex(printed, pattern)

    def test_the_help_names_formats_rates_and_actions(self):
        answer = run("export", "--help")
        for word in ("lerobot-v3.0", "joint_velocity", "30, 60 (default 30)", "--include-failed"):
            self.assertIn(word, answer.stdout)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
