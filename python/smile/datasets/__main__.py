"""python3 -m smile.datasets: exports datasets and checks them."""

from __future__ import annotations

import argparse
import re
import sys
from collections.abc import Sequence
from pathlib import Path

from smile.datasets import ACTIONS, FORMATS, examine, export, merge
from smile.datasets.exporting import RATES
from smile.datasets.pictures import MAPS

WRONG = 2


def main(arguments: Sequence[str]) -> int:
    parser = argparse.ArgumentParser(prog="python3 -m smile.datasets", description=__doc__)
    commands = parser.add_subparsers(required=True, metavar="COMMAND")
    _add_export(commands)
    _add_merge(commands)
    _add_doctor(commands)
    options = parser.parse_args(arguments)
    try:
        return int(options.run(options))
    except (ValueError, OSError, RuntimeError) as error:
        print(f"error: {_words_of(error)}", file=sys.stderr)
        return WRONG
    except ModuleNotFoundError as error:
        # Formats import their packages when they are asked for.
        print(f"error: this format needs a Python package: {error}; docs/datasets.md names it", file=sys.stderr)
        return WRONG
    except KeyboardInterrupt:
        kept = "the finished parts are kept" if getattr(options, "parts", None) else "nothing was written"
        print(f"interrupted: {kept}", file=sys.stderr)
        return 130


def _words_of(error: Exception) -> str:
    if isinstance(error, OSError) and error.filename is not None:
        return f"{error.filename}: {error.strerror}"
    return str(error)


def _add_export(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    parser = commands.add_parser(
        "export", help="make a dataset of runs",
        description="Makes a dataset of runs, an episode for each: recordings of demonstrations or of robots, and "
                    "folders that `smile imitate`, `experiment`, `evaluate` and `generate` wrote.")
    parser.add_argument("runs", nargs="+", metavar="RUN", help="folder of a recording, an imitation or a generation")
    parser.add_argument("--to", choices=FORMATS, default=FORMATS[0], help="format (default %(default)s)")
    parser.add_argument("--out", required=True, metavar="DIR", help="folder to be made")
    parser.add_argument("--camera", action="append", metavar="NAME[:WxH]", default=None,
                        help="camera of the robot or scene, or a view for people, and the size of its pictures; "
                             "repeat it for several cameras; `none` for no pictures (default eye)")
    parser.add_argument("--size", default="320x240", metavar="WxH", type=_size,
                        help="size of pictures in pixels (default %(default)s)")
    parser.add_argument("--fps", type=int, default=30, metavar="N",
                        help=f"frames per second, one of {', '.join(map(str, RATES))} (default %(default)s)")
    parser.add_argument("--action", choices=ACTIONS, default=ACTIONS[0],
                        help="what actions are (default %(default)s)")
    parser.add_argument("--task", metavar="TEXT", help="what is to be done (default: title of each recording)")
    parser.add_argument("--include-failed", action="store_true", help="export imitations that failed, too")
    parser.add_argument("--drop-constant", action="store_true", help="leave out joints that never move")
    parser.add_argument("--no-extras", action="store_true", help="do not copy the recordings into the dataset")
    parser.add_argument("--map", action="append", choices=MAPS, default=[],
                        help="store of each pixel what it shows, too, beside its color: its depth [m], the number of "
                             "its object; may be repeated (robomimic, zarr, mcap, rrd; depth also lerobot-v3.0)")
    parser.add_argument("--language", action="store_true",
                        help="give each frame the words of its subtask and of the plan (LeRobot's formats)")
    parser.add_argument("--parts", type=int, metavar="N",
                        help="make the dataset in parts of N episodes: an interrupted export continues after its "
                             "last part (lerobot-v3.0)")
    parser.set_defaults(run=_export)


def _size(text: str) -> tuple[int, int]:
    width, x, height = text.partition("x")
    if not (x and width.isdigit() and height.isdigit()):
        raise argparse.ArgumentTypeError(f"is {text!r}, expected WIDTHxHEIGHT, for example 320x240")
    return int(width), int(height)


def _export(options: argparse.Namespace) -> int:
    cameras = {}
    for word in options.camera if options.camera is not None else ["eye"]:
        # Views may have colons themselves: only what looks like a size is one.
        sized = re.fullmatch(r"(.*):(\d+)x(\d+)", word)
        if word != "none":
            cameras[sized[1] if sized else word] = (int(sized[2]), int(sized[3])) if sized else options.size
    report = export(options.runs, options.out, format=options.to, cameras=cameras, fps=options.fps,
                    action=options.action, task=options.task, include_failed=options.include_failed,
                    drop_constant=options.drop_constant, extras=not options.no_extras, parts=options.parts,
                    maps=options.map, language=options.language,
                    progress=lambda line: print(line, file=sys.stderr, flush=True))
    for feature, names in report.constant.items():
        print(f"note: {feature} has dimensions that never change: {', '.join(names)}; see --drop-constant",
              file=sys.stderr)
    print(f"{report.folder}: {report.episodes} episodes, {report.frames} frames")
    return 0


def _add_merge(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    parser = commands.add_parser(
        "merge", help="join datasets",
        description="Joins datasets that were exported in the same format with the same options, in this order. "
                    "Episodes are numbered again, and statistics are those of all frames.")
    parser.add_argument("datasets", nargs="+", metavar="DATASET", help="folder of a dataset")
    parser.add_argument("--out", required=True, metavar="DIR", help="folder to be made")
    parser.set_defaults(run=_merge)


def _merge(options: argparse.Namespace) -> int:
    report = merge(options.datasets, options.out,
                   progress=lambda line: print(line, file=sys.stderr, flush=True))
    print(f"{report.folder}: {report.episodes} episodes, {report.frames} frames")
    return 0


def _add_doctor(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    parser = commands.add_parser(
        "doctor", help="check a dataset",
        description="Checks a dataset, of LeRobot v3.0 or v2.1, robomimic, Zarr, or tables that SMILE exported, for "
                    "faults with which programs fail to read it or learn nothing from it, and reports what to do. "
                    "Ends with 0 if there are no errors, else 1.")
    parser.add_argument("dataset", metavar="DATASET", help="folder of the dataset, or HDF5 file")
    parser.set_defaults(run=_doctor)


def _doctor(options: argparse.Namespace) -> int:
    findings = examine(Path(options.dataset))
    for finding in findings:
        print(finding)
    errors = sum(finding.is_error for finding in findings)
    print(f"{options.dataset}: {errors} errors, {len(findings) - errors} warnings")
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
