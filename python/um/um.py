"""Rebuilds what it was shown, in a scene it has never seen: letters, towers, rows, bridges.

    smile imitate DEMO SCENE --brain python/um/um.py

docs/learner.md walks through its twin in Octave, matlab/um; both decide alike.

smile: imitates
"""

from smile.motion import robot_of

from acting import Action, carry_out
from carrying import PARKED, retreat
from constants import ACT
from deciding import Building, decide
from demonstration import read_demonstration
from looking import Eye
from understanding import understand


def init(aux):
    """What the demonstration shows is understood at once; of this scene nothing is known before the
    first look."""
    if "demonstration" not in aux:
        raise ValueError("this brain needs a demonstration: "
                         "smile imitate DEMO SCENE --brain python/um/um.py")
    steps, container = understand(read_demonstration(aux.demonstration), aux.attention)
    for k, step in enumerate(steps):
        place = ", ".join(steps[lower].name for lower in step.on) or "the table"
        print(f"shown: {k + 1}. {step} on {place}")

    aux.planner = robot_of(aux)
    aux.eye = Eye(aux.cameraIntrinsics, aux.cameraPose)
    aux.building = Building(steps, container)  # what is known here, and what was done so far
    aux.actions = [Action("look")]  # what to do next, in this order
    aux.is_recovering = False  # true after an action went wrong

    # The arms begin where they do not stand in the picture.
    aux.imageSeconds = ACT.image_s
    aux.initJointAngles = PARKED


def step(sensor, motor, aux):
    """Goes on with the first of the actions. After the last one, a look at the table decides what
    is next."""
    status = carry_out(aux.actions[0], sensor, motor)
    if status == "done":
        aux.actions.pop(0)
        if not aux.actions:
            aux.is_recovering = False
            aux.actions = decide(aux.building, sensor, aux.eye, aux.planner)
            if not aux.actions:
                print(f"{sensor.simTime:5.1f} s: {aux.building.summary}")
                aux.exit = True
    elif status != "busy":
        print(f"{sensor.simTime:5.1f} s: {status}")
        if aux.is_recovering:
            raise RuntimeError("the arm does not get free")
        aux.actions = retreat(aux.planner, aux.actions[0].arm, sensor.jointAngles)
        aux.is_recovering = True
