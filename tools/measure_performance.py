#!/usr/bin/env python3
"""Measures what docs/performance.md says, and writes it there with its plots.

    tools/measure_performance.py [--rounds N] [--filter REGEX] [--peers | --no-peers | --pictures | --imitations]
    tools/measure_performance.py --page     only writes the page again, from the kept numbers
    tools/measure_performance.py --check    fails if page and plots are not those of the kept numbers

Needs ./run once. A round runs `smile bench`, then each scene and each view of the comparison in each
simulator, one after the other; of N rounds (3) the shortest time is kept in docs/performance.json.
--filter measures only some benchmarks, --peers only the comparison, --pictures only its views,
--imitations only those, --no-peers all but the comparison; the other numbers stay. The first comparison installs MuJoCo and
PyBullet into build/peers.
"""

import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile

from performance import page, scenes

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROGRAM = os.path.abspath(os.environ.get("SMILE_PROGRAM", ROOT / "build/release/bin/smile"))
DATA = ROOT / "docs/performance.json"
PAGE = ROOT / "docs/performance.md"
PLOTS = ROOT / "docs/images/performance"
PEERS = ROOT / "build/peers"
PACKAGES = ("mujoco", "pybullet")
READER = "pillow"  # of our pictures, for the comparison
US = {"ns": 1e-3, "us": 1.0, "ms": 1e3, "s": 1e6}
SETTLE, MINUTE = 3, 60  # [s]

# Simulators with their steps per second: MuJoCo's and PyBullet's default, and MuJoCo with PyBullet's.
SIMULATORS = {"MuJoCo, 500 Hz": ("mujoco", 500), "MuJoCo, 240 Hz": ("mujoco", 240), "PyBullet, 240 Hz": ("pybullet", 240)}
# Our benchmark of each scene, and how many simulated seconds it measures.
OURS = {
    "UM": ("awake: UM, a minute/iterations:1", MINUTE),
    "10 stacks of 5": ("awake: 10 stacks of 5, a minute/iterations:1", MINUTE),
    "5 stacks of 10": ("awake: 5 stacks of 10, a minute/iterations:1", MINUTE),
    "UM with a moving robot": ("UM and a moving robot without grippers, a minute/iterations:1", MINUTE),
    "UM asleep": ("UM asleep, a minute/iterations:1", MINUTE),
}
# What draws views: its name on the page, and in performance/peer_view.py.
RENDERERS = {"MuJoCo": "mujoco", "MuJoCo, its Renderer": "mujoco renderer", "PyBullet, TinyRenderer": "pybullet",
             "PyBullet, OpenGL": "pybullet egl"}
# The views: our benchmark, and the options of `smile render`.
VIEWS = {"UM": ("eye, UM", ["--no-robot"]), "UM with robot": ("eye, UM with robot without grippers", ["--gripper", "none"])}
SIZES = ((200, 150), (640, 480), (1280, 800))
VIEW_SECONDS = 0.5
# Imitations: the demonstrations, by the names of their scenes, and the brains.
DEMONSTRATIONS = ("um", "tower")
LEARNERS = {"Python": "python/learner/learner.py", "Octave": "matlab/learner"}


def say(words):
    print(f"measure_performance: {words}", file=sys.stderr, flush=True)


def rounded(value):
    return float(f"{value:.4g}")


def machine():
    def value(path, separator, key):
        lines = (line.split(separator, 1) for line in pathlib.Path(path).read_text().splitlines())
        return next(line[1].strip().strip('"') for line in lines if line[0].strip() == key)

    compiler = subprocess.run(["c++", "--version"], check=True, capture_output=True, text=True).stdout.splitlines()[0]
    return {"processor": f"{value('/proc/cpuinfo', ':', 'model name')}, {float(value('/proc/cpuinfo', ':', 'cpu MHz')) / 1000:.1f} GHz",
            "cores": os.cpu_count(), "compiler": "g++ " + compiler.split()[-1],
            "system": value("/etc/os-release", "=", "PRETTY_NAME")}


