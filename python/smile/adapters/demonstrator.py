"""Demonstrator: hands, undo and recordings on an Engine."""

from __future__ import annotations

import base64
import hashlib
import json
import os
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from smile.adapters.engine import Engine, Floats
from smile.errors import Refused
from smile.native import load
from smile.simulation import Hand

if TYPE_CHECKING:
    from smile import smile_simulator_native as _native
else:
    _native = load("smile_simulator_native")

Row = dict[str, Any]

FORMAT, VERSION = "smile engine recording", 1
# Poses per second of simulated time in recordings.
_POSE_RATE = 60
_MOST_STEPS = 1_000_000_000


@dataclass(frozen=True)
class _Moment:
    engine: bytes
    hands: Any
    step: int
    rows: int


class _Door:
    """What Hand uses of a simulation, on a Demonstrator."""

    def __init__(self, demonstrator: Demonstrator) -> None:
        self._demonstrator = demonstrator
        self.held, self.has_arrived = demonstrator._hands.held, demonstrator._hands.has_arrived

    def grasp(self, hand: Any, object: str, point: Floats | None) -> str | None:
        return self._demonstrator._apply({"do": "grasp", "hand": hand.name, "object": object,
                                          **({} if point is None else {"point": _vector("point", point).tolist()})})

    def move_to(self, hand: Any, position: Floats, speed: float | None) -> str | None:
        return self._demonstrator._apply({"do": "move", "hand": hand.name,
                                          "position": _vector("position", position).tolist(),
                                          **({} if speed is None else {"speed": float(speed)})})

    def rotate(self, hand: Any, angles: Floats) -> str | None:
        return self._demonstrator._apply({"do": "rotate", "hand": hand.name,
                                          "angles": _vector("angles", angles).tolist()})

    def apply(self, command: str) -> str | None:
        return self._demonstrator._apply(json.loads(command))


def _vector(name: str, values: Any) -> Floats:
    vector = np.asarray(values, float)
    if vector.shape != (3,) or not np.isfinite(vector).all():
        raise ValueError(f"{name} is {vector.tolist()}, expected three finite numbers")
    return vector


