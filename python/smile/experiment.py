"""What the program does with recordings, as functions of the same names: replay, describe, analyze, edit,
imitate, evaluate."""

from __future__ import annotations

import contextlib
import json
import os
import subprocess
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, cast

from smile import messages, program
from smile.brain_values import Values
from smile.exchange import Brain, Exchange, Step, exchange_of
from smile.native import load as _load_native
from smile.recording import Recording, open
from smile.simulation import Model, load, picture_size

if TYPE_CHECKING:
    import pandas

    from smile import smile_simulator_native as _native
else:
    _native = _load_native("smile_simulator_native")

Json = dict[str, Any]
PathLike = str | os.PathLike[str]
Progress = Callable[[str, float, float], object]
"""Called several times a second with the name of the step, done and total [s of simulated time; 0: unknown]."""


class Difference(NamedTuple):
    """A difference between a recording and its replay."""

    tick: int
    object: str
    """id, name of a joint, or `simulation`"""
    quantity: str
    """`position`, `rotation`, `angle`, `state_hash`, `command`, ..."""
    recorded: str
    replayed: str


class Deviation(NamedTuple):
    """How far an object or joint of a replay is from its recording."""

    object: str
    distance: float
    """the largest [m], at `tick`"""
    angle: float
    """[rad]"""
    tick: int


class Replay(NamedTuple):
    """A recording that was run again."""

    ticks: int
    """number that were compared"""
    hash: int
    """of the state at the end"""
    first_difference: Difference | None
    """None: each tick is the same to the last bit"""
    deviations: list[Deviation]
    """largest first"""
    refused: list[tuple[int, int, str]]
    """commands that are refused in the replay: tick, line of commands.jsonl, reason"""

    @property
    def is_identical(self) -> bool:
        """True if each tick has the recorded bits."""
        return self.first_difference is None


class Description(NamedTuple):
    """What a recording shows."""

    words: list[str]
    """for people: objects in the order in which they were placed, and other effects"""
    structure: Json
    """as `smile describe --json` (docs/results.md): lengths in units of the scene, angles in degrees"""


class Edit(NamedTuple):
    """What an edit does."""

    report: Json
    """as `smile edit --json` (docs/editing.md)"""
    recording: Recording | None
    """the new recording, if there was a place for it"""


class Imitation(NamedTuple):
    """An imitation and its score."""

    result: Json
    """`result.json` (docs/results.md): lengths in units of the scene, angles in degrees"""
    directory: Path
    """contains `result.json`, and the recording in `imitation/`"""
    brain_error: str | None
    """why the brain failed"""

    @property
    def is_success(self) -> bool:
        """True if all that was shown is in its place, and stands."""
        return bool(self.result["success"])

    @property
    def score(self) -> float:
        """fraction, 0 to 1, of objects in place and effects achieved"""
        return float(self.result["score"])

    @property
    def recording(self) -> Recording:
        """The recording of the imitation."""
        return open(self.directory / "imitation")


class Evaluation(NamedTuple):
    """Runs of brains from the same random starting layouts."""

    result: Json
    """`evaluation.json` (docs/experiments.md)"""
    directory: Path
    """contains `evaluation.json`, `report.html`, and the runs"""

    @property
    def success_rates(self) -> dict[str, float]:
        """Fraction of successful runs, by brain."""
        return {one["name"]: float(one["summary"]["success_rate"]) for one in self.result["brains"]}

    @property
    def runs(self) -> list[Json]:
        """All runs, each with the name of its `brain`, its `seed`, `success`, `score` and so on."""
        return [{"brain": one["name"], **run} for one in self.result["brains"] for run in one["runs"]]

    def table(self) -> pandas.DataFrame:
        """Returns the runs as a table, one row each. Needs pandas."""
        import pandas
        return pandas.json_normalize(self.runs)


