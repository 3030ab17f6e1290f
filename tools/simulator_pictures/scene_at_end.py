"""Writes a scene with its objects where a run left them, and with the camera `visitor` of the pictures.

Usage: scene_at_end.py SCENE RUN OUT; RUN is what `smile run SCENE --json` printed.
"""

import json
import sys
import xml.etree.ElementTree as ElementTree

NAMESPACE = "http://synapse.cs.umd.edu/tabletop-xml"
VISITOR = {"id": "visitor", "location": "(1,-9,4)", "target": "(-3,-2.5,1.3)", "fov": "36"}


def triple(numbers):
    return "(" + ",".join(f"{number:.9f}" for number in numbers) + ")"


def main(source, run, out):
    ElementTree.register_namespace("", NAMESPACE)
    scene = ElementTree.parse(source)
    with open(run, encoding="utf-8") as file:
        objects = json.load(file)["objects"]
    for element in scene.getroot():
        end = objects[element.attrib["id"]]
        element.set("location", triple(end["position"]))
        element.set("rotation", triple(end["rotation"]))
    ElementTree.SubElement(scene.getroot(), f"{{{NAMESPACE}}}camera", VISITOR)
    scene.write(out, encoding="utf-8", xml_declaration=True)


main(*sys.argv[1:])
