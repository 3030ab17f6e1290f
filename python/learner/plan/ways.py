"""Paths of an arm that takes something, works with it elsewhere, and puts it back, with a choice of ways between."""

from collections import namedtuple

from act.reach import solve, solve_pose_sequence
from act.segments import at_height, is_path_valid, move_joints, move_line

# How an arm comes from one pose to another: on a straight line, or in any way, which passes over both at a height of
# the tool [units]; 0 for no such height.
Way = namedtuple("Way", "is_line height")


def plan_to_take(arm, poses, first, q, held):
    """Plans the paths of an arm to the first of some tool poses, and along straight lines through the others: a list; []
    if there are none.

    poses: 4x4 [units]; it takes something at the second one
    first: joint angles from which those at the first pose are searched [rad]
    q:     its joint angles [rad]
    held:  box around what it takes, see is_path_valid
    """
    above = solve_pose_sequence(arm, poses, first)
    path = above is not None and lines(arm, [move_joints(arm, [q, above])], poses[1:])
    return path if path and are_valid(arm, path[:2]) and are_valid(arm, path[2:], held) else []


def plan_there_and_back(arm, taken, work, put, ways, held, is_clear):
    """Plans the paths of an arm that took something through the tool poses of its work, on the first possible Way there and
    back, and to its parking pose: a list, which begins with the paths on which it took that; [] if there is none.

    taken:     paths, see plan_to_take
    work, put: lists of tool poses, 4x4 [units]; it leaves what it holds at the second of put, which begins where the
               paths ended
    ways:      Ways, in the order in which they are tried
    held:      box around what it holds, see is_path_valid
    is_clear:  function of that list: whether nothing is in the way
    """
    for way in ways:
        path = there_and_back(arm, taken, work, put, way)
        if not path:
            continue
        path.append(move_joints(arm, [path[-1].positions[-1], arm.parked]))
        if are_valid(arm, path[len(taken):-2], held) and are_valid(arm, path[-2:]) and is_clear(path):
            return path
    return []


def are_valid(arm, path, held=None):
    """Returns true if an arm can follow paths while it holds something, see is_path_valid."""
    return all(is_path_valid(arm, it, held) for it in path)


def there_and_back(arm, taken, work, put, way):
    """Returns some paths, and those that follow on a Way to the first pose of some work, through the others, and back;
    [] if there are none."""
    if way.is_line:
        return lines(arm, taken, [*work, *put])
    here = taken[-1].positions[-1]
    via = [here]
    if way.height:
        via += solve(arm, [at_height(it, way.height) for it in (arm.forward(here), work[0])], here, 0)
        if len(via) == 1:
            return []
    first = solve_pose_sequence(arm, work, via[-1])
    path = first is not None and lines(arm, [*taken, move_joints(arm, [*via, first])], work[1:])
    if not path:
        return []
    back = move_joints(arm, [path[-1].positions[-1], *via[::-1]])
    return lines(arm, [*path, back], put[1:])


def lines(arm, path, poses):
    """Returns paths, and straight lines from the last of them through tool poses; [] if there are none."""
    path = list(path)
    for pose in poses:
        path.append(move_line(arm, path[-1], pose))
        if not path[-1]:
            return []
    return path
