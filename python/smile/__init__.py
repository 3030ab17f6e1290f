"""SMILE in Python: simulator, and client for brains.

    import smile
    sim = smile.Simulation(smile.load("scenes/tower.xml"))
    sim.hand("left").grasp("RedBlock")

SI units and radians; the world has z up and its origin in the middle of the table top; quaternions
are w, x, y, z. docs/python.md describes the simulator, docs/brains.md brains, which import only
`smile.brain` and `smile.motion`.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from smile.errors import Diagnostic, Refused, SceneError
    from smile.experiment import (
        Description, Deviation, Difference, Edit, Evaluation, Generation, Imitation, Replay, analyze, describe,
        edit, evaluate, generate, imitate, replay)
    from smile.picture import Picture
    from smile.recording import Action, CommandDifference, Moment, Recording, open
    from smile.serving import BrainServer, serve_brain
    from smile.simulation import Event, Model, Simulation, State, data_file, load
    from smile.task import Comparison, ObjectError, Task
    from smile.viewer import Studio, studio

    __version__: str

# Imported when first used: a brain needs none of them.
_HOMES = {
    "Diagnostic": "errors", "Refused": "errors", "SceneError": "errors",
    **dict.fromkeys(("Description", "Deviation", "Difference", "Edit", "Evaluation", "Generation",
                     "Imitation", "Replay", "analyze", "describe", "edit", "evaluate", "generate", "imitate",
                     "replay"), "experiment"),
    "Picture": "picture",
    "Action": "recording", "CommandDifference": "recording", "Moment": "recording", "Recording": "recording", "open": "recording",
    "BrainServer": "serving", "serve_brain": "serving",
    "Event": "simulation", "Model": "simulation", "Simulation": "simulation", "State": "simulation",
    "data_file": "simulation", "load": "simulation",
    "Comparison": "task", "ObjectError": "task", "Task": "task",
    "Studio": "viewer", "studio": "viewer",
}

__all__ = ["Action", "BrainServer", "CommandDifference", "Comparison", "Description", "Deviation",
           "Diagnostic", "Difference", "Edit", "Evaluation", "Event", "Generation", "Imitation", "Model",
           "Moment", "ObjectError", "Picture", "Recording", "Refused", "Replay", "SceneError", "Simulation",
           "State", "Studio", "Task", "analyze", "data_file", "describe", "edit", "evaluate", "generate", "imitate",
           "load", "open", "replay", "serve_brain", "studio"]


def __getattr__(name: str) -> Any:
    if name == "__version__":
        native = importlib.import_module("smile.native").load("smile_simulator_native")
        return native.program_name().rpartition(" ")[2]
    if name not in _HOMES:
        raise AttributeError(f"module 'smile' has no attribute {name!r}")
    return getattr(importlib.import_module("smile." + _HOMES[name]), name)


def __dir__() -> list[str]:
    return sorted(__all__)
