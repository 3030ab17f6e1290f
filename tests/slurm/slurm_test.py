"""Tests generations and evaluations by a real Slurm, whose daemons run here for the time of the test.

Usage: slurm_test.py SMILE_PROGRAM PROJECT_FOLDER
"""

import filecmp
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import cluster
from cluster import Cluster, wait_until

PROGRAM, PROJECT = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
SHARDS = 8
TOWERS = ("generate", "shown", "--scene", str(PROJECT / "scenes/tower_robot.xml"), "--brain",
          str(PROJECT / "python/learner/learner.py"), "--count", str(SHARDS), "--noise", "joints=0..0.002")


def files_of(folder):
    return {path.relative_to(folder) for path in folder.rglob("*") if path.is_file()}


class Submits(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)
        # A space, as some people's folders have.
        self.work = self.folder / "my work"
        self.work.mkdir()
        self.smile("run", PROJECT / "scenes/tower.xml", "--commands", PROJECT / "examples/tower.jsonl", "--record",
                   "shown", "--size", "320x240")

    def smile(self, *words, environment=None):
        answer = subprocess.run([PROGRAM, *map(str, words)], cwd=self.work, env=environment, capture_output=True,
                                text=True)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        return answer.stdout

    def submit(self, slurm, *words):
        """Returns the jobs of the shards and of the merge."""
        said = self.smile(*words, environment=slurm.environment)
        jobs = re.findall(r"^job (\d+): ", said, re.MULTILINE)
        self.assertEqual(len(jobs), 2, said)
        return jobs

    def log(self, name):
        return (self.work / name).read_text() if (self.work / name).exists() else ""

    def assert_same_bytes(self, one, other):
        one, other = self.work / one, self.work / other
        self.assertEqual(files_of(one), files_of(other))
        different = [name for name in files_of(one) if not filecmp.cmp(one / name, other / name, shallow=False)]
        self.assertEqual(different, [])

    def make_folder(self, name):
        folder = self.folder / name
        folder.mkdir()
        return folder


class WithoutSlurmTest(Submits):
    def test_says_what_is_missing_or_wrong_and_makes_nothing(self):
        nowhere = {**os.environ, "PATH": str(self.make_folder("nothing"))}
        (self.work / "empty").mkdir()
        for options, code, message in (
                (("--slurm", "2", "--out", "shown/towers"), 1, "shown"),
                (("--slurm", "9", "--out", "towers"), 2, "--slurm is 9, expected at most one shard for each of 8"),
                (("--slurm", "1", "--out", "towers"), 2, "--slurm"),
                (("--slurm", "2", "--shard", "1/2", "--out", "towers"), 2, "--shard"),
                (("--slurm", "2", "--out", "empty"), 3, "empty: exists, expected a new folder")):
            answer = self.smile_fails(code, *TOWERS, *options, environment=nowhere)
            self.assertIn(message, answer)
            self.assertFalse((self.work / "towers.slurm").exists())
        answer = self.smile_fails(3, *TOWERS, "--slurm", "2", "--out", "towers", environment=nowhere)
        self.assertIn("sbatch --parsable towers.slurm/shards.sh` needs a machine with Slurm", answer)
        # What it would have submitted.
        self.assertIn("#SBATCH --array=1-2\n", self.log("towers.slurm/shards.sh"))

    def smile_fails(self, code, *words, environment):
        answer = subprocess.run([PROGRAM, *words], cwd=self.work, env=environment, capture_output=True, text=True)
        self.assertEqual(answer.returncode, code, answer.stderr)
        return answer.stderr


@unittest.skipIf(cluster.missing(), "Slurm is not installed")
class SlurmTest(Submits):
    def test_a_generation_survives_kills_and_ends_with_the_bytes_of_one_process(self):
        with Cluster(self.make_folder("cluster")) as slurm:
            shards, merge = self.submit(slurm, *TOWERS, "--slurm", SHARDS, "--out", "towers")
            # Of a cluster with two cores, both work.
            self.wait_for_shards(1, 2)
            # Without the daemon of their node, the shards that are running go on, and the others wait.
            slurm.kill("slurmd")
            slurm.start("slurmd")
            self.wait_for_shards(4)
            slurm.run("scancel", "--signal=KILL", "--full", f"{shards}_4", check=True)
            wait_until(lambda: not slurm.states(merge), "the merge does not end")
            self.assertRegex(self.log("towers.slurm/merge.log"), "shard-4-of-8: is no(t complete| complete shard)|"
                             "shard 4/8 is missing")
            self.assertFalse((self.work / "towers").exists())

            shards, merge = self.submit(slurm, *TOWERS, "--slurm", SHARDS, "--out", "towers")
            wait_until(lambda: not slurm.states(merge), "the merge does not end")
        self.assertTrue((self.work / "towers").exists(), self.log("towers.slurm/merge.log"))
        self.smile(*TOWERS, "--jobs", "2", "--out", "whole")
        self.assert_same_bytes("whole", "towers")

    def wait_for_shards(self, *numbers):
        for number in numbers:
            begun = self.work / f"towers.slurm/shard-{number}-of-{SHARDS}/generation.json"
            wait_until(begun.exists, f"shard {number} has not begun")

    def test_an_evaluation_is_divided_too(self):
        (self.work / "idle.py").write_text("def step(sensor, motor, aux):\n  aux.exit = 1\n")
        with Cluster(self.make_folder("cluster")) as slurm:
            _, merge = self.submit(slurm, "evaluate", "shown", "--scene", PROJECT / "scenes/tower_robot.xml",
                                   "--brain", "idle.py", "--scenes", "3", "--slurm=2", "--jobs=2", "--out=idle/")
            wait_until(lambda: not slurm.states(merge), "the merge does not end")
        self.assertTrue((self.work / "idle/evaluation.json").exists(), self.log("idle.slurm/merge.log"))
        self.assertIn("idle failed: 3 x never_taken", self.log("idle.slurm/merge.log"))


if __name__ == "__main__":
    result = unittest.main(argv=["slurm_test"], exit=False).result
    # Skipped in part is skipped.
    sys.exit(1 if not result.wasSuccessful() else 77 if result.skipped else 0)
