"""Where a real table and a camera are: from touched points, and from a picture of a printed board.

Frames: W world (origin in the middle of the table's top), B the robot's base, P the board, C a camera (x right, y down,
z forward). The origin of P is the first inner corner of the board, x goes along its rows, y along its columns; z goes
into the paper.
"""

from __future__ import annotations

import json
import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from smile.simulation import Floats

FORMAT = 1
LEAST_POINTS = 4
"""points on a table: three fit each plane"""
MOST_POINTS = 1000
SPREAD = 0.05
"""least root mean square of the distances of the points from the line that fits them best [m]"""
RESIDUAL = 0.005
"""greatest root mean square of the distances of touched points from where they should be [m]"""
PIXELS = 1.5
"""the same of corners in a picture [px]"""
FLIP = 2.0
"""so many times better must the pose of the board fit than its mirror image"""
HEIGHT = 0.005
"""greatest difference of the table's height from the scene's for a performance [m]"""
_MOST_BYTES = 4 << 20


def points_of(value: Any, what: str, least: int) -> Floats:
    """Returns (n, 3) points [m] of a JSON value; ValueError if they are fewer, or not numbers."""
    is_right = isinstance(value, list) and all(
        isinstance(row, list) and len(row) == 3
        and all(isinstance(one, (int, float)) and not isinstance(one, bool) and math.isfinite(one) for one in row)
        for row in value)
    if not is_right:
        raise ValueError(f"{what}: expected a list of points [x, y, z] of finite numbers")
    if not least <= len(value) <= MOST_POINTS:
        raise ValueError(f"{what}: has {len(value)} points, expected {least} to {MOST_POINTS}")
    return np.array(value, float).reshape(-1, 3)


@dataclass(frozen=True)
class Plane:
    """A plane through touched points."""

    middle: Floats
    """(3,) of the points [m]"""
    normal: Floats
    """(3,) unit vector, upwards"""
    residual: float
    """root mean square of the distances of the points from it [m]"""

    def height(self, x: float, y: float) -> float:
        """Returns z at a place [m]."""
        return float(self.middle[2] - (self.normal[:2] @ (np.array([x, y]) - self.middle[:2])) / self.normal[2])

    @property
    def tilt(self) -> float:
        """Angle from the horizontal [rad]"""
        return float(np.arccos(np.clip(self.normal[2], -1, 1)))


def plane_of(points: Floats) -> Plane:
    """Returns the plane that fits points best (least squares of the distances).

    Raises ValueError if they are too few or near a line, or are not on a plane.
    """
    if len(points) < LEAST_POINTS:
        raise ValueError(f"the table was touched at {len(points)} points, expected at least {LEAST_POINTS}")
    middle = points.mean(axis=0)
    _, sizes, axes = np.linalg.svd(points - middle, full_matrices=False)
    spread = sizes[1] / math.sqrt(len(points))
    if spread < SPREAD:
        raise ValueError(f"the points on the table are near a line: {1000 * spread:.0f} mm from it (root mean square), "
                         f"expected at least {1000 * SPREAD:.0f} mm")
    residual = float(sizes[2] / math.sqrt(len(points)))
    if residual > RESIDUAL:
        raise ValueError(f"the points on the table are {1000 * residual:.1f} mm from a plane (root mean square), expected at most "
                         f"{1000 * RESIDUAL:.0f} mm")
    return Plane(middle, axes[2] * (1 if axes[2, 2] >= 0 else -1), residual)


