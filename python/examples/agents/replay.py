"""Replays the demonstrated motions at the demonstrated places, with its eyes shut: it succeeds only
where everything begins where it began in the demonstration.

    smile imitate DEMO SCENE --brain python/examples/agents/replay.py

smile: imitates
"""

from deeds import continue_carrying, prepare


def init(aux):
    aux.carries, aux.places = prepare(aux)
    aux.channels = []


def step(sensor, motor, aux):
    continue_carrying(sensor, motor, aux)
