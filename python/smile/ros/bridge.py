"""A connection to a rosbridge server: topics of ROS 1 or 2 as JSON over a WebSocket.

Source of the protocol: RobotWebTools/rosbridge_suite, ROSBRIDGE_PROTOCOL.md (version 2). What its server makes of
values is taken from rosbridge_library/internal/message_conversion.py: NaN and infinity become null, and times have the
fields secs and nsecs in ROS 1, sec and nanosec in ROS 2. Message types are named `package/Name`, which both accept.
"""

from __future__ import annotations

import asyncio
import json
import threading
from collections import deque
from collections.abc import Callable
from typing import Any
from urllib.parse import urlsplit

import websockets
import websockets.exceptions

_OPEN_SECONDS = 10.0
_MOST_BYTES = 16 << 20
"""of a message: a picture of 1920 x 1200 pixels has 9 MB in base64"""
_MOST_WAITING = 64
"""messages that may wait until the server takes them: older commands must not arrive late"""
_MOST_STATUSES = 5

Handler = Callable[[dict[str, Any]], None]


class Bridge:
    """Publishes and receives messages. Handlers are called in a thread of the connection.

    The first fault ends the connection; it is kept in `fault`, and nothing is sent after it.

    address     ws://HOST:PORT, or wss://
    on_fault    called without arguments in the thread, after `fault` was set

    Raises RuntimeError if no rosbridge server answers.
    """

    def __init__(self, address: str, on_fault: Callable[[], None]) -> None:
        parts = urlsplit(address)
        if parts.scheme not in ("ws", "wss") or not parts.hostname:
            raise ValueError(f"the bridge is {address!r}, expected ws://HOST:PORT, as ws://ROBOT:9090")
        self.address = address
        self.fault: str | None = None
        """why the connection ended; None while it stands"""
        self.statuses: deque[str] = deque(maxlen=_MOST_STATUSES)
        """the newest warnings of the server"""
        self._on_fault = on_fault
        self._handlers: dict[str, Handler] = {}
        self._loop = asyncio.new_event_loop()
        self._outgoing: asyncio.Queue[str] = asyncio.Queue()
        self._is_open = threading.Event()
        threading.Thread(target=self._run, daemon=True).start()
        self._is_open.wait()
        if self.fault is not None:
            raise RuntimeError(self.fault)

    def advertise(self, topic: str, kind: str, *, latch: bool = False) -> None:
        """Announces messages of a type, as `std_msgs/Bool`.

        latch  the last message is kept for nodes that listen later
        """
        self._send({"op": "advertise", "topic": topic, "type": kind, **({"latch": True} if latch else {})})

    def publish(self, topic: str, message: dict[str, Any], *, latch: bool = False) -> None:
        """Publishes a message on a topic that was announced, with the same `latch`."""
        self._send({"op": "publish", "topic": topic, "msg": message, **({"latch": True} if latch else {})})

    def subscribe(self, topic: str, kind: str | None, handler: Handler) -> None:
        """Asks for the messages of a topic. A type of None is that which the topic has.

        A message without a field that its handler reads, or with a wrong value in it, is a fault.
        """
        self._handlers[topic] = handler
        words = {"op": "subscribe", "topic": topic, "queue_length": 1}
        self._send(words if kind is None else {**words, "type": kind})

    def unsubscribe(self, topic: str) -> None:
        """Asks for no more messages of a topic."""
        self._send({"op": "unsubscribe", "topic": topic})
        self._handlers.pop(topic, None)

    def _send(self, words: dict[str, Any]) -> None:
        if self.fault is None:
            # Numbers that are not finite have no JSON, and no meaning as a command.
            self._loop.call_soon_threadsafe(self._enqueue, json.dumps(words, allow_nan=False))

    def _enqueue(self, text: str) -> None:
        if self._outgoing.qsize() >= _MOST_WAITING:
            self._fail(f"the bridge at {self.address} takes no messages")
        else:
            self._outgoing.put_nowait(text)

    # The thread.

    def _fail(self, reason: str) -> None:
        if self.fault is None:
            self.fault = reason
            self._on_fault()

    def _run(self) -> None:
        asyncio.set_event_loop(self._loop)
        try:
            self._loop.run_until_complete(self._converse())
        finally:
            self._is_open.set()

    async def _converse(self) -> None:
        try:
            # Compression costs time, and joint states are small.
            async with websockets.connect(self.address, open_timeout=_OPEN_SECONDS, max_size=_MOST_BYTES,
                                          compression=None, close_timeout=1) as socket:
                self._is_open.set()
                sending = asyncio.ensure_future(self._send_all(socket))
                try:
                    await self._receive_all(socket)
                finally:
                    sending.cancel()
        except websockets.exceptions.ConnectionClosed as error:
            self._fail(f"the bridge at {self.address} closed the connection: {error}"[:300])
        except (OSError, asyncio.TimeoutError, websockets.exceptions.WebSocketException) as error:
            self._fail(f"no rosbridge server answers at {self.address}: {error or 'too late'}"[:300])

    async def _send_all(self, socket: Any) -> None:
        while True:
            text = await self._outgoing.get()
            try:
                await socket.send(text)
            except websockets.exceptions.ConnectionClosed:
                return  # which _receive_all reports

    async def _receive_all(self, socket: Any) -> None:
        async for text in socket:
            reason = self._take(text)
            if reason is not None:
                self._fail(f"the bridge at {self.address} {reason}")
            if self.fault is not None:
                return
        self._fail(f"the bridge at {self.address} closed the connection")

    def _take(self, text: str | bytes) -> str | None:
        """Handles a message of the server; returns what is wrong with it."""
        if isinstance(text, bytes):
            return "sent binary data, expected JSON: start it without BSON and CBOR"
        try:
            words = json.loads(text)
        except (ValueError, RecursionError):
            return f"sent {text[:60]!r}, expected JSON"
        op = words.get("op") if isinstance(words, dict) else None
        if op == "publish":
            return self._take_message(words)
        if op == "status":
            return self._take_status(words)
        if op in ("fragment", "png"):
            return f"sent the operation {op!r}: expected whole messages, without fragments and compression"
        return f"sent the operation {str(op)[:40]!r}, expected publish or status"

    def _take_message(self, words: dict[str, Any]) -> str | None:
        topic, message = words.get("topic"), words.get("msg")
        handler = self._handlers.get(topic) if isinstance(topic, str) else None
        if handler is None:
            return None  # of a topic from which it was unsubscribed
        try:
            if not isinstance(message, dict):
                raise TypeError(f"is {str(message)[:40]!r}, expected an object")
            handler(message)
        except KeyError as error:
            return f"sent a message of {topic} without {error.args[0]}"
        except (TypeError, ValueError, OverflowError) as error:
            return f"sent a faulty message of {topic}: {error}"[:300]
        return None

    def _take_status(self, words: dict[str, Any]) -> str | None:
        text = str(words.get("msg"))[:200]
        if words.get("level") == "error":
            return f"reports an error: {text}"
        self.statuses.append(text)
        return None
