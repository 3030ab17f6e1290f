"""Trains policies on robot demonstrations that `smile generate` makes of one demonstration by hand.

    tools/get_training_packages.sh
    build/training/bin/python examples/policy/train.py OUT

Behavior cloning with action chunks: networks look at the poses of all objects and of the tools, and say to what an
arm moves, and where its tool should be in the next second, in steps of .1 s. They are trained on growing numbers of
demonstrations, and compared with the learner, which made them, and with a replay of the demonstrated motions, in
layouts that none has seen. With --pictures, further policies are told no poses: two more networks see them in pictures
of the robot's eye. Writes into the folder OUT, where the same command continues: the demonstration `shown`, the
generated demonstrations `made`, the datasets `data` and `pictures`, of each policy weights and program, the
evaluation `compared`, curve.csv and curve.svg. docs/policy.md shows the result.

Action chunks: T. Zhao et al., "Learning Fine-Grained Bimanual Manipulation with Low-Cost Hardware" (2023).
"""

import argparse
import hashlib
import json
import os
import subprocess
import sys
import time
from pathlib import Path

import numpy as np

import alike
import cloning
import curve
import demonstrations
import network
import pictures
import sight

FOLDER = Path(__file__).resolve().parent
PROJECT = FOLDER.parents[1]
STEPS = 6000               # of training
TEST_SEED = 500_001        # of the layouts in which policies are evaluated; demonstrations begin at 1
ORACLE = ("--oracle", "--size", "64x48")
PARTS = ("policy", "deciding", "network", "eye", "sight", "alike")  # of the brain
PICTURE = f"{sight.SIZE[1]}x{sight.SIZE[0]}"


def smile(options, *arguments):
    """Runs the program. It exports with this Python, and runs brains with the system's."""
    environment = os.environ | ({"SMILE_PYTHON": sys.executable} if arguments[0] == "export" else {})
    subprocess.run([options.smile, *map(str, arguments)], check=True, stdout=subprocess.DEVNULL, env=environment)


def scene_of(options):
    """Where the robot does the task."""
    return PROJECT / f"scenes/{options.task}_robot.xml"


def make_data(options):
    """Demonstrates and generates what is not there yet. Returns the generated demonstrations."""
    shown, made = options.out / "shown", options.out / "made"
    if not shown.exists():
        smile(options, "run", PROJECT / f"scenes/{options.task}.xml", "--kinematic", "--commands",
              PROJECT / f"examples/{options.task}.jsonl", "--record", shown)
    smile(options, "generate", shown, "--scene", scene_of(options), *ORACLE, "--brain",
          PROJECT / "python/examples/agents/true_poses.py", "--count", max(options.counts), "--jobs", options.jobs,
          "--out", made)
    return made


def export(options, made, name, camera, fps):
    """Exports what is not there yet. Returns the dataset."""
    data = options.out / name
    if not data.exists():
        smile(options, "export", made, "--to", "robomimic", "--camera", camera, "--fps", fps, "--no-extras",
              "--out", data)
    return data / "demo.hdf5"


def write_policy(path, nets, **known):
    """Weights, what else it knows, and a program that acts with them."""
    arrays = {f"{net}_{kind}{k}": np.asarray(it) for net, layers in nets.items() for k, both in enumerate(layers)
              for kind, it in zip(("weights", "biases"), both)}
    np.savez(path.with_suffix(".npz"), nets=list(nets), **known, **arrays)
    used = (path.with_suffix(".npz"), *(FOLDER / f"{name}.py" for name in PARTS))
    identity = hashlib.sha256(b"".join(it.read_bytes() for it in used)).hexdigest()
    path.with_suffix(".py").write_text(
        # `evaluate` keeps the finished runs of a program that has not changed.
        f"# With {identity}\nimport sys\n\nsys.path.append({str(FOLDER)!r})\nfrom policy import Policy\n\n"
        f"init, step = Policy({str(path.with_suffix('.npz').resolve())!r}).functions()\n")


def evaluate(options, policies):
    """Returns the summary of each brain, by its name."""
    brains = [*policies, PROJECT / "python/learner/learner.py", PROJECT / "python/examples/agents/replay.py"]
    smile(options, "evaluate", options.out / "shown", "--scene", scene_of(options),
          "--oracle", "--size", PICTURE, "--scenes", options.layouts, "--seed", TEST_SEED,
          "--seconds", options.seconds, "--jobs", options.jobs, "--out", options.out / "compared",
          *(part for brain in brains for part in ("--brain", brain)))
    found = json.loads((options.out / "compared/evaluation.json").read_text())["brains"]
    return {one["name"]: one["summary"] for one in found}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=Path)
    parser.add_argument("--task", choices=("tower", "row"), default="tower")
    parser.add_argument("--counts", type=int, nargs="+", default=[50, 200, 1000], help="of demonstrations")
    parser.add_argument("--pictures", action="store_true", help="train policies that see pictures, too")
    parser.add_argument("--steps", type=int, default=STEPS, help="of training, of each policy")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--layouts", type=int, default=40)
    parser.add_argument("--seconds", type=int, default=60, help="limit of a run")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--smile", type=Path, default=PROJECT / "build/release/bin/smile")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)

    made = make_data(options)
    episodes, names, start = demonstrations.read(export(options, made, "data", "none", 60 // network.STEP_TICKS))
    looks = alike.looks_of(scene_of(options), names)
    views = []
    if options.pictures:
        seen = export(options, made, "pictures", f"eye:{PICTURE}", 1)
        views = pictures.read(seen, max(options.counts), looks)
    policies = []
    for count in options.counts:
        begun = time.monotonic(), time.process_time()
        samples = demonstrations.Samples(*(np.concatenate(parts) for parts in zip(*episodes[:count])))
        nets, sites = cloning.train(samples, looks, options.steps, options.seed)
        known = {"names": names, "looks": looks, "sites": sites, "start": start}
        policies.append(options.out / f"state_{count}.py")
        write_policy(policies[-1], nets, **known)
        print(f"{count} demonstrations, {len(samples.own)} samples: {time.monotonic() - begun[0]:.0f} s, "
              f"{time.process_time() - begun[1]:.0f} s of CPU time", flush=True)
        if options.pictures:
            nets |= pictures.train_sight(views[:count], options.steps / STEPS, options.seed)
            policies.append(options.out / f"pictures_{count}.py")
            write_policy(policies[-1], nets, **known)
            print(f"with the networks that see: {time.monotonic() - begun[0]:.0f} s, "
                  f"{time.process_time() - begun[1]:.0f} s of CPU time", flush=True)
    summaries = evaluate(options, policies)
    curve.write(options.out, summaries)
    for name, each in summaries.items():
        low, high = each["success_interval"]
        print(f"{name}: {each['successes']} of {each['runs']}, 95 %: {100 * low:.1f} to {100 * high:.1f} %")


if __name__ == "__main__":
    main()
