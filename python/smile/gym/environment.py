"""Environment: a robot is to achieve what a demonstration showed."""

from __future__ import annotations

import json
import os
import struct
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import gymnasium
import numpy as np
import numpy.typing as npt
from gymnasium import spaces

from smile.gym.tasks import LEVELS, find_task
from smile.native import load
from smile.picture import Picture
from smile.simulation import (
    CHANNELS, TICKS_PER_SECOND, Floats, Model, Simulation, State, channel_flags, picture_size)
from smile.viewer import Studio

if TYPE_CHECKING:
    from smile import smile_simulator_native as _native
else:
    _native = load("smile_simulator_native")

MAX_EPISODE_STEPS = 600
CONTROLS = ("joint_velocities", "joint_positions", "end_effector", "waypoints")
REWARDS = ("sparse", "dense")
LAYOUTS = ("goal", "lerobot")
_MAGIC = b"SMILEGYM"
# Layouts that are tried before a task is said to be impossible.
_MOST_LAYOUTS = 20

Observation = dict[str, Any]


def _choice(name: str, value: Any, words: Sequence[str]) -> str:
    if value not in words:
        raise ValueError(f"{name} is {value!r}, expected one of {', '.join(words)}")
    return str(value)


def _number(name: str, value: Any, low: float, high: float) -> float:
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not low < value <= high:
        raise ValueError(f"{name} is {value!r}, expected a number above {low:g}, at most {high:g}")
    return float(value)


class Measured(NamedTuple):
    """What is the case in some episodes, a row for each."""

    observations: Floats  # (n, k), see Environment.observation_names
    achieved: Floats      # (n, g), see Environment.goal_names
    desired: Floats       # (n, g)
    scores: Floats        # (n, 3): score, share of the relations, closeness
    refusals: list[str | None]  # what of the actions was impossible

    def infos(self) -> dict[str, Any]:
        """Returns what the infos tell of each episode, (n) each."""
        score, relations, closeness = self.scores.T
        return {"is_success": score == 1, "score": score, "relations": relations,
                "closeness": closeness}


