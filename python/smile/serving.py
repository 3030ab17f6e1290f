"""Serves brains over a socket to simulators, also of other machines."""

from __future__ import annotations

import contextlib
import os
import platform
import socket
import sys
import threading
import traceback
from types import TracebackType
from typing import Any

from smile.brain_values import Values
from smile.exchange import Brain, Exchange, Step, exchange_of
from smile.messages import BYE, ERROR, Connection, ProtocolError

# Connections that may wait for their turn.
_BACKLOG = 128


def _report_of(failure: BaseException) -> Values:
    """Returns an exception as the arrays of ERROR, with the place that raised it."""
    message = f"{type(failure).__name__}: {failure}" if str(failure) else type(failure).__name__
    frames = traceback.extract_tb(failure.__traceback__)
    return {"message": message, "file": frames[-1].filename if frames else "",
            "line": (frames[-1].lineno or 0) if frames else 0}


def _listen(address: str) -> tuple[socket.socket, str]:
    """Returns a listening socket and its address, with the port that it was given."""
    if address.startswith("unix:") and len(address) > len("unix:"):
        listener = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        try:
            # Only this user may connect.
            before = os.umask(0o177)
            try:
                listener.bind(address.removeprefix("unix:"))
            finally:
                os.umask(before)
            listener.listen(_BACKLOG)
        except OSError as error:
            listener.close()
            raise OSError(error.errno, error.strerror, address) from None
        return listener, address
    host, colon, port = address.removeprefix("tcp://").rpartition(":")
    if not address.startswith("tcp://") or not host or not port.isdecimal() or int(port) > 65535:
        raise ValueError(f"address is {address!r}, expected tcp://HOST:PORT or unix:PATH")
    family = socket.AF_INET6 if host.startswith("[") else socket.AF_INET
    try:
        listener = socket.create_server((host.strip("[]"), int(port)), family=family, backlog=_BACKLOG)
    except OSError as error:
        raise OSError(error.errno, error.strerror, address) from None
    return listener, f"tcp://{host}:{listener.getsockname()[1]}"


class BrainServer:
    """Serves a brain to simulators that connect: `smile imitate … --brain ADDRESS`.

    brain    a function `step(sensor, motor, aux)`, or an object with this method and optionally
             `init(aux)` (docs/brains.md): runs are served one after the other, others wait. Or a
             class of such objects: each run gets one of its own, and a thread.
    address  `tcp://HOST:PORT`, where port 0 is any that is free, or `unix:PATH`

    It listens from the beginning, and only there. Simulators are not asked who they are: serve on
    127.0.0.1, or in a network that you trust.
    """

    def __init__(self, brain: Step | Brain | type[Brain], address: str) -> None:
        self._brain = brain
        if not isinstance(brain, type):
            exchange_of(brain)  # raises if it is not a brain
        elif not callable(getattr(brain, "step", None)):
            raise TypeError(f"brain is the class {brain.__name__}, expected one with a method "
                            "step(sensor, motor, aux)")
        self._listener, self.address = _listen(address)
        self._is_closed = False

    def __enter__(self) -> BrainServer:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None,
                 trace: TracebackType | None) -> None:
        self.close()

    def serve(self, runs: int | None = None) -> None:
        """Serves runs, by default until close() or Ctrl-C.

        runs  number of connections after which to return

        An exception of the brain ends its run, with a message in the simulator, and is printed here.
        """
        if runs is not None and (isinstance(runs, bool) or not isinstance(runs, int) or runs < 0):
            raise ValueError(f"runs is {runs!r}, expected a whole number of at least 0")
        threads: list[threading.Thread] = []
        served = 0
        while runs is None or served < runs:
            try:
                accepted, _ = self._listener.accept()
            except OSError:
                if self._is_closed:
                    break
                raise
            served += 1
            threads = [thread for thread in threads if thread.is_alive()]
            if isinstance(self._brain, type):
                threads.append(threading.Thread(target=self._serve, args=(accepted,), daemon=True))
                threads[-1].start()
            else:
                self._serve(accepted)
        for thread in threads:
            thread.join()

    def close(self) -> None:
        """Stops listening. Runs that have begun go on."""
        if self._is_closed:
            return
        self._is_closed = True
        # Wakes a thread that waits in accept(), which close() alone does not.
        with contextlib.suppress(OSError):
            self._listener.shutdown(socket.SHUT_RDWR)
        self._listener.close()
        if self.address.startswith("unix:"):
            with contextlib.suppress(OSError):
                os.unlink(self.address.removeprefix("unix:"))

    def _serve(self, accepted: socket.socket) -> None:
        if accepted.family != socket.AF_UNIX:
            # Questions and answers alternate: none may wait to be sent with the next.
            accepted.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        connection = Connection.of_socket(accepted.detach())
        try:
            self._converse(connection)
        except (BrokenPipeError, ProtocolError) as error:
            print(f"smile: a run ended: {error}", file=sys.stderr, flush=True)

    def _converse(self, connection: Any) -> None:
        connection.greet(client="python", language=platform.python_version(), guard=False)
        exchange: Exchange | None = None
        while True:
            kind, sequence, values = connection.receive()
            if kind == BYE:
                return
            try:
                if exchange is None:
                    exchange = exchange_of(self._brain() if isinstance(self._brain, type) else self._brain)
                kind, values = exchange.answer(kind, values)
            except Exception as failure:
                traceback.print_exception(failure)
                kind, values = ERROR, _report_of(failure)
            try:
                connection.send(kind, sequence, values)
            except ValueError as error:  # too large for a message, or invalid text
                connection.send(ERROR, sequence, _report_of(error))


def serve_brain(brain: Step | Brain | type[Brain], address: str, runs: int | None = None) -> None:
    """Serves a brain at an address, see BrainServer; by default until Ctrl-C."""
    with BrainServer(brain, address) as server:
        server.serve(runs)
