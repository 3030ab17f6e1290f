"""Knows the things of the demonstration in another light: their colors become those that the eye sees."""

from dataclasses import replace

import numpy as np

from check.light_of_controls import know_light
from constants import PERCEPTION as C
from see.colors import color_mask, distinct_colors
from see.containers import detect_container
from see.detection import detect_blocks
from see.light import clear_matches, color_changes
from things.colored import different_colors, is_among, is_near, of_color, whole
from things.steps import Container, start_supports_of


def know_colors(state, picture, eye, heights, tops):
    """Gives what is wanted the colors that it has in a picture, once for each color: one that is seen as it was
    demonstrated stays as it is. What is not seen, or not clearly, is looked for in the next picture.

    tops: of objects in the picture, as from segment_top_faces
    """
    things = wanted_things(state)
    if state.unseen_colors is None:
        know_light(state, things + state.unknown_objects, picture)
        state.unseen_colors = different_colors(whole(things))
    if not state.unseen_colors:
        return
    tops = distinct_colors([color for color, _, _ in tops])
    unseen = [it for it in state.unseen_colors if not is_seen(it, things, tops, picture)]
    seen = [it for it in different_colors(whole(things)) if not is_among(it, unseen)]
    tops = [it for it in tops if not is_near(it, seen)]
    changes = color_changes(unseen, tops)
    for i, k in np.argwhere(np.isfinite(changes)):
        if not looks_so(things + state.unknown_objects, unseen[i], tops[k], picture, eye, heights):
            changes[i, k] = np.inf
    matches = list(zip(unseen, clear_matches(changes)))
    for color, k in matches:
        if k is not None:
            for it in of_color(whole(things + state.unknown_objects), color):
                it.color = tops[k]
    state.unseen_colors = [color for color, k in matches if k is None]


def wanted_things(state):
    """Returns the steps, what they began on, the containers and the tools."""
    tools = [it.tool for it in state.presses if it.tool]
    return [*state.steps, *start_supports_of(state.steps), *tools, *state.containers]


def is_seen(color, things, tops, picture):
    """Returns true if a wanted color is seen as it is: in the tops of blocks, or anywhere if it is that of other
    things."""
    if color_mask(np.reshape(tops, (1, -1, 3)), color).any():
        return True
    is_of_blocks = any(it.form != "ball" and not it.parts and not it.has_knob and not isinstance(it, Container)
                       for it in of_color(things, color))
    return not is_of_blocks and color_mask(picture, color).sum() >= C.min_top_pixels


def looks_so(things, color, seen, picture, eye, heights):
    """Returns true if something of the form and the size of one of some things of a color is seen in another color. Of
    knobs and of things of several colors this is not known before."""
    alike = [replace(it, color=seen) for it in of_color(things, color) if not it.parts]
    boxes = [it for it in alike if isinstance(it, Container)]
    return (not alike or any(detect_container(picture, eye, it)[0] is not None for it in boxes)
            or bool(detect_blocks(picture, eye, [it for it in alike if it not in boxes], heights=heights)))
