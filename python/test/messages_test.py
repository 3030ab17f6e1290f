"""Tests the door from Python to the messages: what goes in comes out, and nonsense is refused."""

import signal
import socket
import struct
import sys
import tempfile
import threading
import unittest

import numpy as np
from smile import messages
from smile.native import how_to_get


def step(values, sequence=1):
    return messages.encode(messages.STEP, sequence, values)


def frame_of(*arrays):
    """A STEP of arrays given byte by byte: name, kind, flags, shape, elements."""
    body = struct.pack("<2I", len(arrays), 0)
    for name, kind, flags, shape, elements in arrays:
        head = struct.pack(f"<4B{len(shape)}I", len(name), kind, len(shape), flags, *shape) + name
        for part in (head, elements):
            body += part + bytes(-len(part) % 8)
    return struct.pack("<4I", 0x31424D53, messages.STEP, 1, len(body)) + body


class ValuesTest(unittest.TestCase):
    def test_come_back_as_they_were_sent(self):
        matrix = np.arange(6.0).reshape(2, 3)
        kind, sequence, values = messages.decode(step(
            {"matrix": matrix, "turned": matrix.T, "row": [1, 2, 3], "cube": np.ones((2, 1, 2)),
             "none": np.zeros((0, 3)), "number": 2, "truth": True, "text": "grüße", "empty": ""}, 7))
        self.assertEqual((kind, sequence), (messages.STEP, 7))
        self.assertEqual(list(values)[:3], ["matrix", "turned", "row"])
        np.testing.assert_array_equal(values["matrix"], matrix)
        np.testing.assert_array_equal(values["turned"], matrix.T)
        self.assertTrue(values["turned"].flags.c_contiguous and values["turned"].flags.writeable)
        self.assertEqual(values["row"].tolist(), [[1, 2, 3]])
        self.assertEqual(values["cube"].shape, (2, 1, 2))
        self.assertEqual(values["none"].shape, (0, 3))
        self.assertEqual((values["number"], values["truth"]), (2.0, 1.0))
        self.assertEqual((values["text"], values["empty"]), ("grüße", ""))

    def test_have_the_types_of_their_kinds(self):
        _, _, values = messages.decode(frame_of(
            (b"picture", 1, 3, (1, 2, 3), bytes(range(6))), (b"columns", 1, 1, (2, 2), bytes(range(4))),
            (b"logicals", 2, 0, (1, 2), b"\0\7"), (b"logical", 2, 0, (1, 1), b"\1"),
            (b"byte", 1, 0, (1, 1), b"\5"), (b"text", 3, 0, (1, 2), b"\xff!")))
        self.assertEqual(values["picture"].tolist(), [[[0, 1, 2], [3, 4, 5]]])
        self.assertEqual(values["picture"].dtype, np.uint8)
        self.assertEqual(values["columns"].tolist(), [[0, 2], [1, 3]])
        self.assertEqual(values["logicals"].tolist(), [[False, True]])
        self.assertEqual(values["logicals"].dtype, bool)
        self.assertIs(values["logical"], True)
        self.assertEqual((values["byte"], values["text"]), (5, "\ufffd!"))

    def test_that_no_message_takes_are_refused(self):
        for wrong in ({"two words": 1}, {"a": np.zeros((3000, 3000))}, {"a": np.zeros((1,) * 9)},
                      {"a": "\ud800"}, {"a": "word", "b": [[1], [2, 3]]},
                      {f"a{k}": k for k in range(65)}):
            with self.assertRaises(ValueError):
                step(wrong)

    def test_of_damaged_messages_are_refused(self):
        whole = step({"matrix": np.ones((2, 7)), "text": "abc"})
        for size in range(len(whole)):
            with self.assertRaises(messages.ProtocolError):
                messages.decode(whole[:size])
        with self.assertRaisesRegex(messages.ProtocolError, "is too large"):
            messages.decode(frame_of((b"a", 0, 0, (2**32 - 1, 2**32 - 1), b"")))
        with self.assertRaisesRegex(messages.ProtocolError, "has 200 dimensions, expected 2 to 8"):
            messages.decode(frame_of((b"a", 0, 0, (1,) * 200, b"")))


class Rung(Exception):
    """An alarm has."""


