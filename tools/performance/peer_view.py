"""Draws one view in another simulator, and prints what it costs.

Run by tools/measure_performance.py with the Python of build/peers. Reads a problem from stdin:

    {"renderer": one of RENDERERS, "view": a name in views.py, "size": [width, height] in pixels,
     "seconds": seconds to measure, "program": path of SMILE,
     "picture": path of the picture that SMILE makes of the view, with its ids and depths beside it}

All that can be switched off and SMILE's eye does not draw is off: shadows, reflections, the sky,
smooth edges. A picture has color, depth [m] and the id of the object in each pixel. Prints a JSON
object with CPU time of all threads and wall-clock time, in ms per picture, the fraction of pixels
that show the same object as SMILE's, and the median difference of their depths [mm].
"""

import importlib.util
import json
import os
import sys
import tempfile
import time
import xml.etree.ElementTree as ET

os.environ.setdefault("MUJOCO_GL", "egl")

import numpy as np
from PIL import Image

from performance import views


def words(numbers):
    return " ".join(repr(float(number)) for number in np.asarray(numbers).ravel())


class MuJoCo:
    """Bare calls: one pass for color and depth, one for ids."""

    def __init__(self, problem):
        import mujoco
        self.mujoco = mujoco
        self.width, self.height = problem["size"]
        self.near, self.far = (np.float32(problem["camera"][plane]) for plane in ("near", "far"))
        self.model = mujoco.MjModel.from_xml_string(self._mjcf(problem))
        self.data = mujoco.MjData(self.model)
        mujoco.mj_forward(self.model, self.data)
        self.renderer = mujoco.Renderer(self.model, self.height, self.width)
        scene = self.renderer.scene
        for flag in ("SHADOW", "REFLECTION", "SKYBOX", "HAZE", "FOG"):
            scene.flags[getattr(mujoco.mjtRndFlag, "mjRND_" + flag)] = 0
        # The id of our object for each geom, and for the background.
        self.ids = np.zeros(256, np.uint32)
        self.ids[1:1 + len(problem["pieces"])] = [piece["id"] for piece in problem["pieces"]]
        self.color, self.segments = (np.empty((self.height, self.width, 3), np.uint8) for _ in range(2))
        self.depth = np.empty((self.height, self.width), np.float32)

    def _mjcf(self, problem):
        camera = problem["camera"]
        root = ET.Element("mujoco")
        # The camera's planes are in multiples of the extent.
        ET.SubElement(root, "statistic", extent="1")
        visual = ET.SubElement(root, "visual")
        ET.SubElement(visual, "global", offwidth=str(self.width), offheight=str(self.height))
        ET.SubElement(visual, "quality", offsamples="0")
        ET.SubElement(visual, "map", znear=str(camera["near"]), zfar=str(camera["far"]))
        assets, world = ET.SubElement(root, "asset"), ET.SubElement(root, "worldbody")
        # MuJoCo's cameras look along -z, with y up.
        turn = np.asarray(camera["rotation"])
        ET.SubElement(world, "camera", name="eye", fovy=str(camera["angle"]), pos=words(camera["position"]),
                      xyaxes=words([turn[:, 0], -turn[:, 1]]))
        for i, piece in enumerate(problem["pieces"]):
            turn = np.asarray(piece["rotation"])
            geom = ET.SubElement(world, "geom", pos=words(piece["position"]), xyaxes=words([turn[:, 0], turn[:, 1]]),
                                 rgba=words([*piece["color"], 1]), contype="0", conaffinity="0")
            if "size" in piece:
                geom.set("type", "box")
                geom.set("size", words(np.asarray(piece["size"]) / 2))
            else:
                geom.set("type", "mesh")
                geom.set("mesh", f"mesh{i}")
                ET.SubElement(assets, "mesh", name=f"mesh{i}", vertex=words(piece["vertices"]), inertia="shell",
                              face=" ".join(str(corner) for triangle in piece["triangles"] for corner in triangle))
        return ET.tostring(root, encoding="unicode")

    def draw(self):
        """Color, depth and ids. Rows are turned over without copying."""
        m, r, scene = self.mujoco, self.renderer, self.renderer.scene
        r.update_scene(self.data, "eye")
        m.mjr_render(r._rect, scene, r._mjr_context)
        m.mjr_readPixels(self.color, self.depth, r._rect, r._mjr_context)
        scene.flags[m.mjtRndFlag.mjRND_SEGMENT] = scene.flags[m.mjtRndFlag.mjRND_IDCOLOR] = 1
        m.mjr_render(r._rect, scene, r._mjr_context)
        m.mjr_readPixels(self.segments, None, r._rect, r._mjr_context)
        scene.flags[m.mjtRndFlag.mjRND_SEGMENT] = scene.flags[m.mjtRndFlag.mjRND_IDCOLOR] = 0
        # In the buffer 1 is near and 0 far.
        depth = self.near * self.far / (self.near + self.depth * (self.far - self.near))
        return self.color[::-1], depth[::-1], self.ids[self.segments[::-1, :, 0]]


