"""A robot program that is written as one generator: from the first picture to the last motion."""


def look(aux):
    """Waits for a new picture of the eye and returns the sensor values with it."""
    aux.imageSeconds = 0
    sensor = yield
    while "rgbVision" not in sensor:
        sensor = yield
    aux.imageSeconds = 3600
    return sensor


def advance(task, sensor, motor, aux):
    """Advances a task by a step; `task(motor, aux)` is the generator. The brain ends with it."""
    if "task" not in aux:
        aux.task = task(motor, aux)
        next(aux.task)
    try:
        aux.task.send(sensor)
    except StopIteration:
        print(f"{sensor.simTime:.1f} s: done")
        aux.exit = True
