"""SMILE's demonstrator in MuJoCo: hands for the free bodies of an MJCF model, undo, and exact recordings.

    from smile.adapters.mujoco import Demonstrator
    with_hands = Demonstrator("scene.xml")
    hand = with_hands.hand("right")
    hand.grasp("cup")

Or with the mouse, in the studio's page: `python3 -m smile.adapters.mujoco scene.xml`.

MuJoCo's Python package is needed: `pip install mujoco`. See docs/other-simulators.md.
"""

from __future__ import annotations

import argparse
import hashlib
import os
import sys
import webbrowser
from pathlib import Path
from typing import Any

import mujoco
import numpy as np

from smile.adapters import demonstrator as _demonstrator
from smile.adapters.drawing import Drawing
from smile.adapters.engine import Floats
from smile.adapters.mujoco_drawing import drawing_of
from smile.adapters.page import Page

Source = str | os.PathLike[str] | Any

_STATE = mujoco.mjtState.mjSTATE_INTEGRATION
_BAD = (mujoco.mjtWarning.mjWARN_BADQPOS, mujoco.mjtWarning.mjWARN_BADQVEL, mujoco.mjtWarning.mjWARN_BADQACC)


class MujocoEngine:
    """A MuJoCo model as an Engine (smile.adapters.engine).

    While a hand carries a free body, `xfrc_applied` of the body and of all that hangs on it bears their weight, and
    `qfrc_applied` gives it the velocities that the hand wants. As forces, they do not press contacts, which are soft
    in MuJoCo, deeper than a weight does.
    """

    def __init__(self, model: Source, data: Any = None) -> None:
        """Takes a model, or reads it from an MJCF file.

        data    state at the start; it is advanced in place. By default that of the model.
        """
        self.model = model if isinstance(model, mujoco.MjModel) else mujoco.MjModel.from_xml_path(os.fspath(model))
        if self.model.opt.enableflags & mujoco.mjtEnableBit.mjENBL_SLEEP:
            raise ValueError("the model lets bodies sleep, which saved states of MuJoCo do not contain: expected the "
                             'flag sleep="disable"')
        self.data = mujoco.MjData(self.model) if data is None else data
        mujoco.mj_forward(self.model, self.data)
        self._size = mujoco.mj_stateSize(self.model, _STATE)
        self._ids = {self.model.body(body).name: body for body in range(1, self.model.nbody)}
        self._ids.pop("", None)
        self._carried = np.zeros(self.model.nbody, np.uint8)

    @property
    def name(self) -> str:
        return f"MuJoCo {mujoco.__version__}"

    @property
    def step_seconds(self) -> float:
        return float(self.model.opt.timestep)

    @property
    def object_ids(self) -> list[str]:
        """Names of the bodies with a free joint."""
        return [name for name, body in self._ids.items() if self._is_free(body)]

    def drawing(self) -> Drawing:
        return drawing_of(self.model, {name: self._ids[name] for name in self.object_ids}, self.data)

    def frame_poses(self) -> Floats:
        # Those of `data` are from the begin of the last step.
        mujoco.mj_kinematics(self.model, self.data)
        return np.concatenate([self.data.xpos, self.data.xquat], 1)

    def model_hash(self) -> str:
        content = np.zeros(mujoco.mj_sizeModel(self.model), np.uint8)
        mujoco.mj_saveModel(self.model, None, content)
        return hashlib.sha256(content.tobytes()).hexdigest()

    def refuse_to_reach(self, object: str) -> str | None:
        if object in self._ids:
            return None
        return f"there is no body '{object}', expected one of {', '.join(self.object_ids) or 'none'}"

    def refuse_to_carry(self, body: int) -> str | None:
        name = self.object_of(body)
        if self._is_free(body):
            return None
        if self.model.body_mocapid[body] >= 0:
            return f"'{name}' is a mocap body, which only its program moves"
        if self.model.body_weldid[body] == 0:
            return f"'{name}' is fixed (it has no joint)"
        return f"'{name}' has no free joint: hands carry bodies that nothing holds"

    def body_of(self, object: str) -> int:
        return self._ids[object]

    def object_of(self, body: int) -> str:
        return self.model.body(body).name

    def motion_of(self, body: int) -> tuple[Floats, Floats]:
        pose, velocity = self._pose(body).copy(), self._velocity(body).copy()
        # MuJoCo has the angular velocity of a free body along the body's own axes.
        mujoco.mju_rotVecQuat(velocity[3:], self._velocity(body)[3:], _unit(pose[3:]))
        return pose, velocity

    def set_carried(self, body: int, is_carried: bool) -> None:
        self._carried[body] = is_carried
        gravity = np.zeros(3) if self._has_no_gravity() else self.model.opt.gravity
        for part in range(body, self.model.nbody):
            if self.model.body_rootid[part] == body:
                weight = self.model.body_mass[part] * (1 - self.model.body_gravcomp[part]) * gravity
                self.data.xfrc_applied[part] = 0
                if is_carried:
                    self.data.xfrc_applied[part, :3] = -weight
        self.data.qfrc_applied[self._tree(body)] = 0

    def set_velocity(self, body: int, linear: Floats, angular: Floats) -> None:
        wanted, inverse = np.zeros(6), np.zeros(4)
        mujoco.mju_negQuat(inverse, _unit(self._pose(body)[3:]))
        wanted[:3] = linear
        mujoco.mju_rotVecQuat(wanted[3:], angular, inverse)
        if self._carried[body]:
            self._accelerate(body, (wanted - self._velocity(body)) / self.step_seconds)
        else:
            self._velocity(body)[:] = wanted

    def _accelerate(self, body: int, acceleration: Floats) -> None:
        """Applies the forces of an acceleration, with which what hangs on the body does not swing."""
        # The inertia of the present state: that of `data` is from the begin of the last step.
        mujoco.mj_kinematics(self.model, self.data)
        mujoco.mj_comPos(self.model, self.data)
        mujoco.mj_makeM(self.model, self.data)
        accelerations, forces = np.zeros(self.model.nv), np.zeros(self.model.nv)
        first = self.model.body_dofadr[body]
        accelerations[first:first + 6] = acceleration
        mujoco.mj_mulM(self.model, self.data, forces, accelerations)
        tree = self._tree(body)
        self.data.qfrc_applied[tree] = forces[tree]

    def step(self) -> None:
        before = [self.data.warning[kind].number for kind in _BAD]
        mujoco.mj_step(self.model, self.data)
        if before != [self.data.warning[kind].number for kind in _BAD]:
            raise RuntimeError(f"MuJoCo reports an unstable simulation at {self.data.time} s; undo returns to the "
                               "state before the last action")

    def save(self) -> bytes:
        state = np.zeros(self._size)
        mujoco.mj_getState(self.model, self.data, state, _STATE)
        return state.tobytes() + self._carried.tobytes()

    def restore(self, state: bytes) -> None:
        expected = 8 * self._size + self.model.nbody
        if len(state) != expected:
            raise ValueError(f"the state has {len(state)} bytes, expected {expected}")
        numbers = np.frombuffer(state, count=self._size)
        if not np.isfinite(numbers).all():
            raise ValueError("the state is not finite, expected finite numbers")
        # What follows from the state is computed for readers of `data`, which leaves its own traces in the state.
        mujoco.mj_setState(self.model, self.data, numbers, _STATE)
        mujoco.mj_forward(self.model, self.data)
        mujoco.mj_setState(self.model, self.data, numbers, _STATE)
        self._carried[:] = np.frombuffer(state, np.uint8, offset=8 * self._size)

    def _is_free(self, body: int) -> bool:
        joint = self.model.body_jntadr[body]
        return bool(joint >= 0 and self.model.jnt_type[joint] == mujoco.mjtJoint.mjJNT_FREE)

    def _has_no_gravity(self) -> bool:
        return bool(self.model.opt.disableflags & mujoco.mjtDisableBit.mjDSBL_GRAVITY)

    def _pose(self, body: int) -> Floats:
        first = self.model.jnt_qposadr[self.model.body_jntadr[body]]
        return self.data.qpos[first:first + 7]

    def _tree(self, body: int) -> Any:
        """Returns which degrees of freedom are those of a free body and of what hangs on it."""
        return self.model.dof_treeid == self.model.dof_treeid[self.model.body_dofadr[body]]

    def _velocity(self, body: int) -> Floats:
        first = self.model.body_dofadr[body]
        return self.data.qvel[first:first + 6]


