"""Does nothing, and claims no more: the floor of each score.

    smile imitate DEMO SCENE --brain python/examples/agents/idle.py

smile: imitates
"""


def init(aux):
    aux.channels = []


def step(sensor, motor, aux):
    aux.claim = "gave up: it never tries"
    aux.exit = True
