"""Kinematics and motions of a robot's arms, for brains.

    from smile.motion import Robot
    robot = Robot("robots/baxter.urdf", unit=0.1)
    q = robot.inverse("left", goal, q_start)

Runs in this process, without a simulator. Lengths are in the scene's unit, angles in radians; poses
are 4x4 matrices in the world. See docs/motion.md.
"""

from smile.native import load

_native = load("smile_motion_native")
InvalidMoment, LineFault = _native.InvalidMoment, _native.LineFault
Robot, Trajectory = _native.Robot, _native.Trajectory

__all__ = ["InvalidMoment", "LineFault", "Robot", "Trajectory", "robot_of"]


def robot_of(aux):
    """Returns the robot of a brain's `aux`: aux.robot, aux.robotBase, aux.unit, aux.robotGripper.

    `aux` may be an object with these attributes or a dict.
    """
    value = aux.get if isinstance(aux, dict) else lambda name: getattr(aux, name, None)
    missing = [name for name in ("robot", "robotBase", "unit") if value(name) is None]
    if missing:
        raise ValueError("aux has no " + ", ".join(missing))
    return Robot(str(value("robot")), base=value("robotBase"), unit=float(value("unit")),
                 gripper=str(value("robotGripper") or ""))
