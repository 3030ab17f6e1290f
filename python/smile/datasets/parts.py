"""Exports in parts, so that what is interrupted can continue."""

from __future__ import annotations

import hashlib
import json
import shutil
from collections.abc import Callable
from pathlib import Path

from smile.datasets.exporting import Options, Plan, Report
from smile.datasets.merging import merge
from smile.datasets.target import refuse_existing

_KEY = "part.json"


def write_in_parts(plan: Plan, options: Options, target: Path, size: int,
                   write: Callable[[Plan, Options, Path, Callable[[str], None]], Report],
                   say: Callable[[str], None]) -> Report:
    """Writes a dataset in parts of `size` episodes, and joins them. Parts that are there already, of
    the same runs and options, are not written again."""
    folder = target.with_name(target.name + ".parts")
    folder.mkdir(parents=True, exist_ok=True)
    parts = []
    for first in range(0, len(plan.sources), size):
        part = folder / f"{first:06d}"
        parts.append(part)
        some = plan._replace(sources=plan.sources[first:first + size])
        key = _key_of(some, options)
        if (part / _KEY).exists() and (part / _KEY).read_text() == key:
            say(f"part from episode {first} is there")
            continue
        shutil.rmtree(part, ignore_errors=True)
        say(f"part from episode {first}")
        write(some, options, part, say)
        (part / _KEY).write_text(key)
    refuse_existing(target)
    report = merge(parts, target, progress=say)
    shutil.rmtree(folder)
    return report


def _key_of(plan: Plan, options: Options) -> str:
    """Returns what a part depends on."""
    sampling = {**plan.sampling._asdict(), "dropped": sorted(plan.sampling.dropped)}
    runs = [[str(source.path), source.digest(), source.result] for source in plan.sources]
    content = hashlib.sha256(json.dumps(runs).encode()).hexdigest()
    return json.dumps({"runs": content, "sampling": sampling, "options": options._asdict(),
                       "cameras": [[camera.name, camera.width, camera.height, camera.maps] for camera in plan.cameras],
                       "has_success": plan.has_success, "has_interventions": plan.has_interventions})
