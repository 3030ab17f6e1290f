"""The parts of docs/performance.md that consist of measured numbers, and its plots."""

import re

from performance.plots import number, plot

SIZES = (12, 50, 100, 200, 1000)
# What grows: the name of a benchmark, and what the page calls it.
TICKS = {
    "growth: all asleep, per tick": "tick, all at rest",
    "growth: one cube carried, the others asleep, per tick": "tick, one carried",
    "growth: one cube carried, the others asleep, per tick and hash": "tick and hash, one carried",
    "growth: one cube carried, the others asleep, per tick, rest test and view": "tick and view, one carried",
}
STATES = {
    "growth: hash, all asleep": "hash",
    "growth: rest test, all asleep": "rest test",
    "growth: view, all asleep": "view",
    "growth: save after a tick, one cube carried": "save after a tick, one carried",
    "growth: restore over a tick, one cube carried": "restore over a tick, one carried",
}
AWAKE = {
    "growth: single cubes awake, per step": "step, all awake, single",
    "growth: stacks of five awake, per step": "step, all awake, stacks of 5",
}
# What may stand around a carried cube, in the sizes that are measured.
SOME_SIZES = (12, 100, 400)
SOME = {
    "growth: one cube carried among boxes with lids asleep, per tick": "tick, one carried, among boxes with sliding lids",
    "growth: one cube carried among fixtures, per tick": "tick, one carried, among static cubes",
    "growth: grasp, three ticks and undo": "grasp, three ticks and undo, not recorded",
}
RECORDINGS = {
    "moving hand, recorded, per tick": "a hand carries a block without a pause",
    "replay of UM": "the demonstration `um`",
    "replay of UM with robot": "the same, with robot",
    "opening of eight hours": "eight hours, of which most are pauses",
}
STEP_US = 1e6 / 480
PLOTS = {
    "tick.svg": ("A tick of 1/60 s", TICKS, None),
    "state.svg": ("Questions and copies", STATES, None),
    "awake.svg": ("A physics step, nothing sleeps", AWAKE, ("real time", STEP_US)),
}
WORK = {
    "12 blocks asleep, per tick": "`um`, all asleep, tick and hash",
    "12 blocks awake, per step": "`um`, all awake, physics step (8 to a tick)",
    "12 blocks and a resting robot, per tick": "`um`, resting robot, tick",
    "12 blocks and a moving robot, per tick": "`um`, moving robot, tick",
    "12 blocks and a moving kinematic robot, per tick": "`um`, moving kinematic robot, tick",
    "awake: 20 rings, per step": "20 rings of 32 segments, awake, physics step",
    "awake: 20 rings fall on a heap, the first second/sides:32/iterations:1": "20 rings of 32 segments fall on a heap, the first second",
    "awake: 20 rings fall on a heap, the first second/sides:64/iterations:1": "the same with 64 segments",
    "moving hand, per tick": "`um`, hand carries a block, tick",
    "moving hand, recorded, per tick": "the same, recorded",
    "save after a tick, UM with robot, one block carried/manual_time": "save after a tick, `um` with robot, a block carried",
    "restore over a tick, UM with robot, one block carried/manual_time": "restore over a tick, the same",
    "undo among 50 blocks, recorded/manual_time": "undo among 50 blocks, recorded",
    "eye, UM/200/150/process_time": "picture 200x150, color, depth and ids",
    "eye, UM/640/480/process_time": "picture 640x480",
    "eye, UM/1280/800/process_time": "picture 1280x800",
    "eye, UM with robot/200/150/process_time": "picture 200x150 with robot",
    "eye, UM with robot/640/480/process_time": "picture 640x480 with robot",
    "eye, UM with robot/1280/800/process_time": "picture 1280x800 with robot",
    "brain round trip, C++/1/1/real_time": "round trip to a brain in C++",
    "brain round trip, Python/1/1/real_time": "round trip to a brain in Python",
    "brain round trip, Octave/1/1/real_time": "round trip to a brain in Octave",
}
PARALLEL = "parallel: two on two threads, "
OUR_PICTURES = "SMILE"
OURS, WITH_DEFAULTS = "SMILE, 480 Hz", ("MuJoCo, 500 Hz", "PyBullet, 240 Hz")


def duration(row):
    """A time with its unit."""
    us = row["us"]
    for factor, unit in ((1e6, "s"), (1e3, "ms"), (1, "µs"), (1e-3, "ns")):
        if us >= factor:
            return f"{number(us / factor)} {unit}"
    return f"{number(1e3 * us)} ns"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def of_size(data, name, size):
    of = f"{name}/cubes:{size}/gap_mm:30"
    return data["benchmarks"].get(of) or data["benchmarks"].get(of + "/manual_time")


def machine(data):
    of = data["machine"]
    return (f"Measured on {of['processor']} ({of['cores']} cores of a virtual machine that other programs used, too), with "
            f"{of['compiler']} on {of['system']}:\nCPU time, for undo, saves, restores and round trips wall-clock time; the shortest of several rounds.")


