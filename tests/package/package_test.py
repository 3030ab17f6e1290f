"""Tests the Python package as pip installed it: it is whole, and computes the bits of the other builds.

Usage: package_test.py PROJECT_FOLDER BUILD_FOLDER, run by the Python of the environment in which
tools/build_python_package.py installed the package, without PYTHONPATH.
"""

import importlib.metadata
import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

import smile

PROJECT, BUILD = Path(sys.argv[1]), Path(sys.argv[2])
PACKAGE = Path(smile.__file__).parent
SMILE = Path(sys.executable).parent / "smile"
SYSTEM_PYTHON = "/usr/bin/python3"

# Hands, a robot, a collision, a state that was written and read, and a layout.
COURSE = """
import pickle, sys, smile
sim = smile.Simulation(smile.load(sys.argv[1], "tern").laid_out(5, "scattered"))
name = sim.object_ids[0]
sim.robot.move_to_pose("ready")
sim.hand("left").grasp(name)
sim.hand("left").move_to([0.3, 0.2, 0.2])
sim.run_until("arrived")
sim.restore(pickle.loads(pickle.dumps(sim.save())))
sim.hand("left").move_to(sim.objects[sim.object_ids[1]].position + [0, 0, 0.02])
sim.step(90)
sim.hand("left").release()
sim.run_until("still")
print(sim.tick, sim.hash, sim.poses.tolist(), sim.objects[name].pose.tolist(), sim.robot.arms["arm"].tool_pose.tolist())
"""


def run(*command, **options):
    environment = {name: value for name, value in os.environ.items() if not name.startswith("SMILE_")}
    done = subprocess.run(list(map(str, command)), text=True, stdout=subprocess.PIPE,
                          env=environment | options.pop("env", {}), **options)
    if done.returncode != 0:
        raise AssertionError(f"{command}: exit code {done.returncode}\n{done.stdout}")
    return done.stdout


class WheelTest(unittest.TestCase):
    def test_is_of_this_source(self):
        for file in (PROJECT / "python/smile").rglob("*.py*"):
            if "__pycache__" not in file.parts:
                installed = PACKAGE / file.relative_to(PROJECT / "python/smile")
                self.assertEqual(installed.read_bytes(), file.read_bytes(),
                                 f"{installed}: run tools/build_python_package.py")

    def test_needs_nothing_but_itself(self):
        self.assertTrue(PACKAGE.is_relative_to(sys.prefix), PACKAGE)
        for name in ("scenes/um.xml", "robots/baxter.urdf", "robots/appearance", "examples/um.jsonl",
                     "matlab/client/smile_brain.m", "python/learner/learner.py"):
            self.assertTrue(smile.data_file(name).is_relative_to(PACKAGE / "share/smile"), name)
        source = str(PROJECT / "build/package/source").encode()
        for file in [*PACKAGE.glob("*.so"), *(PACKAGE / "bin").iterdir()]:
            self.assertNotIn(source, file.read_bytes(), file)

    def test_has_the_version_of_the_program_and_of_its_metadata(self):
        self.assertEqual(run(SMILE, "--version").split()[-1], smile.__version__)
        self.assertEqual(importlib.metadata.version("smile-demonstrator"), smile.__version__)
        self.assertEqual(int(np.__version__.split(".")[0]), 2)

    def test_imports_quickly(self):
        program = ("import sys, time; import numpy; t = time.process_time(); import smile; smile.Simulation; "
                   "print(time.process_time() - t)")
        self.assertLess(min(float(run(sys.executable, "-c", program)) for _ in range(3)), 0.3)


class DocumentTest(unittest.TestCase):
    def test_commands_work(self):
        lines = (PROJECT / "docs/python.md").read_text().splitlines()
        commands = [line for line in lines if line.startswith("~/env/bin/") and "pip" not in line]
        self.assertGreater(len(commands), 1)
        for command in commands:
            run("sh", "-c", command.replace("~/env/bin/", f"{Path(sys.executable).parent}/"), cwd=PROJECT)


