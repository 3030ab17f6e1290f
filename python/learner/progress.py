"""What the learner sees of the scene, and which steps are done."""

import numpy as np

from beliefs import corrected
from blocks import is_in_place, yaw_difference
from clearance import with_held_parts
from constants import BLOCKS, PERCEPTION as C
from detection import detect_blocks
from eye import height_map
from knobs import add_knobs, find_knobs
from notes import Note, verdict_notes
from unexplained import unexplained_points
from unknown_objects import detect_unknown_objects
from verdicts import verdicts_on


def observe(state, sensor, picture, eye):
    """Updates the known blocks from a picture."""
    heights = None if "depth" in state.without else height_map(sensor.depthVision, eye)
    if state.see:
        compare(state, state.see(sensor, eye, state.steps), picture, eye, heights)
        return
    # The place of the container is not known before a site is chosen.
    container = state.container if state.has_site else None
    seen = detect_blocks(picture, eye, likes(state), container, heights)
    if heights is not None:
        find_knobs(state.steps, seen, picture, eye, heights)
    if not state.has_site or state.num_blocked > 0 or len(state.unexplained) >= C.many_unexplained:
        whole = with_held_parts(seen + state.known)
        state.unknown_objects += detect_unknown_objects(picture, eye, whole, heights)
        seen = detect_blocks(picture, eye, likes(state), container, heights)
        add_knobs(state.steps, seen)
    compare(state, seen, picture, eye, heights)
    if heights is not None:
        state.unexplained = unexplained_points(with_held_parts(state.known), heights, eye)


def compare(state, seen, picture, eye, heights):
    """Compares what is expected, the known blocks, with those seen in a picture, and corrects it. If the
    block that was just moved is not where it should be, its grasp failed."""
    # What is dropped into a container may lie anywhere inside.
    tolerance = BLOCKS.confined_tolerance if state.container else BLOCKS.position_tolerance
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
    return state.steps + state.unknown_objects + [it.tool for it in state.presses if it.tool]


def open_steps(state):
    """Returns the numbers of the steps that are not done and whose supports are done, in
    demonstrated order, or in that of a seed; before a press, only of those that were done before it."""
    pending = [press for press in state.presses if not press.done]
    steps = [k for k, step in enumerate(state.steps)
             if (not pending or k in pending[0].after) and not state.done[k]
             and all(state.done[lower] for lower in step.on + step.after)]
    if state.order_seed is None:
        return steps
    rank = np.random.default_rng(state.order_seed).permutation(len(state.steps))
    return sorted(steps, key=lambda k: rank[k])


def assess_progress(state):
    """Compares the known blocks with the steps: updates state.done and state.placement_errors.
    Returns the blocks that are in the place of a step, a list."""
    used = []
    for k, step in enumerate(state.steps):
        state.done[k] = False
        for block in state.known:
            is_early = not all(state.done[lower] for lower in step.after)
            if block not in used and not is_early and is_in_place(block, step):
                state.placement_errors[k] = (np.linalg.norm(block.position - step.position),
                                             abs(yaw_difference(step, block.yaw)))
                state.done[k] = True
                used.append(block)
                break
    return used
