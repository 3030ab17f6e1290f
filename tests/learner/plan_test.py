"""A plan (aux.plan) changes what both twins of the learner want to do, in the same way; and what an analysis says is
redundant or free, they leave out and do in another order.

    plan_test.py SMILE SOURCE

SMILE is the program, SOURCE the folder of the project.
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

LEARNERS = ("python/learner/learner.py", "matlab/learner")
# A tower of two; in between the red block is put elsewhere, though its place does not count.
ERRAND = """{{"hand":"left","do":"grasp","object":"{0}"}}
{{"hand":"left","do":"move_to","position":[{1},{2},3]}}
{{"do":"wait","until":"arrived"}}
{{"hand":"left","do":"move_to","position":[{1},{2},{3}]}}
{{"do":"wait","until":"arrived"}}
{{"hand":"left","do":"release"}}
{{"do":"wait","seconds":0.7}}
"""


def main(smile, source):
    with tempfile.TemporaryDirectory() as folder:
        check_what_does_not_count(smile, source, Path(folder))
        check_free_order(smile, source, Path(folder))


def check_what_does_not_count(smile, source, folder):
    script = folder / "errand.jsonl"
    script.write_text(ERRAND.format("GreenBlock", 0, -3, 0.51) + ERRAND.format("RedBlock", -4, -1.5, 0.51)
                      + ERRAND.format("BlueBlock", 0, -3, 1.51) + '{"do":"wait","seconds":1}\n')
    demo = record(smile, source, folder / "errand", "tower", script)
    all_of_it = analyzed(smile, demo, folder / "all")
    tower = analyzed(smile, demo, folder / "tower", "--ignore", "RedBlock")
    without, with_all, with_tower = (understood(smile, source, demo, "tower", plan)
                                     for plan in (None, all_of_it, tower))
    assert names_of(without) == ["GreenBlock", "RedBlock", "BlueBlock"], without
    assert with_all == without, "everything counts"
    assert names_of(with_tower) == ["GreenBlock", "BlueBlock"], with_tower


def check_free_order(smile, source, folder):
    demo = record(smile, source, folder / "drive", "drive", f"{source}/examples/drive.jsonl")
    plan = analyzed(smile, demo, folder / "plan")
    # That both twins understand this demonstration alike without a plan, decisions_test.py claims.
    without = understood(smile, source, demo, "drive", None, LEARNERS[:1])
    with_plan = understood(smile, source, demo, "drive", plan)
    assert without != with_plan, with_plan


def record(smile, source, demo, task, script):
    run([smile, "run", f"{source}/scenes/{task}.xml", "--kinematic", "--commands", script, "--record", demo])
    return demo


def analyzed(smile, demo, out, *options):
    run([smile, "analyze", demo, "--out", out, *options])
    return out / "analysis.json"


def understood(smile, source, demo, task, plan, learners=LEARNERS):
    """Returns what some learners, all alike, say is to be done: the lines `shown: ...` of their output."""
    found = []
    for learner in learners:
        out = demo.parent / "imitated"
        options = ["--plan", plan] if plan else []
        text = run([smile, "imitate", demo, f"{source}/scenes/{task}_robot.xml", "--brain", f"{source}/{learner}",
                    "--seconds", "0.02", "--no-pictures", "--timeout", "60", "--out", out, *options], expected=(0, 1))
        log = (out / "imitation/brain.log").read_text()
        found.append([line for line in log.splitlines() if line.startswith("shown: ")])
        assert found[-1], text
        subprocess.run(["rm", "-r", out], check=True)
    assert found[0] == found[-1], f"in Python {found[0]}, in Octave {found[-1]}"
    return found[0]


def names_of(lines):
    """Returns the names of the objects of steps: `shown: 1. GreenBlock (1 x 1 x 1) on the table`."""
    return [line.split()[2] for line in lines]


def run(command, expected=(0,)):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    assert done.returncode in expected, f"{command}: {done.stdout}"
    return done.stdout


main(*sys.argv[1:])
