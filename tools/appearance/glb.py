"""Writes the appearance of a robot as binary glTF 2.0.

Each node is named after the link it is fixed to and drawn in that link's frame; a mesh may hang on several nodes (both
arms share theirs). A node with the extra `mood` is visible only while the robot's face shows that mood.
Source: Khronos Group, "glTF 2.0 Specification" (2021).
"""

import json
import struct
from dataclasses import dataclass

import numpy as np

FLOAT, UNSIGNED_SHORT = 5126, 5123
ARRAY_BUFFER, ELEMENT_ARRAY_BUFFER = 34962, 34963


@dataclass(frozen=True)
class Piece:
    """All of a link that has one color (sRGB, 0 to 1)."""

    color: tuple
    surface: object


@dataclass(frozen=True)
class Part:
    """Pieces that are fixed to each of some links."""

    links: tuple
    pieces: list
    mood: str = ""


def linear(channel):
    """An sRGB channel in the linear space that glTF's materials use (IEC 61966-2-1)."""
    return channel / 12.92 if channel <= 0.04045 else ((channel + 0.055) / 1.055) ** 2.4


class Buffer:
    """The binary chunk with its views and accessors."""

    def __init__(self):
        self.bytes, self.views, self.accessors = bytearray(), [], []

    def add(self, array, target, component_type, kind, **limits):
        self.bytes += b"\0" * (-len(self.bytes) % 4)
        self.views.append({"buffer": 0, "byteOffset": len(self.bytes), "byteLength": array.nbytes, "target": target})
        self.accessors.append({"bufferView": len(self.views) - 1, "componentType": component_type,
                               "count": len(array), "type": kind, **limits})
        self.bytes += array.tobytes()
        return len(self.accessors) - 1

    def add_surface(self, surface):
        positions = np.array(surface.vertices, dtype="<f4")
        assert len(positions) < 65536
        indices = np.array(surface.triangles, dtype="<u2").reshape(-1)
        return {"attributes": {"POSITION": self.add(positions, ARRAY_BUFFER, FLOAT, "VEC3",
                                                    min=positions.min(axis=0).tolist(),
                                                    max=positions.max(axis=0).tolist())},
                "indices": self.add(indices, ELEMENT_ARRAY_BUFFER, UNSIGNED_SHORT, "SCALAR")}


def write(path, parts):
    buffer, nodes, meshes, colors = Buffer(), [], [], []
    for part in parts:
        primitives = []
        for piece in part.pieces:
            if piece.color not in colors:
                colors.append(piece.color)
            primitives.append({**buffer.add_surface(piece.surface), "material": colors.index(piece.color)})
        meshes.append({"primitives": primitives})
        for link in part.links:
            nodes.append({"name": link, "mesh": len(meshes) - 1} | ({"extras": {"mood": part.mood}} if part.mood else {}))
    materials = [{"pbrMetallicRoughness": {"baseColorFactor": [*map(linear, color), 1], "metallicFactor": 0}}
                 for color in colors]
    content = {"asset": {"version": "2.0", "generator": "tools/make_robot_appearance.py"}, "scene": 0,
               "scenes": [{"nodes": list(range(len(nodes)))}], "nodes": nodes, "meshes": meshes,
               "materials": materials, "accessors": buffer.accessors, "bufferViews": buffer.views,
               "buffers": [{"byteLength": len(buffer.bytes)}]}
    text = json.dumps(content, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    binary = bytes(buffer.bytes) + b"\0" * (-len(buffer.bytes) % 4)
    header = struct.pack("<4sII", b"glTF", 2, 12 + 8 + len(text) + 8 + len(binary))
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(header + struct.pack("<I4s", len(text), b"JSON") + text
                     + struct.pack("<I4s", len(binary), b"BIN\0") + binary)
