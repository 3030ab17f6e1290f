"""The studio's page on a demonstrator in another simulator: people demonstrate there with the mouse."""

from __future__ import annotations

import json
import re
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from smile.adapters.demonstrator import Demonstrator
from smile.adapters.drawing import Drawing, Visual
from smile.adapters.engine import Engine, Floats
from smile.errors import Refused
from smile.native import load
from smile.viewer import page_folder

if TYPE_CHECKING:
    from smile import smile_simulator_native as _native
else:
    _native = load("smile_simulator_native")

Row = dict[str, Any]

# Pages count in the unit of SMILE's scenes [m].
_UNIT = 0.1
_FRAME = 1 / 60
_FRAMES_PER_STATE, _FRAMES_PER_KEY = 3, 60
_MOST_STEPS_AT_ONCE, _MOST_FRAMES_LATE = 4, 6
_SPEEDS = (0.1, 4.0)
# Slower than this, an object is at rest [m/s or rad/s].
_REST = 0.01
_DEFAULT_DEPTH = 1.2
_SCENE = 1
_COMMANDS = ("grasp", "move_to", "drag", "rotate", "release", "plane", "undo", "redo", "start", "finish")


class DrawnEngine(Engine, Protocol):
    """An engine that pages can draw."""

    def drawing(self) -> Drawing:
        """Returns what is drawn, which does not change."""

    def frame_poses(self) -> Floats:
        """Returns the poses of the frames, (n, 7) x, y, z, w, qx, qy, qz; the first is the world."""


