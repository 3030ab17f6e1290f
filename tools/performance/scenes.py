"""The scenes that SMILE and other simulators are compared in, as plain numbers: see peer.py."""

import json
import math
import pathlib
import re
import subprocess
import xml.etree.ElementTree as ET

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
METERS_PER_UNIT = 0.1
# Of the colors that SMILE names, those of the scene.
COLORS = {"blue": [0, 0, 1], "brown": [65 / 255, 40 / 255, 25 / 255], "cyan": [0, 1, 1], "green": [0, 1, 0], "magenta": [1, 0, 1],
          "orange": [251 / 255, 130 / 255, 0], "red": [1, 0, 0], "yellow": [1, 1, 0]}
ROBOT_GAP = ROBOT_HEIGHT = 0.2  # from the table's near edge, and above its top [m]
TABLE = {"position": [0, 0, -0.2], "size": [2.0, 1.2, 0.4]}


def um(program):
    """The blocks of scenes/um.xml, as the program reads them."""
    text = subprocess.run([program, "check", "--expand", ROOT / "scenes/um.xml"], check=True, capture_output=True,
                          text=True).stdout
    blocks = []
    for block in ET.fromstring(text):
        location = [float(number) for number in re.findall(r"[-\d.e]+", block.get("location"))]
        blocks.append({"position": [METERS_PER_UNIT * x for x in location],
                       "size": [METERS_PER_UNIT * float(block.get(axis + "span")) for axis in "xyz"],
                       "mass": float(block.get("mass")), "color": COLORS[block.get("color")]})
    return blocks


def stacks(num_cubes, cubes_a_stack, edge=0.1, gap=0.1):
    """Stacks of cubes on a square grid; src/bench/scenes.cc makes the same."""
    num_stacks = math.ceil(num_cubes / cubes_a_stack)
    num_columns = math.ceil(math.sqrt(num_stacks))
    blocks = []
    for i in range(num_cubes):
        stack, level = divmod(i, cubes_a_stack)
        row, column = divmod(stack, num_columns)
        x, y = ((place - 0.5 * (num_columns - 1)) * (edge + gap) for place in (column, row))
        blocks.append({"position": [x, y, (level + 0.5) * edge], "size": [edge] * 3, "mass": 1.0})
    return blocks


def robot():
    """Baxter without grippers, where its arms are at the start."""
    urdf = ROOT / "robots/baxter.urdf"
    side = json.loads((ROOT / "robots/baxter.robot.json").read_text())
    start_pose = side["poses"][side["start"]]
    start = {joint: angle for arm in ("left", "right")
             for joint, angle in zip(side["arms"][arm]["joints"], start_pose[arm])}
    uppers = {joint.get("name"): float(joint.find("limit").get("upper"))
              for joint in ET.parse(urdf).getroot().iter("joint") if joint.get("name") in start}
    return {"urdf": str(urdf), "start": start, "upper": [uppers[joint] for joint in start],
            "apart": side["never_collide"]}


def in_robot_frame(box, table_depth):
    """Expresses a box in the frame of a robot at the near edge of the table: x forward, y to the left."""
    x, y, z = box["position"]
    along_x, along_y, along_z = box["size"]
    return {**box, "position": [y + table_depth / 2 + ROBOT_GAP, -x, z - ROBOT_HEIGHT],
            "size": [along_y, along_x, along_z]}


def problems(program):
    """The scenes by name, without simulator and durations."""
    blocks = um(program)
    depth = TABLE["size"][1]
    plain = {"table": None, "robot": None}
    return {
        "UM": {"blocks": blocks, **plain},
        "10 stacks of 5": {"blocks": stacks(50, 5), **plain},
        "5 stacks of 10": {"blocks": stacks(50, 10), **plain},
        "UM with a moving robot": {"blocks": [in_robot_frame(block, depth) for block in blocks],
                                   "table": in_robot_frame(TABLE, depth), "robot": robot()},
    }
