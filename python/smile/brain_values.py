"""The values of a brain: sensor, motor and aux (docs/brains.md)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, cast

import numpy as np
import numpy.typing as npt

__all__ = ["Arm", "ArmMotor", "ArmSensor", "Motor", "Sensor"]

Floats = npt.NDArray[np.float64]
Shape = tuple[int, ...]
Values = dict[str, Any]


class Fields:
    """Values from the simulator, each array as an attribute: `sensor.jointAngles`.

    For optional fields, test `"rgbVision" in sensor`.
    """

    def __init__(self, values: Values) -> None:
        self.__dict__ = values

    def __contains__(self, name: str) -> bool:
        return name in self.__dict__

    def __getattr__(self, name: str) -> Any:  # called only for missing names
        raise AttributeError(f"{name} is unknown, expected {', '.join(self.__dict__) or 'nothing'}"
                             + counterpart_of(name))

    def __repr__(self) -> str:
        return "\n".join(f"{name}: {brief(value)}" for name, value in self.__dict__.items())


# The classic variables exist for robots with two arms of seven joints only.
COUNTERPARTS = {
    "numLimbs": "len(aux.arms)",
    "numJoints": "len(aux.arms[k].joints)",
    "minJointAngles": "aux.arms[k].minJoints",
    "maxJointAngles": "aux.arms[k].maxJoints",
    "maxJointVelocities": "aux.arms[k].maxVelocities",
    "jointAngles": "sensor.arms[k].joints",
    "jointVelocities": "sensor.arms[k].velocities",
    "gripperOpening": "sensor.arms[k].gripper",
    "endEffPos": "sensor.arms[k].endEffector",
    "isHolding": "sensor.arms[k].heldObject",
    "heldObject": "sensor.arms[k].heldObject",
    "motor.jointVelocities": "motor.arms[k].velocities",
    "motor.gripperVelocities": "motor.arms[k].gripperVelocity",
    "motor.jointAngles": "motor.arms[k].joints",
}


def counterpart_of(name: str) -> str:
    instead = COUNTERPARTS.get(name)
    return f"; it is for two arms of seven joints, use {instead}" if instead else ""


class Arm(Fields):
    """An arm of the robot, in `aux.arms`. n is the number of its joints.

    name           str
    joints         their n names, from the shoulder to the wrist
    minJoints      (n,) lower limits [rad; m of a sliding joint]
    maxJoints      (n,) upper limits
    maxVelocities  (n,) [rad/s; m/s]
    gripper        None, or (2,): openings of the closed and the open gripper [units]
    toolPose       (4, 4): the tool in the frame of the last link; translation in units
    initJoints     set in init: (n,) initial posture [rad; m]
    """


class ArmSensor(Fields):
    """The state of an arm, in `sensor.arms`. n is the number of its joints.

    joints       (n,) [rad; m of a sliding joint]
    velocities   (n,) [rad/s; m/s]
    gripper      None, or the opening [units]
    endEffector  (4, 4): pose of the tool (z: approach) in the world; translation in units
    heldObject   id, or '' for none
    """


class Sensor(Fields):
    """Values of a step. `arms` is a list of ArmSensor, made when it is first read."""

    def __init__(self, values: Values, arms: Sequence[Arm]) -> None:
        packed = {name: values.pop(name) for name in PACKED_SENSOR if name in values}
        if packed:
            values["_arms"] = (arms, packed)
        self.__dict__ = values

    def __contains__(self, name: str) -> bool:
        return name in self.__dict__ or name == "arms" and "_arms" in self.__dict__

    def __getattr__(self, name: str) -> Any:  # called only for missing names
        if name == "arms" and "_arms" in self.__dict__:
            self.__dict__["arms"] = sensed_arms(*self.__dict__.pop("_arms"))
            return self.__dict__["arms"]
        return super().__getattr__(name)

    def __repr__(self) -> str:
        if "_arms" in self.__dict__:
            _ = self.arms
        return super().__repr__()


class Commands:
    """Fields of fixed shapes that keep their values until changed; new ones cannot be added."""

    REQUIRED = ("jointVelocities", "gripperVelocities", "velocities", "gripperVelocity")
    TIMED = REQUIRED + ("headVelocity",)

    def __init__(self, name: str, shapes: dict[str, Shape]) -> None:
        self.__dict__["name"] = name
        self.__dict__["shapes"] = shapes
        for field, shape in shapes.items():
            self.__dict__[field] = np.zeros(shape) if field in self.REQUIRED else None

    def __getattr__(self, field: str) -> Any:  # called only for missing names
        raise AttributeError(self.unknown(field))

    def __setattr__(self, field: str, value: npt.ArrayLike | None) -> None:
        if field not in self.shapes:
            raise AttributeError(self.unknown(field))
        if value is None and field in self.REQUIRED:
            raise ValueError(f"{self.name}.{field} is None, expected numbers")
        self.__dict__[field] = None if value is None else self.numbers(field, value)

    def __delattr__(self, field: str) -> None:
        setattr(self, field, None)

    def unknown(self, field: str) -> str:
        known = list(self.shapes) + ["arms"] * bool(self.__dict__.get("counts"))
        return (f"{self.name}.{field} is unknown, expected {', '.join(known)}"
                + counterpart_of(f"{self.name}.{field}"))

    def numbers(self, field: str, value: npt.ArrayLike) -> Floats:
        expected = self.shapes[field]
        array = real_numbers(f"{self.name}.{field}", value)
        if len(expected) == 1 and array.size == expected[0]:
            array = array.reshape(expected)  # rows and columns are accepted
        if expected == () and array.size == 1:
            array = array.reshape(())
        if not self.has_shape(field, array):
            raise ValueError(f"{self.name}.{field} is {shape_text(array.shape)}, "
                             f"expected {shape_text(expected)}")
        return array

    def has_shape(self, field: str, array: Floats) -> bool:
        """Returns true if an array is the value of a tick, or of successive ticks."""
        shape = self.shapes[field]
        return array.shape == shape or field in self.TIMED and array.shape[:-1] == shape

    def checked(self, field: str) -> Floats | None:
        """Returns a field, checked again because elements can be set as well; or None."""
        array = self.__dict__[field]
        if array is None:
            return None
        if not self.has_shape(field, array):
            array = self.numbers(field, array)
        if not math.isfinite(sum(array.ravel().tolist())):  # the fast way for few numbers
            check_finite(f"{self.name}.{field}", array)
        return array


class Motor(Commands):
    """Commands to the robot. Fields keep their values until changed; new fields cannot be added.

    arms               one ArmMotor for each arm of aux.arms
    headVelocity       None, or a number [rad/s]
    ticks              None, or the number of ticks until the next step

    For robots with two arms of seven joints, in place of arms:

    jointVelocities    2 x 7 [rad/s]
    gripperVelocities  one number per arm [units/s]
    jointAngles        None, or 2 x 7: immediate joint angles [rad]

    Velocities may have one more dimension, time: the values of successive ticks.
    """

    def __init__(self, aux: Fields) -> None:
        shapes: dict[str, Shape] = {"headVelocity": (), "ticks": ()}
        if "numLimbs" in aux:
            arms = (aux.numLimbs, aux.numJoints)
            shapes = {"jointVelocities": arms, "gripperVelocities": arms[:1],
                      "jointAngles": arms} | shapes
        super().__init__("motor", shapes)
        self.__dict__["counts"] = [len(arm.joints) for arm in aux.__dict__.get("arms", [])]

    def __getattr__(self, field: str) -> Any:  # called only for missing names
        if field != "arms" or not self.counts:
            raise AttributeError(self.unknown(field))
        # Made when first used: brains that use the classic variables have none.
        arms = tuple(ArmMotor(k, count) for k, count in enumerate(self.counts))
        self.__dict__["arms"] = arms
        return arms

    def values(self) -> Values:
        """Returns the fields for the message."""
        values = {}
        sets_arms = "jointVelocities" not in self.shapes or (
            "arms" in self.__dict__ and any(arm.is_set() for arm in self.arms))
        for name, shape in self.shapes.items():
            array = self.checked(name)
            if array is None:
                continue
            # Beside arms that are set, only what the simulator must refuse.
            if sets_arms and name in self.REQUIRED and not array.any():
                continue
            # One number per limb is a column, one per tick is a row.
            values[name] = array.reshape(-1, 1) if array.shape == shape and array.ndim < 2 else array
        return values | packed_motor(self.arms) if sets_arms else values


class ArmMotor(Commands):
    """Commands to an arm, in `motor.arms`. n is the number of its joints.

    velocities       (n,), or (n, N) for N successive ticks [rad/s; m/s of a sliding joint]
    gripperVelocity  a number, or (N,): rate of change of the opening [units/s]
    joints           None, or (n,): immediate posture in place of velocities [rad; m]
    """

    def __init__(self, index: int, count: int) -> None:
        super().__init__(f"motor.arms[{index}]",
                         {"velocities": (count,), "gripperVelocity": (), "joints": (count,)})

    def is_set(self) -> bool:
        """Returns True if a command differs from doing nothing."""
        return (self.joints is not None or self.velocities.ndim > 1 or self.velocities.any()
                or self.gripperVelocity.ndim > 0 or self.gripperVelocity.any())


def packed_motor(arms: Sequence[ArmMotor]) -> Values:
    """Returns the commands of all arms one after the other; time is the second dimension."""
    def required(arm: ArmMotor, name: str, rows: int) -> Floats:
        return cast("Floats", arm.checked(name)).reshape(rows, -1)  # never None

    velocities = [required(arm, "velocities", arm.shapes["velocities"][0]) for arm in arms]
    grippers = [required(arm, "gripperVelocity", 1) for arm in arms]
    return ({"armVelocities": stacked(velocities), "armGripperVelocities": stacked(grippers)}
            | packed_joints([arm.checked("joints") for arm in arms],
                            [arm.shapes["joints"][0] for arm in arms]))


def packed_joints(joints: Sequence[Floats | None], counts: Sequence[int]) -> Values:
    """Returns the joints of the arms that have some, for the message; {} if none has."""
    if all(values is None for values in joints):
        return {}
    filled = [np.zeros(count) if values is None else values
              for values, count in zip(joints, counts)]
    return {"armJoints": np.concatenate(filled).reshape(-1, 1),
            "armsAtJoints": np.array([[float(values is not None)] for values in joints])}


def stacked(parts: Sequence[Floats]) -> Floats:
    """Stacks values of arms; in those with fewer ticks, the last one remains in effect."""
    ticks = max(part.shape[1] for part in parts)
    return np.vstack([part[:, np.minimum(np.arange(ticks), part.shape[1] - 1)] for part in parts])


def real_numbers(name: str, value: Any) -> Floats:
    array = np.asarray(value)
    if array.dtype.kind not in "fiub":
        raise TypeError(f"{name} is {type(value).__name__} of {array.dtype}, expected real numbers")
    return array.astype(float)


def check_finite(name: str, array: Floats) -> None:
    wrong = np.argwhere(~np.isfinite(array))
    if len(wrong):
        place = f"[{', '.join(map(str, wrong[0]))}]" if array.ndim else ""
        raise ValueError(f"{name}{place} is {array[tuple(wrong[0])]}, expected a finite number")


def shape_text(shape: Shape) -> str:
    return "x".join(map(str, shape)) or "one number"


def brief(value: object) -> str:
    if isinstance(value, np.ndarray) and value.size > 20:
        return f"{shape_text(value.shape)} {value.dtype}"
    return repr(value)


PACKED_SENSOR = ("armJoints", "armVelocities", "armGrippers", "armEndEffectors", "armHeldObjects")


def by_arm(array: Floats, counts: Sequence[int]) -> list[Floats]:
    """Splits values of all joints into those of each arm."""
    return np.split(np.ravel(array), np.cumsum(counts)[:-1])


def sensed_arms(arms: Sequence[Arm], packed: Values) -> list[ArmSensor]:
    counts = [len(arm.joints) for arm in arms]
    return [
        ArmSensor({"joints": joints, "velocities": velocities,
                   "gripper": None if math.isnan(gripper) else float(gripper),
                   "endEffector": pose, "heldObject": held})
        for joints, velocities, gripper, pose, held in zip(
            by_arm(packed["armJoints"], counts), by_arm(packed["armVelocities"], counts),
            np.ravel(packed["armGrippers"]), np.moveaxis(packed["armEndEffectors"], 2, 0),
            packed["armHeldObjects"].split("\n"))
    ]


def arms_of(values: Values) -> list[Arm]:
    """Takes the packed description of the arms out of `values`."""
    names = lines_of(values.pop("armNames"))
    counts = np.ravel(values.pop("armJointCounts")).astype(int).tolist()
    joints = np.split(np.array(lines_of(values.pop("armJointNames"))), np.cumsum(counts)[:-1])
    lower, upper, velocities = (by_arm(values.pop(name), counts) for name in (
        "armMinJoints", "armMaxJoints", "armMaxVelocities"))
    grippers = values.pop("armGrippers").T
    poses = np.moveaxis(values.pop("armToolPoses"), 2, 0)
    return [
        Arm({"name": names[k], "joints": joints[k].tolist(), "minJoints": lower[k],
             "maxJoints": upper[k], "maxVelocities": velocities[k],
             "gripper": None if np.isnan(grippers[k]).any() else grippers[k],
             "toolPose": poses[k]})
        for k in range(len(names))
    ]


def sensor_of(values: Values, arms: Sequence[Arm] = ()) -> Sensor:
    names = values.pop("trackerNames", None)
    if names is not None:
        values["trackerLoc"] = dict(zip(lines_of(names), values.pop("trackerPositions")))
    if "heldObject" in values:
        values["heldObject"] = values["heldObject"].split("\n")
    if "segmentNames" in values:
        values["segmentNames"] = lines_of(values["segmentNames"])
    if "cameraPose" in values:
        take_cameras(values)
    return Sensor(values, arms)


def take_cameras(values: Values) -> None:
    cameras: dict[str, Values] = {}
    for name in [name for name in values if name.startswith("cameras_")]:
        camera, _, field = name.removeprefix("cameras_").rpartition("_")
        cameras.setdefault(camera, {})[field] = values.pop(name)
    if cameras:
        values["cameras"] = Fields({name: Fields(fields) for name, fields in cameras.items()})


def lines_of(text: str) -> list[str]:
    return text.split("\n") if text else []


def aux_of(values: Values) -> Fields:
    lines = [line.split(",") for line in lines_of(values.get("attention", ""))]
    values["attention"] = {words[0]: words[1:] for words in lines}
    if "planWords" in values:
        values["plan"] = take_plan(values)
    values["cameraNames"] = lines_of(values.get("cameraNames", ""))
    for name in ("numLimbs", "numJoints"):
        if name in values:
            values[name] = int(values[name])
    if "armNames" in values:
        values["arms"] = arms_of(values)
    return Fields(values)


def take_plan(values: Values) -> Fields:
    """Returns the plan of a demonstration; its subtasks are counted from 0."""
    rows = zip(values.pop("planWords").split("\n"), values.pop("planObjects").split("\n"),
               values.pop("planSegments").astype(int), np.ravel(values.pop("planNecessary")))
    subtasks = [Fields({"words": words, "objects": objects.split(",") if objects else [],
                        "segments": (int(first), int(last)), "isNecessary": bool(necessary)})
                for words, objects, (first, last), necessary in rows]
    order = values.pop("planOrder").reshape(-1, 2).astype(int) - 1
    sufficient = np.ravel(values.pop("planSufficient")).astype(int) - 1
    return Fields({"subtasks": subtasks, "order": order, "sufficient": sufficient,
                   "goals": lines_of(values.pop("planGoals"))})


def wishes_of(aux: Fields) -> Values:
    """Returns the requests to the simulator that init set in aux."""
    values: Values = {}
    for name in ("initJointAngles", "drawMarkers", "imageSeconds", "watch"):
        if name in aux:
            values[name] = wish_of(aux, name)
    for name in ("channels", "cameras"):
        if name in aux:
            values[name] = in_one_line(f"aux.{name}", getattr(aux, name))
    return values | initial_joints_of(aux.__dict__.get("arms", []))


def initial_joints_of(arms: Sequence[Arm]) -> Values:
    joints = [initial_joints(f"aux.arms[{k}].initJoints", arm) for k, arm in enumerate(arms)]
    return packed_joints(joints, [len(arm.joints) for arm in arms])


def initial_joints(name: str, arm: Arm) -> Floats | None:
    if arm.__dict__.get("initJoints") is None:
        return None
    array = real_numbers(name, arm.initJoints)
    if array.size != len(arm.joints):
        raise ValueError(f"{name} is {shape_text(array.shape)}, expected {len(arm.joints)}")
    check_finite(name, array)
    return array.ravel()


def wish_of(aux: Fields, name: str) -> Floats:
    array = real_numbers(f"aux.{name}", getattr(aux, name))
    check_finite(f"aux.{name}", array)
    return array


def text_of(name: str, text: object) -> str:
    if not isinstance(text, str):
        raise TypeError(f"{name} is {text!r:.80}, expected a text")
    return text


def lines_from(name: str, texts: object) -> str:
    if not isinstance(texts, (list, tuple)):
        raise TypeError(f"{name} is {texts!r:.80}, expected a list of texts")
    return "\n".join(text_of(name, text) for text in texts)


def in_one_line(name: str, words: object) -> str:
    words = [words] if isinstance(words, str) else words
    if not isinstance(words, (list, tuple)) or not all(isinstance(word, str) for word in words):
        raise TypeError(f"{name} is {words!r:.80}, expected a list of names")
    return ",".join(words)
