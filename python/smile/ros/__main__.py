"""python3 -m smile.ros: the simulated robot on a ROS graph, and recorded motions on a real one."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence

import rospy

from smile.ros.serve import serve

FAILED, WRONG = 1, 2


def main(arguments: Sequence[str]) -> int:
    parser = argparse.ArgumentParser(prog="smile ros", description=__doc__.partition(": ")[2])
    commands = parser.add_subparsers(required=True, metavar="COMMAND")
    _add_serve(commands)
    options = parser.parse_args(arguments)
    try:
        return int(options.run(options))
    except (ValueError, OSError, RuntimeError, rospy.ROSException) as error:
        print(f"error: {error}", file=sys.stderr)
        return WRONG
    except KeyboardInterrupt:
        return 130


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
    parser.set_defaults(run=_serve)


def _serve(options: argparse.Namespace) -> int:
    serve(options.scene, robot=options.robot, rate=options.rate, lockstep=options.lockstep,
          picture_rate=options.picture_rate, picture_size=options.size, record=options.record, pose=options.pose)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
