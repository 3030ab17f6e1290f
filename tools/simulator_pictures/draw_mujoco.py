"""Draws a model with MuJoCo's own renderer, from its camera `visitor`.

Usage: MUJOCO_GL=egl draw_mujoco.py MODEL PICTURE, with MuJoCo and PyOpenGL among the packages.
"""

import sys

import mujoco
from PIL import Image

WIDTH, HEIGHT = 640, 400


def main(source, picture):
    model = mujoco.MjModel.from_xml_path(source)
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    with mujoco.Renderer(model, HEIGHT, WIDTH) as renderer:
        renderer.update_scene(data, camera="visitor")
        Image.fromarray(renderer.render()).save(picture, optimize=True)


main(*sys.argv[1:])
