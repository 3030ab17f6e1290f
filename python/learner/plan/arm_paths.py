"""Paths of an arm through poses of its tool, and to where it waits."""

from act.arm_clearance import is_arm_clear
from act.reach import solve_pose_sequence
from act.segments import is_path_valid, move_joints, move_line


def plan_path_through(arm, poses, others, q):
    """Plans the paths of an arm to the first of some tool poses, along straight lines through the
    others, and to its parking pose: a list; [] if there is none.

    poses:  list of 4x4 [units]
    others: obstacles for the forearm, as Blocks, where the tool is lower than the highest pose
    q:      its joint angles [rad]
    """
    height = max(pose[2, 3] for pose in poses)
    for first in arm.starts:
        above = solve_pose_sequence(arm, poses, first)
        if above is None:
            continue
        path = [move_joints(arm, [q, above])]
        for pose in poses[1:]:
            path.append(move_line(arm, path[-1], pose))
            if not path[-1]:
                break
        if not path[-1]:
            continue
        low = [move for move, pose in zip(path, poses) if pose[2, 3] < height]
        if not all(is_arm_clear(arm, move.positions[-1], others) for move in low):
            continue
        path.append(move_joints(arm, [path[-1].positions[-1], arm.parked]))
        if all(is_path_valid(arm, move) for move in path):
            return path
    return []


def plan_parts(arm, parts, is_line, q, is_clear):
    """Plans the paths of an arm along straight lines through the tool poses of each part, from part to part on a
    straight line or any way, and to its parking pose: a list; [] if there is none.

    parts:    lists of 4x4 [units]
    q:        its joint angles [rad]
    is_clear: function of that list: whether nothing is in the way
    """
    for first in arm.starts:
        path = []
        for poses in parts:
            here = path[-1].positions[-1] if path else first
            if not path or not is_line:
                above = solve_pose_sequence(arm, poses, here)
                path.append(above is not None and move_joints(arm, [here if path else q, above]))
                poses = poses[1:]
            for pose in poses:
                path.append(path[-1] and move_line(arm, path[-1], pose))
            if not path[-1]:
                break
        if path[-1]:
            path.append(move_joints(arm, [path[-1].positions[-1], arm.parked]))
            if all(is_path_valid(arm, move) for move in path) and is_clear(path):
                return path
    return []
