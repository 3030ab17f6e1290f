"""Draws MuJoCo models: their geoms as the shapes of the studio's page."""

from __future__ import annotations

from typing import Any

import mujoco
import numpy as np

from smile.adapters.drawing import Y_TO_Z, Drawing, Visual, color_of, mesh_bytes
from smile.adapters.engine import Floats

# MuJoCo's own viewer shows these groups at first: others are usually shapes that only collide.
_NUM_GROUPS_SHOWN = 3
_PLANE_DEPTH = 0.02
_PLANE_HALF = 4.0  # of planes without an end, and at most [m]
_ROUND = 64
_MARGIN = 0.3


def drawing_of(model: Any, object_ids: dict[str, int], data: Any) -> Drawing:
    """Returns the drawing of a model. Its frames are the bodies.

    object_ids  bodies of the objects that hands can carry, by name
    data        the state at the start, from which views are chosen
    """
    parts = _Parts(model)
    for geom in range(model.ngeom):
        parts.add(geom)
    center, span = _middle(model, data, set(object_ids.values()))
    return Drawing(parts.name, model.nbody, object_ids, parts.visuals, parts.meshes, center, span,
                   sorted(set(parts.left_out)))


class _Parts:
    """Visuals and meshes of geoms, one after the other."""

    def __init__(self, model: Any) -> None:
        self.visuals: list[Visual] = []
        self.meshes: list[bytes] = []
        self.left_out: list[str] = []
        self._model = model
        self._mesh_of: dict[tuple[Any, ...], int] = {}

    @property
    def name(self) -> str:
        return self._model.names[:self._model.names.index(b"\0")].decode() or "MuJoCo"

    def add(self, geom: int) -> None:
        model = self._model
        color = model.mat_rgba[model.geom_matid[geom]] if model.geom_matid[geom] >= 0 else model.geom_rgba[geom]
        if model.geom_group[geom] >= _NUM_GROUPS_SHOWN or color[3] == 0:
            return
        kind = mujoco.mjtGeom(model.geom_type[geom])
        draw = _DRAWN.get(kind)
        if draw is None:
            self.left_out.append(f"geoms of type {kind.name.removeprefix('mjGEOM_').lower()} are not drawn")
            return
        for shape, size, position, rotation in draw(self, geom):
            self._place(geom, color_of(color), (shape, size), position, rotation)

    def _place(self, geom: int, color: str, shape: tuple[str, tuple[float, ...]], position: Any, rotation: Any) -> None:
        """Adds a shape at a pose in its geom."""
        model = self._model
        p, q = np.zeros(3), np.zeros(4)
        mujoco.mju_rotVecQuat(p, np.asarray(position, float), model.geom_quat[geom])
        mujoco.mju_mulQuat(q, model.geom_quat[geom], np.asarray(rotation, float))
        self.visuals.append(Visual(int(model.geom_bodyid[geom]), *shape, color, model.geom_pos[geom] + p, q))

    def plane(self, geom: int) -> list[Any]:
        half = [min(length or _PLANE_HALF, _PLANE_HALF) for length in self._model.geom_size[geom, :2]]
        return [("block", (2 * half[0], 2 * half[1], _PLANE_DEPTH), (0, 0, -_PLANE_DEPTH / 2), (1, 0, 0, 0))]

    def box(self, geom: int) -> list[Any]:
        return [("block", tuple(2 * self._model.geom_size[geom]), (0, 0, 0), (1, 0, 0, 0))]

    def sphere(self, geom: int) -> list[Any]:
        return [("sphere", (self._model.geom_size[geom, 0],), (0, 0, 0), (1, 0, 0, 0))]

    def cylinder(self, geom: int) -> list[Any]:
        radius, half, _ = self._model.geom_size[geom]
        return [("cylinder", (radius, 2 * half, _ROUND), (0, 0, 0), Y_TO_Z)]

    def capsule(self, geom: int) -> list[Any]:
        radius, half, _ = self._model.geom_size[geom]
        ends = [("sphere", (radius,), (0, 0, side * half), (1, 0, 0, 0)) for side in (-1, 1)]
        return self.cylinder(geom) + ends

    def ellipsoid(self, geom: int) -> list[Any]:
        size = self._model.geom_size[geom]
        number = self._mesh(("ellipsoid", *size), lambda: _ellipsoid(size))
        return [("mesh", (number,), (0, 0, 0), (1, 0, 0, 0))]

    def mesh(self, geom: int) -> list[Any]:
        mesh = self._model.geom_dataid[geom]
        number = self._mesh(("mesh", mesh), lambda: _triangles(self._model, mesh))
        return [("mesh", (number,), (0, 0, 0), (1, 0, 0, 0))]

    def _mesh(self, key: tuple[Any, ...], make: Any) -> int:
        if key not in self._mesh_of:
            self._mesh_of[key] = len(self.meshes)
            self.meshes.append(mesh_bytes(*make()))
        return self._mesh_of[key]


