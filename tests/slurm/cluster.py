"""A cluster of Slurm on this machine alone, for tests: its own daemons, as any user, in a folder."""

import getpass
import os
import shutil
import socket
import subprocess
import time
from pathlib import Path

NEEDED = ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "scancel", "sinfo", "scontrol")
# Debian's daemons are not on a user's path.
PATH = os.environ.get("PATH", "") + ":/usr/sbin:/sbin"
CONFIGURATION = """\
ClusterName=smile
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={controller_port}
SlurmdPort={node_port}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=1,sched_min_interval=0,bf_interval=1
ReturnToService=2
KillWait=2
SlurmdParameters=config_overrides
NodeName=node NodeHostname={host} NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=node Default=YES MaxTime=INFINITE State=UP
"""


def missing():
    """Returns the programs that are not installed."""
    return [name for name in NEEDED if shutil.which(name, path=PATH) is None]


def wait_until(is_so, what, seconds=120):
    """Waits until `is_so()`; raises TimeoutError with `what` otherwise."""
    end = time.monotonic() + seconds
    while not is_so():
        if time.monotonic() > end:
            raise TimeoutError(f"{what} after {seconds} s")
        time.sleep(0.05)


def _free_port():
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


class Cluster:
    """One node of two cores, in a with statement."""

    def __init__(self, folder):
        self.folder = Path(folder)
        self.environment = {**os.environ, "PATH": PATH, "SLURM_CONF": str(self.folder / "slurm.conf")}
        self._daemons = {}

    def __enter__(self):
        for name in ("state", "spool"):
            (self.folder / name).mkdir()
        # The socket of munge must be reachable, its key must not.
        self.folder.chmod(0o755)
        key = self.folder / "munge.key"
        key.touch(mode=0o600)
        key.write_bytes(os.urandom(128))
        (self.folder / "slurm.conf").write_text(CONFIGURATION.format(
            folder=self.folder, host=socket.gethostname().split(".")[0], user=getpass.getuser(),
            controller_port=_free_port(), node_port=_free_port()))
        try:
            self._start("munged", "--foreground", "--force", f"--key-file={key}",
                        f"--socket={self.folder}/munge.socket", f"--pid-file={self.folder}/munge.pid",
                        f"--seed-file={self.folder}/munge.seed", f"--log-file={self.folder}/munge.log")
            wait_until((self.folder / "munge.socket").exists, "munge has no socket", 30)
            self.start("slurmctld")
            self.start("slurmd")
            wait_until(lambda: self.run("sinfo", "--noheader", "--format=%T").stdout.strip() == "idle",
                       "the node is not idle", 60)
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        if "slurmctld" in self._daemons:
            self.run("scancel", "--user", getpass.getuser())
        for daemon in reversed(self._daemons.values()):
            daemon.terminate()
        for daemon in self._daemons.values():
            try:
                daemon.wait(20)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()

    def start(self, name):
        """Starts `slurmctld` or `slurmd`."""
        node = ("-N", "node") if name == "slurmd" else ()
        self._start(name, "-D", *node)

    def kill(self, name):
        """Kills a daemon without a warning."""
        self._daemons[name].kill()
        self._daemons[name].wait()

    def run(self, *words, **options):
        return subprocess.run(words, env=self.environment, capture_output=True, text=True, **options)

    def states(self, job):
        """Returns the states of the tasks of a job that are waiting or running, by their numbers."""
        lines = self.run("squeue", "--noheader", "--array", f"--jobs={job}", "--format=%K %T").stdout.splitlines()
        return dict(line.split() for line in lines)

    def _start(self, name, *options):
        with (self.folder / f"{name}.out").open("a") as log:
            self._daemons[name] = subprocess.Popen([shutil.which(name, path=PATH), *options], stdout=log,
                                                   stderr=log, env=self.environment)
