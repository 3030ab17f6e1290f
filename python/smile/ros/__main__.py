"""python3 -m smile.ros: the simulated robot on a ROS graph, recorded motions on a real one, and its calibration."""

from __future__ import annotations

import argparse
import json
import signal
import sys
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, TypeVar

import smile
from smile.ros.brain_command import camera_of, cell_fault, describe_outcome, describe_task, dry_run, write_brain_report
from smile.ros.brain_performing import BrainPerformance, BrainTask
from smile.ros.calibrating import photograph, touch, write_cell
from smile.ros.calibration import Board, read_json, table_fault
from smile.ros.description import RobotDescription, describe
from smile.ros.link import RobotLink, SeeingLink
from smile.ros.motion_plan import Plan, approach, fastest, faults, hardest, plan_of, tools
from smile.ros.performing import Performance, Stopped, Watch, write_report
from smile.ros.stop_page import StopPage

FAILED, WRONG, LACKING = 1, 2, 3
_Result = TypeVar("_Result")


class PackageMissing(Exception):
    """A package of the system is not installed."""


def main(arguments: Sequence[str]) -> int:
    parser = argparse.ArgumentParser(prog="smile ros", description=__doc__.partition(": ")[2])
    commands = parser.add_subparsers(required=True, metavar="COMMAND")
    _add_serve(commands)
    _add_perform(commands)
    _add_board(commands)
    _add_touch(commands)
    _add_calibrate(commands)
    options = parser.parse_args(arguments)
    # However the program is asked to end, a robot is stopped first; also by a terminal that closes.
    for ending in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(ending, _interrupt)
    try:
        return int(options.run_command(options))
    except PackageMissing as error:
        print(f"smile: {error}", file=sys.stderr)
        return LACKING
    except (ValueError, OSError, RuntimeError) as error:
        print(f"error: {error}", file=sys.stderr)
        return WRONG
    except KeyboardInterrupt:
        return 130


def _with_ros(work: Callable[[], _Result]) -> _Result:
    """Calls a function that uses ROS 1; exceptions of ROS become RuntimeError."""
    try:
        import rospy
    except ImportError as error:
        raise PackageMissing(f"ROS needs Debian's packages: {error}; get them by\n  tools/get_ros.sh "
                             "(docs/real-robot.md)") from None
    try:
        return work()
    except rospy.ROSException as error:
        raise RuntimeError(str(error)) from None


def _interrupt(number: int, frame: object) -> None:
    raise KeyboardInterrupt


def _number(low: float, high: float, unit: str) -> "type[float]":
    def read(text: str) -> float:
        try:
            value = float(text)
        except ValueError:
            value = float("nan")
        if not low <= value <= high:
            raise argparse.ArgumentTypeError(f"is {text!r}, expected a number from {low:g} to {high:g}{unit}")
        return value
    return read  # type: ignore[return-value]


def _port(text: str) -> int:
    if not (text.isdecimal() and 1 <= int(text) <= 65535):
        raise argparse.ArgumentTypeError(f"is {text!r}, expected a port from 1 to 65535")
    return int(text)


def _size(text: str) -> tuple[int, int]:
    width, x, height = text.partition("x")
    if not (x and width.isdigit() and height.isdigit() and 1 <= int(width) <= 4096 and 1 <= int(height) <= 4096):
        raise argparse.ArgumentTypeError(f"is {text!r}, expected WIDTHxHEIGHT, for example 320x200")
    return int(width), int(height)