class Demonstrator:
    """Hands in another simulator, with undo and a recording of what they do.

    Hands are those of smile.Simulation: they grasp, carry, rotate and release. All else that hands can do is
    refused. The demonstrator advances the simulator; while it does, nothing else may change its state.
    """

    def __init__(self, engine: Engine) -> None:
        """Takes the simulator as it is; a recording begins here."""
        self.engine = engine
        self._is_recording = True
        self._hands = _native.EngineHands(engine)
        self._door = _Door(self)
        self._model, self._start = engine.model_hash(), engine.save()
        self._last = self._start
        self._step = 0
        self._rows: list[Row] = []
        self._undo: list[_Moment] = []
        self._redo: list[tuple[_Moment, _Moment, list[Row]]] = []
        self._steps_per_row = max(1, round(1 / (_POSE_RATE * engine.step_seconds)))

    @property
    def steps(self) -> int:
        """Number of steps since the start."""
        return self._step

    @property
    def time(self) -> float:
        """Simulated time since the start [s]."""
        return self._step * self.engine.step_seconds

    @property
    def hash(self) -> str:
        """Hash of the state of simulator and hands, to the last bit."""
        digest = hashlib.sha256(self.engine.save())
        digest.update(self._hands.hash().to_bytes(8, "little"))
        return digest.hexdigest()[:16]

    @property
    def poses(self) -> dict[str, Floats]:
        """Poses of the objects that hands can carry, by id: (7,) x, y, z [m], w, qx, qy, qz."""
        return {id: self.engine.motion_of(self.engine.body_of(id))[0] for id in self.engine.object_ids}

    @property
    def events(self) -> list[Row]:
        """What hands did, without what was undone: dicts with `step`, `do`, `hand` and the command's values."""
        return [dict(row) for row in self._rows if "do" in row]

    def hand(self, name: str = "any") -> Hand:
        """Returns a hand of the demonstrator: `left`, `right`, `both` or `any`."""
        if name not in _native.HandName.__members__:
            raise ValueError(f"hand is {name!r}, expected left, right, both or any")
        return Hand(self._door, name)

    def refuse_to_grasp(self, hand: str, object: str) -> str | None:
        """Returns the reason why a hand cannot grasp an object now."""
        return self._hands.plan_grasp(_native.HandName.__members__[hand], object)[0]

    def goal(self, hand: str) -> tuple[Floats, Floats, Floats] | None:
        """Returns where a hand wants the grasped point [m], the object's origin [m], and its angles about the world's
        x, then y, then z axis [degrees]; None if it is empty."""
        return self._hands.goal(_native.HandName.__members__[hand])

    def point_on_plane(self, hand: str, origin: Floats, direction: Floats, angle: float, is_level: bool) -> Floats:
        """Returns the point [m] where a ray meets a plane through the hand's goal.

        angle     of a vertical plane, from the x axis [degrees]
        is_level  the plane is level instead

        Raises Refused with the reason if it meets none.
        """
        name = _native.HandName.__members__[hand]
        refusal, point = self._hands.point_on_plane(name, origin, direction, angle, is_level)
        if refusal is not None or point is None:
            raise Refused(refusal)
        return point

    def refusal_of(self, command: str) -> str:
        """Returns the reason why hands cannot do here what they do in SMILE's own worlds."""
        return f"'{command}' needs SMILE's own worlds; in {self.engine.name}, hands grasp, move, rotate and release"

    def step(self, count: int = 1) -> None:
        """Advances by a number of steps."""
        if isinstance(count, bool) or not isinstance(count, int) or not 0 <= count <= _MOST_STEPS:
            raise ValueError(f"count is {count!r}, expected a whole number from 0 to {_MOST_STEPS}")
        self._demand_untouched()
        try:
            for _ in range(count):
                self._hands.before_step()
                self.engine.step()
                self._step += 1
                if self._is_recording and self._step % self._steps_per_row == 0:
                    self._rows.append(self._row())
        finally:
            self._last = self.engine.save()

    def advance(self, seconds: float) -> None:
        """Advances by simulated seconds, rounded to whole steps."""
        if not 0 <= seconds <= _MOST_STEPS * self.engine.step_seconds:
            raise ValueError(f"seconds is {seconds!r}, expected a finite number of at least 0")
        self.step(round(seconds / self.engine.step_seconds))

    def advance_until_arrived(self, timeout: float = 10) -> bool:
        """Advances until all held objects are at their goals; returns false after `timeout` simulated seconds."""
        end = self.time + timeout
        while not all(self.hand(name).has_arrived for name in _native.HandName.__members__):
            if self.time >= end:
                return False
            self.step()
        return True

    def undo(self) -> None:
        """Reverts the last action and everything after it, to the last bit. The moves of a carry are one action."""
        if not self._undo:
            raise Refused("nothing to undo")
        self._demand_untouched()
        then = self._undo.pop()
        self._redo.append((then, self._moment(), self._rows[then.rows:]))
        self._return_to(then)

    def redo(self) -> None:
        """Repeats what the last undo reverted."""
        if not self._redo:
            raise Refused("nothing to redo")
        self._demand_untouched()
        then, later, rows = self._redo.pop()
        self._undo.append(then)
        # What happened since the undo is dropped.
        self._rows[then.rows:] = rows
        self._return_to(later)

    @property
    def can_undo(self) -> bool:
        return bool(self._undo)

    @property
    def can_redo(self) -> bool:
        return bool(self._redo)

    def refuse_to_start(self) -> str | None:
        """Returns the reason why no recording can begin now."""
        for name in _native.HandName.__members__:
            held = self.hand(name).held
            if held is not None:
                return f"hand '{name}' holds '{held}'; release it first, as recordings begin with empty hands"
        return None

    def start(self) -> None:
        """Begins a recording here. What was done before is not in it, and can no longer be undone."""
        refusal = self.refuse_to_start()
        if refusal is not None:
            raise Refused(refusal)
        self._demand_untouched()
        self._start, self._step, self._is_recording = self._last, 0, True
        for kept in (self._rows, self._undo, self._redo):
            kept.clear()

    def finish(self, path: str | os.PathLike[str]) -> None:
        """Writes the recording, see save(), and ends it: poses are no longer kept, until start() begins another."""
        self.save(path)
        self._is_recording = False

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes a recording: what hands did, and the poses of all objects at 60 Hz. See docs/other-simulators.md.

        Raises RuntimeError if the model was changed since the start, or the recording has ended.
        """
        if not self._is_recording:
            raise RuntimeError("there is no recording: finish() ended it, expected start() before")
        if self.engine.model_hash() != self._model:
            raise RuntimeError("the model was changed since the start, which a recording cannot contain")
        head = {"format": FORMAT, "version": VERSION, "engine": self.engine.name, "model": self._model,
                "step_seconds": self.engine.step_seconds, "start": base64.b64encode(self._start).decode()}
        with open(path, "w", encoding="utf-8") as file:
            for row in (head, *self._rows, {**self._row(), "end": True}):
                file.write(json.dumps(row, allow_nan=False) + "\n")

    def _row(self) -> Row:
        return {"step": self._step, "poses": {id: pose.tolist() for id, pose in self.poses.items()}, "hash": self.hash}

    def _moment(self) -> _Moment:
        return _Moment(self.engine.save(), self._hands.states(), self._step, len(self._rows))

    def _return_to(self, moment: _Moment) -> None:
        self.engine.restore(moment.engine)
        self._hands.restore(moment.hands)
        self._step, self._last = moment.step, moment.engine
        del self._rows[moment.rows:]

    def _demand_untouched(self) -> None:
        if self.engine.save() != self._last:
            raise RuntimeError(f"the state of {self.engine.name} was changed outside of the demonstrator, which a "
                               "recording cannot contain")

    def _apply(self, command: Row) -> str | None:
        """Carries out a command and records it; returns the reason if it is refused, without effect."""
        self._demand_untouched()
        if command["do"] == "grasp":
            refusal, to_release = self._hands.plan_grasp(_hand(command), command["object"])
            if refusal is not None:
                return refusal
            for other in to_release:  # each is an action of its own
                self._apply({"do": "release", "hand": other.name})
        before = self._moment()
        refusal = self._perform(command)
        if refusal is not None:
            return refusal
        if not (command["do"] == "move" and self._goes_on(command["hand"])):
            self._undo.append(before)
        self._redo.clear()
        self._rows.append({"step": self._step, **command})
        self._last = self.engine.save()
        return None

    def _goes_on(self, hand: str) -> bool:
        """Returns true if the last command was a move of this hand."""
        last = next((row for row in reversed(self._rows) if "do" in row), None)
        return last is not None and last["do"] == "move" and last["hand"] == hand

    def _perform(self, command: Row) -> str | None:
        hand, do = _hand(command), command["do"]
        if do == "grasp":
            point = _vector("point", command["point"]) if "point" in command else None
            return self._hands.grasp(hand, command["object"], point)
        if do == "move":
            return self._hands.move_to(hand, _vector("position", command["position"]), command.get("speed"))
        if do == "rotate":
            return self._hands.rotate(hand, _vector("angles", command["angles"]))
        if do == "release":
            return self._hands.release(hand)
        return self.refusal_of(do)


def _hand(command: Row) -> Any:
    return _native.HandName.__members__[command["hand"]]


def replay(path: str | os.PathLike[str], engine: Engine) -> Demonstrator:
    """Carries out a recording again in an engine of the same model; returns the demonstrator at its end.

    Raises ValueError, with the line, if it is not a recording, was made by another engine, version or model, or if
    any pose or any state differs in a single bit.
    """
    where, line = os.fspath(path), 0
    try:
        with open(path, encoding="utf-8") as file:
            lines = file.read().splitlines()
        line = 1
        demonstrator = _begin(_row_of(lines[0] if lines else ""), engine)
        for line, text in enumerate(lines[1:], 2):
            if _replay_row(_row_of(text), demonstrator):
                break
        else:
            raise ValueError("the recording ends without its last row")
        if line != len(lines):
            line += 1
            raise ValueError("expected nothing after the last row")
        return demonstrator
    except (ValueError, KeyError, TypeError) as error:
        what = f"{error.args[0]!r} is missing or unknown" if isinstance(error, KeyError) else str(error)
        raise ValueError(f"{where}:{line}: {what}") from None


def _row_of(text: str) -> Row:
    row = json.loads(text)
    if not isinstance(row, dict):
        raise ValueError(f"found {type(row).__name__}, expected a JSON object")
    return row


def _begin(head: Row, engine: Engine) -> Demonstrator:
    expected = {"format": FORMAT, "version": VERSION, "engine": engine.name, "model": engine.model_hash(),
                "step_seconds": engine.step_seconds}
    for name, value in expected.items():
        if head[name] != value:
            raise ValueError(f"{name} is {head[name]!r}, expected {value!r}")
    engine.restore(base64.b64decode(head["start"], validate=True))
    return Demonstrator(engine)


def _replay_row(row: Row, demonstrator: Demonstrator) -> bool:
    """Carries out a row or compares it; returns true for the last one."""
    steps = row["step"] - demonstrator.steps
    if not isinstance(row["step"], int) or not 0 <= steps <= demonstrator._steps_per_row:
        raise ValueError(f"step is {row['step']!r}, expected a whole number from {demonstrator.steps} to "
                         f"{demonstrator.steps + demonstrator._steps_per_row}")
    demonstrator.step(steps)
    if "do" in row:
        refusal = demonstrator._apply({name: value for name, value in row.items() if name != "step"})
        if refusal is not None:
            raise ValueError(f"step {row['step']}: {row['do']} is refused: {refusal}")
        return False
    _compare(row, demonstrator._row())
    return bool(row.get("end", False))


def _compare(recorded: Row, replayed: Row) -> None:
    for id, pose in replayed["poses"].items():
        if recorded["poses"][id] != pose:
            raise ValueError(f"step {replayed['step']}: '{id}' is at {pose}, expected {recorded['poses'][id]}")
    if recorded["hash"] != replayed["hash"]:
        raise ValueError(f"step {replayed['step']}: the hash is {replayed['hash']}, expected {recorded['hash']}")