_DRAWN = {mujoco.mjtGeom.mjGEOM_PLANE: _Parts.plane, mujoco.mjtGeom.mjGEOM_BOX: _Parts.box,
          mujoco.mjtGeom.mjGEOM_SPHERE: _Parts.sphere, mujoco.mjtGeom.mjGEOM_CYLINDER: _Parts.cylinder,
          mujoco.mjtGeom.mjGEOM_CAPSULE: _Parts.capsule, mujoco.mjtGeom.mjGEOM_ELLIPSOID: _Parts.ellipsoid,
          mujoco.mjtGeom.mjGEOM_MESH: _Parts.mesh}


def _triangles(model: Any, mesh: int) -> tuple[Floats, Floats]:
    """Returns the corners of a mesh's triangles, and their normals."""
    faces = slice(model.mesh_faceadr[mesh], model.mesh_faceadr[mesh] + model.mesh_facenum[mesh])
    corners = model.mesh_vert[model.mesh_vertadr[mesh] + model.mesh_face[faces]]
    normals = model.mesh_normal[model.mesh_normaladr[mesh] + model.mesh_facenormal[faces]]
    return corners, normals


def _ellipsoid(size: Floats) -> tuple[Floats, Floats]:
    """Returns triangles of an ellipsoid: those of a grid of 16 by 32 on a sphere, stretched."""
    polar, around = np.meshgrid(np.linspace(0, np.pi, 17), np.linspace(0, 2 * np.pi, 33), indexing="ij")
    on_sphere = np.stack([np.sin(polar) * np.cos(around), np.sin(polar) * np.sin(around), np.cos(polar)], -1)
    a, b, c, d = on_sphere[:-1, :-1], on_sphere[1:, :-1], on_sphere[1:, 1:], on_sphere[:-1, 1:]
    unit = np.concatenate([np.stack(corners, 2).reshape(-1, 3, 3) for corners in ([a, b, c], [a, c, d])])
    normals = unit / size
    return unit * size, normals / np.linalg.norm(normals, axis=-1, keepdims=True)


def _middle(model: Any, data: Any, bodies: set[int]) -> tuple[Floats, float]:
    """Returns the point below the middle of the objects, and the length of a table for them; without, of the model."""
    geoms = [geom for geom in range(model.ngeom) if model.geom_bodyid[geom] in bodies]
    if not geoms:
        return model.stat.center.copy(), float(2 * model.stat.extent)
    turns = data.geom_xmat[geoms].reshape(-1, 3, 3)
    middles = data.geom_xpos[geoms] + np.einsum("nij,nj->ni", turns, model.geom_aabb[geoms, :3])
    halves = np.einsum("nij,nj->ni", np.abs(turns), model.geom_aabb[geoms, 3:])
    low, high = (middles - halves).min(0), (middles + halves).max(0)
    return np.array([*(low + high)[:2] / 2, low[2]]), float((high - low)[:2].max() + 2 * _MARGIN)
