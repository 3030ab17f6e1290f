"""Scenes and simulations.

A Model is a scene with a robot, compiled once; a Simulation moves it. All changes are commands,
which take effect between two ticks of 1/60 s. The same model and the same commands at the same
ticks give the same bits, in C++ and in Python.
"""

from __future__ import annotations

import importlib
import json
import math
import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np
import numpy.typing as npt

from smile.errors import Refused
from smile.native import load as _load_native
from smile.picture import Picture

if TYPE_CHECKING:
    from smile.recording import Recording

if TYPE_CHECKING:
    from smile import smile_simulator_native as _native
else:
    _native = _load_native("smile_simulator_native")

Model = _native.Model
State = _native.State
Floats = npt.NDArray[np.float64]
Event = dict[str, Any]

TICKS_PER_SECOND = 60
CHANNELS = ("rgb", "depth", "id")
# Longer runs are mistakes more often than not: 1000 hours.
_MOST_TICKS = 60 * 3600 * 1000

_T = TypeVar("_T")


def load(scene: str | os.PathLike[str], robot: str | os.PathLike[str] | None = "baxter",
         search: Sequence[str | os.PathLike[str]] = ()) -> Model:
    """Reads a scene file and compiles it with a robot.

    scene   path of a scene file (docs/scene-format.md)
    robot   name that `smile robots` lists, path of a URDF, or None for a table without a robot
    search  folders in which files of scene and robot are searched after their own folders

    Raises SceneError with all findings if a file is not valid. The model never changes; threads and
    simulations may share it.
    """
    return _native.load(os.fspath(scene), None if robot is None else os.fspath(robot),
                        [os.fspath(folder) for folder in search])


def data_file(relative_path: str) -> Path:
    """Returns the path of a file or folder that ships with SMILE, for example `scenes/tower.xml`.

    Raises RuntimeError with all places searched if there is none.
    """
    return Path(_native.data_file(relative_path))


def _demand(refusal: str | None) -> None:
    if refusal is not None:
        raise Refused(refusal)


def _whole(name: str, value: Any, low: int, high: int) -> int:
    if isinstance(value, bool) or not isinstance(value, (int, np.integer)) or not low <= value <= high:
        raise ValueError(f"{name} is {value!r}, expected a whole number from {low} to {high}")
    return int(value)


def picture_size(size: tuple[int, int]) -> tuple[int, int]:
    """Checks a width and a height [px]."""
    if not isinstance(size, (tuple, list)) or len(size) != 2:
        raise ValueError(f"size is {size!r}, expected (width, height)")
    return _whole("width", size[0], 1, 8192), _whole("height", size[1], 1, 8192)


def channel_flags(channels: Sequence[str]) -> list[bool]:
    """Checks names of channels; returns which of CHANNELS are among them."""
    if isinstance(channels, str) or not channels or not set(channels) <= set(CHANNELS):
        raise ValueError(f"channels is {channels!r}, expected some of {', '.join(CHANNELS)}")
    return [name in channels for name in CHANNELS]


def _point(name: str, value: Any) -> Floats:
    try:
        return np.asarray(value, float)
    except (TypeError, ValueError):
        raise ValueError(f"{name} is {value!r}, expected three numbers") from None


