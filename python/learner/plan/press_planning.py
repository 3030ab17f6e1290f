"""Plans presses of buttons."""

from act.actions import Action, Grasp
from act.finger_room import grasp_yaws
from act.grippers import nearest_first
from act.segments import at_height
from check.failures import has_failed
from constants import PRESSES as C
from match.pressing import button_of
from plan.arm_paths import plan_path_through
from things.held_parts import with_held_parts


def plan_press(press, alignment, surface, state, arms, sensor):
    """Plans to press a button with closed fingers from above. Returns actions, the Grasp that stands for the
    attempt, and None; or [], None and the reason."""
    button = button_of(press, alignment, surface, state.shown)
    if button is None:
        return [], None, "no button is visible"
    others = with_held_parts(state.known)
    for arm in nearest_first(arms, button.position[0]):
        for across in grasp_yaws(button, others):
            attempt = Grasp(button.position, arm.index, across)
            if has_failed(attempt, state.failures):
                continue
            down = arm.tool_pose([*button.position[:2], button.bottom + C.depth + arm.reach], across)
            for height in C.heights:
                above = at_height(down, button.top + height + arm.reach)
                path = plan_path_through(arm, [above, down, above], others, sensor.arms[arm.index].joints)
                if path:
                    there, down, _, home = path  # a press goes back by itself
                    moves = [Action("follow", arm, there), Action("press", arm, down), Action("follow", arm, home)]
                    return [Action("open", arm, to=0), *moves, Action("observe")], attempt, None
    return [], None, "no arm reaches it"
