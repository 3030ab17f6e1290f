"""Draws the figures of docs/learner.md: each part of the learner at work on one task, `swap`.

Usage: make.py SMILE FOLDER
"""

import contextlib
import io
import subprocess
import sys
import tempfile
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
sys.path.append(str(PROJECT / "python/learner"))

from explain.demonstration import read_demonstration
from explain.explanation import explain
from explain.task_model import infer_task
from perception import draw_see, draw_watch
from run import record, run
from task import draw_explain, draw_relate
from work import draw_act, draw_check, draw_match, draw_plan

TASK, SEED, LEVEL = "swap", 3, "fixtures"


def draw_all(program, out):
    """Draws all figures into a folder. Returns their files."""
    with tempfile.TemporaryDirectory() as name, contextlib.redirect_stdout(io.StringIO()):
        folder = Path(name)
        shown = record(program, PROJECT, TASK, folder / "shown")
        watched = folder / "watched"
        subprocess.run([program, "rerender", shown, "--demonstrator", "forearm", "--no-symbols", "--out", watched],
                       check=True, stdout=subprocess.DEVNULL)
        demo = read_demonstration(shown)
        explanation = explain(demo, infer_task(demo, {})[1])
        did = run(program, PROJECT, TASK, shown, SEED, LEVEL, folder)
        figures = {"see": draw_see(did), "watch": draw_watch(watched), "relate": draw_relate(demo, explanation),
                   "explain": draw_explain(demo, explanation), "match": draw_match(did), "plan": draw_plan(did),
                   "act": draw_act(did), "check": draw_check(did)}
    out.mkdir(parents=True, exist_ok=True)
    for part, drawing in figures.items():
        drawing.save(out / f"{part}.svg")
    return [out / f"{part}.svg" for part in figures]


if __name__ == "__main__":
    for file in draw_all(sys.argv[1], Path(sys.argv[2])):
        print(file)
