"""Runs a brain in Python for the SMILE simulator until the simulator says goodbye.

The simulator starts `python3 -m smile.brain` and tells it in the environment

    SMILE_BRAIN_TRANSPORT  `socket`
    SMILE_BRAIN_ADDRESS    the Unix socket to connect to
    SMILE_BRAIN_PROGRAM    the brain, a .py file
    SMILE_BRAIN_FOLDER     the folder it lies in

The program is a module with a function `step(sensor, motor, aux)` and, if it likes, `init(aux)`.
docs/brains.md tells what these are, docs/brain-protocol.md describes the messages. Needs numpy, and
the compiled module smile_brain_native.
"""

import importlib.util
import os
import platform
import signal
import sys
import traceback

try:
    import numpy as np
except ImportError:
    sys.exit(f"{sys.executable} has no numpy; install it, or name another Python in SMILE_PYTHON")

try:
    from smile.messages import (
        BYE, ERROR, FINAL_MOTOR, INIT, INIT_DONE, MOTOR, Connection, ProtocolError)
except ImportError as error:
    sys.exit(str(error))

from smile.brain_values import Motor, aux_of, sensor_of, wish_of, wishes_of

NO_MARKERS = np.zeros((0, 3))


class TookTooLong(BaseException):
    """Raised in a program that is late. No Exception: `except Exception` shall not swallow it."""


class Guard:
    """Turns SIGUSR2 into TookTooLong, while the program runs and not in the middle of a message."""

    def __init__(self):
        self.is_watching = False
        signal.signal(signal.SIGUSR2, self.on_signal)

    def on_signal(self, *_):
        if self.is_watching:
            self.is_watching = False
            raise TookTooLong("this took too long and was stopped")

    def __enter__(self):
        self.is_watching = True

    def __exit__(self, *_):
        self.is_watching = False


class Program:
    """The brain, and what it has been told and has answered so far."""

    def __init__(self):
        self.file = os.environ["SMILE_BRAIN_PROGRAM"]
        self.folder = os.path.join(os.environ["SMILE_BRAIN_FOLDER"], "")

    def start(self, values):
        """INIT -> INIT_DONE"""
        # The name of the file, so that its classes can be pickled and its helpers import it.
        name = os.path.splitext(os.path.basename(self.file))[0]
        spec = importlib.util.spec_from_file_location(name, self.file)
        self.module = importlib.util.module_from_spec(spec)
        sys.modules[name] = self.module
        spec.loader.exec_module(self.module)
        if not callable(getattr(self.module, "step", None)):
            raise NameError("there is no function step(sensor, motor, aux)")
        self.aux = aux_of(values)
        self.motor = Motor(self.aux.numLimbs, self.aux.numJoints)
        if hasattr(self.module, "init"):
            self.module.init(self.aux)
        wishes = wishes_of(self.aux)
        self.markers = np.array(wishes.get("drawMarkers", NO_MARKERS))
        return INIT_DONE, wishes

    def step(self, values):
        """STEP -> MOTOR or FINAL_MOTOR"""
        self.module.step(sensor_of(values), self.motor, self.aux)
        is_last = "exit" in self.aux and bool(np.any(self.aux.exit))
        return FINAL_MOTOR if is_last else MOTOR, self.motor.values() | self.new_markers()

    def new_markers(self):
        """aux.drawMarkers, when they are others than those sent last."""
        if "drawMarkers" not in self.aux and not len(self.markers):
            return {}  # most programs have none, and array_equal is slow
        markers = wish_of(self.aux, "drawMarkers") if "drawMarkers" in self.aux else NO_MARKERS
        if np.array_equal(markers, self.markers):
            return {}
        self.markers = np.array(markers)
        return {"drawMarkers": self.markers}

    def describe(self, error):
        """An exception as the arrays of ERROR: what, and where in the program's own folder."""
        file, line = self.place_of(error)
        message = f"{type(error).__name__}: {error}" if str(error) else type(error).__name__
        if isinstance(error, SyntaxError):
            message = f"{type(error).__name__}: {error.msg}"
        if isinstance(error, SystemExit):
            message = f"the program called exit({error.code})"
        return {"message": message, "file": file, "line": line}

    def place_of(self, error):
        if isinstance(error, SyntaxError) and error.filename and error.lineno:
            return os.path.abspath(error.filename), error.lineno
        for frame in reversed(traceback.extract_tb(error.__traceback__)):
            file = os.path.abspath(frame.filename)
            if file.startswith(self.folder):
                return file, frame.lineno
        return self.file, 0

    def show(self, error):
        """Prints the traceback, from the program's own first line on."""
        trace = error.__traceback__
        while trace and not trace.tb_frame.f_code.co_filename.startswith(self.folder):
            trace = trace.tb_next
        traceback.print_exception(type(error), error, trace)


def serve(connection, program, guard):
    connection.greet(client="python", language=platform.python_version(), guard=True)
    while True:
        kind, sequence, values = connection.receive()
        if kind == BYE:
            return
        try:
            with guard:
                kind, values = program.start(values) if kind == INIT else program.step(values)
        except BaseException as error:  # whatever it is, the simulator is told
            program.show(error)
            kind, values = ERROR, program.describe(error)
        try:
            connection.send(kind, sequence, values)
        except ValueError as error:  # too much for a message, or no letters
            connection.send(ERROR, sequence, program.describe(error))


def main():
    if "SMILE_BRAIN_ADDRESS" not in os.environ:
        sys.exit("a brain is started by the simulator: smile run SCENE --brain PROGRAM.py")
    # Modules come from the program's folder, not from the one it happens to be started in.
    os.environ.pop("PYTHONSAFEPATH", None)
    sys.path[:] = [path for path in sys.path if path not in ("", os.getcwd())]
    sys.path.insert(0, os.environ["SMILE_BRAIN_FOLDER"])
    try:
        connection = Connection(os.fsencode(os.environ["SMILE_BRAIN_ADDRESS"]))
        serve(connection, Program(), Guard())
    except ProtocolError as error:
        sys.exit(str(error))


if __name__ == "__main__":
    main()