class Hand:
    """A hand of the demonstrator: it has no body, and moves objects."""

    def __init__(self, native: Any, name: str) -> None:
        self._native, self.name = native, name
        self._hand = _native.HandName.__members__[name]

    @property
    def held(self) -> str | None:
        """Id of the held object."""
        return self._native.held(self._hand)

    @property
    def has_arrived(self) -> bool:
        """True if the held object is at its goal, and for an empty hand."""
        return self._native.has_arrived(self._hand)

    def grasp(self, object: str, point: npt.ArrayLike | None = None) -> None:
        """Grasps an object at a point in the world [m], by default at its origin."""
        at = None if point is None else _point("point", point)
        _demand(self._native.grasp(self._hand, object, at))

    def move_to(self, position: npt.ArrayLike, speed: float | None = None) -> None:
        """Moves the grasped point to a position in the world [m], at most at `speed` [m/s]."""
        _demand(self._native.move_to(self._hand, _point("position", position), speed))

    def rotate(self, angles: npt.ArrayLike) -> None:
        """Rotates the held object about its origin: about the world's x, then y, then z axis [rad]."""
        _demand(self._native.rotate(self._hand, _point("angles", angles)))

    def release(self) -> None:
        """Releases the held object."""
        self._do("release")

    def destroy(self) -> None:
        """Removes the held object from the world."""
        self._do("destroy")

    def attend(self, properties: Sequence[str]) -> None:
        """Sets the properties of the held object that matter; an empty list: none in particular."""
        self._do("attend", properties=list(properties))

    def point_at(self, part: str) -> None:
        """Points at an object or a pointable part. Recorded, without effect on the world."""
        self._do("point", part=part)

    def trigger(self, control: str, part: str | None = None) -> None:
        """Presses a switch, or triggers a part of a control (default: towards the next state)."""
        self._do("trigger", control=control, **({} if part is None else {"part": part}))

    def fasten(self, object: str) -> None:
        """Tightens an object by one stage."""
        self._do("fasten", object=object)

    def loosen(self, object: str) -> None:
        """Loosens an object by one stage."""
        self._do("loosen", object=object)

    def use(self, loosen: bool = False) -> None:
        """Uses the held tool on what its tip is at."""
        self._do("use", **({"loosen": True} if loosen else {}))

    def _do(self, kind: str, **fields: Any) -> None:
        _demand(self._native.apply(json.dumps({"hand": self.name, "do": kind, **fields})))


class Object:
    """An object of a simulation, as it is now."""

    def __init__(self, native: Any, id: str) -> None:
        self._native, self.id = native, id

    @property
    def is_present(self) -> bool:
        """False once the object was destroyed or removed."""
        return self._native.is_present(self.id)

    @property
    def has_fallen(self) -> bool:
        """True once the object fell to the floor: it is out of play."""
        return self._native.has_fallen(self.id)

    @property
    def pose(self) -> Floats:
        """(7,): x, y, z [m] and the quaternion w, x, y, z, in the world. ValueError if it is gone."""
        return self._native.pose(self.id)

    @property
    def position(self) -> Floats:
        """(3,) in the world [m]"""
        return self.pose[:3]

    @property
    def quaternion(self) -> Floats:
        """(4,): w, x, y, z"""
        return self.pose[3:]

    @property
    def velocity(self) -> Floats:
        """(6,): linear velocity of the origin [m/s], then angular velocity [rad/s], in the world."""
        return self._native.velocity(self.id)

    def __repr__(self) -> str:
        # Debuggers ask at any time, so this never raises.
        try:
            if not self.is_present:
                return f"<Object {self.id}: gone>"
            x, y, z = self.position
        except RuntimeError as error:
            return f"<Object {self.id}: {error}>"
        return f"<Object {self.id} at ({x:.3f}, {y:.3f}, {z:.3f}) m>"


