"""Draws an SDFormat file with Drake, from the file's camera `visitor`, in Drake's own light.

Usage: draw_drake.py MODEL PICTURE, with Drake among the packages.
"""

import math
import sys
import xml.etree.ElementTree as ElementTree

from PIL import Image
from pydrake.common.eigen_geometry import Quaternion
from pydrake.geometry import (ClippingRange, ColorRenderCamera, MakeRenderEngineVtk, RenderCameraCore,
                              RenderEngineVtkParams, SceneGraph)
from pydrake.math import RigidTransform, RotationMatrix
from pydrake.multibody.parsing import Parser
from pydrake.multibody.plant import AddMultibodyPlantSceneGraph
from pydrake.systems.framework import DiagramBuilder
from pydrake.systems.sensors import CameraInfo

WIDTH, HEIGHT = 640, 400
BACKGROUND = (0.87, 0.89, 0.92)
STEP_SECONDS = 0.001  # no step is made
# Cameras of SDFormat look along x and have z up, those of Drake look along z and have y down.
X_SC = RigidTransform(RotationMatrix([[0, 0, 1], [-1, 0, 0], [0, -1, 0]]), [0, 0, 0])


def camera_of(source):
    """The camera that Drake's reader leaves out, and its pose X_WC."""
    sensor = ElementTree.parse(source).find(".//sensor[@name='visitor']")
    *place, x, y, z, w = map(float, sensor.find("pose").text.split())
    X_WS = RigidTransform(Quaternion(wxyz=[w, x, y, z]), place)
    image = sensor.find("camera/image")
    width, height = (int(image.find(side).text) for side in ("width", "height"))
    # The picture has the height of the file's, of whatever width.
    focal_px = width / 2 / math.tan(float(sensor.find("camera/horizontal_fov").text) / 2) * HEIGHT / height
    # With the center that it chooses itself, Drake's renderer draws half a pixel aside.
    info = CameraInfo(WIDTH, HEIGHT, focal_px, focal_px, WIDTH / 2, HEIGHT / 2)
    clip = ClippingRange(*(float(sensor.find(f"camera/clip/{end}").text) for end in ("near", "far")))
    core = RenderCameraCore("vtk", info, clip, RigidTransform())
    return ColorRenderCamera(core), X_WS @ X_SC


def main(source, picture):
    builder = DiagramBuilder()
    plant, graph = AddMultibodyPlantSceneGraph(builder, STEP_SECONDS)
    Parser(plant).AddModels(source)
    plant.Finalize()
    graph.AddRenderer("vtk", MakeRenderEngineVtk(RenderEngineVtkParams(default_clear_color=BACKGROUND)))
    diagram = builder.Build()
    context = diagram.CreateDefaultContext()
    query = graph.get_query_output_port().Eval(graph.GetMyContextFromRoot(context))
    camera, X_WC = camera_of(source)
    color = query.RenderColorImage(camera, SceneGraph.world_frame_id(), X_WC)
    Image.fromarray(color.data[:, :, :3]).save(picture, optimize=True)


main(*sys.argv[1:])