def _unit(quaternion: Floats) -> Floats:
    return quaternion / np.linalg.norm(quaternion)


class Demonstrator(_demonstrator.Demonstrator):
    """Hands in a MuJoCo model; see smile.adapters.demonstrator.Demonstrator."""

    engine: MujocoEngine

    def __init__(self, model: Source, data: Any = None) -> None:
        """Takes a model, or reads it from an MJCF file; see MujocoEngine."""
        super().__init__(MujocoEngine(model, data))

    @property
    def model(self) -> Any:
        """The mujoco.MjModel."""
        return self.engine.model

    @property
    def data(self) -> Any:
        """The mujoco.MjData, to be read only."""
        return self.engine.data


    def page(self, *, port: int = 0, folder: str | os.PathLike[str] = "recordings") -> Page:
        """Opens the studio's page on the model, see smile.adapters.page.Page; page.serve() runs it."""
        return Page(self, port=port, folder=Path(folder))


def replay(path: str | os.PathLike[str], model: Source) -> _demonstrator.Demonstrator:
    """Carries out a recording again, with the same model and the same version of MuJoCo.

    Raises ValueError, with the line, at the first difference; see smile.adapters.demonstrator.replay().
    """
    return _demonstrator.replay(path, MujocoEngine(model))


def main(arguments: list[str] | None = None) -> int:
    """Serves the studio's page on a model; returns the exit code."""
    parser = argparse.ArgumentParser(prog="python3 -m smile.adapters.mujoco",
                                     description="Demonstrate in a MuJoCo model with the mouse, in SMILE's page")
    parser.add_argument("model", help="MJCF file")
    parser.add_argument("--port", type=int, default=0, help="port of the page (default: the first free one from 8470 on)")
    parser.add_argument("--recordings", default="recordings", help="folder of the recordings (default: recordings)")
    parser.add_argument("--open", action="store_true", help="open the page in the browser")
    options = parser.parse_args(arguments)
    try:
        page = Demonstrator(options.model).page(port=options.port, folder=options.recordings)
        for words in page.left_out:
            print(words, file=sys.stderr)
        print(page.url, flush=True)
        if options.open:
            webbrowser.open(page.url)
        page.serve()
        return 0
    except (ValueError, RuntimeError) as error:
        print(f"smile.adapters.mujoco: {error}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())