def _add_serve(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    parser = commands.add_parser(
        "serve", help="show the simulated robot to ROS as a real one",
        description="Simulates a scene, and shows its robot at ROS_MASTER_URI under the names of a Baxter "
                    "(docs/real-robot.md).")
    parser.add_argument("scene", metavar="SCENE", help="scene file")
    parser.add_argument("--robot", default="baxter", metavar="NAME", help="robot: a name that `smile robots` lists, or a URDF file (default %(default)s)")
    parser.add_argument("--pose", metavar="NAME", help="named pose in which the robot begins (default: its own start)")
    parser.add_argument("--rate", default=1.0, type=_number(0.01, 1000, ""), metavar="N", help="simulated seconds per second, at most (default 1)")
    parser.add_argument("--lockstep", action="store_true", help="while a limb is commanded, wait in each tick of 1/60 s for its next command: "
                        "results do not depend on the load of the machine")
    parser.add_argument("--picture-rate", default=10.0, type=_number(0.1, 60, " pictures per second"), metavar="N", help="pictures per simulated second of each camera to which a node listens (default 10)")
    parser.add_argument("--size", default="320x200", type=_size, metavar="WxH", help="size of pictures in pixels (default %(default)s)")
    parser.add_argument("--record", metavar="DIR", help="record everything that happens into a new folder")
    parser.set_defaults(run_command=_serve)


def _serve(options: argparse.Namespace) -> int:
    def work() -> int:
        from smile.ros.serve import serve
        serve(options.scene, robot=options.robot, rate=options.rate, lockstep=options.lockstep,
              picture_rate=options.picture_rate, picture_size=options.size, record=options.record, pose=options.pose)
        return 0
    return _with_ros(work)


def _add_bridge(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--bridge", metavar="URL", help="address of a rosbridge server of ROS 1 or 2, as ws://ROBOT:9090 (default: none; the robot is at ROS_MASTER_URI)")


def _add_perform(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    parser = commands.add_parser(
        "perform", help="let a real robot perform a recorded motion, or a brain drive it",
        description="Lets the robot at ROS_MASTER_URI, or behind a rosbridge server, perform what the simulated robot did "
                    "in a recording, or lets a brain drive it. Read docs/real-robot.md first. Ends with 0 if it did, 1 if it was stopped or must not.")
    parser.add_argument("run", metavar="RUN", help="folder of a recording of a robot, or of an imitation; with --brain: scene file")
    _add_brain(parser)
    parser.add_argument("--limb", action="append", default=[], metavar="NAME", help="arm that moves; may be repeated (default: each that moves in the recording)")
    parser.add_argument("--speed", default=0.3, type=_number(0.01, 1, ""), metavar="N", help="fraction of the speed of the recording, or of the clock of the brain (default 0.3)")
    parser.add_argument("--max-acceleration", default=3.0, type=_number(0.01, 100, " rad/s²"), metavar="A", help="greatest acceleration of a joint in rad/s² (default 3)")
    parser.add_argument("--tolerance", default=0.15, type=_number(0.001, 1, " rad"), metavar="RAD", help="tracking error at which the robot is stopped, in rad (default 0.15)")
    parser.add_argument("--silence", default=0.5, type=_number(0.05, 60, " s"), metavar="S", help="wall-clock time without joint states after which the robot is stopped, in seconds (default 0.5)")
    _add_bridge(parser)
    parser.add_argument("--cell", metavar="FILE", help="calibration that `smile ros calibrate` wrote: refuse a table that is not where the scene has it (default: none; the table is not checked)")
    parser.add_argument("--enable", action="store_true", help="switch the motors on, if they are off")
    parser.add_argument("--start-by-trajectory", action="store_true", help="let the robot's own controller follow the way to the start, as one trajectory (default: it is streamed, as the rest)")
    parser.add_argument("--dry-run", action="store_true", help="check everything and say what would be done, and move nothing")
    parser.add_argument("--page", nargs="?", const=0, type=_port, metavar="PORT", help="serve a page with a red button that stops the robot, to this machine only (default: none; without PORT any that is free)")
    parser.add_argument("--yes", action="store_true", help="do not ask before the robot moves")
    parser.add_argument("--report", metavar="FILE", help="write the outcome and the tracking errors as JSON")
    parser.set_defaults(run_command=_perform)


def _add_brain(parser: argparse.ArgumentParser) -> None:
    group = parser.add_argument_group("a brain that drives the robot")
    group.add_argument("--brain", metavar="BRAIN", help="brain, as smile run --brain has it, in place of a recorded motion")
    group.add_argument("--robot", metavar="NAME", help="robot: a name that `smile robots` lists, or a URDF file (default baxter)")
    group.add_argument("--demonstration", metavar="DIR", help="recording that the brain imitates (default: none)")
    group.add_argument("--camera", metavar="TOPIC", help="pictures for the brain, as /cameras/head_camera/image, of the camera in --cell (default: none; the brain sees nothing)")
    group.add_argument("--depth", metavar="TOPIC", help="depths in the pixels of --camera (default: none)")
    group.add_argument("--size", type=_size, metavar="WxH", help="size of the pictures for the brain in pixels (default 640x480)")
    group.add_argument("--picture-age", type=_number(0.01, 10, " s"), metavar="S", help="greatest age of a picture when the brain gets it, in seconds; the arms wait for a newer one (default 0.1)")
    group.add_argument("--timeout", type=_number(0.1, 3600, " s"), metavar="S", help="wall-clock timeout per callback in seconds (default 5)")
    group.add_argument("--seconds", type=_number(0.1, 36000, " s"), metavar="S", help="time limit by the clock of the brain in seconds (default 600)")


_OF_BRAINS = ("robot", "demonstration", "camera", "depth", "size", "picture_age", "timeout", "seconds")


def _mixed_options(options: argparse.Namespace) -> str | None:
    """Returns what is wrong with options of which some belong to brains; None if nothing is."""
    if options.brain is None:
        given = [name for name in _OF_BRAINS if getattr(options, name) is not None]
        return f"--{given[0].replace('_', '-')} is for a brain, expected --brain as well" if given else None
    if options.limb:
        return "--limb selects from a recorded motion, but a brain may move all arms: expected no --limb"
    if options.depth is not None and options.camera is None:
        return "--depth belongs to the pixels of a camera, expected --camera as well"
    if options.camera is not None and options.cell is None:
        return "where the camera is must be known, expected --cell"
    return None


def _perform_brain(options: argparse.Namespace) -> int:
    model = smile.load(options.run, options.robot or "baxter")
    if not model.has_robot:
        raise ValueError(f"{options.run}: has no robot, expected one to drive")
    description = describe(model)
    cell = {} if options.cell is None else read_json(options.cell)
    try:
        fault = None if options.cell is None else cell_fault(cell, model, description, options.camera)
    except ValueError as error:
        raise ValueError(f"{options.cell}: {error}") from None
    if fault is not None:
        print(f"refused: {fault}")
        return FAILED

    def work(link: SeeingLink) -> int:
        camera = None if options.camera is None else camera_of(link, cell, options.camera, options.depth, options.size or (640, 480))
        given = {name: value for name in ("timeout", "seconds", "picture_age") if (value := getattr(options, name)) is not None}
        task = BrainTask(options.brain, options.demonstration or "", camera, options.speed, options.max_acceleration, **given)
        print("\n".join(describe_task(task, model, description)), flush=True)
        return _drive(link, model, description, task, options)
    return _with_link(options.bridge, model.arm_names, description, work)


def _drive(link: SeeingLink, model: smile.Model, description: RobotDescription, task: BrainTask, options: argparse.Namespace) -> int:
    page = None if options.page is None or options.dry_run else StopPage(task.brain, options.page)
    performance = BrainPerformance(link, model, description, task, Watch(tolerance=options.tolerance, silence=options.silence), page,
                                   options.start_by_trajectory)
    try:
        if options.dry_run:
            fault = dry_run(performance)
            print("nothing moved: " + ("this would be performed" if fault is None else f"refused: {fault}"))
            return 0 if fault is None else FAILED
        if not _is_agreed(link, page, options):
            return FAILED
        outcome = performance.perform(lambda line: print(line, flush=True))
    finally:
        performance.close()
    if page is not None:
        page.close("Performed." if outcome.reason is None else f"Stopped: {outcome.reason}.")
    if options.report is not None:
        write_brain_report(outcome, task, description, options.report)
    print("\n".join(describe_outcome(outcome)))
    return 0 if outcome.reason is None else FAILED


def _is_agreed(link: RobotLink, page: StopPage | None, options: argparse.Namespace) -> bool:
    """Asks whether the robot may move, and switches its motors on if that is wanted."""
    if page is not None:
        print(f"stop button: {page.link}", flush=True)
    if not (options.yes or _is_wanted()):
        print("nothing moved")
        return False
    if options.enable:
        switch_on(link)
    return True


def _perform(options: argparse.Namespace) -> int:
    if (fault := _mixed_options(options)) is not None:
        raise ValueError(fault)
    if options.brain is not None:
        return _perform_brain(options)
    plan = plan_of(smile.open(recording_of(options.run)), options.limb, options.speed)
    _describe(plan, options.max_acceleration)
    found = faults(plan, options.max_acceleration)
    if options.cell is not None:
        found += _table_faults(options.cell, plan)
    for fault in found:
        print(f"refused: {fault}")
    if found:
        return FAILED
    return _with_link(options.bridge, plan.arms, plan.description, lambda link: _perform_on(link, plan, options))


def _table_faults(path: str, plan: Plan) -> list[str]:
    try:
        fault = table_fault(read_json(path), plan.description.name, plan.table)
    except ValueError as error:
        raise ValueError(f"{path}: {error}") from None
    return [] if fault is None else [fault]


def _with_link(bridge: str | None, arms: Sequence[str], description: RobotDescription,
               work: Callable[[SeeingLink], int]) -> int:
    """Calls a function with the robot at ROS_MASTER_URI, or behind a bridge."""
    names = [name for joints in description.arms.values() for name in joints]

    def work_with_ros() -> int:
        from smile.ros.ros_link import RosLink
        return work(RosLink(arms, names))

    if bridge is None:
        return _with_ros(work_with_ros)
    try:
        from smile.ros.bridge_link import BridgeLink
    except ImportError as error:
        raise PackageMissing(f"--bridge needs the Python package websockets: {error}; get it by\n  apt-get install "
                             "python3-websockets, or pip install websockets") from None
    return work(BridgeLink(bridge, arms, names))


def _perform_on(link: RobotLink, plan: Plan, options: argparse.Namespace) -> int:
    watch = Watch(tolerance=options.tolerance, silence=options.silence)
    if options.dry_run:
        return _dry_run(Performance(link, plan, watch), plan)
    page = None if options.page is None else StopPage(plan.title, options.page)
    if not _is_agreed(link, page, options):
        return FAILED
    outcome = Performance(link, plan, watch, page, options.start_by_trajectory).perform(lambda line: print(line, flush=True))
    if page is not None:
        page.close("Performed." if outcome.reason is None else f"Stopped: {outcome.reason}.")
    print(outcome.tracking.table() if outcome.tracking.errors else "nothing was performed")
    for words in outcome.words:
        print(f"robot: {words}")
    if options.report is not None:
        write_report(outcome, plan, options.report)
    print("performed" if outcome.reason is None else
          f"stopped after {outcome.seconds:.2f} s of {plan.path.duration:.2f} s: {outcome.reason}")
    return 0 if outcome.reason is None else FAILED


def switch_on(link: RobotLink, patience: float = 5.0) -> None:
    """Switches the motors on; RuntimeError if they do not run after wall-clock time [s]."""
    deadline = time.monotonic() + patience
    while (fault := link.motors_fault()) is not None:
        if time.monotonic() > deadline:
            raise RuntimeError(f"{fault}, {patience:g} s after they were switched on")
        link.enable()
        link.wait(0.1)


def _is_wanted() -> bool:
    if not sys.stdin.isatty():
        raise ValueError("there is no terminal to ask whether the robot may move, expected --yes")
    return input("Is the robot's space clear, and a hand on the stop? Type move: ").strip() == "move"


def recording_of(run: str) -> Path:
    """Returns the recording of a run: itself, or that of an imitation."""
    inside = Path(run) / "imitation"
    return inside if (inside / "demo.json").exists() else Path(run)


def _describe(plan: Plan, max_acceleration: float) -> None:
    speed, acceleration = fastest(plan), hardest(plan, max_acceleration)
    print(f"{plan.title}: {plan.description.name}, {' and '.join(plan.arms)} arm, {plan.path.duration:.1f} s in the recording, "
          f"{plan.seconds:.1f} s at speed {plan.speed:g}")
    print(f"  greatest speed: {speed.joint} {speed.value:.2f} rad/s of {speed.limit:g}")
    print(f"  greatest acceleration: {acceleration.joint} {acceleration.value:.2f} rad/s² of {acceleration.limit:g}")
    for arm in plan.arms:
        print(f"  lowest place of the {arm} tool: {1000 * tools(plan, arm)[:, 2].min():.0f} mm above the table")
    for move in plan.grippers:
        goal = f"closes on {move.held}" if move.held else f"goes to {move.percent:.0f} %"
        print(f"  {move.begin / plan.speed:.1f} s: {move.arm} gripper {goal}")


def _dry_run(performance: Performance, plan: Plan) -> int:
    try:
        path, fault = approach(plan, performance.read().positions)
    except Stopped as error:
        fault = str(error)
    else:
        print(f"  the way to the start takes {path.duration:.1f} s")
    print("nothing moved: " + ("this would be performed" if fault is None else f"refused: {fault}"))
    return 0 if fault is None else FAILED


def _add_board(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    parser = commands.add_parser(
        "board", help="write a chessboard to print, for calibrate", description="Writes a chessboard to scale, as SVG. Print it at "
        "100 %% and measure a square.")
    parser.add_argument("--columns", default=9, type=int, metavar="N", help="inner corners in a row (default 9)")
    parser.add_argument("--rows", default=6, type=int, metavar="N", help="inner corners in a column (default 6)")
    parser.add_argument("--square", default=0.024, type=_number(0.005, 0.2, " m"), metavar="M", help="side of a square in m (default 0.024)")
    parser.add_argument("--out", required=True, metavar="FILE.svg", help="file to write")
    parser.set_defaults(run_command=_board)


def _board(options: argparse.Namespace) -> int:
    Path(options.out).write_text(Board(options.columns, options.rows, options.square).svg())
    return 0


def _add_touch(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    parser = commands.add_parser(
        "touch", help="note where a person lets the robot touch table and board, for calibrate",
        description="Reads lines: t where the tool touches the table, b where it touches a corner of the board; the end of the input "
                    "(Ctrl-D) writes the file. A person moves the arm; nothing moves by itself.")
    parser.add_argument("run", metavar="RUN", help="folder of a recording of the robot, which has its description")
    parser.add_argument("--limb", required=True, metavar="NAME", help="arm that touches")
    _add_bridge(parser)
    parser.add_argument("--camera", metavar="TOPIC", help="pictures of a camera, as /cameras/head_camera/image: at the end, one of the board is saved beside FILE (default: none)")
    parser.add_argument("--out", required=True, metavar="FILE", help="file to write")
    parser.set_defaults(run_command=_touch)


def _touch(options: argparse.Namespace) -> int:
    description = RobotDescription(smile.open(recording_of(options.run)))
    if options.limb not in description.arms:
        raise ValueError(f"limb {options.limb!r}, expected one of {', '.join(description.arms)}")

    def work(link: SeeingLink) -> int:
        print("t: the tool touches the table; b: a corner of the board; Ctrl-D: the end", flush=True)
        points: dict[str, Any] = dict(touch(link, description, options.limb, sys.stdin, lambda line: print(line, flush=True)))
        if options.camera is not None:
            points["camera"] = photograph(link, options.camera, Path(options.out).with_suffix(".png"))
        Path(options.out).write_text(json.dumps({name: one for name, one in points.items() if one}, indent=1) + "\n")
        return 0
    return _with_link(options.bridge, [options.limb], description, work)


def _add_calibrate(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    parser = commands.add_parser(
        "calibrate", help="find where table and camera are, from touched points and a picture of a board",
        description="Computes the plane of the table and the pose of a camera in the frame of the scene (docs/real-robot.md).")
    parser.add_argument("run", metavar="RUN", help="folder of a recording of the robot, which has its description and place")
    parser.add_argument("measurements", metavar="FILE", help="points that `smile ros touch` noted, with the camera's picture")
    parser.add_argument("--out", required=True, metavar="CELL", help="file to write, for perform --cell")
    parser.set_defaults(run_command=_calibrate)


def _calibrate(options: argparse.Namespace) -> int:
    try:
        words = write_cell(options.measurements, RobotDescription(smile.open(recording_of(options.run))), options.out)
    except ImportError as error:
        raise PackageMissing(f"pictures need the Python package OpenCV: {error}; get it by\n  apt-get install python3-opencv, or pip "
                             "install opencv-python-headless") from None
    print("\n".join(words))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
