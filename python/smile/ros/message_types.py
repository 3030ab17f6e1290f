"""Messages that Debian lacks: Baxter's, and the action FollowJointTrajectory.

`definitions/` states their fields: facts of the interface, whose names, order and constants determine the checksum
by which two ROS nodes recognize that they mean the same message. Sources: RethinkRobotics/baxter_common
(baxter_core_msgs/msg) and ros-controls/control_msgs (kinetic-devel). genpy makes classes of them when this module is
imported.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import actionlib_msgs.msg
import genpy.dynamic
import geometry_msgs.msg
import std_msgs.msg
import trajectory_msgs.msg

_DEFINITIONS = Path(__file__).parent / "definitions"
_SEPARATOR = "\n" + "=" * 80 + "\n"
# Of Debian's packages, what the definitions refer to.
_REFERENCES = (std_msgs.msg.Header, geometry_msgs.msg.Point, geometry_msgs.msg.Quaternion, geometry_msgs.msg.Vector3,
               geometry_msgs.msg.Pose, geometry_msgs.msg.Twist, geometry_msgs.msg.Wrench, actionlib_msgs.msg.GoalID,
               actionlib_msgs.msg.GoalStatus, trajectory_msgs.msg.JointTrajectoryPoint,
               trajectory_msgs.msg.JointTrajectory)


def _of_action(path: Path) -> dict[str, str]:
    """Returns the seven messages of an action, as actionlib defines them (wiki.ros.org/actionlib/DetailedDescription)."""
    goal, result, feedback = (part.strip() for part in path.read_text().split("\n---\n"))
    name = path.stem
    return {
        f"{name}Goal": goal, f"{name}Result": result, f"{name}Feedback": feedback,
        f"{name}ActionGoal": f"Header header\nactionlib_msgs/GoalID goal_id\n{name}Goal goal",
        f"{name}ActionResult": f"Header header\nactionlib_msgs/GoalStatus status\n{name}Result result",
        f"{name}ActionFeedback": f"Header header\nactionlib_msgs/GoalStatus status\n{name}Feedback feedback",
        f"{name}Action": f"{name}ActionGoal action_goal\n{name}ActionResult action_result\n"
                         f"{name}ActionFeedback action_feedback"}


def _definitions() -> dict[str, str]:
    texts = {}
    for path in sorted(_DEFINITIONS.glob("*/*")):
        messages = _of_action(path) if path.suffix == ".action" else {path.stem: path.read_text().strip()}
        texts.update({f"{path.parent.name}/{name}": text for name, text in messages.items()})
    return texts


def _generate() -> dict[str, Any]:
    texts = _definitions()
    # The text of an installed message continues with those that it refers to.
    for message in _REFERENCES:
        texts[message._type] = message._full_text.split("\n" + "=" * 80)[0]
    first, *others = texts
    return genpy.dynamic.generate_dynamic(
        first, _SEPARATOR.join([texts[first], *(f"MSG: {name}\n{texts[name]}" for name in others)]))


_classes = _generate()
AssemblyState = _classes["baxter_core_msgs/AssemblyState"]
EndEffectorCommand = _classes["baxter_core_msgs/EndEffectorCommand"]
EndEffectorProperties = _classes["baxter_core_msgs/EndEffectorProperties"]
EndEffectorState = _classes["baxter_core_msgs/EndEffectorState"]
EndpointState = _classes["baxter_core_msgs/EndpointState"]
JointCommand = _classes["baxter_core_msgs/JointCommand"]
FollowJointTrajectoryActionGoal = _classes["control_msgs/FollowJointTrajectoryActionGoal"]
FollowJointTrajectoryActionResult = _classes["control_msgs/FollowJointTrajectoryActionResult"]
FollowJointTrajectoryAction = _classes["control_msgs/FollowJointTrajectoryAction"]
FollowJointTrajectoryFeedback = _classes["control_msgs/FollowJointTrajectoryFeedback"]
FollowJointTrajectoryGoal = _classes["control_msgs/FollowJointTrajectoryGoal"]
FollowJointTrajectoryResult = _classes["control_msgs/FollowJointTrajectoryResult"]


def fill(message: Any, values: Mapping[str, Any]) -> Any:
    """Sets the fields of a message, and of messages in it, by their names; returns it. genpy's own function finds no
    generated classes. Raises ValueError if there is no such field."""
    for name, value in values.items():
        if not hasattr(message, name):
            raise ValueError(f"{type(message).__name__} has no field {name}")
        if isinstance(value, Mapping):
            fill(getattr(message, name), value)
        elif isinstance(value, list) and value and isinstance(value[0], Mapping):
            kind = message._slot_types[message.__slots__.index(name)].removesuffix("[]")
            setattr(message, name, [fill(_classes[kind](), one) for one in value])
        else:
            setattr(message, name, value)
    return message
