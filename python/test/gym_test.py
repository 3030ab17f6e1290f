"""Tests the Gymnasium environments with Gymnasium itself, which tools/get_gymnasium.sh installs.

Usage: gym_test.py PROJECT_FOLDER. Ends with 77 where Gymnasium is not installed.
"""

import contextlib
import io
import json
import os
import re
import sys
import tempfile
import time
import unittest
import warnings
from pathlib import Path
from unittest import mock

import numpy as np
from hands import put_on

PROJECT = Path(sys.argv[1])
sys.path.append(str(PROJECT / "build/gymnasium"))
try:
    import gymnasium
except ImportError:
    print("skipped: Gymnasium is not installed, see tools/get_gymnasium.sh")
    sys.exit(77)
from gymnasium.utils.env_checker import check_env

import smile
import smile.gym
from smile.gym.environment import CONTROLS
from smile.simulation import _native

TOWER = PROJECT / "scenes/tower.xml"


def stacked_demo(folder):
    """A demonstration that puts the red block on the blue one."""
    sim = smile.Simulation(smile.load(TOWER, robot=None))
    sim.record(folder, pictures=False)
    put_on(sim, "RedBlock", "BlueBlock")
    return sim.finish()


def equal(one, other):
    """Whether two values of Gymnasium are the same to the last bit."""
    if isinstance(one, dict):
        return one.keys() == other.keys() and all(equal(one[key], other[key]) for key in one)
    if isinstance(one, (tuple, list)):
        return len(one) == len(other) and all(map(equal, one, other))
    return np.array_equal(one, other) and np.asarray(one).dtype == np.asarray(other).dtype


def episode(env, seed, steps):
    """What a random policy sees."""
    env.action_space.seed(seed)
    seen = [env.reset(seed=seed)]
    for _ in range(steps):
        seen.append(env.step(env.action_space.sample()))
    return seen