def rows_of(pattern):
    """What matching benchmarks report."""
    printed = subprocess.run([PROGRAM, "bench", "--json", "--filter", pattern], check=True, stdout=subprocess.PIPE).stdout
    return json.loads(printed)["benchmarks"]


def bench(pattern):
    """The times [us] and counters of matching benchmarks, by name."""
    known = {"name", "run_name", "run_type", "time_unit", "label", "aggregate_name"}
    rows = {}
    for row in rows_of(pattern):
        if row.get("error_occurred"):
            say(f"{row['name']}: {row['error_message']}")
            continue
        is_wall_clock = row["name"].endswith(("/real_time", "/manual_time"))
        rows[row["name"]] = {"us": rounded(row["real_time" if is_wall_clock else "cpu_time"] * US[row["time_unit"]])}
        for name, value in row.items():
            if isinstance(value, float) and name not in known | {"real_time", "cpu_time"}:
                rows[row["name"]][name] = rounded(value)
    return rows


def keep_shorter(kept, new, key):
    """Keeps the new values of a row if it took less time."""
    for name, row in new.items():
        if name not in kept or row[key] < kept[name][key]:
            kept[name] = row


def install_peers():
    """The Python of the environment with the other simulators."""
    python = PEERS / "bin/python"
    if not python.exists():
        say("installing " + ", ".join(PACKAGES))
        subprocess.run([sys.executable, "-m", "venv", PEERS], check=True)
    subprocess.run([python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", *PACKAGES, READER],
                   check=True)
    return python


def versions(python):
    program = f"import importlib.metadata as m; print(*(m.version(p) for p in {PACKAGES}))"
    printed = subprocess.run([python, "-c", program], check=True, capture_output=True, text=True).stdout
    return dict(zip(PACKAGES, printed.split()))


def run_peer(python, problem):
    return printed_numbers([python, ROOT / "tools/performance/peer.py"], problem)


def printed_numbers(command, problem):
    """The result of a program that solves a problem from stdin; its directory is that of this one."""
    done = subprocess.run(command, input=json.dumps(problem), capture_output=True, text=True, cwd=ROOT / "tools")
    if done.returncode != 0:
        sys.exit(f"{json.dumps(problem)[:200]} failed:\n{done.stderr}")
    return {name: rounded(value) for name, value in json.loads(done.stdout.splitlines()[-1]).items()}


def our_scene(name):
    """Our numbers in the form of a peer's."""
    benchmark, seconds = OURS[name]
    row = bench("^" + benchmark + "$")[benchmark]
    return {"cpu_ms_per_s": rounded(row["us"] / 1000 / seconds),
            **{key: row[key] for key in ("sag_mm", "creep_mm", "joint_error_rad") if key in row}}


def compare_scenes(python, kept):
    """One round of the comparison: all simulators in each scene, one after the other."""
    problems = scenes.problems(PROGRAM)
    problems["UM asleep"] = problems["UM"]
    for name, problem in problems.items():
        say(name)
        may_sleep = name in ("UM asleep", "UM with a moving robot")
        of = kept.setdefault(name, {})
        keep_shorter(of, {page.OURS: our_scene(name)}, "cpu_ms_per_s")
        for simulator, (package, rate) in SIMULATORS.items():
            result = run_peer(python, {**problem, "simulator": package, "rate": rate, "may_sleep": may_sleep,
                                       "settle": SETTLE, "seconds": MINUTE})
            keep_shorter(of, {simulator: result}, "cpu_ms_per_s")


def our_view(name, size, kept):
    """Our picture: its times, and what draws it."""
    (row,) = rows_of(f"^{VIEWS[name][0]}/{size[0]}/{size[1]}/process_time$")
    kept["device"] = row["label"]
    return {f"{key}_ms": rounded(row[f"{time}_time"] * US[row["time_unit"]] / 1000) for key, time in (("cpu", "cpu"), ("wall", "real"))}


def keep_shortest(kept, new):
    """Keeps the shortest times; all else is equal in each round."""
    for key, value in new.items():
        kept[key] = min(value, kept.get(key, value))


def compare_views(python, kept):
    """One round of the comparison of pictures: all renderers of each view, one after the other."""
    for name, (_, render_options) in VIEWS.items():
        for size in SIZES:
            title = f"{name}, {size[0]}x{size[1]}"
            say(title)
            of = kept.setdefault("views", {}).setdefault(title, {})
            with tempfile.TemporaryDirectory() as folder:
                picture = os.path.join(folder, "view.png")
                subprocess.run([PROGRAM, "render", ROOT / "scenes/um.xml", "--camera", "eye", "--size", f"{size[0]}x{size[1]}",
                                "--channels", "rgb,depth,id", "--out", picture, *render_options], check=True, capture_output=True)
                keep_shortest(of.setdefault("SMILE", {}), our_view(name, size, kept))
                for other, renderer in RENDERERS.items():
                    problem = {"renderer": renderer, "view": name, "size": size, "seconds": VIEW_SECONDS, "program": PROGRAM,
                               "picture": picture}
                    keep_shortest(of.setdefault(other, {}), printed_numbers([python, "-m", "performance.peer_view"], problem))


def cpu_seconds(command):
    """The CPU time of a program and all processes that it waited for [s]."""
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, cwd=ROOT) as process:
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))} failed")
    return rounded(usage.ru_utime + usage.ru_stime)


