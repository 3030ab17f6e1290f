"""Where a demonstration put things that came back later, like a cover on its stand."""

from dataclasses import dataclass, replace

import numpy as np

from constants import TASK_MODEL as C
from explain.object_roles import is_same_pose
from explain.shown_pictures import mask_around, picture_frames, read_picture
from things.blocks import Block
from things.standing import stands_on


@dataclass(eq=False)
class Aside:
    """A place on something that is no block, and how the demonstration shows it before."""

    place: Block
    before: np.ndarray  # picture of the demonstration before something was put there, HxWx3
    changed: np.ndarray  # mask of the pixels around its middle, HxW bool
    height: float  # of the center of what was carried there, at its highest [units]


def aside_of(demo, step):
    """Returns the last Aside of a carried object that ends where it began; None if it was put on the table or on
    blocks in between."""
    n = demo.ids.index(step.name)
    releases = [frame for frame, word, _ in demo.events if word == "release"]
    for frame in [when for when, m in zip(releases, demo.placed) if m == n][-2::-1] if step.begins_there else []:
        later = [when for when, word, _ in demo.events if word == "grasp" and when > frame]
        pose = demo.pose(n, later[0])
        turn = np.radians(pose[5] - demo.moves[n][-1, 6])
        place = Block(step.color, step.size, pose[:3], step.yaw + turn, form=step.form)
        others = [it for m, it in demo.appearances.items() if m != n]
        is_known = place.bottom < C.min_inside_bottom or any(stands_on(place, it) for it in others)
        if not is_known and not is_same_pose(pose, demo.moves[n][-1, 1:]):
            taken = min(when for when, word, it in demo.events if word == "grasp" and it[1] == step.name)
            picture = read_picture(demo, max(it for it in picture_frames(demo) if it <= taken))
            rows = demo.moves[n][demo.moves[n][:, 0] <= frame]
            return Aside(place, picture, mask_around(picture, demo.eye, pose[:3]), rows[:, 3].max())
    return None


def with_asides(demo, steps, needs=None):
    """Returns steps with the Asides of those that come back, which is after all that was placed before, or what the
    goal needs before; needs: if it is known, see infer_task"""
    found = []
    for k, step in enumerate(steps):
        aside = None if step.stays else aside_of(demo, step)
        after = [i for i in range(k) if i not in step.on] if aside and not needs else step.after
        if needs and not step.stays:
            after = sorted({*after, *needs.required_before(steps, k)})
        found.append(replace(step, aside=aside, after=after))
    return found
