"""The pictures of a demonstration, and the eye that saw them."""

import numpy as np
from PIL import Image

from constants import TASK_MODEL, USES as C
from see.eye import Eye, pixels_of


def eye_of(info):
    """Returns the Eye that demo.json describes."""
    eye = info.get("eye")
    if not eye:
        raise ValueError("the demonstration has no pictures, so that nothing shows how its objects "
                         "look: record it without --no-pictures")
    w, x, y, z = eye["rotation_wxyz"]  # a unit quaternion
    v = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])  # v @ a is the cross product with a
    pose = np.eye(4)
    pose[:3, :3] += 2 * w * v + 2 * v @ v
    pose[:3, 3] = np.array(eye["position_m"]) / info["meters_per_unit"]
    return Eye(np.array([[eye["fx"], 0, eye["cx"]], [0, eye["fy"], eye["cy"]], [0, 0, 1]]), pose)


def picture_frames(demo):
    """Returns the frames that have pictures, a list."""
    return sorted(int(it.stem) for it in demo.folder.glob("*/*.png") if it.stem.isdigit())


def read_picture(demo, frame):
    """Reads the picture of a frame: HxWx3, 0 to 1; None if there is none."""
    found = sorted(demo.folder.glob(f"*/{int(frame)}.png"))
    return np.asarray(Image.open(found[0]).convert("RGB")) / 255 if found else None


def mask_around(picture, eye, point):
    """Returns the mask, HxW bool, of what a picture shows at and around a point, x y z [units]."""
    side = np.linspace(-C.around, C.around, C.points_around)
    x, y = (it.ravel() for it in np.meshgrid(side, side))
    row, column, inside = pixels_of(point + np.column_stack([x, y, 0 * x]), eye, picture)
    mask = np.zeros(picture.shape[:2], bool)
    mask[row[inside], column[inside]] = True
    return mask


def select_frames(demo, n):
    """Returns the frames in which an object may be entirely visible, with its pose, in rows as of demo.moves: its first;
    then those where it was highest, and some in which others were moved, which may have covered it before, first those in
    which a pixel shows the least of it."""
    moves = demo.moves[n]
    highest = np.argsort(-moves[:, 3], kind="stable")[:TASK_MODEL.num_highest_frames]
    frames = np.unique(np.concatenate([rows[:, 0] for rows in demo.moves]))
    chosen = np.arange(TASK_MODEL.num_other_frames) * (len(frames) - 1) // (TASK_MODEL.num_other_frames - 1)
    others = [[frame, *moves[moves[:, 0] <= frame][-1, 1:]] for frame in frames[chosen]
              if frame >= moves[0, 0]]
    return np.array([moves[0], *sorted([*moves[highest], *others], key=lambda row: pixel_extent(row[1:4], demo.eye))])


def pixel_extent(place, eye):
    """Returns how much of a level area at a place, x y z, a pixel shows, away from the eye, but for a factor."""
    away = eye.pose[:3, 3] - place
    return away @ away / away[2] if away[2] > 0 else np.inf
