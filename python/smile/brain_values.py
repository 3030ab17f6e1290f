"""The values of a brain: sensor, motor and aux (docs/brains.md)."""

import math

import numpy as np


class Fields:
    """Values from the simulator, each array as an attribute: `sensor.jointAngles`.

    For optional fields, test `"rgbVision" in sensor`.
    """

    def __init__(self, values):
        self.__dict__ = values

    def __contains__(self, name):
        return name in self.__dict__

    def __getattr__(self, name):  # called only for missing names
        raise AttributeError(f"{name} is unknown, expected {', '.join(self.__dict__) or 'nothing'}")

    def __repr__(self):
        return "\n".join(f"{name}: {brief(value)}" for name, value in self.__dict__.items())


class Motor:
    """Commands to the robot. Fields keep their values until changed; new fields cannot be added.

    jointVelocities    limbs x joints [rad/s]
    gripperVelocities  one number per limb [units/s]
    jointAngles        None, or limbs x joints: immediate joint angles [rad]
    headVelocity       None, or a number [rad/s]
    ticks              None, or the number of ticks until the next step

    Velocities may have one more dimension, time: the values of successive ticks.
    """

    TIMED = ("jointVelocities", "gripperVelocities", "headVelocity")

    def __init__(self, num_limbs, num_joints):
        arms = (num_limbs, num_joints)
        self.__dict__["shapes"] = {
            "jointVelocities": arms,
            "gripperVelocities": (num_limbs,),
            "jointAngles": arms,
            "headVelocity": (),
            "ticks": (),
        }
        self.jointVelocities = np.zeros(arms)
        self.gripperVelocities = np.zeros(num_limbs)
        self.jointAngles = None
        self.headVelocity = None
        self.ticks = None

    def __setattr__(self, name, value):
        if name not in self.shapes:
            raise AttributeError(f"motor.{name} is unknown, expected {', '.join(self.shapes)}")
        if value is None and name in ("jointVelocities", "gripperVelocities"):
            raise ValueError(f"motor.{name} is None, expected numbers")
        self.__dict__[name] = None if value is None else self.numbers(name, value)

    def __delattr__(self, name):
        setattr(self, name, None)

    def numbers(self, name, value):
        expected = self.shapes[name]
        array = real_numbers(f"motor.{name}", value)
        if name == "gripperVelocities" and array.size == expected[0]:
            array = array.reshape(expected)  # rows and columns are accepted
        if expected == () and array.size == 1:
            array = array.reshape(())
        if not self.has_shape(name, array):
            raise ValueError(f"motor.{name} is {shape_text(array.shape)}, "
                             f"expected {shape_text(expected)}")
        return array

    def has_shape(self, name, array):
        """Returns true if an array is the value of a tick, or of successive ticks."""
        shape = self.shapes[name]
        return array.shape == shape or name in self.TIMED and array.shape[:-1] == shape

    def values(self):
        """Returns the fields for the message, checked again because elements can be set as well."""
        values = {}
        for name, shape in self.shapes.items():
            array = self.__dict__[name]
            if array is None:
                continue
            if not self.has_shape(name, array):
                array = self.numbers(name, array)
            if not math.isfinite(sum(array.ravel().tolist())):  # the fast way for few numbers
                check_finite(f"motor.{name}", array)
            # One number per limb is a column, one per tick is a row.
            values[name] = array.reshape(-1, 1) if array.shape == shape and array.ndim < 2 else array
        return values


def real_numbers(name, value):
    array = np.asarray(value)
    if array.dtype.kind not in "fiub":
        raise TypeError(f"{name} is {type(value).__name__} of {array.dtype}, expected real numbers")
    return array.astype(float)


def check_finite(name, array):
    wrong = np.argwhere(~np.isfinite(array))
    if len(wrong):
        place = f"[{', '.join(map(str, wrong[0]))}]" if array.ndim else ""
        raise ValueError(f"{name}{place} is {array[tuple(wrong[0])]}, expected a finite number")


def shape_text(shape):
    return "x".join(map(str, shape)) or "one number"


def brief(value):
    if isinstance(value, np.ndarray) and value.size > 20:
        return f"{shape_text(value.shape)} {value.dtype}"
    return repr(value)


def sensor_of(values):
    names = values.pop("trackerNames", None)
    if names is not None:
        values["trackerLoc"] = dict(zip(lines_of(names), values.pop("trackerPositions")))
    if "heldObject" in values:
        values["heldObject"] = values["heldObject"].split("\n")
    if "segmentNames" in values:
        values["segmentNames"] = lines_of(values["segmentNames"])
    if "cameraPose" in values:
        take_cameras(values)
    return Fields(values)


def take_cameras(values):
    cameras = {}
    for name in [name for name in values if name.startswith("cameras_")]:
        camera, _, field = name.removeprefix("cameras_").rpartition("_")
        cameras.setdefault(camera, {})[field] = values.pop(name)
    if cameras:
        values["cameras"] = Fields({name: Fields(fields) for name, fields in cameras.items()})


def lines_of(text):
    return text.split("\n") if text else []


def aux_of(values):
    lines = [line.split(",") for line in lines_of(values.get("attention", ""))]
    values["attention"] = {words[0]: words[1:] for words in lines}
    values["cameraNames"] = lines_of(values.get("cameraNames", ""))
    for name in ("numLimbs", "numJoints"):
        values[name] = int(values[name])
    return Fields(values)


def wishes_of(aux):
    """Returns the requests to the simulator that init set in aux."""
    values = {}
    for name in ("initJointAngles", "drawMarkers", "imageSeconds", "watch"):
        if name in aux:
            values[name] = wish_of(aux, name)
    for name in ("channels", "cameras"):
        if name in aux:
            values[name] = in_one_line(f"aux.{name}", getattr(aux, name))
    return values


def wish_of(aux, name):
    array = real_numbers(f"aux.{name}", getattr(aux, name))
    check_finite(f"aux.{name}", array)
    return array


def in_one_line(name, words):
    words = [words] if isinstance(words, str) else words
    if not isinstance(words, (list, tuple)) or not all(isinstance(word, str) for word in words):
        raise TypeError(f"{name} is {words!r:.80}, expected a list of names")
    return ",".join(words)
