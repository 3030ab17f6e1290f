"""A rosbridge server for tests, after ROSBRIDGE_PROTOCOL.md of RobotWebTools/rosbridge_suite (version 2).

Neither Debian nor PyPI has rosbridge's own. Two things may be behind ours: a ROS 1 graph (`GraphTopics`), or values that
a test sends.
"""

import asyncio
import base64
import importlib
import json
import math
import threading

import websockets
import websockets.exceptions

TIMES = ("time", "duration")


def json_of(value, kind, version=1):
    """A ROS 1 value as rosbridge sends it; in ROS 2, the fields of a time have other names."""
    if kind in TIMES:
        names = ("secs", "nsecs") if version == 1 else ("sec", "nanosec")
        return dict(zip(names, (value.secs, value.nsecs)))
    if kind == "uint8[]":
        return base64.b64encode(value).decode()
    if kind.endswith("]"):
        return [json_of(one, kind.partition("[")[0], version) for one in value]
    if isinstance(value, float) and not math.isfinite(value):
        return None
    if hasattr(value, "__slots__"):
        return {name: json_of(getattr(value, name), inner, version) for name, inner in zip(value.__slots__, value._slot_types)}
    return value


def class_of(kind):
    """The class of a message type, as package/Name or package/msg/Name."""
    from smile.ros import message_types
    package, *_, name = kind.split("/")
    if package in ("baxter_core_msgs", "control_msgs"):
        return getattr(message_types, name)
    return getattr(importlib.import_module(f"{package}.msg"), name)


class GraphTopics:
    """Topics of the ROS 1 graph on which this process is a node."""

    def __init__(self, version=1):
        self._version, self._publishers = version, {}

    def advertise(self, topic, kind, latch):
        import rospy
        self._publishers[topic] = rospy.Publisher(topic, class_of(kind), queue_size=10, tcp_nodelay=True, latch=latch)
        return self._publishers[topic].unregister

    def publish(self, topic, values):
        from smile.ros.message_types import fill
        self._publishers[topic].publish(fill(self._publishers[topic].data_class(), values))

    def subscribe(self, topic, kind, send):
        import rospy

        def receive(message):
            values = json_of(message, message._type, self._version)
            if self._version == 2:
                # Headers of ROS 2 have no number.
                values.get("header", {}).pop("seq", None)
                if topic.endswith("camera_info"):
                    values = {name.lower(): value for name, value in values.items()}
                if topic == "/rosout":
                    del values["header"]
                    values["level"] = {1: 10, 2: 20, 4: 30, 8: 40, 16: 50}[values["level"]]
            send(values)

        subscriber = rospy.Subscriber(topic, class_of(kind or "rosgraph_msgs/Log"), receive, queue_size=10, tcp_nodelay=True)
        return subscriber.unregister


class RosbridgeServer:
    """Serves topics at a free port of 127.0.0.1, in a thread."""

    def __init__(self, topics):
        self._topics, self._sockets = topics, set()
        self._subscriptions, self._advertised = {}, {}
        """by topic: functions that end them"""
        self._loop = asyncio.new_event_loop()
        ready = threading.Event()
        threading.Thread(target=self._run, args=(ready,), daemon=True).start()
        ready.wait()
        self.address = f"ws://127.0.0.1:{self._port}"

    def _run(self, ready):
        async def serve():
            self._server = await websockets.serve(self._converse, "127.0.0.1", 0, compression=None, max_size=1 << 20)
            self._port = self._server.sockets[0].getsockname()[1]
            ready.set()
            await self._server.wait_closed()
        asyncio.set_event_loop(self._loop)
        self._loop.run_until_complete(serve())

    def close(self):
        """Ends like a program that is killed: each connection is closed."""
        self._loop.call_soon_threadsafe(self._server.close)

    def send_text(self, text):
        """Sends a text, or binary data, to each client."""
        for socket in list(self._sockets):
            asyncio.run_coroutine_threadsafe(socket.send(text), self._loop)

    async def _converse(self, socket, path=None):
        self._sockets.add(socket)
        try:
            async for text in socket:
                words = json.loads(text)
                try:
                    self._take(socket, words)
                except Exception as error:
                    await socket.send(json.dumps({"op": "status", "level": "error", "msg": f"{words['op']}: {error}"}))
        except websockets.exceptions.ConnectionClosed:
            pass  # by a client that found a fault
        finally:
            self._sockets.discard(socket)
            for end in self._subscriptions.values():
                end()
            self._subscriptions.clear()
            for end in self._advertised.values():
                end()
            self._advertised.clear()

    def _take(self, socket, words):
        topic, op = words["topic"], words["op"]
        if op == "advertise":
            self._advertised[topic] = self._topics.advertise(topic, words["type"], words.get("latch", False))
        elif op == "publish":
            self._topics.publish(topic, words["msg"])
        elif op == "subscribe":
            def send(values):
                text = json.dumps({"op": "publish", "topic": topic, "msg": values}, allow_nan=False)
                asyncio.run_coroutine_threadsafe(socket.send(text), self._loop)
            self._subscriptions[topic] = self._topics.subscribe(topic, words.get("type"), send)
        elif op == "unsubscribe":
            self._subscriptions.pop(topic)()
        else:
            raise ValueError(f"operation {op!r} is unknown")
