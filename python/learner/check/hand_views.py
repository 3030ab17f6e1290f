"""What the cameras of the hands see of the scene."""

import numpy as np

from check.looking import likes
from check.notes import Note
from constants import BELIEFS as C
from see.denoising import without_noise
from see.detection import detect_blocks
from see.eye import Eye, height_map
from see.pictures import noise_of


def see_from_hand(state, sensor, arm):
    """Adds the blocks that the camera of a hand sees, and the eye does not, to the known ones."""
    view = getattr(sensor.cameras, arm.camera)
    eye = Eye(view.intrinsics, view.pose)
    picture = view.rgb / 255
    noise = noise_of(picture)
    if noise > 0:
        picture = without_noise(picture, noise, 1)
    seen = detect_blocks(picture, eye, likes(state), heights=height_map(view.depth, eye))
    new = [it for it in seen if all(np.linalg.norm(it.position - other.position) > C.same_block_distance
                                    for other in state.known)]
    state.known = new + state.known
    state.notes.append(Note("saw", f"{len(new)} more object{'s' * (len(new) != 1)} with the {arm.name} hand", found=new,
                            camera=arm.camera))
