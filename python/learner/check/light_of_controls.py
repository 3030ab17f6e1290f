"""Knows controls and tools in another light than that in which the pictures of the demonstration show them."""

import numpy as np

from constants import PERCEPTION as C
from see.colors import frequent_colors
from see.gains import brightened, gains_between
from things.colored import whole


def know_light(state, things, picture):
    """Gives the pictures of controls, and some things, the colors that they have in the light of a picture. Things whose
    colors have changed in other ways remain unknown."""
    if not state.presses:
        return
    shown, seen = (np.reshape(frequent_colors(it, C.min_unknown_object_pixels), (-1, 3))
                   for it in (state.presses[0].before, picture))
    gains = gains_between(shown, seen)
    if (gains == 1).all():
        return
    for press in state.presses:
        press.before, press.later = brightened(press.before, gains), brightened(press.later, gains)
    for it in {id(it): it for it in whole(things)}.values():
        it.color = brightened(it.color, gains)
