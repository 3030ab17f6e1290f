"""The learner, told the true poses of the objects that it needs and of what they stand on, and which
pixels show which other object: what it still fails at is planning or acting, not seeing.

    smile imitate DEMO SCENE --oracle --brain python/examples/agents/oracle.py

It sees the poses of things with a knob, of several colors or of another shape, of objects of which the learner knows only the
handle, and of what it drags, itself.
A real robot does not have this information: only the simulator has it.

smile: imitates
"""

import sys
from pathlib import Path

import numpy as np

sys.path.append(str(Path(__file__).resolve().parents[2] / "learner"))
import learner
from learner import step
from see.colors import table_color
from see.detection import detect_blocks
from see.eye import height_map
from see.knobs import find_knobs
from see.measuring import measure_block
from things.kinds import same_size
from things.standing import stands_on
from things.steps import is_dragged
from true_poses import true_blocks


def init(aux):
    aux.see = lambda sensor, eye, steps: see(sensor, eye, steps, true_blocks(sensor, aux, steps))
    learner.init(aux)
    aux.channels = ["rgb", "depth", "segmentation"]


def see(sensor, eye, steps, told):
    """Returns the objects of some steps and tools, and the others of which the whole top is visible, as Blocks."""
    picture = sensor.rgbVision / 255
    heights = height_map(sensor.depthVision, eye)
    special = [it for it in steps if it.has_knob or it.parts or it.outline or is_dragged(it) or is_only_part(it, told)]
    needed = {it.name: told[it.name] for it in steps if it not in special and it.name in told}
    below = {name: it for name, it in told.items() if any(stands_on(upper, it) for upper in needed.values())}
    seen = list((needed | below).values())
    names = {it.name for it in steps} | below.keys()
    if special:
        seen += detect_blocks(picture, eye, special, heights=heights)
        find_knobs(steps, seen, picture, eye, heights)
    for k, name in enumerate(sensor.segmentNames, 1):
        rows, columns = np.nonzero(sensor.segmentVision == k)
        if name in names or name in ("table", "robot") or len(rows) == 0:
            continue
        top = heights[rows, columns].max()
        is_top = heights[rows, columns] > top - 0.02
        rows, columns = rows[is_top], columns[is_top]
        color = np.median(picture[rows, columns], axis=0)
        block = measure_block(color, rows, columns, picture, eye, table_color(picture), heights)
        seen += [block] if block else []
    return seen


def is_only_part(step, told):
    """Returns true if a step is not about an object as large as the one told of its name, on whichever face."""
    return step.name in told and not same_size(np.sort(step.size), np.sort(told[step.name].size))
