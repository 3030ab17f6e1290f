"""The learner chooses the same actions in Python and in Octave: from the same demonstration and the
same picture of a scene, both find the same facts, infer the same steps, detect the same blocks, choose
the same site and plan the same actions, also with switches and tools, and from pictures alone.

    decisions_test.py SMILE SOURCE OCTAVE...

SMILE is the program, SOURCE the folder of the project, OCTAVE the command that runs decisions.m, with
the same inputs.
"""

import json
import math
import os
import subprocess
import sys
import tempfile
from pathlib import Path
from types import SimpleNamespace

import numpy as np
from PIL import Image

from act.grippers import arms_for
from act.robot_arms import arms_of
from check.task_state import TaskState
from explain.demonstration import has_texts, read_demonstration
from explain.devices import infer_devices
from explain.drives import Drive
from explain.explanation import explain
from explain.sentences import page_of
from explain.task_model import infer_task
from explain.uses import Use
from explain.watching import watch_demonstration
from plan.task_planning import choose_actions

# For each robot: task, the layout of the robot's scene, [] to keep the scene as it is, and the light in it, if that is another
# than in the demonstration. After a slash, the demonstrator in the pictures of a recording without texts.
CASES = {
    "baxter": [("tower", ["--seed", "4", "--level", "stacked"]), ("row", ["--seed", "1"]), ("bridge", ["--seed", "3"]),
               ("box", ["--seed", "1"]), ("hatch", []), ("pyramid", []), ("bricks", []),
               ("swap", ["--seed", "1", "--level", "fixtures"]),
               ("beside", ["--seed", "1", "--level", "fixtures"]),
               ("hanoi", ["--seed", "1", "--level", "fixtures"]), ("ball", ["--seed", "1"]), ("plank", ["--seed", "4"]),
               ("drive", ["--seed", "3", "--level", "fixtures"], 'brightness="0.8" color="#fff0d8"'),
               ("scissors", ["--seed", "1004", "--level", "fixtures"]), ("cover", ["--seed", "1", "--level", "fixtures"]),
               ("tower", ["--seed", "2", "--level", "distractors"], 'brightness="0.75"'),
               ("um", ["--seed", "3", "--level", "mixed"], 'brightness="0.8" color="#ffd8b0"'),
               ("lid", ["--seed", "1", "--level", "piles"], 'brightness="0.8"'),
               ("tower/ghost", ["--seed", "1"]), ("swap/forearm", ["--seed", "1", "--level", "fixtures"])],
    "tern": [("tower", ["--seed", "1", "--robot", "tern"])],
}
TOLERANCE = 1e-6  # of units and radians
# Of the tool's pose at the end of a path: the residual of inverse kinematics. Joints may differ
# more, where rounding decides which of many solutions is found.
TOOL_TOLERANCE = 1e-3
# What a brain knows of each robot, at a table 12 units deep: pose of its base, and its arms.
ROBOTS = {
    "baxter": {"robotBase": [[0, -1, 0, 0], [1, 0, 0, -8], [0, 0, 1, 2], [0, 0, 0, 1.0]],
               "arms": [{"name": name, "joints": [0] * 7, "gripper": [0, 2]}
                        for name in ("left", "right")]},
    "tern": {"robotBase": [[0, -1, 0, 0], [1, 0, 0, -5], [0, 0, 1, 0], [0, 0, 0, 1.0]],
             "arms": [{"name": "arm", "joints": [0] * 6, "gripper": [0, 1.3]}]},
}


def main(smile, source, *octave):
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        found, expected = [], []
        for robot, cases in CASES.items():
            aux = {"robot": f"{source}/robots/{robot}.urdf", "unit": 0.1, **ROBOTS[robot]}
            Path(f"{robot}.json").write_text(json.dumps(aux))
            folders = [prepare(smile, source, f"{robot}{k}", *case)
                       for k, case in enumerate(cases)]
            expected += subprocess.run([*octave, f"{robot}.json", *folders], check=True,
                                       stdout=subprocess.PIPE, text=True).stdout.splitlines()
            found += [line for folder in folders for line in decisions(folder, aux)]
    case = ""
    wrong = len(found) != len(expected)
    for one, other in zip(found, expected):
        case = one if one.startswith("case") else case
        if not agree(one, other):
            print(f"{case}: in Python {one}\n{' ' * len(case)}  in Octave {other}")
            wrong = True
    assert sum(line.startswith("action") for line in found) > 50
    sys.exit(wrong)


