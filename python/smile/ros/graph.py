"""This process as a node of a ROS graph."""

from __future__ import annotations

import os
import threading
import time
from collections.abc import Callable

import rosgraph
import rospy

_CHECK_SECONDS = 0.5
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


def master_is_lost() -> Callable[[], bool]:
    """Watches the master in a thread; the function returned says whether it no longer answers.

    Nodes that know each other would go on without: neither could be found any more, nor stopped by others.
    """
    last_answer = time.monotonic()

    def watch() -> None:
        nonlocal last_answer
        while True:
            time.sleep(_CHECK_SECONDS)
            if rosgraph.is_master_online():
                last_answer = time.monotonic()

    threading.Thread(target=watch, daemon=True).start()
    return lambda: time.monotonic() - last_answer > _MASTER_TIMEOUT
