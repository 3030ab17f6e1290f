"""The commands `smile ros board`, `touch` and `calibrate`: measurements of a real table and a camera."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

import numpy as np

from smile.picture import Picture
from smile.ros.calibration import (FORMAT, LEAST_POINTS, Board, corners_in, plane_of, points_of, pose_in_camera,
                                   pose_of_touched, read_json)
from smile.ros.description import RobotDescription
from smile.ros.link import Reading, RobotLink, SeeingLink
from smile.simulation import Floats

_STILL = 2e-3
"""greatest motion of a joint while it touches a point [rad]"""
_STILL_SECONDS = 0.3
_SILENCE = 2.0
"""wall-clock time without joint states after which touching ends [s]"""
_PICTURE_SECONDS = 15.0
_MOST_PIXELS = 40_000_000


def touch(link: RobotLink, description: RobotDescription, arm: str, lines: Iterable[str],
          say: Callable[[str], None]) -> dict[str, list[list[float]]]:
    """Returns where the tool of an arm was at each line: points of the table and of the board's corners, in B [m].

    Nothing is commanded: a person moves the arm.

    lines  `t` for a point of the table, `b` for a corner of the board; anything else is refused
    """
    points: dict[str, list[list[float]]] = {"table": [], "board": []}
    for line in lines:
        kind = {"t": "table", "b": "board"}.get(line.strip())
        if kind is None:
            say(f"{line.strip()[:20]!r}: expected t (table), b (board), or the end of the input")
            continue
        place = _tool_at_rest(link, description, arm)
        if isinstance(place, str):
            say(f"not taken: {place}")
            continue
        points[kind].append([round(float(one), 6) for one in place])
        say(f"{kind} {len(points[kind])}: {', '.join(f'{one:.4f}' for one in place)} m from the robot's base")
    return points


def _tool_at_rest(link: RobotLink, description: RobotDescription, arm: str) -> Floats | str:
    """Returns where a tool is, in B [m]; or why that is not known."""
    names = description.arms[arm]
    first: Reading | None = None
    link.wait(0)  # an older one
    while True:
        reading = link.wait(_SILENCE)
        if reading is None:
            raise RuntimeError(link.connection_fault() or f"no joint states for {_SILENCE:g} s")
        if any(not np.isfinite(reading.positions.get(name, np.nan)) for name in names):
            raise RuntimeError(f"the joint states lack finite positions of {', '.join(names)}")
        first = first or reading
        q, before = (np.array([one.positions[name] for name in names]) for one in (reading, first))
        if np.abs(q - before).max() > _STILL:
            return f"the {arm} arm moves"
        if reading.time - first.time >= _STILL_SECONDS:
            return np.asarray(description.motion.forward(arm, q))[:3, 3]


def photograph(link: SeeingLink, topic: str, path: Path) -> dict[str, Any]:
    """Saves a picture of a camera, and returns the member `camera` of the measurements."""
    seen = link.picture(topic, _PICTURE_SECONDS)
    path.write_bytes(Picture(seen.rgb, None, None, seen.intrinsics, np.full((4, 4), np.nan)).to_png())
    return {"name": topic, "image": path.name, "K": seen.intrinsics.ravel().tolist(), "D": seen.distortion.tolist()}


def calibrate(measured: dict[str, Any], description: RobotDescription, folder: Path) -> dict[str, Any]:
    """Returns the calibration of a cell, with poses in W: what `smile ros calibrate` writes.

    measured  `table`: points in B; optional `board` (4 corners in B), `pattern` and `camera`
    folder    of the picture that the camera names

    Raises ValueError if the measurements are faulty, too few or contradict each other.
    """
    unknown = set(measured) - {"table", "board", "pattern", "camera"}
    if unknown:
        raise ValueError(f"member {min(unknown)!r} is unknown, expected table, board, pattern, camera")
    X_WB = description.X_WB
    plane = plane_of(_in_world(X_WB, points_of(measured.get("table"), "table", LEAST_POINTS)))
    cell: dict[str, Any] = {"format": FORMAT, "robot": description.name, "table": {
        "middle": plane.middle.tolist(), "normal": plane.normal.tolist(), "tilt": plane.tilt, "residual": plane.residual,
        "points": len(measured["table"])}}
    if "camera" in measured:
        board = Board(**_members(measured.get("pattern", {}), "pattern", {"columns": int, "rows": int, "square": float}))
        X_WP, touched = pose_of_touched(board, _in_world(X_WB, points_of(measured.get("board"), "board", 4)))
        cell["camera"] = _camera(measured["camera"], board, X_WP, folder)
        cell["board"] = {"pose": X_WP.tolist(), "residual": touched}
    elif measured.get("board"):
        raise ValueError("board: was touched, but there is no camera that saw it")
    return cell


def _in_world(X_WB: Floats, points: Floats) -> Floats:
    return points @ X_WB[:3, :3].T + X_WB[:3, 3]


def _members(value: Any, what: str, kinds: dict[str, type]) -> dict[str, Any]:
    if not isinstance(value, dict) or set(value) - set(kinds):
        raise ValueError(f"{what}: expected an object with {', '.join(kinds)}")
    for name, one in value.items():
        allowed = (int, float) if kinds[name] is float else kinds[name]
        if isinstance(one, bool) or not isinstance(one, allowed):
            raise ValueError(f"{what}.{name} is {str(one)[:40]!r}, expected {kinds[name].__name__}")
    return value


def _numbers(value: Any, what: str, count: int) -> Floats:
    try:
        numbers = np.array(value, float).ravel()
    except (TypeError, ValueError):
        numbers = np.zeros(0)
    if numbers.size != count or not np.isfinite(numbers).all():
        raise ValueError(f"{what}: expected {count} finite numbers, as in sensor_msgs/CameraInfo")
    return numbers


def _camera(value: Any, board: Board, X_WP: Floats, folder: Path) -> dict[str, Any]:
    camera = _members(value, "camera", {"name": str, "image": str, "K": list, "D": list})
    if missing := {"name", "image", "K", "D"} - set(camera):
        raise ValueError(f"camera.{min(missing)} is missing")
    K, D = _numbers(camera["K"], "camera.K", 9).reshape(3, 3), _numbers(camera["D"], "camera.D", 5)
    if K[0, 0] <= 0 or K[1, 1] <= 0 or K[2].tolist() != [0, 0, 1]:
        raise ValueError("camera.K: expected focal lengths above 0, and 0 0 1 as the last row")
    gray = _gray(folder / camera["image"])
    X_CP, residual = pose_in_camera(board, corners_in(board, gray), K, D)
    return {"name": camera["name"], "pose": (X_WP @ np.linalg.inv(X_CP)).tolist(), "K": K.ravel().tolist(), "D": D.tolist(),
            "width": gray.shape[1], "height": gray.shape[0], "residual_px": residual}


def _gray(path: Path) -> Any:
    import cv2
    gray = cv2.imread(str(path), cv2.IMREAD_GRAYSCALE)
    if gray is None or gray.size > _MOST_PIXELS:
        raise ValueError(f"{path}: is not a picture of up to {_MOST_PIXELS // 1_000_000} million pixels")
    return gray


def describe(cell: dict[str, Any]) -> list[str]:
    """Returns a calibration in words."""
    table = cell["table"]
    words = [f"table: {1000 * table['middle'][2]:+.1f} mm from the scene's at the middle of {table['points']} points, tilted by "
             f"{np.degrees(table['tilt']):.2f}°; residual {1000 * table['residual']:.2f} mm"]
    if "camera" in cell:
        X = np.array(cell["camera"]["pose"])
        words.append(f"camera {cell['camera']['name']}: at {', '.join(f'{one:.4f}' for one in X[:3, 3])} m from the middle of the table's "
                     f"top; residuals {cell['camera']['residual_px']:.2f} px and {1000 * cell['board']['residual']:.2f} mm")
    return words


def write_cell(measurements: str, description: RobotDescription, out: str) -> list[str]:
    """Calibrates from a file of measurements, and writes the result; returns it in words."""
    try:
        cell = calibrate(read_json(measurements), description, Path(measurements).parent)
    except ValueError as error:
        raise ValueError(f"{measurements}: {error}") from None
    Path(out).write_text(json.dumps(cell, indent=1) + "\n")
    return describe(cell)