class Generation(NamedTuple):
    """Recordings of a robot that were made from one demonstration (docs/generation.md)."""

    summary: Json
    """`summary.json`: numbers of attempts and episodes, their yield with its interval, causes"""
    directory: Path
    """contains `summary.json`, `manifest.jsonl`, `episodes/` and `failures/`; smile.datasets.export()
    takes it"""

    @property
    def is_complete(self) -> bool:
        """Whether each wanted episode succeeded."""
        return bool(self.summary["episodes"] == self.summary["wanted"])

    @property
    def attempts(self) -> list[Json]:
        """All attempts, each with its `seed`, `variation`, `outcome`, `cause`, `recording` and so on."""
        return [json.loads(line) for line in (self.directory / "manifest.jsonl").read_text().splitlines()]

    @property
    def episodes(self) -> list[Path]:
        """Directories of the recordings that succeeded, for open()."""
        return [self.directory / one["recording"] for one in self.attempts if one["outcome"] == "success"]


def replay(demo: Recording | PathLike, start: float | None = None, end: float | None = None, *,
           progress: bool | Progress = False) -> Replay:
    """Runs a recording again and compares each tick, from `start` to `end` [s since it began].

    Raises SceneError if it cannot be opened, ValueError if the times are not in it.
    """
    recording = _recording(demo)
    with _reports(progress) as report:
        ticks, hash, first, deviations, refused = _native.replay(recording._native, start, end, report)
    return Replay(ticks, hash, None if first is None else Difference(*first),
                  [Deviation(*one) for one in deviations], refused)


def describe(demo: Recording | PathLike) -> Description:
    """Describes the result of a recording: placed objects in order, and other effects."""
    structure, words = _native.describe(_recording(demo)._native)
    return Description(words, json.loads(structure))


def analyze(demo: Recording | PathLike, *, jobs: int | None = None,
            progress: bool | Progress = False) -> Json:
    """Finds out which subtasks of a demonstration matter, and in which order, by simulating it without them
    and in other orders. Returns `analysis.json` (docs/analysis.md).

    jobs      number of simulations at the same time; None: one for each core
    progress  reports `simulating`, the number of finished simulations, and of all at most

    Raises SceneError if it has no commands, achieves nothing, or what it achieves does not stand.
    """
    if jobs is None:
        jobs = os.cpu_count() or 1
    elif isinstance(jobs, bool) or not 1 <= jobs <= 256:
        raise ValueError(f"jobs is {jobs!r}, expected 1 to 256")
    with _reports(progress, unit="simulations") as report:
        analysis: Json = json.loads(_native.analyze(_recording(demo)._native, jobs, report))
    return analysis


def edit(demo: Recording | PathLike, edits: Sequence[Mapping[str, Any]],
         out: PathLike | None = None, *, pictures: bool = True,
         progress: bool | Progress = False) -> Edit:
    """Edits a recording into a new one, and simulates that.

    edits     in this order, as docs/editing.md lists them: `{"do": "drop", "first": 1, "last": 2}`,
              `{"do": "move", "segment": 5, "place": 2}`, `{"do": "speed", "factor": 1.5}`, ...
    out       new directory; None: only reports what would become of it
    pictures  whether the new recording has some

    Raises ValueError that says which edit is not possible, SceneError if `out` exists.
    """
    recording = _recording(demo)
    with _reports(progress) as report:
        answer = _native.edit(recording._native, json.dumps([dict(one) for one in edits]),
                              None if out is None else os.fspath(out), pictures, report)
    return Edit(json.loads(answer), None if out is None else open(out))