class Page:
    """The studio's page at 127.0.0.1, which advances a demonstrator in real time.

    Only one page at a time controls; others watch. While it is open, nothing else may use the demonstrator.
    Recordings that people make there are written into a folder.
    """

    def __init__(self, demonstrator: Demonstrator, *, port: int = 0, folder: str | Path = "recordings",
                 tell: Callable[[str], None] = partial(print, flush=True)) -> None:
        """Starts to serve the page; update() carries out what people do there.

        port    of the page; 0 for the first free one from 8470 on
        folder  of recordings; made when the first one is written
        tell    called with a line about each recording

        Raises RuntimeError if the page is not built, or the port is taken.
        """
        if isinstance(port, bool) or not isinstance(port, int) or not 0 <= port <= 65535:
            raise ValueError(f"port is {port!r}, expected a whole number from 0 to 65535")
        self.demonstrator, self.folder, self._tell = demonstrator, Path(folder), tell
        self._engine: DrawnEngine = demonstrator.engine  # type: ignore[assignment]
        self._drawing = self._engine.drawing()
        self._planes = dict.fromkeys(_native.HandName.__members__, 0.0)
        self._recording: str | None = None
        self._is_paused, self._speed, self._measured = False, 1.0, 0.0
        self._owed, self._frames, self._measured_from = 0.0, 0, (time.monotonic(), 0.0)
        self._passed = 0.0
        self._sent_state: Row = {}
        self._sent_poses = np.zeros((0, 7))
        self._server = _native.PageServer(page_folder(), port, self._everything)
        self._put_contents()
        for name, carry_out in self._requests().items():
            self._server.handle(name, _in_json(carry_out))

    @property
    def url(self) -> str:
        """Link of the page."""
        return self._server.link

    @property
    def left_out(self) -> list[str]:
        """What is not drawn, in words."""
        return list(self._drawing.left_out)

    def serve(self) -> None:
        """Updates 60 times a second, until close() or Ctrl-C."""
        due = time.monotonic()
        try:
            while not self._server.is_closed:
                self.update()
                # After a long interruption, frames do not catch up in a burst.
                due = max(due + _FRAME, time.monotonic() - _MOST_FRAMES_LATE * _FRAME)
                time.sleep(max(0.0, due - time.monotonic()))
        except KeyboardInterrupt:
            pass
        finally:
            self.close()

    def update(self) -> None:
        """Carries out what people did, and advances the simulator by a frame of 1/60 s."""
        self._server.update()
        try:
            self._advance()
        except RuntimeError as error:  # as when numbers explode: undo leads back
            self._is_paused = True
            self._server.send(json.dumps({"t": "error", "error": str(error)}))
        if self._frames % _FRAMES_PER_STATE == 0:
            state = self._state()
            if state != self._sent_state:
                self._server.send(json.dumps(state))
                self._sent_state = state
        self._send_poses()
        self._frames += 1

    def close(self) -> None:
        """Ends the page, and writes a recording that is in progress."""
        if self._server.is_closed:
            return
        try:
            if self._recording is not None:
                self._finish({})
        finally:
            self._server.close()

    def __enter__(self) -> Page:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None,
                 trace: TracebackType | None) -> None:
        self.close()

    def _put_contents(self) -> None:
        self._server.put("/scenes", "application/json", b'{"scenes":[],"presets":[]}')
        for number, mesh in enumerate(self._drawing.meshes):
            self._server.put(f"/meshes/{_SCENE}/{number}", "application/octet-stream", mesh)

    def _requests(self) -> dict[str, Callable[[Row], Row]]:
        """Returns the functions that carry out requests, by their names; those about lists are always asked."""
        return {"command": lambda asked: self._command(asked["command"]),
                "allowed": lambda asked: {"allowed": [self._allowed(one) for one in asked["requests"]]},
                "pause": lambda _: self._pause(True), "resume": lambda _: self._pause(False),
                "speed": self._set_speed,
                "library": lambda _: {"recordings": []}, "brains": lambda _: {"brains": []},
                "jobs": lambda _: {"jobs": [], "folder": "", "levels": [], "variations": [], "formats": [],
                                   "cameras": [], "rates": [], "max_count": 0, "max_jobs": 0}}

    def _command(self, command: Any) -> Row:
        meant = self._meant_by(command)
        if isinstance(meant, tuple):
            return self._drag(*meant)
        values = json.loads(meant)
        on = self.demonstrator
        own: dict[str, Callable[[Row], Row]] = {
            "plane": self._turn_plane, "start": self._start, "finish": self._finish,
            "undo": lambda _: self._go(on.undo), "redo": lambda _: self._go(on.redo)}
        if values["do"] in own:
            return own[values["do"]](values)
        hand = on.hand(values["hand"])
        if values["do"] == "grasp":
            hand.grasp(values["object"], values.get("point"))
        elif values["do"] == "move_to":
            hand.move_to(values["position"], values.get("speed"))
        elif values["do"] == "rotate":
            hand.rotate(np.radians(values["angles"]))
        else:
            hand.release()
        return {}

    def _meant_by(self, command: Any) -> Any:
        """Returns a command as read_command() does. Raises ValueError if it is none, and Refused if hands have none
        like it here."""
        meant = _native.read_command(json.dumps(command), _UNIT)
        if command["do"] not in _COMMANDS:
            raise Refused(self.demonstrator.refusal_of(command["do"]))
        return meant

    def _drag(self, hand: str, origin: Floats, direction: Floats, is_level: bool, speed: float | None) -> Row:
        point = self.demonstrator.point_on_plane(hand, origin, direction, self._planes[hand], is_level)
        self.demonstrator.hand(hand).move_to(point, speed)
        return {}

    def _turn_plane(self, command: Row) -> Row:
        self._planes[command["hand"]] = command["angle"]
        return {}

    def _go(self, there: Callable[[], None]) -> Row:
        there()
        self._owed = 0.0
        return {}

    def _start(self, command: Row) -> Row:
        if self._recording is not None:
            raise Refused(f"'{self._recording}' is being recorded; finish it first")
        name = command.get("name") or re.sub(r"[^\w-]+", "-", self._drawing.name)
        if not re.fullmatch(r"[\w-]{1,100}", name):
            raise Refused(f"name is {name!r}, expected at most 100 letters, digits, _ and -")
        number = next(k for k in range(1, 1_000_000) if not self._file(f"{name}-{k}").exists())
        self.demonstrator.start()
        self._recording = f"{name}-{number}"
        return {"recording": self._recording}

    def _finish(self, _: Row) -> Row:
        if self._recording is None:
            raise Refused("there is no recording to finish")
        file = self._file(self._recording)
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
            self.demonstrator.finish(file)
        except OSError as error:
            raise Refused(f"{file}: {error.strerror}") from None
        self._recording = None
        self._tell(f"recording: {file}")
        return {}

    def _file(self, name: str) -> Path:
        return self.folder / f"{name}.jsonl"

    def _pause(self, is_paused: bool) -> Row:
        self._is_paused = is_paused
        return {}

    def _set_speed(self, asked: Row) -> Row:
        if not _SPEEDS[0] <= asked["factor"] <= _SPEEDS[1]:
            raise Refused(f"factor is {asked['factor']}, expected a number from {_SPEEDS[0]} to {_SPEEDS[1]}")
        self._speed = float(asked["factor"])
        return {}

    def _allowed(self, asked: Row) -> bool | str:
        """Returns true, or the reason why a request would be refused now."""
        if asked.get("do") != "command":
            return self.demonstrator.refusal_of(str(asked.get("do")))
        try:
            meant = self._meant_by(asked.get("command"))
        except (Refused, ValueError) as error:
            return str(error)
        command = json.loads(meant) if isinstance(meant, str) else {"do": "drag"}
        if command["do"] != "grasp":
            return True
        return self.demonstrator.refuse_to_grasp(command["hand"], command["object"]) or True

    def _advance(self) -> None:
        now = time.monotonic()
        deadline = now + _FRAME
        if not self._is_paused:
            # Some steps per frame in any case, so that a slow simulation advances; what is late is dropped.
            step, frame = self._engine.step_seconds, _FRAME * self._speed
            self._owed = min(self._owed + frame, max(_MOST_FRAMES_LATE * frame, step))
            while self._owed >= step:
                count = min(_MOST_STEPS_AT_ONCE, int(self._owed / step))
                self.demonstrator.step(count)
                self._owed -= count * step
                self._passed += count * step
                if time.monotonic() > deadline:
                    break
        began, passed = self._measured_from
        if now - began > 1:
            self._measured, self._measured_from = (self._passed - passed) / (now - began), (now, self._passed)

    def _everything(self) -> list[str]:
        """Returns what a page that comes must know; poses follow with the next key."""
        self._sent_poses = np.zeros((0, 7))
        offers = {"t": "offers", "requests": sorted(self._requests()), "commands": list(_COMMANDS)}
        return [json.dumps(message) for message in (offers, self._scene(), self._state())]

    def _scene(self) -> Row:
        drawing = self._drawing
        depth = max(_DEFAULT_DEPTH, drawing.span) / _UNIT
        objects = [{"id": id, "frame": frame, "shape": "", "fixed": False, "parts": [], "controls": [], "bonds": False,
                    "properties": []} for id, frame in drawing.frame_of.items()]
        return {"t": "scene", "scene": _SCENE, "name": drawing.name, "metersPerUnit": _UNIT,
                "table": {"size": [depth, depth, 0]}, "center": (drawing.center / _UNIT).tolist(),
                "numFrames": drawing.num_frames, "robotFrame": None, "looks": [], "objects": objects, "robot": None,
                "visuals": [_describe(visual) for visual in drawing.visuals]}

    def _state(self) -> Row:
        recording: Row = {"id": self._recording, "title": self._recording, "seconds": round(self.demonstrator.time, 2),
                          "segments": [], "over": None, "corrects": None}
        return {"t": "state", "tick": self._tick, "mode": "live", "paused": self._is_paused,
                "allowed": {"requests": {}, "commands": self._allowed_commands()}, "speed": round(self._measured, 2),
                "hands": {name: self._hand(name) for name in self._planes}, "uses": {}, "still": self._is_still(),
                "recording": None if self._recording is None else recording, "playback": None, "restoring": None,
                "failure": None, "controls": {}, "gone": [], "fallen": [], "attention": {}, "robot": None,
                "brain": {"name": "", "status": "none", "message": "", "claim": None, "file": "", "line": 0},
                "snap": [], "eye": None, "markers": []}

    @property
    def _tick(self) -> int:
        return round(self.demonstrator.time / _FRAME)

    def _allowed_commands(self) -> Row:
        on = self.demonstrator
        return {"undo": on.can_undo or "nothing to undo", "redo": on.can_redo or "nothing to redo",
                "start": on.refuse_to_start() or True, "finish": True}

    def _hand(self, name: str) -> Row:
        goal = self.demonstrator.goal(name)
        hand = {"object": self.demonstrator.hand(name).held, "plane": round(self._planes[name], 4)}
        if goal is None:
            return hand
        point, origin, angles = goal
        return {**hand, "goal": _rounded(point / _UNIT), "place": _rounded(origin / _UNIT), "angles": _rounded(angles)}

    def _is_still(self) -> bool:
        velocities = [self._engine.motion_of(self._engine.body_of(id))[1] for id in self._engine.object_ids]
        return bool(np.abs(velocities).max() < _REST) if velocities else True

    def _send_poses(self) -> None:
        poses = self._engine.frame_poses()
        is_key = self._frames % _FRAMES_PER_KEY == 0 or poses.shape != self._sent_poses.shape
        # Frame 0 is the world, which never moves.
        moved = range(1, len(poses)) if is_key else np.flatnonzero((poses != self._sent_poses).any(1))
        frames = [int(frame) for frame in moved]
        in_units = np.concatenate([poses[:, :3] / _UNIT, poses[:, 4:], poses[:, 3:4]], 1)
        self._server.send_poses(_SCENE, self._tick, is_key, frames, in_units[frames].ravel().tolist())
        self._sent_poses = poses


def _in_json(carry_out: Callable[[Row], Row]) -> Callable[[str], str]:
    return lambda fields: json.dumps(carry_out(json.loads(fields)))


def _describe(visual: Visual) -> Row:
    lengths = [float(length) / _UNIT for length in visual.size]
    shapes: dict[str, Row] = {"block": {"block": lengths}, "sphere": {"sphere": lengths[0]},
                              "cylinder": {"cylinder": [*lengths[:2], int(visual.size[-1])]},
                              "mesh": {"mesh": int(visual.size[0]), "scale": 1 / _UNIT}}
    w, x, y, z = visual.rotation
    return {"frame": visual.frame, "object": visual.frame, "color": visual.color, "choice": -1, "look": 0,
            "pose": [*(float(length) / _UNIT for length in visual.position), x, y, z, w], **shapes[visual.shape]}


def _rounded(values: Floats) -> list[float]:
    return [round(float(value), 4) for value in values]
