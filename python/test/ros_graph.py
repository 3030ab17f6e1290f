"""A ROS graph on this machine for tests: a master of its own, and programs on it.

Ends the test as skipped (77) where tools/get_ros.sh installed nothing.
"""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

try:
    import actionlib  # noqa: F401
    import rosgraph  # noqa: F401
    import rosmaster  # noqa: F401
    import rospy  # noqa: F401
except ImportError as error:
    print(f"skipped: {error}; tools/get_ros.sh installs ROS")
    sys.exit(77)

# A loaded machine is slow, and no test waits for it to be fast [s].
PATIENCE = 300
# At a port of its own choice, which it prints: one that was free before may be taken by now.
MASTER = """
import time
from rosmaster.master import Master
master = Master(port=0)
master.start()
print(master.uri, flush=True)
while master.ok():
    time.sleep(0.1)
"""


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

    def freeze(self):
        self._process.send_signal(signal.SIGSTOP)

    def thaw(self):
        self._process.send_signal(signal.SIGCONT)

    def interrupt(self):
        self._process.send_signal(signal.SIGINT)

    def end(self):
        if self._process.poll() is None:
            self._process.kill()
        self._process.wait()


class Graph:
    """A master; this process and its children use it."""

    def __init__(self, folder):
        os.environ.update(ROS_IP="127.0.0.1", ROS_HOME=str(Path(folder) / "ros_home"))
        self.master = Program(folder, "master", [sys.executable, "-c", MASTER])
        self.master.wait_for_output("\n")
        self.address = os.environ["ROS_MASTER_URI"] = self.master.output.splitlines()[0]


def wait_until(condition, words):
    """Waits until a condition holds."""
    deadline = time.monotonic() + PATIENCE
    while not condition():
        if time.monotonic() > deadline:
            raise AssertionError(f"{words} did not happen within {PATIENCE} s")
        time.sleep(0.01)
