"""What the learner sees of the scene, compared with what it expects."""

import numpy as np

from check.beliefs import corrected
from check.notes import Note
from check.other_light import know_colors
from check.verdict_notes import verdict_notes
from check.verdicts import verdicts_on
from constants import BLOCKS, PERCEPTION as C
from see.colors import table_color
from see.detection import detect_blocks
from see.eye import height_map
from see.knobs import add_knobs, find_knobs
from see.unexplained import unexplained_points
from see.unknown_objects import detect_unknown_objects, segment_top_faces
from things.held_parts import with_held_parts


def observe(state, sensor, picture, eye):
    """Updates the known blocks from a picture."""
    heights = None if "depth" in state.without else height_map(sensor.depthVision, eye)
    if state.see:
        compare(state, state.see(sensor, eye, state.steps + tools_of(state)), picture, eye, heights)
        return
    looks_around = not state.has_site or state.num_blocked > 0 or len(state.unexplained) >= C.many_unexplained
    tops = []
    if looks_around or heights is not None and state.unseen_colors != []:
        tops = segment_top_faces(picture, table_color(picture), heights)
    if heights is not None:
        know_colors(state, picture, eye, heights, tops)
    # The places of containers are not known before a site is chosen.
    containers = state.containers if state.has_site else []
    seen = detect_blocks(picture, eye, likes(state), containers, heights)
    if heights is not None:
        find_knobs(state.steps, seen, picture, eye, heights)
    if looks_around:
        whole = with_held_parts(seen + state.known)
        state.unknown_objects += detect_unknown_objects(picture, eye, whole, heights, tops)
        seen = detect_blocks(picture, eye, likes(state), containers, heights)
        add_knobs(state.steps, seen)
    compare(state, seen, picture, eye, heights)
    if heights is not None:
        state.unexplained = unexplained_points(with_held_parts(state.known), heights, eye)


def compare(state, seen, picture, eye, heights):
    """Compares what is expected, the known blocks, with those seen in a picture, and corrects it. If the
    block that was just moved is not where it should be, its grasp failed."""
    # What is dropped into a container may lie anywhere inside.
    tolerance = BLOCKS.confined_tolerance if state.containers else BLOCKS.position_tolerance
    verdicts = verdicts_on(state.known, seen, picture, eye, heights, tolerance)
    if not state.known:
        state.notes.append(Note("saw", f"{len(seen)} objects", found=seen))
    state.notes += verdict_notes(verdicts, seen, state.steps, state.moved)
    if state.moved and verdicts[-1].word == "contradicted":
        state.failures.append(state.grasp)
    state.moved = ""
    state.known = corrected(seen, verdicts)


def is_moving(state, picture):
    """Returns true until nothing has moved in the last few pictures, or there were very many: what swings is looked at
    when it hangs still."""
    last, state.last_picture = state.last_picture, picture
    state.num_looks += 1
    is_still = last is not None and (np.abs(picture - last).max(axis=2) > C.max_still_change).sum() < C.max_moving_pixels
    state.num_still = state.num_still + 1 if is_still else 0
    return state.num_still < C.num_still and state.num_looks < C.max_looks


def likes(state):
    """Returns what blocks may look like: those of the steps, unknown objects, and tools."""
    return state.steps + state.unknown_objects + tools_of(state)


def tools_of(state):
    """Returns the tools of a task, one for each use or drive."""
    return [it.tool for it in state.presses if it.tool]