def prepare(smile, source, name, task, layout, light=None):
    """Records the demonstration of the task, unless an earlier case did, and takes a picture of the
    scene. Returns the folder of both."""
    case = Path(name)
    case.mkdir()
    task, _, demonstrator = task.partition("/")
    robot = layout[layout.index("--robot"):] if "--robot" in layout else []
    scene = f"{source}/scenes/{task}_robot.xml"
    shown = Path(f"shown_{task}")
    if not shown.exists():
        subprocess.run([smile, "run", f"{source}/scenes/{task}.xml", "--kinematic", "--commands",
                        f"{source}/examples/{task}.jsonl", "--record", shown], check=True,
                       stdout=subprocess.DEVNULL)
    if demonstrator:
        subprocess.run([smile, "rerender", shown, "--demonstrator", demonstrator, "--no-symbols", "--out",
                        case / "shown"], check=True, stdout=subprocess.DEVNULL)
    else:
        (case / "shown").symlink_to(shown.resolve())
    if layout:
        subprocess.run([smile, "layout", scene, *layout, "--out", case / "scene.xml"], check=True,
                       stdout=subprocess.DEVNULL)
        scene = case / "scene.xml"
    if light:
        scene.write_text(scene.read_text().replace("</tabletop>", f"<lighting {light}/></tabletop>"))
    subprocess.run([smile, "run", scene, "--brain", f"{source}/tests/learner/look.py",
                    "--timeout", "60", *robot],
                   check=True, stdout=subprocess.DEVNULL,
                   env=os.environ | {"LOOK": str(case.resolve())})
    print(f"{case}: {task} {demonstrator} {' '.join(layout)} {light or ''}")
    return str(case)


def decisions(case, aux):
    """Returns the results of the learner for a case: lines of words and numbers.

    aux: what the brain knows of the robot
    """
    shown = f"{case}/shown"
    demo = read_demonstration(shown) if has_texts(shown) else watch_demonstration(shown)
    steps, containers = infer_task(demo, {})
    presses = infer_devices(demo, steps)
    building = TaskState(steps, containers, presses=presses, shown=demo.eye)
    explanation = explain(demo, containers)
    lines = [f"case {case}"]
    for keyframe in explanation.keyframes:
        lines.append(" ".join(f"deed {keyframe.deed} {keyframe.is_means:d}".split()))
        lines += [f"fact {it}" for it in keyframe.facts]
    lines += [f"goal {it}" for it in explanation.goal]
    lines += page_of(explanation)
    for step in steps:
        if step.aside:
            row, column = np.nonzero(step.aside.changed)
            lines.append(fact("aside", *step.aside.place.position, step.aside.place.yaw, step.aside.height, len(row),
                              row.sum(), column.sum()))
        lines += [fact("step", step.name, step.form, *step.color, *step.size, *step.position, step.yaw,
                       *step.on, step.has_knob, step.begins_there, *step.after),
                  fact("begin", step.takes_place_of, *step.start if step.start is not None else [],
                       *step.start_size if step.start_size is not None else [])]
        lines += [fact("part", *it.color, *it.size, *it.position, it.yaw) for it in step.parts]
    for press in presses:
        row, column = np.nonzero(press.changed)
        way = [*press.pose, *press.begin] if isinstance(press, Use) else []
        if isinstance(press, Drive):
            way = [press.height, *(number for it in press.turns for number in (*it.place, it.number, it.is_loosening))]
        lines.append(fact(str(press), *press.after, len(row), row.sum(), column.sum(), *way))
    picture = np.asarray(Image.open(f"{case}/look.png").convert("RGB"))
    arms = arms_of(SimpleNamespace(**aux | {
        "arms": [SimpleNamespace(**arm) for arm in aux["arms"]],
        "cameraIntrinsics": demo.eye.intrinsics, "cameraPose": demo.eye.pose, "tableSize": demo.eye.table, "cameraNames": []}))
    lines += [fact("arm", arm.name, *arm.parked, arm.reach, *arm.foot) for arm in arms]
    depth = np.fromfile(f"{case}/look.depth").reshape(picture.shape[:2])
    sensor = SimpleNamespace(rgbVision=picture, depthVision=depth,
                             arms=[SimpleNamespace(joints=arm.parked) for arm in arms])
    # Where something may swing, it looks again and again until it hangs still.
    actions = []
    while not building.has_site and not building.claim:
        actions = choose_actions(building, sensor, demo.eye, arms_for(steps, arms))
    known = sorted(([*it.position, *it.color, *it.size, it.yaw] for it in building.known),
                   key=lambda row: [round(number, 4) for number in row[:3]])
    lines += [fact("known", *row) for row in known]
    lines.append(fact("unexplained", len(building.unexplained), *building.unexplained.sum(axis=0)))
    lines += [fact("site", *step.position, step.yaw) for step in building.steps]
    lines += [fact("aligned", control, math.cos(it.angle), math.sin(it.angle), *it.place)
              for control, it in building.alignments.items()]
    lines += [f"note {it}" for it in building.notes]
    if building.claim:
        lines.append(fact("claim", building.claim.reason))
    for action in actions:
        arm = [action.arm.name] if action.arm else []
        lines.append(fact("action", action.kind, *arm, action.to, action.width))
        if action.kind in ("follow", "lift", "press"):
            tool = action.arm.forward(action.path.positions[-1])
            lines.append(fact("tool", *tool[:3, 3], *tool[:3, 1]))
    return lines


def fact(*words):
    return " ".join(word if isinstance(word, str) else f"{word:.9f}" for word in words)


def agree(found, expected):
    words, others = found.split(), expected.split()
    tolerance = TOOL_TOLERANCE if words[0] == "tool" else TOLERANCE
    return len(words) == len(others) and all(
        is_same(*pair, tolerance) for pair in zip(words, others))


def is_same(word, other, tolerance):
    try:
        return abs(float(word) - float(other)) <= tolerance
    except ValueError:
        return word == other


main(*sys.argv[1:])
