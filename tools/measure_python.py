#!/usr/bin/env python3
"""Measures the simulator in Python, beside MuJoCo's own Python package in the same scenes.

    PYTHONPATH=python:build/release/python build/peers/bin/python tools/measure_python.py [--rounds N]

build/peers is the environment of tools/measure_performance.py, which installs MuJoCo there. Prints a table in
Markdown: CPU time, the shortest of N (7) short rounds, which other programs disturb least; `chrt -f 10` before it
keeps them away. docs/performance.md has the results.

The scene: 12 cubes of 10 cm fall from 30 cm on the table, and are awake all the while; with a robot, the scene
UM beside Baxter, whose joints move. A tick is 1/60 s: 8 steps of ours, 8 of MuJoCo's at the same 480 Hz.
"""

import argparse
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

os.environ.setdefault("MUJOCO_GL", "egl")
ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tools"))

import numpy as np  # noqa: E402
from performance.peer import MuJoCo  # noqa: E402

import smile  # noqa: E402

TICKS = 40                # of the fall that are measured
SIZE = (200, 150)
STEPS_A_TICK = 8
CUBES = [{"position": [0.15 * (i % 4) - 0.225, 0.15 * (i // 4) - 0.15, 0.35], "size": [0.1] * 3, "mass": 1.0}
         for i in range(12)]
TABLE = {"position": [0, 0, -0.2], "size": [2.0, 1.2, 0.4]}


def shortest(rounds, prepare, work):
    """CPU time of work(), the shortest of all rounds [us]."""
    best = np.inf
    for _ in range(rounds):
        prepare()
        start = time.process_time_ns()
        work()
        best = min(best, time.process_time_ns() - start)
    return best / 1000


def falling_cubes(folder):
    xml = "".join(f'<block id="B{i}" location="({10 * x},{10 * y},{10 * z})" xspan="1" yspan="1" zspan="1" color="red"/>'
                  for i, (x, y, z) in enumerate(one["position"] for one in CUBES))
    path = Path(folder) / "cubes.xml"
    path.write_text(f'<tabletop xmlns="http://synapse.cs.umd.edu/tabletop-xml" xspan="20" yspan="12">{xml}</tabletop>')
    return smile.Simulation(smile.load(path, robot=None))


def moving_robot():
    sim = smile.Simulation(smile.load(ROOT / "scenes/um.xml"))
    for arm in sim.robot.arms.values():
        arm.move(velocities=np.full(len(arm.q), 0.05))
    return sim


def step_times(sim, rounds, ticks=TICKS):
    """CPU time of a tick when Python asks for each, and when C++ does all of them [us]."""
    start = sim.save()

    def one_by_one():
        for _ in range(ticks):
            sim.step(1)

    # In turns, so that both meet the same disturbances.
    each, together = np.inf, np.inf
    for _ in range(rounds):
        each = min(each, shortest(1, lambda: sim.restore(start), one_by_one))
        together = min(together, shortest(1, lambda: sim.restore(start), lambda: sim.step(ticks)))
    return each / ticks, together / ticks


def mujoco_cubes():
    return MuJoCo({"simulator": "mujoco", "rate": 60 * STEPS_A_TICK, "may_sleep": False, "blocks": CUBES, "table": TABLE,
                   "robot": None})


def state_times(sim, peer, rounds):
    """CPU time of saving and restoring after a tick [us]: ours, MuJoCo's."""
    import mujoco
    start = sim.save()
    ours = np.inf
    for _ in range(rounds * 10):
        sim.restore(start)
        sim.step(3)
        begin = time.process_time_ns()
        sim.restore(sim.save())
        ours = min(ours, time.process_time_ns() - begin)
    kind = mujoco.mjtState.mjSTATE_INTEGRATION
    state = np.empty(mujoco.mj_stateSize(peer.model, kind))
    theirs = np.inf
    for _ in range(rounds * 10):
        peer.step(STEPS_A_TICK)
        begin = time.process_time_ns()
        mujoco.mj_getState(peer.model, peer.data, state, kind)
        mujoco.mj_setState(peer.model, peer.data, state, kind)
        theirs = min(theirs, time.process_time_ns() - begin)
    return ours / 1000, theirs / 1000


def picture_time(sim, rounds, camera="eye"):
    """CPU time of a picture in colors as an array [us]."""
    sim.render(camera, SIZE)
    return shortest(rounds * 5, lambda: None, lambda: sim.render(camera, SIZE))


def mujoco_picture_time(peer, rounds):
    import mujoco
    renderer = mujoco.Renderer(peer.model, SIZE[1], SIZE[0])

    def draw():
        renderer.update_scene(peer.data)
        renderer.render()

    draw()
    return shortest(rounds * 5, lambda: None, draw)


def import_time(module, rounds):
    """CPU time of an import, without that of numpy [s]."""
    program = f"import numpy, time; t = time.process_time(); {module}; print(time.process_time() - t)"
    return min(float(subprocess.run([sys.executable, "-c", program], check=True, capture_output=True, text=True).stdout)
               for _ in range(rounds))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=7)
    rounds = parser.parse_args().rounds
    with tempfile.TemporaryDirectory() as folder:
        cubes, peer = falling_cubes(folder), mujoco_cubes()
        import mujoco
        start = (peer.data.qpos.copy(), peer.data.qvel.copy())

        def again():
            peer.data.qpos[:], peer.data.qvel[:] = start

        def fall():
            for _ in range(TICKS):
                peer.step(STEPS_A_TICK)

        each, together = step_times(cubes, rounds)
        theirs = shortest(rounds, again, fall) / TICKS
        tick = 1e6 / 60
        rows = [("tick, 12 cubes fall, from Python", f"{each:.0f} µs, {tick / each:.0f} x real time",
                 f"{theirs:.0f} µs, {tick / theirs:.0f} x real time"),
                ("the same, all ticks in one call", f"{together:.0f} µs ({each / together - 1:+.1%} from Python)", "")]
        robot = moving_robot()
        each, together = step_times(robot, rounds)
        rows.append(("tick, a moving robot, from Python", f"{each:.0f} µs", ""))
        rows.append(("the same, all ticks in one call", f"{together:.0f} µs ({each / together - 1:+.1%} from Python)", ""))
        ours, theirs = state_times(cubes, peer, rounds)
        rows.append(("save and restore, 12 cubes in motion", f"{ours:.1f} µs", f"{theirs:.1f} µs"))
        ours, _ = state_times(robot, peer, rounds)
        rows.append(("save and restore, UM with a moving robot", f"{ours:.1f} µs", ""))
        rows.append(("picture 200x150, 12 cubes", f"{picture_time(cubes, rounds) / 1000:.2f} ms",
                     f"{mujoco_picture_time(peer, rounds) / 1000:.2f} ms"))
        rows.append(("picture 200x150, UM with robot", f"{picture_time(robot, rounds) / 1000:.2f} ms", ""))
        rows.append(("import, beside numpy", f"{import_time('import smile; smile.Simulation', 3):.2f} s",
                     f"{import_time('import mujoco', 3):.2f} s"))
    print(f"| CPU time | SMILE | MuJoCo {mujoco.__version__} |\n|---|---|---|")
    for row in rows:
        print(f"| {' | '.join(row)} |")


if __name__ == "__main__":
    main()
