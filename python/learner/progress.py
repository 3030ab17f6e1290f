"""What the learner sees of the scene, and which steps are done."""

import numpy as np

from beliefs import update_beliefs
from blocks import is_in_place, yaw_difference
from detection import detect_blocks
from eye import height_map
from unknown_objects import detect_unknown_objects


def observe(state, sensor, picture, eye):
    """Updates the known blocks from a picture."""
    heights = None if "depth" in state.without else height_map(sensor.depthVision, eye)
    if state.see:
        seen = state.see(sensor, eye, state.steps)
        state.known = update_beliefs(state.known, seen, picture, eye, heights)
        return
    # The place of the container is not known before a site is chosen.
    container = state.container if state.has_site else None
    seen = detect_blocks(picture, eye, state.steps + state.unknown_objects, container, heights)
    if not state.has_site or state.num_blocked > 0:
        state.unknown_objects += detect_unknown_objects(picture, eye, seen + state.known, heights)
        seen = detect_blocks(picture, eye, state.steps + state.unknown_objects, container, heights)
    state.known = update_beliefs(state.known, seen, picture, eye, heights)


def open_steps(state):
    """Returns the numbers of the steps that are not done and whose supports are done, in
    demonstrated order."""
    return [k for k, step in enumerate(state.steps)
            if not state.done[k] and all(state.done[lower] for lower in step.on)]


def assess_progress(state):
    """Compares the known blocks with the steps: updates state.done and state.placement_errors.
    Returns the blocks that are in the place of a step, a list."""
    used = []
    for k, step in enumerate(state.steps):
        state.done[k] = False
        for block in state.known:
            if block not in used and is_in_place(block, step):
                state.placement_errors[k] = (np.linalg.norm(block.position - step.position),
                                             abs(yaw_difference(step, block.yaw)))
                state.done[k] = True
                used.append(block)
                break
    return used
