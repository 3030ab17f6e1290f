"""Goals and results of the action control_msgs/FollowJointTrajectory, as plain values: the fields of its messages by name."""

from __future__ import annotations

from typing import Any

from smile.ros.joint_path import JointPath
from smile.ros.link import TrajectoryReading

KIND = "control_msgs/FollowJointTrajectory"
_SUCCEEDED = 3
"""of actionlib_msgs/GoalStatus: 0 is pending, 1 active; from 2 on it has ended, or is about to (6, 7)"""
_ENDED = (2, 3, 4, 5, 8, 9)


def action_of(arm: str) -> str:
    """Returns the name of an arm's action."""
    return f"/robot/limb/{arm}/follow_joint_trajectory"


def goal_of(path: JointPath, tolerance: float) -> dict[str, Any]:
    """Returns a goal: to begin at once, with a tolerance for each joint on the way [rad]."""
    points = [{"positions": [float(one) for one in positions], "velocities": [float(one) for one in velocities],
               "accelerations": [], "effort": [], "time_from_start": _time_of(time)}
              for time, positions, velocities in zip(path.times, path.positions, path.velocities)]
    header = {"stamp": {"secs": 0, "nsecs": 0}, "frame_id": ""}
    return {"trajectory": {"header": header, "joint_names": path.names, "points": points}, "goal_tolerance": [],
            "path_tolerance": [{"name": name, "position": float(tolerance), "velocity": 0.0, "acceleration": 0.0} for name in path.names],
            "goal_time_tolerance": {"secs": 0, "nsecs": 0}}


def _time_of(seconds: float) -> dict[str, int]:
    whole, nanoseconds = divmod(round(float(seconds) * 1e9), 1_000_000_000)
    return {"secs": whole, "nsecs": nanoseconds}


def reading_of(status: int, words: str) -> TrajectoryReading:
    """Returns the state that a status of actionlib_msgs/GoalStatus, and the words of the robot, stand for."""
    if status not in _ENDED:
        return TrajectoryReading(status != 0, False, None)
    fault = None if status == _SUCCEEDED else words[:300] or f"it ended with status {status}"
    return TrajectoryReading(True, True, fault)