def imitate(kept):
    """One round of imitations: each demonstration by each learner."""
    for scene in DEMONSTRATIONS:
        with tempfile.TemporaryDirectory() as folder:
            demo = os.path.join(folder, "demo")
            subprocess.run([PROGRAM, "run", f"scenes/{scene}.xml", "--commands", f"examples/{scene}.jsonl", "--record", demo],
                           check=True, stdout=subprocess.DEVNULL, cwd=ROOT)
            for language, learner in LEARNERS.items():
                say(f"{scene}, {language}")
                seconds = cpu_seconds([PROGRAM, "imitate", demo, f"scenes/{scene}_robot.xml", "--brain", learner, "--no-pictures",
                                       "--out", os.path.join(folder, language)])
                keep_shortest(kept.setdefault(language, {}), {scene: seconds})


def measure(data, options):
    benchmarks, kept_imitations, kept_scenes, kept_views = {}, {}, {}, {}
    python = None if options.no_peers or options.imitations else install_peers()
    for i in range(options.rounds):
        say(f"round {i + 1} of {options.rounds}")
        if options.imitations:
            imitate(kept_imitations)
            continue
        if not options.peers and not options.pictures:
            keep_shorter(benchmarks, bench(options.filter), "us")
            if options.filter == ".":
                imitate(kept_imitations)
        if python and not options.pictures:
            compare_scenes(python, kept_scenes)
        if python:
            compare_views(python, kept_views)
    data["machine"] = machine()
    data.setdefault("benchmarks", {}).update(benchmarks)
    if kept_imitations:
        data["imitations"] = kept_imitations
    if kept_scenes:
        data["peers"] = {"versions": versions(python), "scenes": kept_scenes}
    if kept_views:
        data["pictures"] = {"versions": versions(python), **kept_views}


def text_of(data):
    """One benchmark a line, so that changes are readable."""
    rows = ",\n".join(f"  {json.dumps(name)}: {json.dumps(row)}" for name, row in data["benchmarks"].items())
    rest = json.dumps({name: value for name, value in data.items() if name != "benchmarks"}, indent=1)
    return rest[:-2] + f',\n "benchmarks": {{\n{rows}\n }}\n}}\n'


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--filter", default=".")
    for option in ("peers", "no-peers", "pictures", "imitations", "page", "check"):
        parser.add_argument("--" + option, action="store_true")
    options = parser.parse_args()
    data = json.loads(DATA.read_text()) if DATA.exists() else {}
    if not options.page and not options.check:
        measure(data, options)
        DATA.write_text(text_of(data))
    files = {PAGE: page.filled(PAGE.read_text(), data),
             **{PLOTS / name: text for name, text in page.plots(data).items()}}
    for path, text in files.items():
        if options.check and (not path.exists() or path.read_text() != text):
            sys.exit(f"{path.relative_to(ROOT)} is not that of {DATA.relative_to(ROOT)}: run tools/measure_performance.py --page")
        if not options.check:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)


main()
