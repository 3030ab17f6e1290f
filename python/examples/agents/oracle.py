"""The learner, told which pixels show which object, and the sizes of the demonstrated ones: what it
still fails at is planning or acting, not seeing.

    smile imitate DEMO SCENE --brain python/examples/agents/oracle.py

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
from see.eye import height_map, onto_plane
from see.faces import fit_face
from see.measuring import measure_block
from things.blocks import Block
from things.kinds import same_size


def init(aux):
    aux.see = see
    learner.init(aux)
    aux.channels = ["rgb", "depth", "segmentation"]


def see(sensor, eye, steps):
    """Returns the objects whose whole top is visible, as Blocks."""
    picture = sensor.rgbVision / 255
    heights = height_map(sensor.depthVision, eye)
    kinds = {step.name: step for step in steps}
    seen = []
    for k, name in enumerate(sensor.segmentNames, 1):
        rows, columns = np.nonzero(sensor.segmentVision == k)
        if name in ("table", "robot") or len(rows) == 0:
            continue
        top = heights[rows, columns].max()
        is_top = heights[rows, columns] > top - 0.02
        rows, columns = rows[is_top], columns[is_top]
        color = np.median(picture[rows, columns], axis=0)
        if name not in kinds:
            block = measure_block(color, rows, columns, picture, eye, table_color(picture), heights)
            seen += [block] if block else []
            continue
        kind = kinds[name]
        top = np.median(heights[rows, columns])
        face = fit_face(*onto_plane(rows, columns, eye, top))
        if (face.is_round == kind.is_round and same_size(face.sides, kind.size[:2])
                and face.misfit < 0.05):
            seen.append(Block(color, kind.size, np.append(face.center, top - kind.size[2] / 2),
                              face.yaw, form=kind.form))
    return seen
