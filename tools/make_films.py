#!/usr/bin/env python3
"""Makes the films of docs/scenes.md again: runs the robot programs, renders each run, and writes animated WebP.

Needs ./run once, or SMILE=path/to/smile, and Pillow (Debian: python3-pil). The same program makes the same runs.

    tools/make_films.py [FILM...]
"""
import os
import pathlib
import subprocess
import sys
import tempfile

from PIL import Image

PROJECT = pathlib.Path(__file__).resolve().parent.parent
PROGRAM = os.environ.get("SMILE", PROJECT / "build/release/bin/smile")
FILMS = PROJECT / "docs/images/films"
SIZE, RATE = "320x240", 10  # [px], frames per second
MOST_KB = 250  # of a film
QUALITIES = range(70, 10, -10)  # tried in this order until the film is small enough

RUNS = {
    "drive": ["scenes/drive_robot.xml", "--brain", "python/examples/drive/drive.py"],
    "scissors": ["scenes/scissors_robot.xml", "--brain", "python/examples/scissors/scissors.py"],
    "cover": ["scenes/cover_robot.xml", "--brain", "python/examples/cover/cover.py"],
    "desk": ["scenes/desk.xml", "--robot", "tern", "--brain", "python/examples/desk/desk.py"],
}
# film: run, camera, seconds of the run, times real time
CUTS = {
    "drive": ("drive", "8,0.5,9:0.6,-2.8,0.7:38", 0, 43.4, 5),
    "scissors": ("scissors", "close", 2, 20, 3),
    "cover_screw": ("cover", "-5.5,2.2,5.5:-0.5,-2.4,1.9:40", 3, 24, 3),
    "cover_fuse": ("cover", "close", 82, 130, 6),
    "desk_drawer": ("desk", "-9,-5,5:-3,-2.3,0.7:34", 0, 9.5, 2),
    "desk_dial": ("desk", "8,-8,5:3.2,-3.4,0.6:30", 9.5, 20, 2),
    "desk_door": ("desk", "9,-4,5:2.4,-0.9,1:32", 20, 30, 2),
    "desk_lid": ("desk", "-5,5,5:-0.9,-0.6,1.3:30", 30, 39.9, 2),
}


def run(*arguments):
    subprocess.run([PROGRAM, *map(str, arguments)], cwd=PROJECT, check=True,
                   stdout=subprocess.DEVNULL)


def film(recording, name, scratch):
    """Writes a film; returns its size [kB], number of frames, and quality."""
    _, camera, begin, end, speed = CUTS[name]
    frames = scratch / f"{name}-frames"
    run("render", recording, "--out", f"{frames}/", "--camera", camera, "--size", SIZE, "--rate",
        RATE, "--speed", speed, "--from", begin, "--to", end)
    pictures = [Image.open(path).convert("RGB") for path in sorted(frames.glob("*.png"))]
    times = [1000 // RATE] * len(pictures)
    times[-1] = 1500  # a pause before it begins again [ms]
    out = FILMS / f"{name}.webp"
    for quality in QUALITIES:
        pictures[0].save(out, save_all=True, append_images=pictures[1:], duration=times, loop=0,
                         quality=quality, method=6)
        if out.stat().st_size <= MOST_KB * 1024:
            break
    else:
        sys.exit(f"{out}: {out.stat().st_size} bytes, expected {MOST_KB} kB at most")
    return out.stat().st_size / 1024, len(pictures), quality


def main():
    names = sys.argv[1:] or list(CUTS)
    FILMS.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        scratch = pathlib.Path(folder)
        for name in names:
            task = CUTS[name][0]
            if not (scratch / task).exists():
                run("run", *RUNS[task], "--record", scratch / task, "--no-pictures")
            kilobytes, count, quality = film(scratch / task, name, scratch)
            print(f"{name}: {count} frames, {kilobytes:.0f} kB, quality {quality}")


if __name__ == "__main__":
    main()