class Arm:
    """An arm of the robot, with n joints."""

    def __init__(self, native: Any, name: str) -> None:
        self._native, self.name = native, name

    @property
    def q(self) -> Floats:
        """(n,): angles of the joints, from the shoulder to the wrist [rad; m of a sliding joint]"""
        return self._native.arm_angles(self.name)

    @property
    def velocities(self) -> Floats:
        """(n,) [rad/s; m/s]"""
        return self._native.arm_velocities(self.name)

    @property
    def gripper(self) -> float:
        """Opening of the gripper [m]; 0 without one"""
        return self._native.gripper_opening(self.name)

    @property
    def tool_pose(self) -> Floats:
        """(7,): the tool, between the fingers with z along the approach, in the world"""
        return self._native.tool_pose(self.name)

    @property
    def held(self) -> list[str]:
        """Ids of the objects that the gripper holds."""
        return self._native.arm_held(self.name)

    def move(self, velocities: npt.ArrayLike | None = None, gripper: float | None = None) -> None:
        """Sets velocities, in effect until the next command.

        velocities  (n,) of the joints [rad/s; m/s]
        gripper     rate of change of the opening [m/s]; above 0 opens
        """
        joints = None if velocities is None else np.asarray(velocities, float)
        _demand(self._native.set_joint_velocities(self.name, joints, gripper))

    def set_q(self, angles: npt.ArrayLike) -> None:
        """Sets the angles of the joints at once, (n,) [rad; m]; held objects come along."""
        _demand(self._native.set_joint_angles(self.name, np.asarray(angles, float)))


class Robot:
    """The robot of a simulation."""

    def __init__(self, native: Any) -> None:
        self._native = native

    @property
    def arms(self) -> Mapping[str, Arm]:
        """Arms by name."""
        return _Lookup(self._native.model().arm_names, lambda name: Arm(self._native, name))

    @property
    def is_following(self) -> bool:
        """True while joints move to a pose or along a trajectory."""
        return self._native.is_robot_following()

    def move_to_pose(self, name: str, speed: float = 0.5) -> None:
        """Moves arms and head straight to a named pose, at a fraction of their maximum speed."""
        _demand(self._native.apply(json.dumps({"do": "pose", "name": name, "speed": speed})))


def _recording() -> Any:
    # Imported late: it imports this module.
    return importlib.import_module("smile.recording")


class _Lookup(Mapping[str, _T]):
    """Things by name, made when they are looked up."""

    def __init__(self, names: Sequence[str], make: Callable[[str], _T]) -> None:
        self._names, self._make = list(names), make

    def __getitem__(self, name: str) -> _T:
        if name not in self._names:
            raise KeyError(f"{name!r}, expected one of {', '.join(self._names) or 'none'}")
        return self._make(name)

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)


