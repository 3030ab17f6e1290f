"""Learner: rebuilds in a new scene what a demonstration shows (letters, towers, rows, bridges).

    smile imitate DEMO SCENE --brain python/learner/learner.py

docs/learner.md describes it and its twin in Octave, matlab/learner; where Octave does a task, both choose
the same actions.

smile: imitates
"""

from arms import arms_for, arms_of
from constants import TASK_PLANNING
from demonstration import read_demonstration
from devices import infer_devices
from execution import Action, execute_action
from explain import explain
from eye import Eye
from joint_estimates import JointEstimates
from motion_planning import retreat
from notes import Note, tops_of
from sentences import page_of
from task_model import infer_task
from task_planning import choose_actions
from task_state import TaskState, give_up, remember_failure


def init(aux):
    """Infers the task from the demonstration. This scene is unknown before the first picture."""
    if "demonstration" not in aux:
        raise ValueError("this brain needs a demonstration: "
                         "smile imitate DEMO SCENE --brain python/learner/learner.py")
    demo = read_demonstration(aux.demonstration)
    steps, container = infer_task(demo, aux.attention)
    presses = infer_devices(demo, steps)
    page = page_of(explain(demo, container))
    for line in page:
        print(line)
    aux.notes = [f"understood: {line.strip()}" for line in page]
    for k, step in enumerate(steps):
        place = ", ".join(steps[lower].name for lower in step.on) or "the table"
        print(f"shown: {k + 1}. {step} on {place}")
    for press in presses:
        before = ", ".join(steps[k].name for k in press.after) or "nothing"
        print(f"shown: {press} after {before}")

    arms = arms_of(aux)
    aux.hands = arms_for(steps, arms)
    aux.eye = Eye(aux.cameraIntrinsics, aux.cameraPose)
    # Beliefs about this scene, and progress. Agents to compare with, in python/examples/agents, set
    # what the learner does without, or another way to see.
    aux.state = TaskState(steps, container, presses=presses, shown=demo.eye,
                          without=vars(aux).get("without", ()), see=vars(aux).get("see"))
    if "variationOrder" in aux:
        aux.state.order_seed = int(aux.variationOrder)
    aux.actions = [Action("observe")]  # the next actions, in this order
    aux.num_retreats = 0  # number of successive retreats after failed actions

    aux.channels = ["rgb", "depth"]

    # The arms start outside the picture.
    for arm in arms:
        aux.arms[arm.index].initJoints = arm.parked
    aux.joints = JointEstimates([arm.initJoints for arm in aux.arms])


def step(sensor, motor, aux):
    """Continues the first action. After the last one, a picture of the table determines the
    next."""
    aux.joints.correct(sensor, aux.tickSeconds)
    status = execute_action(aux.actions[0], sensor, motor, aux)
    aux.joints.remember(motor)
    if status == "done":
        aux.actions.pop(0)
        if not aux.actions:
            aux.num_retreats = 0
            aux.actions = choose_actions(aux.state, sensor, aux.eye, aux.hands)
    elif status != "busy":
        aux.state.notes.append(Note("contradicted", status))
        if aux.num_retreats == 0:
            remember_failure(aux.state, aux.actions)
        arm = aux.actions[0].arm
        aux.num_retreats += 1
        if aux.num_retreats <= TASK_PLANNING.max_retreats:
            q = sensor.arms[arm.index].joints
            aux.actions = retreat(arm, q, can_rise=aux.num_retreats == 1)
        else:
            give_up(aux.state, "because the arm is stuck")
    tell(aux, sensor.simTime)
    if aux.state.claim:
        aux.claim = f"{'done' if aux.state.claim.done else 'gave up'}: {aux.state.claim.reason}"
        print(f"{sensor.simTime:5.1f} s: {aux.claim}")
        aux.exit = True


def tell(aux, seconds):
    """Tells the notes that were not told yet: those about actions also in the log."""
    notes, aux.state.notes = aux.state.notes, []
    if not notes:
        return
    for note in notes:
        if note.word not in ("plan", "saw"):
            print(f"{seconds:5.1f} s: {note}")
    aux.notes = [str(note) for note in notes]
    aux.noteTops = tops_of(notes)
