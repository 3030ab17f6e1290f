"""Learner: rebuilds in a new scene what a demonstration shows (letters, towers, rows, bridges).

    smile imitate DEMO SCENE --brain python/learner/learner.py

docs/learner.md describes it and its twin in Octave, matlab/learner, which chooses the same actions.

smile: imitates
"""

from act.actions import Action
from act.execution import execute_action
from act.grippers import arms_for
from act.joint_estimates import JointEstimates
from act.robot_arms import arms_of
from check.choices import choices_of
from check.claims import Claim, end_with, give_up
from check.hand_views import see_from_hand
from check.task_state import TaskState
from check.telling import tell
from constants import TASK_PLANNING
from explain.limits import NotUnderstood
from explain.understanding import understand
from plan.recovery import recover
from plan.task_planning import choose_actions
from see.framing import eye_of_robot


def init(aux):
    """Infers the task from the demonstration. This scene is unknown before the first picture."""
    if "demonstration" not in aux:
        raise ValueError("this brain needs a demonstration: smile imitate DEMO SCENE --brain python/learner/learner.py")
    aux.state = None
    try:
        demo, steps, containers, presses = understand(aux)
    except NotUnderstood as problem:
        end_with(Claim(False, str(problem)), 0, aux)
        return
    arms = arms_of(aux)
    aux.hands = arms_for(steps, arms)
    aux.eye = eye_of_robot(aux)
    # Beliefs and progress. Agents in python/examples/agents set what it does without, or another way to see.
    aux.state = TaskState(steps, containers, presses=presses, shown=demo.eye, unclear=demo.unclear, choices=choices_of(aux),
                          without=vars(aux).get("without", ()), see=vars(aux).get("see"))
    aux.actions = [Action("observe")]  # the next actions, in this order
    aux.num_retreats = 0  # number of successive retreats after failed actions
    aux.channels = ["rgb", "depth"]
    aux.cameras = [arm.camera for arm in aux.hands if arm.camera]
    # The arms start outside the picture.
    for arm in arms:
        aux.arms[arm.index].initJoints = arm.parked
    aux.joints = JointEstimates([arm.initJoints for arm in aux.arms])


def step(sensor, motor, aux):
    """Continues the first action. After the last one, a picture of the table determines the next."""
    if not aux.state:
        return
    aux.joints.correct(sensor, aux.tickSeconds)
    status = execute_action(aux.actions[0], sensor, motor, aux)
    aux.joints.remember(motor)
    if status == "done":
        last = aux.actions.pop(0)
        if last.kind == "look":
            see_from_hand(aux.state, sensor, last.arm)
        if not aux.actions:
            aux.actions = choose_actions(aux.state, sensor, aux.eye, aux.hands)
            if aux.num_retreats > TASK_PLANNING.max_retreats and not aux.state.claim:
                give_up(aux.state, "because the arm is stuck")
            aux.num_retreats = 0
    elif status != "busy":
        recover(status, sensor, aux)
    tell(aux, sensor.simTime)
    if aux.state.claim:
        end_with(aux.state.claim, sensor.simTime, aux)
