"""Paths of an arm that takes something, works with it elsewhere, and puts it back, with a choice of ways between."""

from act.segments import is_path_valid, move_joints
from plan.ways import back_after, lines, there_on


def plan_to_take(arm, poses, above, q, held):
    """Plans the paths of an arm to the first of some tool poses, and along straight lines through the others: a list; []
    if there are none.

    poses: 4x4 [units]; it takes something at the second one
    above: joint angles at the first one [rad]
    q:     its joint angles [rad]
    held:  box around what it takes, see is_path_valid
    """
    path = lines(arm, [move_joints(arm, [q, above])], poses[1:])
    return path if path and are_valid(arm, path[:2]) and are_valid(arm, path[2:], held) else []


def plan_there_and_back(arm, taken, work, put, ways, held, is_way_clear, is_rest_clear):
    """Plans the paths of an arm that took something through the tool poses of its work, on the first possible Way there and
    back, and to its parking pose: a list, which begins with the paths on which it took that; [] if there is none.

    taken:         paths, see plan_to_take
    work, put:     lists of tool poses, 4x4 [units]; it leaves what it holds at the second of put, which begins where the
                   paths ended
    ways:          Ways, in the order in which they are tried
    held:          box around what it holds, see is_path_valid
    is_way_clear:  function of the path there: whether nothing is in the way
    is_rest_clear: function of all paths, of which that one is clear
    """
    # Most Ways are excluded by where the work begins or on the way there: this is looked at before the rest is planned.
    def can_begin(q):
        return is_path_valid(arm, move_joints(arm, [q]), held)

    for way in ways:
        there, via = there_on(arm, taken, work, way, can_begin)
        if not there or not is_path_valid(arm, there[-1], held) or not is_way_clear(there[-1]):
            continue
        path = back_after(arm, lines(arm, there, work[1:]), put, via)
        if not path:
            continue
        path.append(move_joints(arm, [path[-1].positions[-1], arm.parked]))
        if are_valid(arm, path[len(there):-2], held) and are_valid(arm, path[-2:]) and is_rest_clear(path):
            return path
    return []


def are_valid(arm, path, held=None):
    """Returns true if an arm can follow paths while it holds something, see is_path_valid."""
    return all(is_path_valid(arm, it, held) for it in path)
