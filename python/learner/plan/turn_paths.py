"""Paths on which an arm turns a block."""

from act.actions import Action
from act.arm_clearance import are_fingers_clear, is_hand_clear, samples
from act.reach import solve_poses
from act.segments import move_joints, move_line
from constants import ARMS, MOTION_PLANNING as C
from plan.tilt import turn_height


def plan_turn_to(grasp, block, held, place, others, sensor):
    """Plans the actions that turn a block with a grasp and put it at a place; [] if there are none."""
    arm = grasp.arm
    width = block.size[held]
    opening = min(width + C.opening_margin, arm.opening)
    highest = max((it.top for it in others), default=0)
    for over_end, end in grasp.ends(place, turn_height(block, others)):
        found = solve_poses(arm, [over_end, end], grasp.q[0], grasp.margin)
        if not found or not is_hand_clear(arm, found, others, place):
            continue
        to_start = move_joints(arm, [sensor.arms[arm.index].joints, grasp.q[0]])
        down = move_line(arm, to_start, grasp.start)
        up = down and move_line(arm, down, grasp.over_start)
        turn = up and move_joints(arm, [up.positions[-1], found[0]])
        lower = turn and move_line(arm, turn, end)
        leave = lower and move_line(arm, lower, over_end)
        if not leave:
            continue
        path = [to_start, down, up, turn, lower, leave,
                move_joints(arm, [leave.positions[-1], arm.parked])]
        is_high = all(grasp.corners(q)[:, 2].min() > highest for q in samples(turn))
        is_clear = (are_fingers_clear(arm, to_start, [*others, block])
                    and are_fingers_clear(arm, path[-1], [*others, place]))
        is_valid = all(arm.robot.first_invalid(it, q_both=arm.all_parked, table=ARMS.table) is None
                       for it in path)
        if not (is_high and is_clear and is_valid):
            continue
        moves = [Action("follow", arm, it) for it in path]
        moves[2].kind = "lift"
        return [Action("open", arm, to=opening), *moves[:2],
                Action("grasp", arm, width=width, grasp=grasp.attempt), *moves[2:5],
                Action("open", arm, to=opening), *moves[5:], Action("observe")]
    return []