class MuJoCoRenderer(MuJoCo):
    """The documented way: mujoco.Renderer, one pass for each channel."""

    def draw(self):
        r = self.renderer
        r.update_scene(self.data, "eye")
        color = r.render()
        r.enable_depth_rendering()
        depth = r.render()
        r.enable_segmentation_rendering()
        geoms = r.render()[:, :, 0]
        r.disable_segmentation_rendering()
        return color, depth, self.ids[geoms + 1]


class PyBullet:
    """TinyRenderer, without OpenGL."""

    def __init__(self, problem):
        import pybullet
        self.p = p = pybullet
        self.client = p.connect(p.DIRECT)
        camera = problem["camera"]
        self.width, self.height = problem["size"]
        self.near, self.far = (np.float32(camera[plane]) for plane in ("near", "far"))
        position, turn = np.asarray(camera["position"]), np.asarray(camera["rotation"])
        self.view = p.computeViewMatrix(position.tolist(), (position + turn[:, 2]).tolist(), (-turn[:, 1]).tolist())
        self.projection = p.computeProjectionMatrixFOV(camera["angle"], self.width / self.height, camera["near"], camera["far"])
        self.prepare()
        # The id of our object for each body; the last entry, -1, is the background.
        self.ids = np.zeros(len(problem["pieces"]) + 1, np.uint32)
        with tempfile.TemporaryDirectory() as folder:
            for i, piece in enumerate(problem["pieces"]):
                body = p.createMultiBody(0, -1, self._shape(piece, os.path.join(folder, f"{i}.obj")), piece["position"],
                                         quaternion(np.asarray(piece["rotation"])))
                self.ids[body] = piece["id"]

    def prepare(self):
        pass

    def _shape(self, piece, path):
        color = [*piece["color"], 1]
        if "size" in piece:
            return self.p.createVisualShape(self.p.GEOM_BOX, halfExtents=[s / 2 for s in piece["size"]], rgbaColor=color)
        with open(path, "w") as file:
            file.writelines(f"v {words(vertex)}\n" for vertex in piece["vertices"])
            file.writelines(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in piece["triangles"])
        return self.p.createVisualShape(self.p.GEOM_MESH, fileName=path, rgbaColor=color)

    def draw(self):
        _, _, color, depth, bodies = self.p.getCameraImage(
            self.width, self.height, self.view, self.projection, shadow=0, renderer=self.kind())
        depth = self.near * self.far / (self.far - depth * (self.far - self.near))
        return color[:, :, :3], depth, self.ids[bodies]

    def kind(self):
        return self.p.ER_TINY_RENDERER


class PyBulletEgl(PyBullet):
    """OpenGL through PyBullet's plugin."""

    def prepare(self):
        plugin = importlib.util.find_spec("eglRenderer").origin
        if self.p.loadPlugin(plugin, "_eglRendererPlugin") < 0:
            sys.exit("PyBullet's eglRenderer does not run here")

    def kind(self):
        return self.p.ER_BULLET_HARDWARE_OPENGL


def quaternion(turn):
    """x, y, z, w of a rotation matrix: the eigenvector of its largest eigenvalue (I. Bar-Itzhack, 2000)."""
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = turn
    _, vectors = np.linalg.eigh(np.array([[xx - yy - zz, yx + xy, zx + xz, zy - yz], [yx + xy, yy - xx - zz, zy + yz, xz - zx],
                                          [zx + xz, zy + yz, zz - xx - yy, yx - xy], [zy - yz, xz - zx, yx - xy, xx + yy + zz]]))
    return vectors[:, -1].tolist()


RENDERERS = {"mujoco": MuJoCo, "mujoco renderer": MuJoCoRenderer, "pybullet": PyBullet, "pybullet egl": PyBulletEgl}


def likeness(picture, depth, ids):
    """How alike this picture and SMILE's are."""
    stem = os.path.splitext(picture)[0]
    their_ids = np.asarray(Image.open(stem + ".id.png"))
    same = (ids == their_ids) & (ids > 0)
    their_depth = np.asarray(Image.open(stem + ".depth.png")) / 10  # [mm]
    return {"same_ids": float(np.mean(ids == their_ids)),
            "depth_error_mm": float(np.median(abs(1000 * depth - their_depth)[same]))}


def main():
    problem = json.load(sys.stdin)
    problem.update(views.views(problem["program"])[problem["view"]])
    renderer = RENDERERS[problem["renderer"]](problem)
    _, depth, ids = renderer.draw()
    alike = likeness(problem["picture"], depth, ids)
    renderer.draw()
    count, wall, cpu = 0, time.perf_counter(), time.process_time()
    while count < 2 or time.perf_counter() - wall < problem["seconds"]:
        renderer.draw()
        count += 1
    wall, cpu = time.perf_counter() - wall, time.process_time() - cpu
    # Libraries may print, too: the result is the last line.
    print("\n" + json.dumps({"cpu_ms": 1000 * cpu / count, "wall_ms": 1000 * wall / count, **alike}), flush=True)
    # The plugins of some simulators do not end cleanly.
    os._exit(0)


main()
