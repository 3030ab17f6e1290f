"""Paths of an arm through poses of its tool, and to where it waits."""

from act.arm_clearance import is_arm_clear, is_path_over
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
        # From and to where it waits, only this tells whether it passes over all.
        if (all(is_path_valid(arm, move) for move in path)
                and all(is_path_over(arm, move, others) for move in (path[0], path[-1]))):
            return path
    return []
