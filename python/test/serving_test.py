"""Tests brains that are served over sockets: with them a run has the bits of a brain in a process.

Usage: serving_test.py SMILE_PROGRAM PROJECT_FOLDER
"""

import contextlib
import io
import json
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import unittest
from pathlib import Path

import smile

PROGRAM, PROJECT = sys.argv[1], Path(sys.argv[2])
TOWER = PROJECT / "scenes/tower.xml"

# What it does depends on what it senses, and on how often it was asked.
BRAIN = """
import numpy as np

class Brain:
    def init(self, aux):
        self.count = 0
        aux.imageSeconds = 0.1
    def step(self, sensor, motor, aux):
        self.count += 1
        if "rgbVision" in sensor:
            self.brightness = float(sensor.rgbVision.mean())
        for arm, sensed in zip(motor.arms, sensor.arms):
            arm.velocities = 0.3 * np.sin(self.brightness + self.count / 30 + sensed.joints)
        aux.exit = sensor.simTime >= 1

brain = Brain()
init, step = brain.init, brain.step
"""


def result_of(brain, *options):
    """Hash and brain of a run; the program's words if it failed."""
    done = subprocess.run([PROGRAM, "run", TOWER, "--brain", brain, "--json", *options], text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    if done.returncode not in (0, 1) or not done.stdout:
        return done.stderr
    result = json.loads(done.stdout)
    return result["hash"], result["brain"]["status"], result["brain"]["message"]


def brain_class():
    namespace = {}
    exec(BRAIN, namespace)
    return namespace["Brain"]


@contextlib.contextmanager
def serving(brain, address="tcp://127.0.0.1:0", **how):
    """A server with its thread, and what it prints."""
    printed = io.StringIO()
    with smile.BrainServer(brain, address) as server, contextlib.redirect_stderr(printed):
        thread = threading.Thread(target=server.serve, kwargs=how)
        thread.start()
        try:
            yield server, printed
        finally:
            server.close()
            thread.join(30)
            assert not thread.is_alive()


class ServingTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        (cls.folder / "process").mkdir()
        (cls.folder / "process/brain.py").write_text(BRAIN)
        cls.expected = result_of(cls.folder / "process/brain.py")
        assert cls.expected[1:] == ("exited", ""), cls.expected

    def test_the_bits_are_those_of_a_process(self):
        for address in ("tcp://127.0.0.1:0", f"unix:{self.folder / 'socket'}"):
            with serving(brain_class()(), address) as (server, _):
                self.assertEqual(result_of(server.address), self.expected)
                self.assertEqual(result_of(server.address), self.expected)  # init begins again
        self.assertFalse((self.folder / "socket").exists())

    def test_a_class_serves_runs_at_the_same_time(self):
        with serving(brain_class()) as (server, _):
            results = []
            threads = [threading.Thread(target=lambda: results.append(result_of(server.address))) for _ in range(2)]
            for thread in threads:
                thread.start()
            for thread in threads:
                thread.join()
        self.assertEqual(results, [self.expected] * 2)

    def test_another_program_serves_until_it_is_interrupted(self):
        program = self.folder / "server.py"
        program.write_text(BRAIN + "\nimport smile\nwith smile.BrainServer(Brain, 'tcp://127.0.0.1:0') as server:\n"
                           "    print(server.address, flush=True)\n    server.serve()\n")
        with subprocess.Popen([sys.executable, program], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as server:
            address = server.stdout.readline().strip()
            self.assertEqual(result_of(address), self.expected)
            server.send_signal(signal.SIGINT)
            _, printed = server.communicate(timeout=30)
        self.assertIn("KeyboardInterrupt", printed)
        self.assertIn("cannot connect to the brain: Connection refused", result_of(address)[2])

    def test_an_exception_ends_its_run_but_not_the_server(self):
        class Moody(brain_class()):
            runs = 0

            def init(self, aux):
                super().init(aux)
                Moody.runs += 1

            def step(self, sensor, motor, aux):
                if Moody.runs == 1 and self.count == 3:
                    raise ZeroDivisionError("on purpose")
                super().step(sensor, motor, aux)

        with serving(Moody()) as (server, printed):
            _, status, message = result_of(server.address)
            self.assertEqual(status, "failed")
            self.assertRegex(message, r"serving_test\.py:\d+: ZeroDivisionError: on purpose")
            self.assertEqual(result_of(server.address), self.expected)
        self.assertIn("ZeroDivisionError: on purpose", printed.getvalue())

    def test_a_lost_connection_has_a_cause(self):
        with socket.create_server(("127.0.0.1", 0)) as listener:
            address = f"tcp://127.0.0.1:{listener.getsockname()[1]}"
            thread = threading.Thread(target=lambda: listener.accept()[0].close())
            thread.start()
            _, status, message = result_of(address)
            thread.join()
        self.assertEqual((status, message),
                         ("failed", f"{address}: the connection to the brain was lost during the start: end of file"))

    def test_a_silent_server_is_left(self):
        with socket.create_server(("127.0.0.1", 0)) as listener:
            address = f"tcp://127.0.0.1:{listener.getsockname()[1]}"
            _, status, message = result_of(address, "--timeout", "0.05")
        self.assertEqual((status, message), ("failed", f"{address}: the start took longer than 0.6 s and was disconnected"))

    def test_evaluations_name_it(self):
        demo = self.folder / "demo"
        with smile.Simulation(smile.load(TOWER, robot=None)) as sim:
            sim.record(demo, pictures=False)
            hand = sim.hand("left")
            hand.grasp("RedBlock")
            hand.move_to([0.3, 0.2, 0.2])
            sim.run_until("arrived")
            hand.release()
            sim.run_until("still")
            sim.finish()
        with serving(brain_class()) as (server, _):
            evaluation = smile.evaluate(demo, TOWER, server.address, self.folder / "evaluation", scenes=2, jobs=2)
        (brain,) = evaluation.result["brains"]
        self.assertEqual(brain["brain"], server.address)
        self.assertEqual(brain["name"], server.address.removeprefix("tcp://").replace(".", "_").replace(":", "_"))
        self.assertEqual([run["success"] for run in brain["runs"]], [False, False])

    def test_wrong_arguments_are_named(self):
        for address in ("", "localhost", "tcp://", "tcp://127.0.0.1", "tcp://127.0.0.1:x", "tcp://127.0.0.1:70000", "unix:"):
            with self.assertRaisesRegex(ValueError, "expected tcp://HOST:PORT or unix:PATH"):
                smile.BrainServer(print, address)
        with self.assertRaisesRegex(TypeError, "brain is int, expected"):
            smile.BrainServer(3, "tcp://127.0.0.1:0")
        with self.assertRaisesRegex(TypeError, "brain is the class list, expected one with a method"):
            smile.BrainServer(list, "tcp://127.0.0.1:0")
        with smile.BrainServer(print, "tcp://127.0.0.1:0") as server:
            with self.assertRaisesRegex(OSError, server.address):
                smile.BrainServer(print, server.address)
            with self.assertRaisesRegex(ValueError, "runs is -1"):
                server.serve(-1)
        self.assertIn("expected tcp://HOST:PORT with a port", result_of("tcp://localhost:0"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
