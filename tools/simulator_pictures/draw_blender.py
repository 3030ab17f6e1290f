"""Draws a USD file with Blender's renderer Cycles, from its camera `visitor`, in its own light and some from all around.

Usage: draw_blender.py MODEL PICTURE, with Blender's package bpy among the packages.
"""

import sys

import bpy

WIDTH, HEIGHT = 640, 400
BACKGROUND = (0.16, 0.18, 0.2, 1)  # in proportion to light
SAMPLES = 64  # per pixel
# Blender 4.5 reads a sun of n lux as one of 4 n W/m2, which is four times as bright in its pictures.
LIGHT_SCALE = 0.25


def paint(meshes):
    """Shows meshes in their attribute `displayColor`: of boxes, Blender reads it, but not their materials."""
    material = bpy.data.materials.new("display_color")
    material.use_nodes = True
    tree = material.node_tree
    color = tree.nodes.new("ShaderNodeAttribute")
    color.attribute_name = "displayColor"
    surface = tree.nodes["Principled BSDF"]
    surface.inputs["Roughness"].default_value = 1
    tree.links.new(color.outputs["Color"], surface.inputs["Base Color"])
    for mesh in meshes:
        mesh.materials.append(material)


def light_from_all_around():
    world = bpy.data.worlds.new("surroundings")
    world.use_nodes = True
    world.node_tree.nodes["Background"].inputs["Color"].default_value = BACKGROUND
    return world


def main(source, picture):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.wm.usd_import(filepath=source, light_intensity_scale=LIGHT_SCALE)
    paint(bpy.data.meshes)
    scene = bpy.context.scene
    scene.world = light_from_all_around()
    scene.camera = bpy.data.objects["visitor"]
    scene.camera.data.sensor_fit = "VERTICAL"  # the picture has the height of the file's, of whatever width
    scene.view_settings.view_transform = "Standard"
    scene.render.engine = "CYCLES"
    scene.cycles.samples = SAMPLES
    scene.render.resolution_x, scene.render.resolution_y = WIDTH, HEIGHT
    scene.render.dither_intensity = 0
    scene.render.image_settings.color_mode = "RGB"
    scene.render.filepath = picture
    bpy.ops.render.render(write_still=True)


main(*sys.argv[1:])
