"""A page with the state of a performance and a button that stops it, on 127.0.0.1."""

from __future__ import annotations

import json
import math
import threading
import time
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

from smile.ros.performing import Supervisor

_PAGE = Path(__file__).parent / "stop_page.html"
_POLICY = "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; connect-src 'self'; frame-ancestors 'none'"
_READ_SECONDS = 5.0
_VIEWED_SECONDS = 1.0
"""a page that asked within this time is open"""
_FAREWELL_SECONDS = 1.0
"""time for open pages to see the end"""


class StopPage(Supervisor):
    """Serves the page until close(), to this machine only.

    A program that reaches the port may stop the robot, and do nothing else.

    title  of the performance
    port   0: any that is free

    Raises OSError if the port is taken.
    """

    def __init__(self, title: str, port: int = 0) -> None:
        self._pressed = threading.Event()
        self._lock = threading.Lock()
        self._state: dict[str, Any] = {"title": title, "phase": "Waiting", "seconds": 0.0, "duration": 0.0, "error": None, "end": None}
        self._asked = -math.inf
        self._end_was_seen = threading.Event()
        self._server = _Server(("127.0.0.1", port), _Request)
        self._server.page = self
        self.link = f"http://127.0.0.1:{self._server.server_port}/"
        threading.Thread(target=self._server.serve_forever, kwargs={"poll_interval": 0.05}, daemon=True).start()

    def must_stop(self) -> str | None:
        return "the button of the page was pressed" if self._pressed.is_set() else None

    def show(self, phase: str, seconds: float, duration: float, error: float) -> None:
        with self._lock:
            self._state.update(phase=phase, seconds=seconds, duration=duration, error=error if math.isfinite(error) else None)

    def close(self, end: str) -> None:
        """Shows how the performance ended to pages that are open, and ends."""
        with self._lock:
            self._state.update(end=end)
            is_viewed = time.monotonic() - self._asked < _VIEWED_SECONDS
        if is_viewed:
            self._end_was_seen.wait(_FAREWELL_SECONDS)
        self._server.shutdown()
        self._server.server_close()

    def press(self) -> None:
        """Presses the button."""
        self._pressed.set()

    def state(self) -> dict[str, Any]:
        """Returns what the page shows."""
        with self._lock:
            self._asked = time.monotonic()
            return dict(self._state)

    def note_seen(self, state: dict[str, Any]) -> None:
        """Notes that a page has received a state."""
        if state["end"] is not None:
            self._end_was_seen.set()


class _Server(ThreadingHTTPServer):
    daemon_threads = True
    page: StopPage


class _Request(BaseHTTPRequestHandler):
    timeout = _READ_SECONDS
    server: _Server

    def do_GET(self) -> None:
        if not self._is_ours():
            return
        if self.path == "/":
            self._answer(_PAGE.read_bytes(), "text/html; charset=utf-8")
        elif self.path == "/state":
            state = self.server.page.state()
            self._answer(json.dumps(state).encode(), "application/json")
            self.server.page.note_seen(state)
        else:
            self.send_error(HTTPStatus.NOT_FOUND)

    def do_POST(self) -> None:
        if not self._is_ours():
            return
        if self.path == "/stop":
            self.server.page.press()
            self._answer(b"{}", "application/json")
        else:
            self.send_error(HTTPStatus.NOT_FOUND)

    def _is_ours(self) -> bool:
        """Refuses other names of this machine, by which pages from elsewhere could read ours."""
        if self.headers.get("Host") == f"127.0.0.1:{self.server.server_port}":
            return True
        self.send_error(HTTPStatus.FORBIDDEN)
        return False

    def _answer(self, content: bytes, kind: str) -> None:
        self.send_response(HTTPStatus.OK)
        for name, value in (("Content-Type", kind), ("Content-Length", str(len(content))), ("Cache-Control", "no-store"),
                            ("Content-Security-Policy", _POLICY), ("X-Content-Type-Options", "nosniff")):
            self.send_header(name, value)
        self.end_headers()
        self.wfile.write(content)

    def log_message(self, format: str, *args: Any) -> None:
        """Prints nothing: the program's output is that of the performance."""
