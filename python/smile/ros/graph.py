"""This process as a node of a ROS graph."""

from __future__ import annotations

import http.client
import os
import threading
import time
import xmlrpc.client
from collections.abc import Callable
from typing import Any

import rosgraph
import rospy

_CHECK_SECONDS = 0.5
_ANSWER_SECONDS = 1.0
_MASTER_TIMEOUT = 3.0


def join_graph(name: str, *, anonymous: bool) -> None:
    """Makes this process a node.

    anonymous  the name gets a suffix, so that several nodes of it may be on the graph

    Raises RuntimeError if no master answers, or ROS_MASTER_URI is not set.
    """
    address = os.environ.get("ROS_MASTER_URI")
    if not address:
        raise RuntimeError("ROS_MASTER_URI is not set, expected the address of a ROS master, as http://ROBOT:11311")
    try:
        is_online = rosgraph.is_master_online()
    except ValueError as error:
        raise RuntimeError(f"ROS_MASTER_URI is {address!r}: {error}") from None
    if not is_online:
        raise RuntimeError(f"no ROS master answers at {address}")
    # Ctrl-C is handled here: the robot is to be stopped first.
    rospy.init_node(name, anonymous=anonymous, disable_signals=True)


class _ImpatientTransport(xmlrpc.client.Transport):
    """Waits some seconds for an answer, not for ever."""

    def make_connection(self, host: Any) -> http.client.HTTPConnection:
        connection = super().make_connection(host)
        connection.timeout = _ANSWER_SECONDS
        return connection


def _master_answers() -> bool:
    try:
        with xmlrpc.client.ServerProxy(os.environ["ROS_MASTER_URI"], _ImpatientTransport()) as master:
            answer: Any = master.getPid(rospy.get_name())
            return bool(answer[0] == 1)
    except (OSError, http.client.HTTPException, xmlrpc.client.Error):
        return False


def master_is_lost() -> Callable[[], bool]:
    """Watches the master in a thread; the function returned says whether it has not answered for some seconds, though it was
    asked again and again.

    Nodes that know each other would go on without: neither could be found any more, nor stopped by others.
    """
    # Not the time of the last answer: where the whole machine stood still for a while, nothing was asked.
    silent_since: float | None = None

    def watch() -> None:
        nonlocal silent_since
        while True:
            time.sleep(_CHECK_SECONDS)
            if _master_answers():
                silent_since = None
            elif silent_since is None:
                silent_since = time.monotonic()

    threading.Thread(target=watch, daemon=True).start()

    def is_lost() -> bool:
        since = silent_since
        return since is not None and time.monotonic() - since > _MASTER_TIMEOUT

    return is_lost
