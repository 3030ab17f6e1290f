"""Kinematics and motions of a robot's arms, for brains.

    from smile.motion import Robot
    robot = Robot("robots/baxter.urdf", unit=0.1)
    q = robot.inverse("left", goal, q_start)

Runs in this process, without a simulator. Lengths are in the scene's unit, angles in radians; poses
are 4x4 matrices in the world. See docs/motion.md.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from smile.native import load

if TYPE_CHECKING:
    from smile import smile_motion_native as _native
else:
    _native = load("smile_motion_native")
InvalidMoment = _native.InvalidMoment
LineFault = _native.LineFault
Robot = _native.Robot
Trajectory = _native.Trajectory

__all__ = ["InvalidMoment", "LineFault", "Robot", "Trajectory", "robot_of"]


def robot_of(aux: Any) -> Robot:
    """Returns the robot of a brain's `aux`: aux.robot, aux.robotBase, aux.unit, aux.robotGripper.

    `aux` may be an object with these attributes or a dict.
    """
    def value(name: str) -> Any:
        return aux.get(name) if isinstance(aux, dict) else getattr(aux, name, None)

    missing = [name for name in ("robot", "robotBase", "unit") if value(name) is None]
    if missing:
        raise ValueError("aux has no " + ", ".join(missing))
    return Robot(str(value("robot")), base=value("robotBase"), unit=float(value("unit")),
                 gripper=str(value("robotGripper") or ""))
