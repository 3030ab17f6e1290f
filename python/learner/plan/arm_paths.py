"""Paths of an arm through poses of its tool, and to where it waits."""

from act.arm_clearance import is_arm_clear, is_path_over
from act.reach import solve_poses
from act.segments import at_height, is_path_valid, move_joints, move_line
from constants import MOTION_PLANNING as C


def plan_path_through(arm, poses, others, q, placed=(), taken=()):
    """Plans the paths of an arm to the first of some tool poses, along straight lines through the
    others, and to its parking pose: a list; [] if there is none.

    poses:  list of 4x4 [units]
    others: obstacles for the forearm, as Blocks, where the tool is lower than the highest pose
    q:      its joint angles [rad]
    placed: what it leaves there, as Blocks: obstacles on the way to its parking pose
    taken:  what it takes there, as Blocks: obstacles on the way from where it is
    """
    height = max(pose[2, 3] for pose in poses)
    possible = []
    for first in arm.starts:
        found = solve_poses(arm, poses, first)
        if not found:
            continue
        path = [move_joints(arm, [q, found[0]])]
        for pose in poses[1:]:
            path.append(move_line(arm, path[-1], pose))
            if not path[-1]:
                break
        if not path[-1]:
            continue
        low = [move for move, pose in zip(path, poses) if pose[2, 3] < height]
        if not all(is_arm_clear(arm, move.positions[-1], others) for move in low):
            continue
        # From and to where it waits, only this tells whether it passes over all.
        if not all(is_path_valid(arm, move) for move in path) or not is_path_over(arm, path[0], [*others, *taken]):
            continue
        home = path_home(arm, path[-1], [*others, *placed], rise=0)
        if home:
            return [*path, home]
        possible.append(path)
    for path in possible:
        for rise in C.rises:
            home = path_home(arm, path[-1], [*others, *placed], rise)
            if home:
                return [*path, home]
    return []


def path_home(arm, before, obstacles, rise):
    """Returns a path of an arm from the end of another one to its parking pose, raised first by a height [units], over
    obstacles; None if there is none."""
    waypoints = [before.positions[-1]]
    if rise > 0:
        here = arm.forward(waypoints[0])
        raised = move_line(arm, before, at_height(here, here[2, 3] + rise))
        if not raised:
            return None
        waypoints.append(raised.positions[-1])
    path = move_joints(arm, [*waypoints, arm.parked])
    return path if is_path_valid(arm, path) and is_path_over(arm, path, obstacles) else None