class Simulation:
    """A model in motion.

    One thread at a time may use it; other threads run while it steps and renders. `close()` ends
    it, as does the end of a `with` block.
    """

    def __init__(self, model: Model) -> None:
        if not isinstance(model, Model):
            raise TypeError(f"model is {type(model).__name__}, expected what smile.load() returns")
        self._native = _native.Simulation(model)

    def __enter__(self) -> Simulation:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None,
                 trace: TracebackType | None) -> None:
        self.close()

    def close(self) -> None:
        """Ends the simulation; a recording is written to its end."""
        self._native.close()

    @property
    def model(self) -> Model:
        """The model, which changes only by commands that add objects."""
        return self._native.model()

    @property
    def tick(self) -> int:
        """Number of ticks since the start."""
        return self._native.tick()

    @property
    def time(self) -> float:
        """Simulated time since the start [s]."""
        return self.tick / TICKS_PER_SECOND

    @property
    def hash(self) -> int:
        """64-bit hash of all state that affects the future."""
        return self._native.hash()

    @property
    def is_still(self) -> bool:
        """True if no object except held ones moves faster than 2 mm/s or 0.02 rad/s."""
        return self._native.is_still()

    @property
    def events(self) -> list[Event]:
        """Events so far, as dicts with `tick` and `kind`, without those of undone actions."""
        return self._native.events()

    @property
    def objects(self) -> Mapping[str, Object]:
        """Objects by id, also those that are gone."""
        return _Lookup(self._native.object_ids(), lambda id: Object(self._native, id))

    @property
    def object_ids(self) -> list[str]:
        """Ids of the objects, in the order of the scene."""
        return self._native.object_ids()

    @property
    def poses(self) -> Floats:
        """(objects, 7) in the order of `object_ids`, as Object.pose; NaN for those that are gone."""
        return self._native.poses()

    @property
    def controls(self) -> dict[str, str]:
        """States of the switches, lights and controls, by id."""
        return json.loads(self._native.describe_controls())

    @property
    def robot(self) -> Robot | None:
        """The robot; None for a table without one."""
        return Robot(self._native) if self.model.has_robot else None

    def hand(self, name: str = "any") -> Hand:
        """Returns a hand of the demonstrator: `left`, `right`, `both` or `any`."""
        if name not in _native.HandName.__members__:
            raise ValueError(f"hand is {name!r}, expected left, right, both or any")
        return Hand(self._native, name)

    def apply(self, command: Mapping[str, Any]) -> None:
        """Applies a command in its written form (docs/commands.md), in units of the scene.

        Raises ValueError if it is not a command, Refused if it cannot be carried out.
        """
        _demand(self._native.apply(json.dumps(dict(command))))

    def undo(self) -> None:
        """Reverts the last action and everything after it, to the last bit."""
        self.apply({"do": "undo"})

    def redo(self) -> None:
        """Repeats what the last undo reverted."""
        self.apply({"do": "redo"})

    def step(self, ticks: int = 1) -> None:
        """Advances by ticks of 1/60 s."""
        self._native.step(_whole("ticks", ticks, 0, _MOST_TICKS))

    def run_until(self, condition: str | Callable[[Simulation], bool], timeout: float = 60) -> None:
        """Advances, at least by a tick, until a condition holds.

        condition  `arrived`: hands and robot reached their goals; `still`: all objects are at rest,
                   for a quarter of a second; or a function, called after each tick
        timeout    simulated time after which TimeoutError is raised [s]
        """
        if not (math.isfinite(timeout) and timeout > 0):
            raise ValueError(f"timeout is {timeout!r}, expected a number of seconds above 0")
        ticks = _whole("timeout in ticks", math.ceil(timeout * TICKS_PER_SECOND), 1, _MOST_TICKS)
        if callable(condition):
            for _ in range(ticks):
                self._native.step(1)
                if condition(self):
                    return
        elif condition in ("arrived", "still"):
            if self._native.run_until(condition, ticks):
                return
        else:
            raise ValueError(f"condition is {condition!r}, expected 'arrived', 'still' or a function")
        name = getattr(condition, "__name__", condition)
        raise TimeoutError(f"{name} did not hold within {timeout:g} s of simulated time")

    def save(self) -> State:
        """Returns the complete state.

        It can be pickled; `bytes(state)` continues with the same bits in another process of the same
        build, on the same model.
        """
        return self._native.save()

    def restore(self, state: State | bytes) -> None:
        """Continues from a saved state. Earlier actions can no longer be undone.

        Raises ValueError if it is damaged or belongs to another scene or robot.
        """
        self._native.restore(state if isinstance(state, State) else State(state))

    def record(self, directory: str | os.PathLike[str], *, rate: float = 4, pictures: bool = True,
               size: tuple[int, int] = (640, 480), camera: str = "eye", title: str = "",
               notes: str = "") -> None:
        """Starts a recording in a new directory, until finish() or close().

        rate    pictures per second of simulated time, at most 60
        size    width and height of the pictures [px]
        """
        self._native.record(os.fspath(directory), rate, pictures, *picture_size(size), camera, title,
                            notes)

    def finish(self) -> Recording:
        """Ends the recording, and opens it."""
        return _recording().open(self._native.finish())

    def render(self, camera: str = "eye", size: tuple[int, int] = (640, 480),
               channels: Sequence[str] = ("rgb",)) -> Picture:
        """Renders what a camera sees.

        camera    one of `model.camera_names`, or a view for people: `close`, or
                  `FROM:TO[:FOV]` in units of the scene, as for `smile render`
        size      width and height [px]
        channels  some of `rgb`, `depth`, `id`
        """
        return Picture(*self._native.render(camera, *picture_size(size), *channel_flags(channels)))