@dataclass(frozen=True)
class Board:
    """A printed chessboard. One of the two counts is even and the other odd, so that it has one orientation only."""

    columns: int = 9
    """inner corners in a row"""
    rows: int = 6
    square: float = 0.024
    """side of a square [m]"""

    def __post_init__(self) -> None:
        if not (3 <= self.columns <= 40 and 3 <= self.rows <= 40 and (self.columns + self.rows) % 2 == 1):
            raise ValueError(f"the board has {self.columns} x {self.rows} inner corners, expected 3 to 40 each, one of them even "
                             "and the other odd")
        if not 0.005 <= self.square <= 0.2:
            raise ValueError(f"the squares of the board are {self.square} m wide, expected 0.005 to 0.2")

    def corners(self) -> Floats:
        """Returns the (n, 3) inner corners in P, row by row [m]."""
        return np.array([[x, y, 0] for y in range(self.rows) for x in range(self.columns)], float) * self.square

    def outermost(self) -> Floats:
        """Returns the (4, 3) inner corners to be touched, in P [m]: the first one, then around as in reading a page:
        the end of the first row, the end of the last one, and its beginning."""
        x, y = self.columns - 1, self.rows - 1
        return np.array([[0, 0, 0], [x, 0, 0], [x, y, 0], [0, y, 0]], float) * self.square

    def svg(self) -> str:
        """Returns the board as a picture to scale, for a printer: 1 unit is 1 mm. The square at its first corner is black."""
        side, margin = 1000 * self.square, 10.0
        width, height = (self.columns + 1) * side + 2 * margin, (self.rows + 1) * side + 2 * margin + 8
        squares = [f'<rect x="{margin + x * side:g}" y="{margin + y * side:g}" width="{side:g}" height="{side:g}"/>'
                   for y in range(self.rows + 1) for x in range(self.columns + 1) if (x + y) % 2 == 0]
        words = (f"{self.columns} x {self.rows} inner corners, squares of {side:g} mm: measure one after printing. "
                 "Touch 1: the inner corner at the top left, then clockwise.")
        return "\n".join([
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:g}mm" height="{height:g}mm" viewBox="0 0 {width:g} {height:g}">',
            f'<rect width="{width:g}" height="{height:g}" fill="white"/>', *squares,
            f'<text x="{margin:g}" y="{height - 7:g}" font-family="sans-serif" font-size="4">{words}</text>', "</svg>", ""])


def pose_of_touched(board: Board, touched: Floats) -> tuple[Floats, float]:
    """Returns the board's pose (4, 4) in the frame of its touched corners, and their residual [m].

    touched  (4, 3): the corners that `Board.outermost` names, in that order

    Source: K. S. Arun et al., "Least-Squares Fitting of Two 3-D Point Sets" (1987). Raises ValueError if they do not fit.
    """
    if touched.shape != (4, 3):
        raise ValueError(f"the board was touched at {len(touched)} corners, expected 4")
    model = board.outermost()
    from_middle, touched_from_middle = model - model.mean(axis=0), touched - touched.mean(axis=0)
    u, _, vt = np.linalg.svd(from_middle.T @ touched_from_middle)
    mirror = np.diag([1, 1, np.sign(np.linalg.det(vt.T @ u.T))])
    X = np.eye(4)
    X[:3, :3] = vt.T @ mirror @ u.T
    X[:3, 3] = touched.mean(axis=0) - X[:3, :3] @ model.mean(axis=0)
    residual = float(np.sqrt(((touched_from_middle - from_middle @ X[:3, :3].T) ** 2).sum(axis=1).mean()))
    if residual > RESIDUAL:
        raise ValueError(f"the touched corners of the board are {1000 * residual:.1f} mm from where they should be (root mean square), "
                         f"expected at most {1000 * RESIDUAL:.0f} mm: their order, or the size of the squares, is another one")
    return X, residual


def corners_in(board: Board, gray: npt.NDArray[np.uint8]) -> Floats:
    """Returns the (n, 2) inner corners of the board in a picture [px], in the order of Board.corners()."""
    import cv2
    found, corners = cv2.findChessboardCornersSB(gray, (board.columns, board.rows), flags=cv2.CALIB_CB_ACCURACY)
    if not found:
        raise ValueError(f"no board with {board.columns} x {board.rows} inner corners is in the picture, all of it visible")
    corners = np.asarray(corners, float).reshape(board.rows, board.columns, 2)
    # The square at the first corner is black, and that at the last one, between the last two rows, is white.
    middle = corners[:2, :2].mean(axis=(0, 1)), corners[-2:, -2:].mean(axis=(0, 1))
    first, last = (int(gray[int(round(y)), int(round(x))]) for x, y in middle)
    # Inside of the first corner lies the square (1, 1), which is black as (0, 0).
    return (corners if first < last else corners[::-1, ::-1]).reshape(-1, 2)


