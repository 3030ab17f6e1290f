"""Paths on which an arm uses a tool."""

from act.actions import Action
from act.segments import at_height
from constants import MOTION_PLANNING
from plan.tool_holds import tool_pose
from plan.there_and_back import plan_there_and_back


def plan_held_use(hold, tool, way, turn, avoided, ways):
    """Plans a use with a Hold; [] if the arm cannot.

    way:     the places where the tool's straight way to its work begins and ends
    turn:    of the tool until then [rad]
    avoided: Surroundings on the way there and back, and on that straight way
    ways:    Ways there and back, in the order in which they are tried
    """
    arm, width = hold.arm, tool.size[1]
    opening = min(width + MOTION_PLANNING.opening_margin, arm.opening)
    above, start, _ = hold.poses
    put = at_height(start, start[2, 3] + MOTION_PLANNING.place_height_margin)
    work = [tool_pose(arm, tool, hold.grasp.yaw, hold.grip, it, turn) for it in (*way, way[0])]

    around, at_work = avoided

    def is_way_clear(path):
        return around.avoids(arm, path, hold.load)

    def is_rest_clear(paths):
        return (is_way_clear(paths[6]) and all(at_work.avoids(arm, it) for it in paths[4:6])
                and all(around.avoids(arm, it) for it in paths[0:10:9]))

    path = plan_there_and_back(arm, hold.taken, work, [above, put, above], ways, hold.load.box(), is_way_clear,
                               is_rest_clear)
    if not path:
        return []
    moves = [Action("follow", arm, it) for it in path]
    moves[2].kind = "lift"
    closing = [Action("grasp", arm, width=width) for _ in range(2)]
    return [Action("open", arm, to=opening), *moves[:2], closing[0], *moves[2:5], closing[1], *moves[5:8],
            Action("open", arm, to=opening), *moves[8:], Action("observe")]
