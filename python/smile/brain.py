"""Runs a brain in Python for the SMILE simulator until the simulator closes the connection.

The simulator starts `python3 -m smile.brain` with these environment variables:

    SMILE_BRAIN_TRANSPORT  `socket`
    SMILE_BRAIN_ADDRESS    the Unix socket to connect to
    SMILE_BRAIN_PROGRAM    the brain, a .py file
    SMILE_BRAIN_FOLDER     the folder of that file

The brain is a module with a function `step(sensor, motor, aux)` and optionally `init(aux)`.
docs/brains.md describes these functions, docs/brain-protocol.md the messages. Requires numpy and
the compiled module smile_brain_native.
"""

from __future__ import annotations

import ctypes
import importlib.util
import os
import platform
import signal
import sys
import traceback
from types import TracebackType

try:
    import numpy as _  # noqa: F401
except ImportError:
    sys.exit(f"{sys.executable} has no numpy; install numpy, or set SMILE_PYTHON to another Python")

try:
    from smile.messages import BYE, ERROR, INIT, Connection, ProtocolError
except ImportError as error:
    sys.exit(str(error))

from smile.brain_values import Values
from smile.exchange import Exchange


class TookTooLong(BaseException):
    """Raised in a brain that is late; `except Exception` does not catch it."""


class Guard:
    """Turns SIGUSR2 into TookTooLong while the brain runs, but not during a message."""

    def __init__(self) -> None:
        self.is_watching = False
        signal.signal(signal.SIGUSR2, self.on_signal)

    def on_signal(self, *_: object) -> None:
        if self.is_watching:
            self.is_watching = False
            raise TookTooLong("this took too long and was stopped")

    def __enter__(self) -> None:
        self.is_watching = True

    def __exit__(self, *_: object) -> None:
        self.is_watching = False


class Program:
    """The brain: a module of its file, whose functions answer."""

    def __init__(self) -> None:
        self.file = os.environ["SMILE_BRAIN_PROGRAM"]
        self.folder = os.path.join(os.environ["SMILE_BRAIN_FOLDER"], "")

    def answer(self, kind: int, values: Values) -> tuple[int, Values]:
        """Returns kind and values of the answer to a question."""
        if kind == INIT:
            self.exchange = self.load()
        return self.exchange.answer(kind, values)

    def load(self) -> Exchange:
        """Imports the brain."""
        # The module is named like the file, so that pickle and helper modules find it.
        name = os.path.splitext(os.path.basename(self.file))[0]
        spec = importlib.util.spec_from_file_location(name, self.file)
        assert spec is not None and spec.loader is not None  # of a .py file
        module = importlib.util.module_from_spec(spec)
        sys.modules[name] = module
        spec.loader.exec_module(module)
        if not callable(getattr(module, "step", None)):
            raise NameError("function step(sensor, motor, aux) is missing")
        return Exchange(module.step, getattr(module, "init", None))

    def describe(self, error: BaseException) -> Values:
        """Returns an exception as the arrays of ERROR: message, file and line of the brain."""
        file, line = self.place_of(error)
        message = f"{type(error).__name__}: {error}" if str(error) else type(error).__name__
        if isinstance(error, SyntaxError):
            message = f"{type(error).__name__}: {error.msg}"
        if isinstance(error, SystemExit):
            message = f"the program called exit({error.code})"
        return {"message": message, "file": file, "line": line}

    def place_of(self, error: BaseException) -> tuple[str, int]:
        if isinstance(error, SyntaxError) and error.filename and error.lineno:
            return os.path.abspath(error.filename), error.lineno
        for frame in reversed(traceback.extract_tb(error.__traceback__)):
            file = os.path.abspath(frame.filename)
            if file.startswith(self.folder):
                return file, frame.lineno or 0
        return self.file, 0

    def show(self, error: BaseException) -> None:
        """Prints the traceback, from the program's own first line on."""
        trace: TracebackType | None = error.__traceback__
        while trace and not trace.tb_frame.f_code.co_filename.startswith(self.folder):
            trace = trace.tb_next
        traceback.print_exception(type(error), error, trace)


def serve(connection: Connection, program: Program, guard: Guard) -> None:
    connection.greet(client="python", language=platform.python_version(), guard=True)
    while True:
        kind, sequence, values = connection.receive()
        if kind == BYE:
            return
        try:
            with guard:
                kind, values = program.answer(kind, values)
        except BaseException as error:  # every failure is reported to the simulator
            program.show(error)
            kind, values = ERROR, program.describe(error)
        try:
            connection.send(kind, sequence, values)
        except ValueError as error:  # too large for a message, or invalid text
            connection.send(ERROR, sequence, program.describe(error))


def keep_freed_memory() -> None:
    """Lets the allocator keep the memory of freed arrays for the next ones.

    glibc returns arrays of the size of a picture to the system when they are freed. The system
    clears the memory of the next one, which takes several times as long as many a computation on
    it.
    """
    trim_threshold, mmap_threshold = -1, -3  # M_TRIM_THRESHOLD, M_MMAP_THRESHOLD of malloc.h
    try:
        mallopt = ctypes.CDLL(None).mallopt
    except AttributeError:
        return  # another C library
    mallopt(mmap_threshold, 32 << 20)
    mallopt(trim_threshold, 256 << 20)


def main() -> None:
    keep_freed_memory()
    if "SMILE_BRAIN_ADDRESS" not in os.environ:
        sys.exit("a brain is started by the simulator: smile run SCENE --brain PROGRAM.py")
    # Modules are imported from the brain's folder, not from the working directory.
    os.environ.pop("PYTHONSAFEPATH", None)
    sys.path[:] = [path for path in sys.path if path not in ("", os.getcwd())]
    sys.path.insert(0, os.environ["SMILE_BRAIN_FOLDER"])
    try:
        address = os.fsencode(os.environ["SMILE_BRAIN_ADDRESS"])
        connection = Connection(address)  # type: ignore[arg-type]  # any bytes are a path
        serve(connection, Program(), Guard())
    except ProtocolError as error:
        sys.exit(str(error))


if __name__ == "__main__":
    main()