def pose_in_camera(board: Board, corners: Floats, intrinsics: Floats, distortion: Floats) -> tuple[Floats, float]:
    """Returns the board's pose X_CP (4, 4), and the residual of its corners in the picture [px].

    intrinsics  (3, 3) [px]
    distortion  (5,) coefficients of ROS' plumb_bob

    Source: T. Collins, A. Bartoli, "Infinitesimal Plane-Based Pose Estimation" (2014). Raises ValueError if the mirror
    image of the pose fits nearly as well, or nothing does.
    """
    import cv2
    model = board.corners()
    # IPPE's object points are centered by OpenCV itself.
    count, turns, shifts, errors = cv2.solvePnPGeneric(model, corners, intrinsics, distortion, flags=cv2.SOLVEPNP_IPPE)
    if count == 0:
        raise ValueError("no pose of the board fits its corners in the picture")
    worst = np.ravel(errors)
    turn, shift = cv2.solvePnPRefineLM(model, corners, intrinsics, distortion, turns[0], shifts[0])
    shown, _ = cv2.projectPoints(model, turn, shift, intrinsics, distortion)
    residual = float(np.sqrt(((shown.reshape(-1, 2) - corners) ** 2).sum(axis=1).mean()))
    if not residual <= PIXELS:
        raise ValueError(f"the corners of the board are {residual:.2f} px from where they should be (root mean square), expected at most "
                         f"{PIXELS:g} px: the intrinsics or the size of the squares are another one")
    if count > 1 and worst[1] < FLIP * max(worst[0], 0.05):
        raise ValueError("the board could as well be tilted the other way: show it larger, or more obliquely")
    X = np.eye(4)
    X[:3, :3], X[:3, 3] = cv2.Rodrigues(turn)[0], np.ravel(shift)
    return X, residual


def read_json(path: str) -> dict[str, Any]:
    """Returns the object in a file; ValueError if there is none."""
    if Path(path).stat().st_size > _MOST_BYTES:
        raise ValueError(f"{path}: is larger than {_MOST_BYTES >> 20} MB")
    try:
        value = json.loads(Path(path).read_bytes())
    except (ValueError, RecursionError) as error:
        raise ValueError(f"{path}: is not JSON: {error}"[:300]) from None
    if not isinstance(value, dict):
        raise ValueError(f"{path}: expected a JSON object")
    return value


def table_fault(cell: dict[str, Any], robot: str, size: tuple[float, float]) -> str | None:
    """Returns why a robot must not perform at the table of a calibration; None if it may.

    cell   a file that `smile ros calibrate` wrote
    robot  of the recording
    size   width and depth of the scene's table [m]

    Raises ValueError if it is no such file.
    """
    table = cell.get("table")
    if cell.get("format") != FORMAT or not isinstance(table, dict):
        raise ValueError(f"format is {cell.get('format')!r}, with the members {', '.join(cell)[:100]}: expected format {FORMAT} with a table")
    if cell.get("robot") != robot:
        return f"the calibration is that of the robot {cell.get('robot')!r}, expected {robot!r}"
    middle, normal = (points_of([table.get(name)], f"table.{name}", 1)[0] for name in ("middle", "normal"))
    if not 0.5 < normal[2] <= 1:
        raise ValueError(f"table.normal is {normal.tolist()}, expected a unit vector upwards")
    plane = Plane(middle, normal, 0)
    heights = [plane.height(x * size[0] / 2, y * size[1] / 2) for x in (-1, 1) for y in (-1, 1)]
    worst = max(heights, key=abs)
    if abs(worst) > HEIGHT:
        return (f"the real table is {1000 * abs(worst):.0f} mm {'higher' if worst > 0 else 'lower'} at a corner than that of the scene, "
                f"expected at most {1000 * HEIGHT:.0f} mm: move the table, or the robot")
    return None
