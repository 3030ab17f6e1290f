"""A ROS graph on this machine for tests: a master of its own, and programs on it.

Ends the test as skipped (77) where tools/get_ros.sh installed nothing.
"""

import os
import signal
import socket
import subprocess
import sys
import time
from pathlib import Path

try:
    import actionlib  # noqa: F401
    import rosgraph
    import rosmaster  # noqa: F401
    import rospy  # noqa: F401
except ImportError as error:
    print(f"skipped: {error}; tools/get_ros.sh installs ROS")
    sys.exit(77)

# A loaded machine is slow, and no test waits for it to be fast [s].
PATIENCE = 300
MASTER = "import rosmaster, sys; rosmaster.rosmaster_main(['rosmaster', '--core', '-p', sys.argv[1]])"


class Program:
    """A child process; its output is a file."""

    def __init__(self, folder, name, words):
        self.log = Path(folder) / f"{name}.log"
        with open(self.log, "wb") as log:
            self._process = subprocess.Popen([str(word) for word in words], stdout=log, stderr=subprocess.STDOUT,
                                             stdin=subprocess.DEVNULL)

    @property
    def output(self):
        return self.log.read_text(errors="replace")

    def wait_for_output(self, words):
        deadline = time.monotonic() + PATIENCE
        while words not in self.output:
            if self._process.poll() is not None or time.monotonic() > deadline:
                raise AssertionError(f"{words!r} was not printed: {self.output}")
            time.sleep(0.05)

    def wait(self):
        """Returns the exit code."""
        return self._process.wait(PATIENCE)

    def interrupt(self):
        self._process.send_signal(signal.SIGINT)

    def end(self):
        if self._process.poll() is None:
            self._process.kill()
        self._process.wait()


class Graph:
    """A master at a free port; this process and its children use it."""

    def __init__(self, folder):
        with socket.socket() as probe:
            probe.bind(("127.0.0.1", 0))
            port = probe.getsockname()[1]
        self.address = f"http://127.0.0.1:{port}"
        os.environ.update(ROS_MASTER_URI=self.address, ROS_IP="127.0.0.1", ROS_HOME=str(Path(folder) / "ros_home"))
        self.master = Program(folder, "master", [sys.executable, "-c", MASTER, port])
        deadline = time.monotonic() + PATIENCE
        while not rosgraph.is_master_online():
            if time.monotonic() > deadline:
                raise AssertionError(f"the master does not answer: {self.master.output}")
            time.sleep(0.05)


def wait_until(condition, words):
    """Waits until a condition holds."""
    deadline = time.monotonic() + PATIENCE
    while not condition():
        if time.monotonic() > deadline:
            raise AssertionError(f"{words} did not happen within {PATIENCE} s")
        time.sleep(0.01)
