"""`smile ros perform --brain`: what is checked and said before a brain drives a robot, and afterwards."""

from __future__ import annotations

import json
import time
from typing import Any

import numpy as np

import smile
from smile.ros.brain_performing import BrainOutcome, BrainPerformance, BrainTask, CameraPose
from smile.ros.calibration import table_fault
from smile.ros.camera_view import CameraView, is_same_camera
from smile.ros.description import RobotDescription
from smile.ros.link import CameraReading, SeeingLink
from smile.ros.motion_plan import approach, table_of
from smile.ros.performing import Stopped

_CAMERA_SECONDS = 15.0
"""wall-clock time in which a camera must have sent its first picture [s]"""


def cell_fault(cell: dict[str, Any], model: smile.Model, description: RobotDescription, topic: str | None) -> str | None:
    """Returns why a brain must not drive a robot in a calibrated cell; None if it may.

    topic  of the camera; None without one

    Raises ValueError if `smile ros calibrate` did not write the cell.
    """
    fault = table_fault(cell, description.name, table_of(model))
    if fault is not None or topic is None:
        return fault
    camera = cell.get("camera")
    if not isinstance(camera, dict):
        return f"the calibration has no camera, expected {topic}: touch and see the board as well"
    if camera.get("name") != topic:
        return f"the calibration is that of the camera {camera.get('name')!r}, expected {topic}"
    return None


def camera_of(link: SeeingLink, cell: dict[str, Any], topic: str, depth: str | None, size: tuple[int, int]) -> CameraPose:
    """Returns the calibrated camera of a cell, after its first picture.

    size  width and height of the pictures for the brain [px]

    Raises ValueError if the camera is not as it was when it was calibrated, or does not fit; RuntimeError if it is silent.
    """
    link.watch(topic, depth)
    seen = _first_picture(link, topic)
    width, height = seen.rgb.shape[1], seen.rgb.shape[0]
    calibrated = cell["camera"]
    try:
        K, D = np.array(calibrated["K"], float).reshape(3, 3), np.array(calibrated["D"], float).reshape(5)
        X_WC = np.array(calibrated["pose"], float).reshape(4, 4)
        pixels = int(calibrated["width"]), int(calibrated["height"])
    except (KeyError, TypeError, ValueError) as error:
        raise ValueError(f"the camera of the calibration is faulty: {error!r}, expected width, height, K, D and pose") from None
    if not np.isfinite(X_WC).all() or np.abs(X_WC[:3, :3] @ X_WC[:3, :3].T - np.eye(3)).max() > 1e-6:
        raise ValueError("the camera of the calibration is faulty: its pose is not that of a rigid body")
    if pixels != (width, height) or not is_same_camera(seen, K, D):
        raise ValueError(f"{topic}: camera_info or size ({width} x {height}) differ from the calibration ({pixels[0]} x {pixels[1]}): "
                         "calibrate again")
    try:
        view = CameraView(K, D, pixels, size)
    except ValueError as error:
        raise ValueError(f"{topic}: {error}") from None
    if (fault := view.fault_of(seen)) is not None:
        raise ValueError(f"{topic}: {fault}")
    return CameraPose(topic, view, X_WC, depth is not None)


def _first_picture(link: SeeingLink, topic: str) -> CameraReading:
    deadline = time.monotonic() + _CAMERA_SECONDS
    while (seen := link.seen()) is None:
        if time.monotonic() > deadline:
            raise RuntimeError(link.connection_fault() or f"{topic}, its camera_info and depths did not arrive within "
                               f"{_CAMERA_SECONDS:g} s")
        link.wait(0.1)
    return seen


def describe_task(task: BrainTask, model: smile.Model, description: RobotDescription) -> list[str]:
    """Returns what a brain will be let do, in words."""
    words = [f"{task.brain} drives {description.name} in {model.name}, {' and '.join(model.arm_names)} arm, for up to {task.seconds:g} s of "
             f"its clock, which runs at speed {task.speed:g}"]
    if task.demonstration:
        words.append(f"  it imitates {task.demonstration}")
    if task.camera is not None:
        (width, height), K = task.camera.view.size, task.camera.view.intrinsics
        wide, high = (np.degrees(2 * np.arctan(side / 2 / K[axis, axis])) for axis, side in enumerate((width, height)))
        words.append(f"  it sees {width} x {height} pixels of {task.camera.topic}, {wide:.0f}° x {high:.0f}°, without distortion"
                     + (", with depths" if task.camera.has_depth else ""))
    else:
        words.append("  it sees nothing: there is no --camera")
    return words


def dry_run(performance: BrainPerformance) -> str | None:
    """Starts the brain and plans its way to the start; returns why it would be refused, None if it would not."""
    try:
        plan = performance.start(print)
        if plan is None:
            print("  it begins where the arms are")
            return None
        path, fault = approach(plan, performance.read().positions)
    except Stopped as error:
        return str(error)
    print(f"  the way to the posture in which it begins takes {path.duration:.1f} s")
    return fault


def describe_outcome(outcome: BrainOutcome) -> list[str]:
    """Returns what became of it, in words."""
    words = [outcome.tracking.table() if outcome.tracking.errors else "nothing was performed"]
    words += [f"robot: {one}" for one in outcome.words]
    words += [f"the arms waited {seconds:.1f} s for {'the brain' if what == 'brain' else what}" for what, seconds in outcome.waits.items()
              if seconds > 0.05]
    if outcome.claim is not None:
        words.append(f"the brain claims: {'done' if outcome.claim[0] else 'gave up'}: {outcome.claim[1]}")
    words.append("performed" if outcome.reason is None else f"stopped after {outcome.seconds:.2f} s: {outcome.reason}")
    return words


def write_brain_report(outcome: BrainOutcome, task: BrainTask, description: RobotDescription, path: str) -> None:
    """Writes the outcome as a JSON file."""
    with open(path, "w", encoding="utf-8") as file:
        json.dump(outcome.report(task, description.name), file, indent=2)
        file.write("\n")