class ConnectionTest(unittest.TestCase):
    def setUp(self):
        folder = self.enterContext(tempfile.TemporaryDirectory())
        door = self.enterContext(socket.socket(socket.AF_UNIX))
        door.bind(f"{folder}/door")
        door.listen()
        self.connection = messages.Connection(f"{folder}/door")
        self.simulator = self.enterContext(door.accept()[0])

    def test_carries_messages_and_reports_their_end(self):
        self.simulator.sendall(step({"a": 1}, 5) + step({"b": "x"}, 6))
        self.assertEqual(self.connection.receive(), (messages.STEP, 5, {"a": 1.0}))
        self.assertEqual(self.connection.receive(), (messages.STEP, 6, {"b": "x"}))
        self.connection.send(messages.MOTOR, 6, {"c": 2})
        self.assertEqual(messages.decode(self.simulator.recv(4096)), (messages.MOTOR, 6, {"c": 2.0}))
        self.simulator.close()
        self.assertEqual(self.connection.receive(), (messages.BYE, 0, {}))
        with self.assertRaisesRegex(BrokenPipeError, "the simulator has closed the connection"):
            self.connection.send(messages.MOTOR, 7, {})

    def test_leaves_a_picture_in_the_memory_it_was_received_into(self):
        pixels = bytes(k % 251 for k in range(480 * 640 * 3))
        frame = frame_of((b"picture", 1, 3, (480, 640, 3), pixels), (b"pose", 0, 0, (4, 4), bytes(128)))
        threading.Thread(target=self.simulator.sendall, args=(frame,)).start()
        _, _, values = self.connection.receive()
        self.assertEqual(values["picture"].tobytes(), pixels)
        self.assertIsInstance(values["picture"].base, bytearray)
        self.assertEqual(len(values["picture"].base), len(frame) - 16)
        self.assertLess(len(values["pose"].base), 1000, "to keep it would keep the picture")

    def test_lets_signals_through_while_it_waits(self):
        with self.assertRaises(Rung):
            self.receive_until_it_rings()
        self.simulator.sendall(step({}, 8))
        self.assertEqual(self.connection.receive()[1], 8)

    def test_continues_in_the_middle_of_a_picture(self):
        pixels = bytes(k % 251 for k in range(240 * 320 * 3))
        frame = frame_of((b"picture", 1, 3, (240, 320, 3), pixels))
        self.simulator.sendall(frame[:100_000])
        with self.assertRaises(Rung):
            self.receive_until_it_rings()
        threading.Thread(target=self.simulator.sendall, args=(frame[100_000:],)).start()
        self.assertEqual(self.connection.receive()[2]["picture"].tobytes(), pixels)

    def receive_until_it_rings(self):
        def ring(*_):
            raise Rung

        before = signal.signal(signal.SIGALRM, ring)
        try:
            signal.setitimer(signal.ITIMER_REAL, 0.05, 0.05)
            self.connection.receive()
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
            signal.signal(signal.SIGALRM, before)

    def test_lets_other_threads_run_while_it_waits(self):
        threading.Timer(0.05, self.simulator.sendall, args=(step({}, 9),)).start()
        self.assertEqual(self.connection.receive()[1], 9)

    def test_refuses_what_is_too_long_before_it_comes(self):
        self.simulator.sendall(struct.pack("<4I", 0x31424D53, messages.STEP, 1, 2**32 - 1))
        with self.assertRaisesRegex(messages.ProtocolError, "4294967295 bytes, expected at most"):
            self.connection.receive()

    def test_needs_somebody_at_the_other_end(self):
        with self.assertRaisesRegex(FileNotFoundError, "/nowhere/door"):
            messages.Connection(b"/nowhere/door")


class NativeTest(unittest.TestCase):
    def test_that_is_missing_is_explained(self):
        text = how_to_get("smile_brain_native", "no such thing")
        self.assertIn(f"{sys.executable} (Python ", text)
        self.assertIn("is built for another Python: set SMILE_PYTHON", text)
        self.assertIn(f"-DPython3_EXECUTABLE={sys.executable}", text)
        self.assertIn("must be on PYTHONPATH", how_to_get("smile_other_native", "no such thing"))


if __name__ == "__main__":
    unittest.main()
