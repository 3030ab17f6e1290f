"""Plans uses of tools: take one, bring it to where it works, close the gripper again, and put it back."""

from itertools import product, tee

import numpy as np

from act.grippers import nearest_first
from check.failures import able_arms
from constants import USES as C
from match.pressing import is_within
from match.tools import find_tool
from plan.carrying import surroundings_of
from plan.loads import belongs_to, moved_to, whole_of
from plan.tool_holds import holds
from plan.use_paths import plan_held_use
from plan.ways import Way
from things.areas import rotated


def plan_use(use, alignment, surface, state, arms, sensor):
    """Plans a Use. Returns actions, the Grasp of the tool, and None; or [], None and the reason."""
    found = find_tool(use, state.known, surface, state.shown)
    if not found:
        return [], None, f"{use.tool.name} is not visible"
    block, tool = found
    # Should it fail, the tool is no longer where it was.
    state.known.remove(block)
    others = list(state.known)
    state.known.append(block)
    is_tool = belongs_to(tool, surface.points)
    looks, around = surface.points[is_tool], surface.points[~is_tool]
    # On the straight way to its work, the tool passes as in the demonstration, and may touch what it changes.
    fixed = around[~is_within(use.changed, alignment, around, state.shown)]
    avoided = surroundings_of(around), surroundings_of(fixed)
    able, reason = able_arms(arms, block, tool.size[1], state.failures, "no arm brings it there and back", use.tool.name)
    if not able:
        return [], None, reason
    whole = whole_of(looks, tool.position[2])
    candidates = holds(nearest_first(able, tool.position[0]), tool, whole, others, state.failures, sensor)
    for part, ways, side in ways_from([[0]] if use.at is None else C.sides_rad, ways_past(avoided[0])):
        begin, end, yaw = seen_from(use, side, alignment)
        begin = end + part * (begin - end)
        # All ways bring the tool there, whatever the Hold.
        if not avoided[0].of_load.is_below(moved_to(whole, tool, begin, yaw - tool.yaw)):
            continue
        # Each is planned once, when its turn comes first.
        candidates, these = tee(candidates)
        for hold in these:
            actions = plan_held_use(hold, tool, (begin, end), yaw - tool.yaw, avoided, ways)
            if actions:
                return actions, hold.grasp, None
    return [], None, reason


def seen_from(use, side, alignment):
    """Returns the begin and the end of the straight way of a Use in the scene, x y z each, and its yaw [rad], turned about
    what it works on by some angle [rad]."""
    def placed(place):
        turned = place[:2] if use.at is None else use.at + rotated(place[:2] - use.at, side)
        return np.append(rotated(turned - alignment.place, -alignment.angle), place[2])
    return placed(use.begin), placed(use.pose[:3]), use.pose[3] + side - alignment.angle


def ways_from(sides, ways):
    """Returns all ways_past from sides [rad], of which lists are given: all from those of a list before any from the next."""
    return ((part, these, side) for some in sides for (part, these), side in product(ways, some))


def ways_past(around):
    """Returns the Ways there and back, lists in the order in which they are tried: first those beside what Surroundings
    contain; where none is clear, those over all of it, as high as necessary. Before each, which part of the straight way
    it leads to: what comes from above comes as close to its work as is clear, away from the robot."""
    highest = around.of_load.heights.max(initial=0)
    over = [Way(False, highest + it) for it in C.heights_over]
    return [(1, [Way(True, 0), Way(False, 0)]), *((part, over) for part in C.parts_of_way)]
