#!/usr/bin/env python3
"""Writes scenes/meshes/: small meshes, one for each format that scenes can read.

Everything is computed, so there is nothing to be licensed and nothing to be lost. Files have y up.
"""

import json
import math
import pathlib
import struct

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "scenes" / "meshes"


def lathe(profile, segments):
    """Turns a closed outline of (radius, y), counter-clockwise, about the y axis."""
    def point(radius, y, k):
        angle = 2 * math.pi * (k % segments) / segments
        return (round(radius * math.cos(angle), 6), y, round(-radius * math.sin(angle), 6))

    triangles = []
    for (r0, y0), (r1, y1) in zip(profile, profile[1:] + profile[:1]):
        for k in range(segments):
            a, b = point(r0, y0, k), point(r0, y0, k + 1)
            c, d = point(r1, y1, k + 1), point(r1, y1, k)
            if r0 > 0:
                triangles.append((a, b, c))
            if r1 > 0:
                triangles.append((a, c, d))
    return triangles


def prism(outline, z0, z1):
    """An outline of (x, y), counter-clockwise, with its faces; the caps are single polygons."""
    n = len(outline)
    vertices = [(x, y, z0) for x, y in outline] + [(x, y, z1) for x, y in outline]
    faces = [[i, (i + 1) % n, n + (i + 1) % n, n + i] for i in range(n)]
    return vertices, faces


def write_stl(name, triangles):
    def text(p):
        return " ".join(f"{c:g}" for c in p)

    lines = [f"solid {name}"]
    for a, b, c in triangles:
        u, v = [q - p for p, q in zip(a, b)], [q - p for p, q in zip(a, c)]
        n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
        length = math.hypot(*n)
        lines.append("facet normal " + text([round(x / length, 4) + 0.0 for x in n]))
        lines += ["outer loop", *("vertex " + text(p) for p in (a, b, c)), "endloop", "endfacet"]
    lines.append(f"endsolid {name}")
    (FOLDER / f"{name}.stl").write_text("\n".join(lines) + "\n")


def write_obj(name, vertices, faces):
    lines = [f"o {name}"]
    lines += ["v " + " ".join(f"{c:g}" for c in v) for v in vertices]
    lines += ["f " + " ".join(str(i + 1) for i in f) for f in faces]
    (FOLDER / f"{name}.obj").write_text("\n".join(lines) + "\n")


def write_dae(name, vertices, faces):
    triangles = [(f[0], f[k - 1], f[k]) for f in faces for k in range(2, len(f))]
    numbers = " ".join(f"{c:g}" for v in vertices for c in v)
    corners = " ".join(str(i) for t in triangles for i in t)
    (FOLDER / f"{name}.dae").write_text(f"""<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
  <asset><unit name="meter" meter="1"/><up_axis>Y_UP</up_axis></asset>
  <library_geometries>
    <geometry id="{name}" name="{name}">
      <mesh>
        <source id="places">
          <float_array id="numbers" count="{3 * len(vertices)}">{numbers}</float_array>
          <technique_common>
            <accessor source="#numbers" count="{len(vertices)}" stride="3">
              <param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>
            </accessor>
          </technique_common>
        </source>
        <vertices id="corners"><input semantic="POSITION" source="#places"/></vertices>
        <triangles count="{len(triangles)}">
          <input semantic="VERTEX" source="#corners" offset="0"/>
          <p>{corners}</p>
        </triangles>
      </mesh>
    </geometry>
  </library_geometries>
  <library_visual_scenes>
    <visual_scene id="scene">
      <node id="node"><instance_geometry url="#{name}"/></node>
    </visual_scene>
  </library_visual_scenes>
  <scene><instance_visual_scene url="#scene"/></scene>
</COLLADA>
""")


def write_glb(name, vertices, triangles):
    places = b"".join(struct.pack("<3f", *v) for v in vertices)
    corners = b"".join(struct.pack("<3H", *t) for t in triangles)
    corners += b"\0" * (-len(corners) % 4)
    low = [min(v[i] for v in vertices) for i in range(3)]
    high = [max(v[i] for v in vertices) for i in range(3)]
    text = json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"name": name, "mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": len(vertices), "type": "VEC3",
             "min": low, "max": high},
            {"bufferView": 1, "componentType": 5123, "count": 3 * len(triangles),
             "type": "SCALAR"}],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": len(places)},
            {"buffer": 0, "byteOffset": len(places), "byteLength": len(corners)}],
        "buffers": [{"byteLength": len(places) + len(corners)}]}).encode()
    text += b" " * (-len(text) % 4)
    binary = places + corners
    chunks = struct.pack("<I4s", len(text), b"JSON") + text
    chunks += struct.pack("<I4s", len(binary), b"BIN\0") + binary
    (FOLDER / f"{name}.glb").write_bytes(struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks)


def main():
    FOLDER.mkdir(parents=True, exist_ok=True)
    # A cup: outside up, over the rim, down inside.
    write_stl("cup", lathe([(0, -0.6), (0.45, -0.6), (0.6, 0.6), (0.52, 0.6), (0.38, -0.5), (0, -0.5)],
                           24))
    # An L. Its caps are two quadrilaterals each, that share the inner corner.
    outline = [(-0.5, -0.5), (0.7, -0.5), (0.7, -0.3), (-0.3, -0.3), (-0.3, 0.7), (-0.5, 0.7)]
    vertices, faces = prism(outline, -0.3, 0.3)
    write_obj("bracket", vertices, faces + [[3, 2, 1, 0], [5, 4, 3, 0], [6, 7, 8, 9], [6, 9, 10, 11]])
    outline = [(-0.6, -0.25), (0.6, -0.25), (-0.6, 0.5)]
    vertices, faces = prism(outline, -0.4, 0.4)
    write_dae("wedge", vertices, faces + [[2, 1, 0], [3, 4, 5]])
    # A gem: six sides between two points.
    ring = [(0.4 * math.cos(k * math.pi / 3), 0.0, -0.4 * math.sin(k * math.pi / 3)) for k in range(6)]
    vertices = ring + [(0.0, 0.5, 0.0), (0.0, -0.3, 0.0)]
    triangles = [(k, (k + 1) % 6, 6) for k in range(6)] + [((k + 1) % 6, k, 7) for k in range(6)]
    write_glb("gem", vertices, triangles)


if __name__ == "__main__":
    main()