def growth(data):
    rows = [[label, *(number(of_size(data, name, size)["us"]) for size in SIZES)]
            for name, label in {**TICKS, **STATES, **AWAKE}.items()]
    return table(["µs", *(str(size) for size in SIZES)], rows)


def some(data):
    rows = [[label, *(number(of_size(data, name, size)["us"]) for size in SOME_SIZES)] for name, label in SOME.items()]
    return table(["µs", *(str(size) for size in SOME_SIZES)], rows)


def recordings(data):
    rows = []
    for name, label in RECORDINGS.items():
        row = data["benchmarks"][name]
        speed = f"{number(row['x_real_time'])} x" if "x_real_time" in row else ""
        rows.append([label, number(row["MB_per_hour"]), speed, duration(row) if "opening" in name else ""])
    return table(["recording", "MB an hour", "replay, times real time", "opening"], rows)


def imitations(data):
    rows = [[name, *(number(of[scene]) for scene in ("um", "tower"))] for name, of in data["imitations"].items()]
    return table(["CPU s", "`um`", "`tower`"], rows)


def work(data):
    return table(["", "time"], [[label, duration(data["benchmarks"][name])]
                                for name, label in WORK.items() if name in data["benchmarks"]])


def parallel(data):
    rows = [[name.removeprefix(PARALLEL).removesuffix("/manual_time"), f"{row['speed_up']:.2f}",
             f"{row['speed_up_by_cpu_time']:.2f}"]
            for name, row in data["benchmarks"].items() if name.startswith(PARALLEL)]
    return table(["two simulations on two threads", "speed-up", "by CPU time"], rows)


def quality(cell):
    if "joint_error_rad" in cell:
        return f"{number(cell['joint_error_rad'])} rad"
    sag, creep = (number(value) if value >= 1e-4 else "&lt;0.0001" for value in (cell["sag_mm"], cell["creep_mm"]))
    return f"{sag}, {creep}"


def peers(data):
    scenes = data["peers"]["scenes"]
    simulators = list(next(iter(scenes.values())))
    cells = [[name, *(f"{number(of[name]['cpu_ms_per_s'])} ({quality(of[name])})" for of in scenes.values())]
             for name in simulators]
    ratios = [[f"SMILE / {name.split(',')[0]}", *(f"{of[OURS]['cpu_ms_per_s'] / of[name]['cpu_ms_per_s']:.2g}"
                                                  for of in scenes.values())] for name in WITH_DEFAULTS]
    return table(["", *scenes], cells + ratios)


def pictures(data):
    views = data["pictures"]["views"]
    names = list(next(iter(views.values())))
    others = [name for name in names if name != OUR_PICTURES]
    cells = [[name, *(f"{number(of[name]['cpu_ms'])} ({number(of[name]['wall_ms'])})" for of in views.values())] for name in names]
    ratios = [f"{of[OUR_PICTURES]['cpu_ms'] / min(of[name]['cpu_ms'] for name in others):.2g}" for of in views.values()]
    return table(["", *views], [*cells, ["SMILE / the fastest other, by CPU time", *ratios]])


def likeness(data):
    """How alike the pictures are in which the others and SMILE show the same."""
    lines = []
    for name in next(iter(data["pictures"]["views"].values())):
        rows = [of[name] for of in data["pictures"]["views"].values()]
        if name != OUR_PICTURES:
            lines.append([name, f"{100 * min(row['same_ids'] for row in rows):.2f} %",
                          f"{max(row['depth_error_mm'] for row in rows):.2g} mm"])
    return table(["beside SMILE's pictures", "pixels with the same object, at least", "difference of depths, median, at most"], lines)


def drawn_by(data):
    return f"OpenGL is drawn on the processor, by {data['pictures']['device']}, for SMILE and for the others."


def versions(data):
    of = data["peers"]["versions"]
    return (f"MuJoCo {of['mujoco']} (Apache-2.0) and PyBullet {of['pybullet']} (zlib) from the Python package index; they are run as tools, "
            "and nothing\nof them is part of SMILE.")


def plots(data):
    """The SVG files by name."""
    files = {}
    for file, (title, names, limit) in PLOTS.items():
        lines = {label.removeprefix("step, all awake, "):
                 {size: of_size(data, name, size)["us"] for size in SIZES} for name, label in names.items()}
        files[file] = plot(title, "µs", lines, limit)
    return files


def filled(text, data):
    """The page with its measured parts made again: they lie between `<!-- measured: NAME -->` and `<!-- -->`."""
    functions = (machine, growth, some, recordings, imitations, work, parallel, peers, pictures, likeness, drawn_by, versions)
    parts = {function.__name__: function for function in functions}
    return re.sub(r"(?<=<!-- measured: )(\w+)( -->\n).*?(?=<!-- -->)",
                  lambda part: f"{part[1]}{part[2]}\n{parts[part[1]](data)}\n\n", text, flags=re.DOTALL)
