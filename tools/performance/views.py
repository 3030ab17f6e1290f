"""The views that SMILE and other simulators are compared in, as plain numbers: see peer_view.py.

A view is that of the robot's eye on the scene `um`, with Baxter or without. Its robot has no
grippers, and the same triangles as in SMILE, from robots/appearance/baxter.glb.
"""

import json
import struct
import xml.etree.ElementTree as ET

import numpy as np

from performance import scenes

EYE_ANGLE = 60  # vertical [degrees]
NEAR, FAR = 0.01, 10.0  # planes of the eye [m]
TABLE_COLOR = [1, 1, 1]
UNSEEN = "head"  # link that carries the eye


def rotation(rpy):
    """The rotation matrix of URDF's roll, pitch and yaw [rad]."""
    (sr, sp, sy), (cr, cp, cy) = np.sin(rpy), np.cos(rpy)
    return (np.array([[cy, -sy, 0], [sy, cy, 0], [0, 0, 1]]) @ np.array([[cp, 0, sp], [0, 1, 0], [-sp, 0, cp]])
            @ np.array([[1, 0, 0], [0, cr, -sr], [0, sr, cr]]))


def pose(position, turn):
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = turn, position
    return matrix


def robot_base():
    """Base frame of the robot in the world: x forward, y to the left."""
    near_edge = -scenes.TABLE["size"][1] / 2
    return pose([0, near_edge - scenes.ROBOT_GAP, scenes.ROBOT_HEIGHT], rotation([0, 0, np.pi / 2]))


def link_poses(urdf, q):
    """Poses of all links in the world, with the joints named in `q` [rad]; the others are at 0."""
    def numbers(element, name):
        return [float(number) for number in element.get(name).split()]

    poses = {"base": robot_base()}
    for joint in ET.parse(urdf).getroot().iter("joint"):  # parents come first in this file
        origin = joint.find("origin")
        # Each joint of this robot that turns does so about its own z.
        turn = rotation(numbers(origin, "rpy")) @ rotation([0, 0, q.get(joint.get("name"), 0)])
        poses[joint.find("child").get("link")] = poses[joint.find("parent").get("link")] @ pose(numbers(origin, "xyz"), turn)
    return poses


class Glb:
    """Triangles and colors of a glTF file as SMILE writes them."""

    TYPES = {5126: np.float32, 5123: np.uint16, 5125: np.uint32}

    def __init__(self, path):
        data = path.read_bytes()
        (size,) = struct.unpack_from("<I", data, 12)
        self.json = json.loads(data[20:20 + size])
        self.binary = data[20 + size + 8:]

    def values(self, index):
        accessor = self.json["accessors"][index]
        view = self.json["bufferViews"][accessor["bufferView"]]
        count = accessor["count"] * {"SCALAR": 1, "VEC3": 3}[accessor["type"]]
        return np.frombuffer(self.binary, self.TYPES[accessor["componentType"]], count,
                             view.get("byteOffset", 0) + accessor.get("byteOffset", 0)).reshape(-1, 3)

    def color(self, material):
        """The color as shown on a screen; the file has linear light."""
        linear = np.array(self.json["materials"][material]["pbrMetallicRoughness"]["baseColorFactor"][:3])
        return np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055).round(4).tolist()

    def pieces(self):
        """For each drawn piece: link, vertices, triangles, color. Of the faces, the one at rest."""
        for node in self.json["nodes"]:
            if node.get("extras", {}).get("mood", "idle") != "idle":
                continue
            for primitive in self.json["meshes"][node["mesh"]]["primitives"]:
                yield (node["name"], self.values(primitive["attributes"]["POSITION"]), self.values(primitive["indices"]),
                       self.color(primitive["material"]))


def as_row(matrix):
    """Position and rows of the rotation."""
    return {"position": matrix[:3, 3].tolist(), "rotation": matrix[:3, :3].tolist()}


def robot_pieces(poses, object_id):
    pieces = []
    for link, vertices, triangles, color in Glb(scenes.ROOT / "robots/appearance/baxter.glb").pieces():
        if link != UNSEEN:
            pieces.append({**as_row(poses[link]), "vertices": vertices.round(6).tolist(), "triangles": triangles.tolist(),
                           "color": color, "id": object_id})
    return pieces


def views(program):
    """The views by name, without simulator and size. Ids are those of SMILE: table, objects, robot."""
    robot = scenes.robot()
    poses = link_poses(robot["urdf"], robot["start"])
    upright = as_row(np.eye(4))["rotation"]
    boxes = [{**scenes.TABLE, "color": TABLE_COLOR}, *scenes.um(program)]
    pieces = [{"position": box["position"], "rotation": upright, "size": box["size"], "color": box["color"], "id": i + 1}
              for i, box in enumerate(boxes)]
    camera = {**as_row(poses["eye"]), "angle": EYE_ANGLE, "near": NEAR, "far": FAR}
    return {
        "UM": {"camera": camera, "pieces": pieces},
        "UM with robot": {"camera": camera, "pieces": pieces + robot_pieces(poses, len(boxes) + 1)},
    }
