"""The handles by which objects were dragged."""

from itertools import product

import numpy as np

from constants import BLOCKS, PERCEPTION, TASK_MODEL as C
from explain.limits import NotUnderstood
from explain.shown_pictures import read_picture
from see.colors import color_mask, frequent_colors
from see.eye import onto_plane
from see.faces import fit_face
from see.regions import label_regions
from things.kinds import same_size
from things.steps import Step


def measure_handle(demo, n):
    """Measures the handle by which object n of a demonstration was dragged, as a Step: the highest
    flat top with the same displacement as the object. The closer to the eye a top is, the farther
    it moves in the picture; so its displacement in the picture determines its height."""
    moves = demo.moves[n]
    pictures = [read_picture(demo, moves[i, 0]) for i in (0, -1)]
    displacement = moves[-1, 1:3] - moves[0, 1:3]
    eye_height = demo.eye.pose[2, 3]
    step = None
    has_pictures = all(picture is not None for picture in pictures)
    for color in frequent_colors(pictures[0]) if has_pictures else []:
        masks = [color_mask(picture, color) for picture in pictures]
        for before, after in product(displaced_regions(*masks), displaced_regions(*masks[::-1])):
            def centers(height):
                faces = [fit_face(*onto_plane(*pixels, demo.eye, height))
                         for pixels in (before, after)]
                return faces, faces[1].center - faces[0].center

            _, on_table = centers(0)
            height = eye_height * (1 - (displacement @ displacement) / (displacement @ on_table))
            if not C.min_handle_height < height < eye_height / 2:
                continue
            (face, later), moved = centers(height)
            if (np.hypot(*(moved - displacement)) < C.max_handle_error
                    and face.misfit < PERCEPTION.misfit and same_size(face.sides, later.sides)
                    and (step is None or height > step.top)):
                step = Step(color, np.append(face.sides, height),
                            np.append(face.center, height / 2), face.yaw, demo.ids[n], [],
                            displacement, tolerance=drag_tolerance(displacement))
    if step is None:
        raise NotUnderstood(f"no picture of the demonstration shows the handle of {demo.ids[n]}")
    return step


def drag_tolerance(displacement):
    """Returns the tolerance of the place where a drag ends [units]: its direction is only as well known as the yaw of the
    handle."""
    return BLOCKS.position_tolerance + C.drag_direction_rad * np.hypot(*displacement)


def displaced_regions(mask, other):
    """Returns the connected regions of a mask that are mostly outside another mask: a list of rows
    and columns."""
    number = label_regions(mask)
    displaced = []
    for region in np.flatnonzero(np.bincount(number.ravel()) >= PERCEPTION.min_top_pixels):
        if region and other[number == region].mean() < C.max_remaining_fraction:
            displaced.append(np.nonzero(number == region))
    return displaced
