"""What comes after an action that failed."""

from act.actions import Action
from act.retreats import retreat
from check.failures import remember_failure
from check.notes import Note
from constants import TASK_PLANNING as C


def recover(status, sensor, aux):
    """Remembers how an action failed, and plans that its arm retreats; after too many retreats, only another look.

    status: of the first of the actions, as from execute_action
    """
    aux.state.notes.append(Note("contradicted", status))
    if aux.num_retreats == 0:
        remember_failure(aux.state, aux.actions, status)
    arm = aux.actions[0].arm
    aux.num_retreats += 1
    if aux.num_retreats <= C.max_retreats:
        aux.actions = retreat(arm, sensor.arms[arm.index].joints, can_rise=aux.num_retreats == 1)
    else:
        aux.actions = [Action("observe")]  # all may be done already
