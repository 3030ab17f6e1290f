"""Pictures of a real camera as a simulated one would take them: of another size, and without distortion."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from smile.ros.link import CameraReading
from smile.simulation import Floats

_SAME_PIXELS = 1e-3
"""greatest difference between two intrinsics of the same camera [px]"""
_SAME_DISTORTION = 1e-6
_MOST_ZOOM = 1.5
"""a lens that needs a narrower view shows too little"""

Pixels = npt.NDArray[np.uint8]
Depths = npt.NDArray[np.float32]


class CameraView:
    """The largest view of a pinhole camera, in the middle of what a real camera sees.

    Where the camera has more pixels, several are averaged.

    intrinsics  (3, 3) of the camera [px], counted from the center of the first pixel, as in ROS
    distortion  (5,) coefficients of ROS' plumb_bob
    source      width and height of its pictures [px]
    size        width and height of the view [px]

    Raises ValueError if the camera has fewer pixels, or its lens does not show such a view.
    """

    def __init__(self, intrinsics: Floats, distortion: Floats, source: tuple[int, int], size: tuple[int, int]) -> None:
        self.size, self._source = size, source
        self._K, self._D = intrinsics, distortion
        scale = max(size[0] / source[0], size[1] / source[1])
        if scale > 1:
            raise ValueError(f"the camera has {source[0]} x {source[1]} pixels, expected at least {size[0]} x {size[1]}: choose a "
                             "smaller --size")
        self._samples = int(np.ceil(1 / scale - 1e-9))
        for zoom in np.arange(1, _MOST_ZOOM, 0.01):
            self.intrinsics = self._pinhole(scale * float(zoom))
            """(3, 3) [px], counted from the corner of the first pixel, as in SMILE"""
            grids = [self._source_pixels(x, y) for x, y in self._offsets()]
            if all(self._is_inside(u, v) for u, v in grids):
                break
        else:
            raise ValueError(f"the lens distorts so much (D is {', '.join(f'{one:.3g}' for one in distortion)}) that no view without "
                             f"distortion has more than {1 / _MOST_ZOOM:.0%} of its width")
        self._grids = [_bilinear(u, v, source) for u, v in grids]
        u, v = self._source_pixels(0.5, 0.5)
        self._nearest = (np.clip(np.rint(v), 0, source[1] - 1).astype(int), np.clip(np.rint(u), 0, source[0] - 1).astype(int))

    def _pinhole(self, scale: float) -> Floats:
        """Returns the intrinsics of the view, whose middle is that of the camera's pictures."""
        K = self._K.copy()
        K[:2] *= scale
        for axis in (0, 1):
            center = self._K[axis, 2] + 0.5 - self._source[axis] / 2
            K[axis, 2] = self.size[axis] / 2 + scale * center
        return K

    def _offsets(self) -> list[tuple[float, float]]:
        steps = (np.arange(self._samples) + 0.5) / self._samples
        return [(float(x), float(y)) for y in steps for x in steps]

    def _source_pixels(self, x: float, y: float) -> tuple[Floats, Floats]:
        """Returns where the places (x, y) within all pixels of the view are in the camera's pictures [px].

        Source: OpenCV's documentation of calib3d, "Detailed Description" (radial and tangential distortion).
        """
        K = self.intrinsics
        a, b = np.meshgrid((np.arange(self.size[0]) + x - K[0, 2]) / K[0, 0], (np.arange(self.size[1]) + y - K[1, 2]) / K[1, 1])
        k1, k2, p1, p2, k3 = self._D
        r2 = a * a + b * b
        radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3))
        # Where the radius no longer grows with that of the scene, the polynomial means nothing.
        radial = np.where(1 + r2 * (3 * k1 + r2 * (5 * k2 + r2 * 7 * k3)) > 0, radial, np.inf)
        u = a * radial + 2 * p1 * a * b + p2 * (r2 + 2 * a * a)
        v = b * radial + p1 * (r2 + 2 * b * b) + 2 * p2 * a * b
        return self._K[0, 0] * u + self._K[0, 2], self._K[1, 1] * v + self._K[1, 2]

    def _is_inside(self, u: Floats, v: Floats) -> bool:
        low, high = -0.5 - _SAME_PIXELS, np.array(self._source) - 0.5 + _SAME_PIXELS
        return bool(u.min() >= low and v.min() >= low and u.max() <= high[0] and v.max() <= high[1])

    def fault_of(self, seen: CameraReading) -> str | None:
        """Returns why a picture is not of this camera; None if it is."""
        height, width, _ = seen.rgb.shape
        if (width, height) != self._source:
            return f"a picture has {width} x {height} pixels, expected {self._source[0]} x {self._source[1]}"
        if seen.depth is not None and seen.depth.shape != seen.rgb.shape[:2]:
            return f"the depths have {seen.depth.shape[1]} x {seen.depth.shape[0]} pixels, expected {width} x {height}, as the picture"
        if not is_same_camera(seen, self._K, self._D):
            return "camera_info has other intrinsics than at the start: focus or zoom of the camera have changed"
        return None

    def picture(self, rgb: Pixels) -> Pixels:
        """Returns the view of a (height, width, 3) picture."""
        total = np.zeros((self.size[1], self.size[0], 3), np.float32)
        for rows, columns, weights in self._grids:
            for row, column, weight in zip(rows, columns, weights):
                total += weight[..., None] * rgb[row, column]
        return np.asarray(np.rint(total / len(self._grids)), np.uint8)

    def depths(self, depth: Depths) -> Depths:
        """Returns the depths in the middle of the pixels of the view, from (height, width) ones [m]."""
        return np.ascontiguousarray(depth[self._nearest])


def _bilinear(u: Floats, v: Floats, source: tuple[int, int]) -> tuple[list[Any], list[Any], list[Any]]:
    """Returns rows, columns and weights of the four pixels around places in a picture; those of weight 0 are left out."""
    u, v = np.clip(u, 0, source[0] - 1), np.clip(v, 0, source[1] - 1)
    # Places that are in the middle of pixels but for rounding are there.
    u, v = (np.where(np.abs(one - np.rint(one)) < 1e-6, np.rint(one), one) for one in (u, v))
    left, top = np.floor(u).astype(int), np.floor(v).astype(int)
    s, t = (u - left).astype(np.float32), (v - top).astype(np.float32)
    corners = [(top + y, left + x, (s if x else 1 - s) * (t if y else 1 - t)) for y in (0, 1) for x in (0, 1)]
    kept = [(np.minimum(row, source[1] - 1), np.minimum(column, source[0] - 1), weight)
            for row, column, weight in corners if weight.any()]
    rows, columns, weights = zip(*kept)
    return list(rows), list(columns), list(weights)


def is_same_camera(seen: CameraReading, intrinsics: Floats, distortion: Floats) -> bool:
    """Returns whether a picture has these intrinsics (3, 3) [px] and this distortion (5,)."""
    return (bool(np.abs(seen.intrinsics - intrinsics).max() <= _SAME_PIXELS)
            and bool(np.abs(seen.distortion - distortion).max() <= _SAME_DISTORTION))
