"""Tests the examples that train policies, for a few steps, in the environment of tools/get_training_packages.sh.

Usage: training_test.py PROJECT_FOLDER. Ends with 77 without that environment.
"""

import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROJECT = Path(sys.argv[1])
PYTHON = PROJECT / "build/training/bin/python"
if not PYTHON.exists():
    print("skipped: there is no build/training, see tools/get_training_packages.sh")
    sys.exit(77)


def train(out, *options):
    done = subprocess.run([PYTHON, PROJECT / "examples/push/train.py", out, "--steps", "4096", "--layouts", "2", *options],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0:
        raise AssertionError(done.stdout)
    return done.stdout


class TrainingTest(unittest.TestCase):
    def test_learns_the_same_with_any_number_of_threads(self):
        with tempfile.TemporaryDirectory() as folder:
            outs = [Path(folder) / name for name in ("one", "two", "other")]
            said = train(outs[0], "--threads", "1")
            self.assertRegex(said, r"4096 steps in \d+ s, \d+ s of CPU time; success in \d+% of 2 new layouts")
            train(outs[1], "--threads", "2")
            train(outs[2], "--seed", "2")
            policies = [(out / "policy.npz").read_bytes() for out in outs]
            self.assertEqual(policies[0], policies[1])
            self.assertNotEqual(policies[0], policies[2])
            curve = (outs[0] / "curve.csv").read_text().split()
            self.assertEqual((curve[0], len(curve)), ("steps,seconds,success", 3))
            self.assertIn(">4,096</text>", (outs[0] / "curve.svg").read_text())

    def test_policies_of_generated_demonstrations_are_compared(self):
        with tempfile.TemporaryDirectory() as folder:
            out = Path(folder) / "out"
            command = [PYTHON, PROJECT / "examples/policy/train.py", out, "--counts", "1", "2", "--steps", "40",
                       "--pictures", "--layouts", "1", "--seconds", "40", "--smile", os.environ["SMILE"]]
            done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            self.assertEqual(done.returncode, 0, done.stdout)
            self.assertRegex(done.stdout, r"2 demonstrations, \d+ samples: \d+ s, \d+ s of CPU time")
            rows = [line.split(",") for line in (out / "curve.csv").read_text().split()]
            self.assertEqual([row[0] for row in rows],
                             ["brain", "state_1", "pictures_1", "state_2", "pictures_2", "learner", "replay"])
            self.assertEqual(rows[5][1:3], ["1", "1"])
            self.assertIn(">from pictures</text>", (out / "curve.svg").read_text())
            brains = json.loads((out / "compared/evaluation.json").read_text())["brains"]
            self.assertLessEqual({cause for brain in brains[:4] for cause in brain["summary"]["causes"]},
                                 {"time_up", "never_taken", "not_placed", "misplaced", "toppled", "fell_off_table"})


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