def imitate(demo: Recording | PathLike, scene: Model | PathLike, brain: Step | Brain | PathLike,
            out: PathLike, *, seconds: float = 600, timeout: float = 5, pictures: bool = True,
            camera: str = "eye", size: tuple[int, int] = (640, 480),
            noise: Mapping[str, float] | None = None, progress: bool | Progress = False,
            on_message: Callable[[str], object] | None = None) -> Imitation:
    """Runs a brain that was given a demonstration, and scores what it did.

    scene       a model, which has the robot; or the path of a scene, for Baxter
    brain       path of a brain; or, in this process, a function `step(sensor, motor, aux)`, or an
                object with this method and perhaps `init(aux)`. It gets the same values as in a
                process of its own (docs/brains.md), and the run has the same bits.
    out         directory, in which `imitation/` must not exist
    seconds     limit of simulated time, from the end of watching
    timeout     of each callback of a brain in a process [s of wall-clock time]
    pictures    whether the recording has some; the brain gets them anyway
    camera      the robot's eye, with `size` (width, height) [px]
    noise       standard deviations in what the brain senses: `joints` [rad], `image` [1 is full
                brightness], `depth` [units]; and a `seed`
    on_message  called with what the brain prints, line by line, from any thread

    An exception of a brain in this process is raised here, after the recording was written to its
    end. Raises SceneError if demonstration, scene and brain do not fit together.
    """
    model = scene if isinstance(scene, Model) else load(scene)
    recording, directory = _recording(demo), Path(out)
    failures: list[BaseException] = []
    runs_here = not isinstance(brain, (str, os.PathLike))
    how = _answers(exchange_of(brain), failures) if runs_here else os.fspath(cast(PathLike, brain))
    with _reports(progress) as report, _python_of_brains():
        text, brain_error = _native.imitate(
            os.fspath(recording.directory), model, how, os.fspath(directory), seconds=seconds,
            timeout=timeout, pictures=pictures, eye=(*picture_size(size), camera),
            noise=_noise_of(noise), on_progress=report, on_message=on_message)
    if failures:
        raise failures[0]
    result = json.loads(text)
    (directory / "result.json").write_text(json.dumps(result, indent=2, ensure_ascii=False) + "\n")
    return Imitation(result, directory, brain_error)


def evaluate(demo: Recording | PathLike, scene: PathLike, brains: PathLike | Sequence[PathLike],
             out: PathLike, *, scenes: int = 10, seed: int = 1, level: str | None = None,
             jobs: int | None = None, keep: str = "failures",
             options: Sequence[str] = ()) -> Evaluation:
    """Runs brains from the same random starting layouts, each run in a process of its own.

    brains   path of a brain, or several to compare
    out      directory of the results; an evaluation that was interrupted continues there
    scenes   number of layouts, of which `seed` is the first seed
    level    difficulty of the layouts (docs/experiments.md)
    jobs     number of runs at a time; None: of the processor's cores
    keep     recordings to keep: `all`, `failures` or `none`
    options  further options of `smile evaluate`

    Raises RuntimeError with the program's words if it cannot be carried out.
    """
    result = _run(["evaluate", _recording(demo).directory, "--scene", scene, *_repeated("--brain", brains),
                   "--out", out, "--scenes", scenes, "--seed", seed, "--keep", keep,
                   *_given("--level", level), *_given("--jobs", jobs), *options, "--json"])
    return Evaluation(result, Path(out))


def generate(demo: Recording | PathLike, scene: PathLike | Sequence[PathLike], brain: PathLike,
             out: PathLike, *, count: int = 100, seed: int = 1, level: str | None = None,
             hold: float = 2, tries: int = 5, oracle: bool = False, jobs: int | None = None,
             options: Sequence[str] = ()) -> Generation:
    """Makes many recordings of a robot from one demonstration: a brain imitates it in random layouts,
    and what succeeds, holds and replays to the last bit is kept.

    scene    path of a scene, or several, of which each attempt draws one
    brain    path of a brain
    out      directory of the recordings; a generation that was interrupted continues there
    count    number of wanted episodes, of which `seed` is the first seed
    level    difficulty of the layouts (docs/experiments.md); of a comma-separated list, each attempt
             draws one
    hold     seconds that the result must stand
    tries    limit of attempts at an episode
    oracle   whether the brain is told the true poses of all objects
    jobs     number of runs at a time; None: of the processor's cores
    options  further options of `smile generate`: of its variation, for example

    Raises RuntimeError with the program's words if it cannot be carried out. Episodes at which no
    attempt succeeded are missing: see `is_complete`.
    """
    summary = _run(["generate", _recording(demo).directory, *_repeated("--scene", scene), "--brain", brain,
                    "--out", out, "--count", count, "--seed", seed, "--hold", hold, "--tries", tries,
                    *_given("--level", level), *_given("--jobs", jobs), *(["--oracle"] if oracle else []),
                    *options, "--json"], is_done=lambda code: code in (0, _EPISODES_ARE_MISSING))
    return Generation(summary, Path(out))