class Environments(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.demo = Path(cls.folder.name) / "demo"
        stacked_demo(cls.demo)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def make(self, id="smile/Tower-v0", **kwargs):
        if id == "smile/Demonstration-v0":
            kwargs = {"demo": self.demo, "scene": TOWER, **kwargs}
        env = gymnasium.make(id, **kwargs)
        self.addCleanup(env.close)
        return env


class CheckerTest(Environments):
    def test_gymnasiums_checker_accepts_every_id_with_every_control(self):
        for number, id in enumerate(smile.gym.IDS):
            for control in CONTROLS:
                # The robots take turns; each reward, too.
                robot = "tern" if id.split("/")[1] in ("Tower-v0", "Demonstration-v0") else "baxter"
                with self.subTest(id=id, control=control), warnings.catch_warnings():
                    warnings.simplefilter("error")
                    # Bounds of the numbers of a state are not known.
                    warnings.filterwarnings("ignore", ".*(infinity|Box observation space).*")
                    env = self.make(id, control=control, robot=robot,
                                    reward=("sparse", "dense")[number % 2])
                    check_env(env.unwrapped, skip_render_check=control != "waypoints")

    def test_gymnasiums_checker_accepts_pictures_in_lerobots_form(self):
        env = self.make(robot="tern", observe="lerobot", cameras=("eye",),
                        channels=("rgb", "depth"), camera_size=(40, 30), render_mode="rgb_array")
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            warnings.filterwarnings("ignore", ".*(infinity|Box observation space).*")
            check_env(env.unwrapped)
        observation, info = env.reset(seed=1)
        self.assertEqual(observation["pixels"]["eye"].shape, (30, 40, 3))
        self.assertEqual(observation["depth"]["eye"].dtype, np.float32)
        self.assertEqual(len(observation["agent_pos"]), 6 + 6 + 1 + 7)
        self.assertIs(info["is_success"], False)
        # The camera's matrices belong to the picture.
        sim = env.unwrapped.simulation
        picture = sim.render("eye", size=(40, 30), channels=("rgb",))
        np.testing.assert_array_equal(observation["extrinsics"]["eye"], picture.pose)
        np.testing.assert_array_equal(observation["pixels"]["eye"], picture.rgb)
        self.assertEqual(env.render().shape, (360, 480, 3))


class ExactnessTest(Environments):
    def test_the_same_seed_and_actions_give_the_same_everything(self):
        for control in CONTROLS:
            first, second = (self.make(robot="tern", control=control) for _ in range(2))
            self.assertTrue(equal(episode(first, 5, 20), episode(second, 5, 20)), control)
            self.assertFalse(equal(episode(first, 6, 1), episode(second, 7, 1)), control)

    def test_a_saved_state_continues_with_the_same_bits_in_another_environment(self):
        env, other = self.make(robot="tern"), self.make(robot="tern")
        episode(env, 3, 10)
        other.reset(seed=4)
        state = env.unwrapped.get_state()
        actions = [env.action_space.sample() for _ in range(20)]
        there = [env.unwrapped.step(action) for action in actions], env.reset()
        for one in (env, other):
            one.unwrapped.set_state(state)
            again = [one.unwrapped.step(action) for action in actions], one.reset()
            self.assertTrue(equal(there, again))

    def test_contacts_before_a_saved_state_are_not_forgotten(self):
        env = self.make("smile/Demonstration-v0", robot="tern").unwrapped
        env.reset(seed=1, options={"level": "scene"})
        before = env.get_state()
        env.simulation.hand("left").grasp("RedBlock")
        held = env.get_state()
        released = env.goal_names.index("RedBlock.released")
        for state, number in ((before, 1), (held, 0), (before, 1)):
            observation, _ = env.set_state(state)
            self.assertEqual(observation["achieved_goal"][released], number)

    def test_what_is_no_state_is_refused_and_changes_nothing(self):
        env = self.make(robot="tern").unwrapped
        episode(env, 1, 3)
        state, there = env.get_state(), env.get_state()
        foreign = self.make("smile/Row-v0", robot="tern").unwrapped
        foreign.reset(seed=1)
        for bad in (b"", state[:50], state[:-1], b"x" + state, foreign.get_state(), None):
            with self.assertRaises(ValueError):
                env.set_state(bad)
            self.assertEqual(env.get_state(), there)

    def test_a_vector_of_worlds_is_as_single_ones_whatever_the_number_of_threads(self):
        steps, seed = 13, 11

        def run(envs):
            rng = np.random.default_rng(2)
            seen = [envs.reset(seed=seed)]
            for _ in range(steps):
                actions = rng.uniform(-1, 1, envs.action_space.shape).astype(np.float32)
                seen.append(envs.step(actions))
            envs.close()
            return seen

        arguments = {"num_envs": 3, "robot": "tern", "reward": "dense"}
        # Episodes end within the run, and begin again.
        sync = run(gymnasium.make_vec("smile/Tower-v0", vectorization_mode="sync",
                                      max_episode_steps=5, **arguments))
        self.assertTrue(any(step[3].any() for step in sync[1:]))
        for threads in (1, 2, 3):
            ours = run(gymnasium.make_vec("smile/Tower-v0", threads=threads,
                                          vectorization_mode="vector_entry_point",
                                          max_episode_steps=5, **arguments))
            self.assertTrue(equal(sync, ours), threads)

    def test_a_forked_process_steps_with_threads_of_its_own(self):
        envs = gymnasium.make_vec("smile/Tower-v0", num_envs=2, robot="tern", threads=2,
                                  vectorization_mode="vector_entry_point")
        envs.reset(seed=3)
        action = np.full(envs.action_space.shape, 0.5, np.float32)
        envs.step(action)
        reading, writing = os.pipe()
        child = os.fork()
        if child == 0:
            try:
                os.write(writing, envs.step(action)[0]["observation"].tobytes())
            finally:
                os._exit(0)
        os.close(writing)
        expected = envs.step(action)[0]["observation"].tobytes()
        with os.fdopen(reading, "rb") as answer:
            self.assertEqual(answer.read(), expected)
        os.waitpid(child, 0)

    def test_worlds_in_other_processes_are_the_same(self):
        seen = []
        for mode in ("sync", "async"):
            envs = gymnasium.make_vec("smile.gym:smile/Tower-v0", num_envs=2, robot="tern",
                                      vectorization_mode=mode)
            seen.append([envs.reset(seed=1), envs.step(np.full(envs.action_space.shape, 0.5, np.float32))])
            envs.close()
        self.assertTrue(equal(*seen))


class GoalsTest(Environments):
    def test_the_reward_of_a_step_is_that_of_its_goals(self):
        for reward in ("sparse", "dense"):
            env = self.make(robot="tern", reward=reward).unwrapped
            seen = episode(env, 2, 15)
            rows = [observation for observation, *_ in seen[1:]]
            achieved = np.stack([row["achieved_goal"] for row in rows])
            desired = np.stack([row["desired_goal"] for row in rows])
            rewards = env.compute_reward(achieved, desired, {})
            np.testing.assert_array_equal(rewards, [step[1] for step in seen[1:]])
            np.testing.assert_array_equal(env.compute_terminated(achieved, desired, {}),
                                          [step[2] for step in seen[1:]])
            self.assertEqual(env.compute_reward(achieved[3], desired[3], {}), seen[4][1])
            # Hindsight: whatever was achieved is a goal that was achieved.
            shape = (3, 5, achieved.shape[1])
            self.assertTrue((env.compute_terminated(achieved.reshape(shape),
                                                    achieved.reshape(shape), {})).all())
            np.testing.assert_allclose(env.compute_reward(achieved, achieved, {}), 0, atol=1e-6)
            with self.assertRaisesRegex(ValueError, "expected both"):
                env.compute_reward(achieved[:, 1:], desired[:, 1:], {})

    def test_success_is_what_the_task_says(self):
        env = self.make("smile/Demonstration-v0", robot="tern", reward="dense").unwrapped
        for seed in range(3):
            _, info = env.reset(seed=seed)
            self.assertFalse(info["is_success"])
            still = np.zeros(env.action_space.shape, np.float32)
            _, before, *_ = env.step(still)
            task = smile.Task(smile.open(self.demo), env.simulation)
            put_on(env.simulation, "GreenBlock", "BlueBlock")
            _, reward, terminated, _, info = env.step(still)
            self.assertEqual((terminated, info["score"]), (False, task.compare().score))
            self.assertLess(reward, 0)
            env.reset(seed=seed)
            put_on(env.simulation, "RedBlock", "BlueBlock")
            _, reward, terminated, _, info = env.step(still)
            self.assertTrue(terminated and info["is_success"], info)
            self.assertGreater(reward, before)

    def test_every_score_on_the_way_of_the_demonstrator_is_that_of_the_task(self):
        def perform(sim, line):
            command = json.loads(line)
            if command["do"] != "wait":
                sim.apply(command)
            elif "until" in command:
                sim.run_until(command["until"])
            else:
                sim.step(round(60 * command["seconds"]))

        for task in ("tower", "row", "bridge", "box", "um", "hatch", "drive"):
            with tempfile.TemporaryDirectory() as folder:
                demo = Path(folder) / "demo"
                _native.record_demonstration(task, "baxter", demo)
                env = smile.gym.Environment(task, scene=PROJECT / f"scenes/{task}.xml", level="scene")
                env.reset()
                judge = smile.Task(smile.open(demo), env.simulation)
                scores = set()
                for line in (PROJECT / f"examples/{task}.jsonl").read_text().splitlines():
                    if not line or line.startswith("#"):
                        continue
                    perform(env.simulation, line)
                    scores.add(score := judge.compare().score)
                    self.assertEqual(env._told()[1]["score"], score, (task, line))
                self.assertGreater(len(scores), 2)
                observation, reward, terminated, _, info = env.step(np.zeros(env.action_space.shape))
                self.assertTrue(terminated and info["is_success"], task)
                self.assertEqual(reward, 0)
                env.close()


class ControlTest(Environments):
    def test_an_end_effector_moves_by_its_displacement_and_holds_still(self):
        env = self.make(robot="tern", displacement=0.03).unwrapped
        env.reset(seed=1)
        env.simulation.robot.move_to_pose("ready")
        env.simulation.run_until("arrived")
        arm = env.simulation.robot.arms["arm"]
        for axis in range(3):
            start = arm.tool_pose
            action = np.zeros(7)
            action[axis] = 0.5
            env.step(action)
            expected = np.zeros(3)
            expected[axis] = 0.015
            np.testing.assert_allclose(arm.tool_pose[:3] - start[:3], expected, atol=0.002)
            env.step(-action)
            env.step(np.zeros(7))
            np.testing.assert_allclose(arm.tool_pose[:3], start[:3], atol=0.003)

    def test_joint_positions_are_reached(self):
        env = self.make(robot="tern", control="joint_positions", speed=1.0).unwrapped
        env.reset(seed=1)
        arm = env.simulation.robot.arms["arm"]
        env.simulation.robot.move_to_pose("ready")
        env.simulation.run_until("arrived")
        ready = arm.q
        env.step(np.zeros(7))
        self.assertGreater(np.abs(arm.q - ready).max(), 0.01)
        for _ in range(60):
            env.step(np.r_[np.zeros(6), 0])
        middle = arm.q
        env.step(np.r_[np.zeros(6), 0])
        np.testing.assert_allclose(arm.q, middle, atol=1e-3)

    def test_a_waypoint_is_reached_or_refused_with_the_reason(self):
        env = self.make(robot="tern", control="waypoints",
                        workspace=((-0.2, -0.5, 0.1), (0.2, 0.1, 0.3))).unwrapped
        env.reset(seed=1)
        _, _, _, _, info = env.step([0, -0.2, 0, 0, 0])
        self.assertNotIn("refused", info)
        tool = env.simulation.robot.arms["arm"].tool_pose
        np.testing.assert_allclose(tool[:3], [0, -0.26, 0.2], atol=0.01)
        far = self.make(robot="tern", control="waypoints",
                        workspace=((5, 5, 5), (6, 6, 6))).unwrapped
        far.reset(seed=1)
        self.assertIn("out of reach", far.step([0, 0, 0, 0, 0])[4]["refused"])

    def test_people_watch_all_episodes_at_one_link_in_real_time(self):
        env, alone = self.make(robot="tern", render_mode="human"), self.make(robot="tern")
        opened = []
        with mock.patch("smile.viewer.Studio.open", lambda studio: opened.append(studio.url)):
            self.assertIsNone(env.unwrapped.studio)
            self.assertTrue(equal(env.reset(seed=1), alone.reset(seed=1)))
            begin, action = time.monotonic(), env.action_space.sample()
            for _ in range(3):
                self.assertTrue(equal(env.step(action), alone.step(action)))
            self.assertGreater(time.monotonic() - begin, 0.25)
            self.assertIsNone(env.render())
            env.reset(seed=2)
        self.assertEqual(opened, [env.unwrapped.studio.url])
        env.close()
        self.assertTrue(env.unwrapped.studio.is_closed)
        with self.assertRaisesRegex(ValueError, "expected 'rgb_array'"):
            smile.gym.VectorEnv(2, robot="tern", render_mode="human")

    def test_mistakes_are_named(self):
        for arguments, words in (({"control": "mind"}, "expected one of joint_velocities"),
                                 ({"rate": 7}, "divisor of 60"), ({"arms": ["third"]}, "third"),
                                 ({"task": "chess"}, "chess"), ({"cameras": ["nowhere"]}, "nowhere"),
                                 ({"render_mode": "ansi"}, "expected 'human'"), ({"speed": 0}, "speed"),
                                 ({"task": None}, "recording")):
            with self.assertRaisesRegex(ValueError, words):
                smile.gym.Environment(**{"robot": "tern", **arguments})
        env = self.make(robot="tern").unwrapped
        with self.assertRaisesRegex(ValueError, "level"):
            env.reset(options={"level": "upside down"})
        with self.assertRaisesRegex(ValueError, "expected only 'level'"):
            env.reset(options={"mood": 1})
        env.reset(seed=1)
        with self.assertRaisesRegex(ValueError, "expected 7"):
            env.step(np.zeros(3))
        with self.assertRaisesRegex(ValueError, "finite"):
            env.step(np.full(7, np.nan))

    def test_levels_are_options_and_keep_the_spaces(self):
        env = self.make("smile/Row-v0", robot="baxter")
        for level in ("scattered", "distractors", "edges", "scene"):
            observation, _ = env.reset(seed=1, options={"level": level})
            self.assertTrue(env.observation_space.contains(observation), level)
        _, _ = env.reset(seed=1, options={"level": "distractors"})
        self.assertEqual(len(env.unwrapped.simulation.object_ids),
                         3 + len(smile.load(PROJECT / "scenes/row_robot.xml", None).object_ids))


class DocumentTest(unittest.TestCase):
    def test_what_the_document_prints_is_printed(self):
        text = (PROJECT / "docs/gym.md").read_text()
        blocks = re.findall(r"^```(\w+) (\S+)\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
        printed, count = "", 0
        with tempfile.TemporaryDirectory() as folder, contextlib.chdir(folder):
            for name in ("scenes", "examples", "robots"):
                Path(name).symlink_to(PROJECT / name)
            for language, purpose, content in blocks:
                if language == "python":
                    out = io.StringIO()
                    with contextlib.redirect_stdout(out):
                        exec(compile(content, purpose, "exec"), {"__name__": "__main__"})
                    printed = out.getvalue()
                elif purpose == "output":
                    count += 1
                    for line in content.splitlines():
                        pattern = ".*".join(map(re.escape, line.split("\u2026")))
                        self.assertRegex(printed, pattern)
        self.assertGreater(count, 2)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
