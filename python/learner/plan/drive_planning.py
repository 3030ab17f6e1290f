"""Plans what a tool turns: takes it, turns one fastener after the other, and puts it back."""

import numpy as np

from act.actions import Grasp
from act.grippers import nearest_first
from check.failures import able_arms, has_failed
from constants import USES as C
from explain.drives import Drive
from match.alignment import refined
from plan.carrying import surroundings_of
from plan.drive_paths import plan_arm_drive
from things.areas import footprint, overlap, rotated
from things.kinds import is_same_kind


def plan_drive(drive, alignment, surface, state, arms, sensor):
    """Plans a Drive. Returns actions, the Grasp of the tool, and None; or [], None and the reason."""
    tool = next((it for it in state.known if is_same_kind(it, drive.tool)), None)
    if tool is None:
        return [], None, f"{drive.tool.name} is not visible"
    # Should it fail, the tool is no longer where it was.
    state.known.remove(tool)
    state.known.append(tool)
    alignment = refined_at(drive, alignment, surface, state.shown)
    turns = [it._replace(place=np.append(rotated(it.place[:2] - alignment.place, -alignment.angle), it.place[2]))
             for it in drive.turns]
    points = surface.points
    is_tool = overlap(np.column_stack([points[:, :2], np.zeros((len(points), 3))]), footprint([tool], C.around))[0]
    around = surroundings_of(points[~is_tool])
    able, reason = able_arms(arms, tool, tool.size[1], state.failures, "no arm brings it there and back",
                             drive.tool.name)
    for arm in nearest_first(able, tool.position[0]):
        attempt = Grasp(tool.position, arm.index, 0.0)
        if has_failed(attempt, state.failures):
            continue
        actions = plan_arm_drive(arm, tool, drive.height - drive.tool.position[2] + tool.position[2], turns,
                                 sensor.arms[arm.index].joints, lambda path: around.avoids(arm, path))
        if actions:
            return actions, attempt, None
    return [], None, reason


def refined_at(drive, alignment, surface, shown):
    """Returns an Alignment that is more accurate at the fasteners, by what the scene shows within a short distance."""
    places = np.array([rotated(it.place[:2] - alignment.place, -alignment.angle) for it in drive.turns])
    away = np.hypot(*(surface.points[:, None, :2] - places).T).min(axis=0)
    return refined(surface.part(away < C.refining_radius), alignment, places.mean(axis=0), drive.before, shown)[1]


def was_driven(drive, state):
    """Returns true if an arm did all of a Drive, as far as it could tell: what it changes may not be visible. Its
    tool stands where it was again."""
    return (drive.attempts > 0 and not any(it is drive.grasp for it in state.failures)
            and any(is_same_kind(it, drive.tool) for it in state.known))


def is_driver(block, state):
    """Returns true if a known block is the tool of a Drive, which stays in its holder meanwhile."""
    return any(isinstance(it, Drive) and is_same_kind(block, it.tool) for it in state.presses)
