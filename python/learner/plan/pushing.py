"""Pushes blocks to places where what they touch leaves no room for fingers."""

from act.actions import Action, Grasp
from act.grippers import nearest_first
from act.push_ways import is_on_way, push_ways
from act.pushing_hands import pushing_hands
from act.segments import at_height
from check.failures import has_failed
from constants import MOTION_PLANNING as C
from plan.arm_paths import plan_path_through


def pushes_to(arms, block, goal, others, sensor, failures):
    """Plans the pushes that bring a block to a goal (a Block or Step) from where a way there begins.

    The arguments are those of plan_pick_and_place.
    Returns the actions of the one for which the block is in place, [] if there is none; and the starts of the others, as
    Blocks.
    """
    starts = []
    for way in push_ways(block, goal, others):
        is_there = is_on_way(block, way)
        actions = plan_push(arms, block if is_there else way.start, way, others, sensor, failures)
        if actions and is_there:
            return actions, []
        if actions:
            starts.append(way.start)
    return [], starts


def plan_push(arms, block, way, others, sensor, failures):
    """Plans to push a block that is on a PushWay to its end. Returns actions; [] if no arm can do it."""
    height = max(it.top for it in [*others, block])
    for arm in nearest_first(arms, way.end.position[0]):
        for hand in pushing_hands(arm, block, way, others):
            attempt = Grasp(block.position, arm.index, hand.across)
            if has_failed(attempt, failures):
                continue
            over = height + arm.reach + C.clearance
            poses = [at_height(hand.poses[0], over), *hand.poses, at_height(hand.poses[-1], over)]
            path = plan_path_through(arm, poses, others, sensor.arms[arm.index].joints, [way.end], [block])
            if path:
                moves = [Action("follow", arm, it) for it in path]
                moves[2] = Action("push", arm, path[2], grasp=attempt)
                return [Action("open", arm, to=hand.opening), *moves, Action("observe")]
    return []
