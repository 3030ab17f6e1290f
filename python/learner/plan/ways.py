"""Ways of an arm between where it takes something, where it works with it, and where it puts it."""

from collections import namedtuple

from act.reach import solve_poses
from act.segments import at_height, move_joints, move_line

# How an arm comes from one pose to another: on a straight line, or in any way, which passes over both at a height of
# the tool [units]; 0 for no such height.
Way = namedtuple("Way", "is_line height")


def there_on(arm, taken, work, way, can_begin):
    """Returns some paths and the one that follows on a Way to the first pose of some work, [] if there is none; and the
    joint angles between which it leads, [] for a straight line. can_begin: function of joint angles, whether the work can
    begin there"""
    if way.is_line:
        path = lines(arm, taken, work[:1])
        return (path if path and can_begin(path[-1].positions[-1]) else []), []
    via = [taken[-1].positions[-1]]
    if way.height:
        over = solve_poses(arm, [at_height(it, way.height) for it in (arm.forward(via[0]), work[0])], via[0])
        if not over:
            return [], []
        via += over
    first = solve_poses(arm, work[:1], via[-1])
    if not first or not can_begin(first[0]) or len(solve_poses(arm, work[1:], first[0])) < len(work) - 1:
        return [], via
    return [*taken, move_joints(arm, [*via, *first])], via


def back_after(arm, path, put, via):
    """Returns some paths, and those that follow back between joint angles via, see there_on, and through the poses where
    the arm puts what it holds; [] if there are none."""
    if not path or not via:
        return lines(arm, path, put)
    return lines(arm, [*path, move_joints(arm, [path[-1].positions[-1], *via[::-1]])], put[1:])


def lines(arm, path, poses):
    """Returns paths, and straight lines from the last of them through tool poses; [] if there are none."""
    path = list(path)
    for pose in poses if path else []:
        path.append(move_line(arm, path[-1], pose))
        if not path[-1]:
            return []
    return path