# Exit code of `smile generate`.
_EPISODES_ARE_MISSING = 1


def _repeated(option: str, values: PathLike | Sequence[PathLike]) -> list[PathLike]:
    several = [values] if isinstance(values, (str, os.PathLike)) else list(values)
    return [word for one in several for word in (option, one)]


def _given(option: str, value: str | int | None) -> list[str]:
    return [] if value is None else [option, str(value)]


def _run(words: Sequence[PathLike | float], is_done: Callable[[int], bool] = lambda code: code == 0) -> Json:
    """Runs a command of the program; returns the JSON that it prints."""
    command = [os.fspath(program.path()),
               *(os.fspath(word) if isinstance(word, os.PathLike) else str(word) for word in words)]
    with _python_of_brains():
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if not is_done(done.returncode) or not done.stdout:
        raise RuntimeError(done.stderr.strip() or f"{command[0]} ended with exit code {done.returncode}")
    result: Json = json.loads(done.stdout)
    return result


def _recording(demo: Recording | PathLike) -> Recording:
    return demo if isinstance(demo, Recording) else open(demo)


def _answers(exchange: Exchange, failures: list[BaseException]) -> Callable[[bytes], bytes]:
    """Returns the function from a question to its answer. What it raises is kept in `failures`."""
    def answer(question: bytes) -> bytes:
        kind, sequence, values = messages.decode(question)
        try:
            kind, answered = exchange.answer(kind, values)
            return messages.encode(kind, sequence, answered)
        except BaseException as failure:  # also Ctrl-C: the recording is written to its end
            failures.append(failure)
            report: Values = {"message": f"{type(failure).__name__}: {failure}"}
            return messages.encode(messages.ERROR, sequence, report)
    return answer


def _noise_of(noise: Mapping[str, float] | None) -> tuple[float, float, float, int]:
    given = dict(noise or {})
    joints, image, depth = (float(given.pop(name, 0)) for name in ("joints", "image", "depth"))
    seed = int(given.pop("seed", 0))
    if given:
        raise ValueError(f"noise has {', '.join(given)}, expected joints, image, depth or seed")
    if not all(0 <= value <= 1000 for value in (joints, image, depth)) or not 0 <= seed <= 2**53:
        raise ValueError(f"noise is {noise}, expected numbers from 0 to 1000, and a seed up to 2^53")
    return joints, image, depth, seed


@contextlib.contextmanager
def _python_of_brains() -> Iterator[None]:
    """Lets brains in Python run with this interpreter, for which the package was compiled."""
    if os.environ.get("SMILE_PYTHON"):
        yield
        return
    os.environ["SMILE_PYTHON"] = sys.executable
    try:
        yield
    finally:
        del os.environ["SMILE_PYTHON"]


@contextlib.contextmanager
def _reports(progress: bool | Progress, unit: str = "s") -> Iterator[Progress | None]:
    """Returns the function that is called with the progress; of True, one that draws a bar with tqdm.

    unit  of what is done
    """
    if not isinstance(progress, bool):
        yield progress
        return
    bar = _bar(unit) if progress else None
    if bar is None:
        yield None
        return

    def show(step: str, done: float, total: float) -> None:
        bar.set_description(step, refresh=False)
        bar.total = total or None
        bar.update(done - bar.n)

    with bar:
        yield show


def _bar(unit: str) -> Any:
    """Returns a progress bar; None without tqdm."""
    try:
        from tqdm.auto import tqdm
    except ImportError:
        return None
    return tqdm(unit=unit, bar_format="{desc}: {n:.4g} of {total} {unit}, {elapsed} passed")