class TypesTest(unittest.TestCase):
    def test_of_the_compiled_modules_are_written_down(self):
        with tempfile.TemporaryDirectory() as folder:
            run(PROJECT / "tools/make_stubs.sh", folder)
            for file in Path(folder).iterdir():
                kept = PROJECT / "python/smile" / file.name
                self.assertEqual(kept.read_text(), file.read_text(), f"{kept}: run tools/make_stubs.sh")

    def test_are_right(self):
        run(sys.executable, "-m", "mypy", "--cache-dir", PROJECT / "build/package/mypy", "python/smile", cwd=PROJECT)

    def test_reach_users(self):
        self.assertTrue((PACKAGE / "py.typed").exists())
        with tempfile.TemporaryDirectory() as folder:
            user = Path(folder) / "user.py"
            user.write_text("import smile\n"
                            "sim = smile.Simulation(smile.load('scenes/tower.xml'))\n"
                            "reveal_type(sim.objects['RedBlock'].pose)\n"
                            "sim.hand('left').grasp(3)\n")
            done = subprocess.run([sys.executable, "-m", "mypy", "--cache-dir", folder, user], cwd=folder, text=True,
                                  stdout=subprocess.PIPE)
            self.assertIn('Argument 1 to "grasp" of "Hand" has incompatible type "int"', done.stdout)
            self.assertIn('Revealed type is "numpy.ndarray', done.stdout)
            self.assertIn("Found 1 error", done.stdout)


class BitsTest(unittest.TestCase):
    def test_are_those_of_the_release(self):
        lines = (PROJECT / "tests/golden/recordings/hashes.txt").read_text().splitlines()
        golden = dict(line.split() for line in lines)
        for name, scene, options in (("um", "um", ["--no-robot"]), ("drive", "drive", ["--no-robot"]),
                                     ("robot_poses", "tower", [])):
            answer = run(SMILE, "run", PROJECT / f"scenes/{scene}.xml", "--commands",
                         PROJECT / f"examples/{name}.jsonl", "--json", *options)
            self.assertEqual(json.loads(answer)["hash"], golden[name], name)

    def test_of_old_recordings_come_again(self):
        for name in ("friction_grasp", "loads_unstack", "robot_press", "scissors", "shapes", "tern"):
            smile.open(PROJECT / "tests/golden/recordings" / name).verify()

    def test_are_those_of_another_build_with_another_numpy(self):
        path = f"{PROJECT / 'python'}:{BUILD / 'python'}"
        scene = PROJECT / "scenes/tower.xml"
        there = run(SYSTEM_PYTHON, "-B", "-c", COURSE, scene, env={"PYTHONPATH": path})
        self.assertEqual(run(sys.executable, "-c", COURSE, scene), there)
        # The modules of the clone are compiled with Debian's pybind11, which does not know numpy 2.
        self.assertEqual(run(sys.executable, "-B", "-c", COURSE, scene, env={"PYTHONPATH": path}), there)


class BrainsTest(unittest.TestCase):
    def test_run_in_the_environment_of_the_package(self):
        with tempfile.TemporaryDirectory() as folder:
            brain = Path(folder) / "brain/where.py"
            brain.parent.mkdir()
            brain.write_text("import sys, numpy, smile.motion\n"
                             "def init(aux):\n"
                             "    smile.motion.robot_of(aux)\n"
                             "def step(sensor, motor, aux):\n"
                             "    print('with', sys.executable, numpy.__version__)\n"
                             "    aux.exit = True\n")
            done = subprocess.run([SMILE, "run", PROJECT / "scenes/tower.xml", "--brain", brain], text=True,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            self.assertEqual(done.returncode, 0, done.stdout)
            self.assertIn(f"with {sys.executable} {np.__version__}", done.stdout)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