class Environment(gymnasium.Env[Observation, npt.NDArray[np.float32]]):
    """A robot is to achieve what a demonstration showed, in another layout of the objects.

    task, demo, scene  name of a shipped task; or None, a recording and a scene file
    robot      name or path of a robot, as for smile.load()
    arms       names of the arms that are controlled (default: all)
    control    `joint_velocities`, `joint_positions`, `end_effector` or `waypoints`
    reward     `sparse`: 0 if the task is achieved, else -1; `dense`: from -1 to 0
    level      of random layouts; `scene` for the positions in the scene file
    rate       actions per second of simulated time; it divides 60
    speed      greatest speed of joints, as a fraction of their limits
    displacement, rotation  of an end effector by an action of 1, along and about each axis [m, rad]
    workspace  corners (lowest, highest) of the box of waypoints, in the world [m]
    observe    `goal`: observation, achieved_goal, desired_goal; `lerobot`: agent_pos,
               environment_state
    cameras, channels, camera_size  pictures in the observation: names of cameras, some of `rgb` and
               `depth`, width and height [px]
    search     folders in which files of scene and robot are searched, too
    render_mode  `human`: the studio's page shows the episodes in real time, and opens in the browser
               if there is a screen; `rgb_array`: render() returns pictures
    render_camera, render_size  of these pictures

    Not thread-safe; several environments may be used by several threads.
    """

    metadata: dict[str, Any] = {"render_modes": ["human", "rgb_array"], "render_fps": 10}

    def __init__(self, task: str | None = "tower", *,
                 demo: str | os.PathLike[str] | None = None,
                 scene: str | os.PathLike[str] | None = None,
                 robot: str | os.PathLike[str] = "baxter", arms: Sequence[str] | None = None,
                 control: str = "end_effector", reward: str = "sparse", level: str | None = None,
                 rate: int = 10, speed: float = 0.5, displacement: float = 0.05,
                 rotation: float = 0.2,
                 workspace: tuple[Sequence[float], Sequence[float]] = ((-0.5, -0.5, 0), (0.5, 0.5, 0.5)),
                 observe: str = "goal", cameras: Sequence[str] = (),
                 channels: Sequence[str] = ("rgb",), camera_size: tuple[int, int] = (128, 96),
                 search: Sequence[str | os.PathLike[str]] = (), render_mode: str | None = None,
                 render_camera: str = "close", render_size: tuple[int, int] = (480, 360)) -> None:
        if rate not in range(1, TICKS_PER_SECOND + 1) or TICKS_PER_SECOND % rate != 0:
            raise ValueError(f"rate is {rate!r}, expected a divisor of {TICKS_PER_SECOND}")
        if render_mode not in (None, "human", "rgb_array"):
            raise ValueError(f"render_mode is {render_mode!r}, expected 'human', 'rgb_array' or None")
        if isinstance(arms, str) or isinstance(cameras, str):
            raise ValueError("arms and cameras are lists of names")
        self.render_mode = render_mode
        self.metadata = {**type(self).metadata, "render_fps": int(rate)}
        source = find_task(task, demo, scene, robot, tuple(os.fspath(folder) for folder in search))
        self.task = source.name
        self.task_description = "; ".join(source.goals.words(source.model.unit))
        self._max_episode_steps = MAX_EPISODE_STEPS  # as LeRobot expects
        self._base, self._goals = source.model, source.goals
        self._level = _choice("level", source.level if level is None else level, LEVELS)
        self._reward = _choice("reward", reward, REWARDS)
        self._control: tuple[Any, ...] = (
            _native.ControlKind.__members__[_choice("control", control, CONTROLS)],
            list(arms or ()), TICKS_PER_SECOND // int(rate), _number("speed", speed, 0, 1),
            _number("displacement", displacement, 0, 10), _number("rotation", rotation, 0, 10),
            np.asarray(workspace[0], float), np.asarray(workspace[1], float))
        self._observe = _choice("observe", observe, LAYOUTS)
        self._cameras, self._camera_size = tuple(cameras), picture_size(camera_size)
        self._channels = channel_flags(channels)
        self._render = (render_camera, picture_size(render_size))
        self._layout: tuple[int | None, str] = (None, "scene")
        self._studio: Studio | None = None
        self._team = _native.ThreadTeam(1)
        self._begin(self._base)
        self._make_spaces()

    def _begin(self, model: Model) -> None:
        """Begins an episode. Raises SceneError if there is nothing to do."""
        simulation = Simulation(model)
        # Objects that a level adds are not in the state: its size is the same in all episodes.
        options = (*self._control, self._base.object_ids)
        self._episode = _native.TaskEpisode(simulation._native, self._goals, *options)
        self._simulation = simulation
        if self._studio is not None:
            self._studio.show(simulation)

    def _make_spaces(self) -> None:
        observation, achieved = (rows[0] for rows in self._episode.now()[:2])
        self._num_robot_numbers: int = self._episode.num_robot_numbers
        every: dict[str, spaces.Space[Any]]
        if self._observe == "goal":
            every = {"observation": _box(observation.shape), "achieved_goal": _box(achieved.shape),
                     "desired_goal": _box(achieved.shape)}
        else:
            every = {"agent_pos": _box((self._num_robot_numbers,)),
                     "environment_state": _box((len(observation) - self._num_robot_numbers,))}
        self._picture_space = self._make_picture_space()
        self.observation_space = spaces.Dict({**every, **self._picture_space})
        self.action_space = spaces.Box(-1, 1, (len(self._episode.action_names),), np.float32)

    def _make_picture_space(self) -> spaces.Dict:
        width, height = self._camera_size
        unknown = set(self._cameras) - set(self._base.camera_names)
        if unknown:
            raise ValueError(f"cameras has {sorted(unknown)}, expected some of "
                             f"{', '.join(self._base.camera_names)}")

        def each(space: spaces.Space[Any]) -> spaces.Dict:
            return spaces.Dict({camera: space for camera in self._cameras})

        every: dict[str, spaces.Space[Any]] = {}
        if self._cameras and self._has("rgb"):
            every["pixels"] = each(spaces.Box(0, 255, (height, width, 3), np.uint8))
        if self._cameras and self._has("depth"):
            every["depth"] = each(spaces.Box(0, np.inf, (height, width), np.float32))
        if self._cameras:
            every["intrinsics"] = each(_box((3, 3)))
            every["extrinsics"] = each(_box((4, 4)))
        return spaces.Dict(every)

    def _has(self, channel: str) -> bool:
        return self._channels[CHANNELS.index(channel)]

    @property
    def simulation(self) -> Simulation:
        """The simulation of this episode, for looking at it and recording it."""
        return self._simulation

    @property
    def studio(self) -> Studio | None:
        """The page of `render_mode="human"`, with its `url`; None before the first reset()."""
        return self._studio

    @property
    def action_names(self) -> list[str]:
        """Names of the numbers of an action."""
        return self._episode.action_names

    @property
    def observation_names(self) -> list[str]:
        """Names of the numbers of `observation`; `agent_pos` are those of the robot."""
        return self._episode.observation_names

    @property
    def goal_names(self) -> list[str]:
        """Names of the numbers of a goal."""
        return self._goals.names(self._base.unit)

    def reset(self, *, seed: int | None = None,
              options: dict[str, Any] | None = None) -> tuple[Observation, dict[str, Any]]:
        """Begins an episode in a new random layout.

        options  `level`: of the layout, for this episode
        """
        self._restart(seed, options)
        return self._told()

    def _restart(self, seed: int | None = None, options: dict[str, Any] | None = None) -> None:
        super().reset(seed=seed)
        unknown = set(options or {}) - {"level"}
        if unknown:
            raise ValueError(f"options has {sorted(unknown)}, expected only 'level'")
        level = _choice("level", (options or {}).get("level", self._level), LEVELS)
        for attempt in range(_MOST_LAYOUTS):
            layout = None if level == "scene" else int(self.np_random.integers(2**63))
            try:
                self._begin(self._laid_out(layout, level))
                break
            except ValueError:
                # There was no room, or chance did the task already (SceneError).
                if layout is None or attempt + 1 == _MOST_LAYOUTS:
                    raise
        self._layout = (layout, level)
        if self.render_mode == "human" and self._studio is None:
            self._studio = Studio(self._simulation, speed=1)
            self._studio.open()

    def _laid_out(self, seed: int | None, level: str) -> Model:
        return self._base if seed is None else self._base.laid_out(seed, level)

    def step(self, action: npt.ArrayLike) -> tuple[Observation, float, bool, bool, dict[str, Any]]:
        """Carries out an action (docs/gym.md)."""
        row = np.asarray(action, float).reshape(1, -1)
        measured = Measured(*_native.step_episodes([self._episode], row, self._team))
        observation, info = self._told(measured)
        return observation, float(self._rewards(measured)[0]), info["is_success"], False, info

    def _measure(self) -> Measured:
        """Returns what is the case now."""
        return Measured(*self._episode.now())

    def _told(self, measured: Measured | None = None) -> tuple[Observation, dict[str, Any]]:
        """Returns an observation and an info."""
        rows = measured or self._measure()
        observation = {name: values[0] for name, values in self._numbers(rows).items()}
        if self._cameras:
            observation.update(self._pictures())
        info = {name: values[0].item() for name, values in rows.infos().items()}
        if rows.refusals[0] is not None:
            info["refused"] = rows.refusals[0]
        return observation, info

    def _numbers(self, measured: Measured) -> Observation:
        """Returns the observation without pictures, a row for each episode."""
        if self._observe == "goal":
            return {"observation": measured.observations, "achieved_goal": measured.achieved,
                    "desired_goal": measured.desired}
        robot, others = np.split(measured.observations, [self._num_robot_numbers], axis=1)
        return {"agent_pos": robot, "environment_state": others}

    def _rewards(self, measured: Measured) -> Floats:
        rewards: Floats = self._reward_of(*measured.scores.T)
        return rewards

    def _pictures(self) -> Observation:
        pictures = {camera: Picture(*self._simulation._native.render(
            camera, *self._camera_size, *self._channels)) for camera in self._cameras}
        observation: Observation = {}
        if self._has("rgb"):
            observation["pixels"] = {name: one.rgb for name, one in pictures.items()}
        if self._has("depth"):
            observation["depth"] = {name: one.depth for name, one in pictures.items()}
        observation["intrinsics"] = {name: one.intrinsics for name, one in pictures.items()}
        observation["extrinsics"] = {name: one.pose for name, one in pictures.items()}
        return observation

    def _reward_of(self, score: Any, relations: Any, closeness: Any) -> Any:
        if self._reward == "sparse":
            return score * 0.0 - (score != 1)
        return (score + relations + closeness) / 3 - 1

    def _scores(self, achieved_goal: npt.ArrayLike,
                desired_goal: npt.ArrayLike) -> tuple[Floats, Floats, Floats]:
        achieved, desired = np.asarray(achieved_goal, float), np.asarray(desired_goal, float)
        size = self._goals.size
        if achieved.shape != desired.shape or achieved.shape[-1:] != (size,):
            raise ValueError(f"achieved_goal has shape {achieved.shape} and desired_goal "
                             f"{desired.shape}, expected both (..., {size})")
        rows = self._goals.compare(achieved.reshape(-1, size), desired.reshape(-1, size))
        score, relations, closeness = rows.T.reshape((3, *achieved.shape[:-1]))
        return score, relations, closeness

    def compute_reward(self, achieved_goal: npt.ArrayLike, desired_goal: npt.ArrayLike,
                       info: Any = None) -> Any:
        """Returns the reward of a goal that was achieved while another one was desired.

        achieved_goal, desired_goal  (..., n); the result has the leading axes, a float without
        """
        reward = self._reward_of(*self._scores(achieved_goal, desired_goal))
        return float(reward) if np.ndim(reward) == 0 else reward

    def compute_terminated(self, achieved_goal: npt.ArrayLike, desired_goal: npt.ArrayLike,
                           info: Any = None) -> Any:
        """Returns whether an episode ends with success, with shapes as in compute_reward()."""
        is_done = self._scores(achieved_goal, desired_goal)[0] == 1
        return bool(is_done) if np.ndim(is_done) == 0 else is_done

    def compute_truncated(self, achieved_goal: npt.ArrayLike, desired_goal: npt.ArrayLike,
                          info: Any = None) -> Any:
        """Returns False: only time limits end an episode that has not succeeded."""
        shape = np.shape(achieved_goal)[:-1]
        return np.zeros(shape, bool) if shape else False

    def get_state(self) -> bytes:
        """Returns the complete state, with that of `np_random`.

        An environment that was made with the same arguments, also in another process of the same
        build, continues from it with the same bits. A limit of the episode's steps, which is in
        wrappers, is not in it.
        """
        header = json.dumps({"layout": self._layout,
                             "np_random": self.np_random.bit_generator.state}).encode()
        return b"".join((_MAGIC, struct.pack("<I", len(header)), header, bytes(self._simulation.save())))

    def set_state(self, state: bytes) -> tuple[Observation, dict[str, Any]]:
        """Continues from a state that get_state() returned.

        Returns the observation and the info of that moment. Raises ValueError if the state is
        damaged or belongs to another environment; this one has then not changed.
        """
        layout, generator, saved = _parts_of(state)
        before = self._simulation, self._episode, self._layout
        try:
            if layout != self._layout:
                self._begin(self._laid_out(*layout))
            self._simulation.restore(State(saved))
        except ValueError:
            self._simulation, self._episode, self._layout = before
            if self._studio is not None:
                self._studio.show(self._simulation)
            raise
        self._layout = layout
        self.np_random = generator
        return self._told()

    def render(self) -> npt.NDArray[np.uint8] | None:
        """Returns a picture (height, width, 3) in the mode `rgb_array`.

        None otherwise; in the mode `human`, the page shows each moment by itself.
        """
        if self.render_mode != "rgb_array":
            return None
        return self._simulation.render(*self._render).rgb

    def close(self) -> None:
        """Ends the simulation, a recording to its end, and the page of `render_mode="human"`."""
        self._simulation.close()
        if self._studio is not None:
            self._studio.close()


def _box(shape: tuple[int, ...]) -> spaces.Box:
    return spaces.Box(-np.inf, np.inf, shape, np.float64)


def _parts_of(state: bytes) -> tuple[tuple[int | None, str], np.random.Generator, bytes]:
    """Returns layout, generator and simulation of a state."""
    start = len(_MAGIC) + 4
    if not isinstance(state, bytes) or state[:len(_MAGIC)] != _MAGIC or len(state) < start:
        raise ValueError("state is not one of an environment, expected what get_state() returns")
    (header_size,) = struct.unpack("<I", state[len(_MAGIC):start])
    middle = start + header_size
    try:
        header = json.loads(state[start:middle])
        seed, level = header["layout"]
        if level not in LEVELS or not (seed is None or (isinstance(seed, int) and 0 <= seed < 2**63)):
            raise ValueError("layout")
        bits = np.random.PCG64()
        bits.state = header["np_random"]
    except (ValueError, KeyError, TypeError):
        raise ValueError("state is damaged, expected what get_state() returns") from None
    return (seed, level), np.random.Generator(bits), state[middle:]
