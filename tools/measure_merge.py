#!/usr/bin/env python3
"""Measures how long joining datasets takes, and its memory: of synthetic episodes, as a robot with two arms makes.

Usage: PYTHONPATH=python:build/release/python:build/dataset_readers tools/measure_merge.py [EPISODES [FRAMES [FORMAT]]]
"""

import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

from smile.datasets import exporting, merge
from smile.datasets.episode import Column
from smile.datasets.lerobot import write_json

PARTS, FPS = 10, 30
# Dimensions of towers: 17 channels, 2 tools, 8 objects.
WIDTHS = {"observation.state": 17, "action": 17, "sim.tool_poses": 14, "sim.object_poses": 56,
          "sim.object_exists": 8, "sim.object_held": 8}


def columns_of(episode, frames):
    random = np.random.default_rng(episode)
    columns = {name: Column(np.cumsum(random.normal(size=(frames, width)), axis=0).astype(np.float32),
                            [f"arm.{i}" for i in range(width)]) for name, width in WIDTHS.items()}
    columns["sim.tick"] = Column(2 * np.arange(frames), None)
    done = np.zeros(frames, bool)
    done[-1] = True
    return {**columns, "next.done": Column(done, None), "next.success": Column(done, None)}


def write_part(folder, format, first, episodes, frames):
    folder.mkdir(parents=True)
    writer = exporting._writer_of(format)(folder, FPS, [], columns_of(0, frames), "synthetic")
    for episode in range(first, first + episodes):
        more = {"smile/recording_sha256": f"{episode:064x}", "smile/seed": episode, "smile/success": True,
                "sparse_subtask_names": ["take a", "place a"], "sparse_subtask_start_frames": [0, frames // 2],
                "sparse_subtask_end_frames": [frames // 2, frames]}
        writer.add(columns_of(episode, frames), "build a tower", {}, {}, more)
    writer.finish()
    about = {"format": 1, "action": "joint_position", "intrinsics": {}, "constant": {}, "dropped": [], "pixels": {}}
    write_json(folder / ("meta/smile.json" if format.startswith("lerobot") else "smile.json"), about)


def main(episodes=10_000, frames=100, format="lerobot-v3.0"):
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        for part in range(PARTS):
            write_part(folder / f"part-{part}", format, part * episodes // PARTS, episodes // PARTS, frames)
        megabytes = sum(path.stat().st_size for path in folder.rglob("*") if path.is_file()) / 1e6
        # In a process of its own: its peak of memory.
        subprocess.run([sys.executable, __file__, "merge", folder], check=True)
        print(f"{episodes} episodes of {frames} frames, {format}, {megabytes:.0f} MB")


def measure(folder):
    begin = time.monotonic()
    merge(sorted(folder.glob("part-*")), folder / "whole")
    usage = resource.getrusage(resource.RUSAGE_SELF)
    print(f"{time.monotonic() - begin:.1f} s, of which {usage.ru_utime + usage.ru_stime:.1f} s of computing, "
          f"{usage.ru_maxrss / 1000:.0f} MB at most")


if __name__ == "__main__":
    if sys.argv[1:2] == ["merge"]:
        measure(Path(sys.argv[2]))
    else:
        main(*(int(word) if word.isdigit() else word for word in sys.argv[1:]))
