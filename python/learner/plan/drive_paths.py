"""Paths on which an arm takes a tool, turns fasteners, and puts the tool back."""

from itertools import product

import numpy as np

from act.actions import Action, Grasp
from act.segments import is_path_valid, move_joints
from constants import MOTION_PLANNING, USES as C
from plan.driving_hands import DrivingHand, NoPath


def plan_arm_drive(arm, tool, height, turns, q, is_clear):
    """Plans a Drive with one arm: actions, [] if that arm cannot.

    tool:     the tool where it stands upright, a Block; height: of its center on the way [units]
    turns:    Turns, at their places in this scene
    q:        joint angles of the arm [rad]; is_clear: function of a path: whether nothing is in its way
    """
    for start, depth in product(arm.starts, C.depths):
        hand = DrivingHand(arm, tool.size[1], tool.size[2] / 2 - depth)
        try:
            take = paths_to_take(hand, tool, height, turns[0], start, q)
            work = []
            for it in turns:
                work.append(paths_to_turn(hand, it, height, (work or [take])[-1][-1].positions[-1]))
            put = paths_to_put(hand, tool, height, take, work[-1][-1].positions[-1])
        except NoPath:
            continue
        paths = [*take, *(path for paths in work for path in paths), *put]
        across = [*(it[0] for it in work), put[0]]
        if all(is_path_valid(arm, it) for it in paths) and all(map(is_clear, across)):
            numbers = [hand.strokes(it)[2] for it in turns]
            return actions_of(hand, tool, take, list(zip(work, numbers)), put)
    return []


def paths_to_take(hand, tool, height, turns, start, q):
    """Returns the paths over a tool, down to it, and up again."""
    over = hand.pose(tool.position, height)
    first = hand.arm.inverse(over, start, any_turn=True, max_iterations=MOTION_PLANNING.ik_iterations)
    if first is None:
        raise NoPath
    way = move_joints(hand.arm, [q, np.append(first[:-1], hand.strokes(turns)[0])])
    down = hand.line(way.positions[-1], hand.pose(tool.position, tool.position[2]))
    return [way, down, hand.line(down.positions[-1], over)]


def paths_to_turn(hand, turns, height, q):
    """Returns the paths over a fastener, to where the strokes begin, and of a stroke: down, turning, up, back."""
    over = hand.pose(turns.place, height)
    begin, end, _ = hand.strokes(turns)
    paths = [hand.over(q, over)]
    paths.append(hand.turned(paths[-1].positions[-1], begin))
    paths.append(hand.line(paths[-1].positions[-1], hand.pose(turns.place, turns.place[2])))
    paths.append(hand.turned(paths[-1].positions[-1], end))
    paths.append(hand.line(paths[-1].positions[-1], over))
    return [*paths, move_joints(hand.arm, [paths[-1].positions[-1], paths[1].positions[-1]])]


def paths_to_put(hand, tool, height, take, q):
    """Returns the paths over the place of the tool, to how the arm took it, down, up, and to where the arm waits."""
    across = hand.over(q, hand.pose(tool.position, height))
    adjust = move_joints(hand.arm, [across.positions[-1], take[-1].positions[-1]])
    low = tool.position[2] + MOTION_PLANNING.place_height_margin
    put = hand.line(adjust.positions[-1], hand.pose(tool.position, low))
    up = hand.line(put.positions[-1], hand.pose(tool.position, height))
    return [across, adjust, put, up, move_joints(hand.arm, [up.positions[-1], hand.arm.parked])]


def actions_of(hand, tool, take, work, put):
    """Returns the actions; work: for each fastener, its paths and the number of strokes."""
    arm = hand.arm
    opening = min(hand.width + MOTION_PLANNING.opening_margin, arm.opening)
    closed = Action("grasp", arm, width=hand.width, grasp=Grasp(tool.position, arm.index, 0.0))
    way = sum([paths[:2] + number * paths[2:] for paths, number in work], []) + put[:3]
    to_tool, there_and_back, away = [[Action("follow", arm, it) for it in part] for part in (take[:2], way, put[3:])]
    return [Action("open", arm, to=opening), *to_tool, closed, Action("lift", arm, take[2]), *there_and_back,
            Action("open", arm, to=opening), *away, Action("observe")]
