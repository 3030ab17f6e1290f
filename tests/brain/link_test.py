"""Tests smilelink against a simulator made of bytes: link_test.py OCTAVE COMMAND..., which runs
link_test.m."""

import os
import re
import socket
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from smile import messages
from smile.messages import HELLO, MOTOR, decode

CLIENT = Path(__file__).parents[2] / "matlab" / "client" / "smile_brain.m"

DOUBLE, BYTE, LOGICAL, TEXT = range(4)


def frame(sequence, *arrays):
    """A STEP of arrays given byte by byte: name, kind, flags, shape, elements."""
    body = struct.pack("<2I", len(arrays), 0)
    for name, kind, flags, shape, elements in arrays:
        head = struct.pack(f"<4B{len(shape)}I", len(name), kind, len(shape), flags, *shape) + name
        for part in (head, elements):
            body += part + bytes(-len(part) % 8)
    return struct.pack("<4I", 0x31424D53, 4, sequence, len(body)) + body


def step(sequence, first):
    return frame(sequence, (b"double", DOUBLE, 0, (2, 3), struct.pack("<6d", first, *range(2, 7))),
                 (b"picture", BYTE, 1, (1, 2, 3), bytes(range(6))), (b"bytes", BYTE, 0, (1, 2), b"\1\2"),
                 (b"truth", LOGICAL, 0, (1, 1), b"\1"), (b"text", TEXT, 0, (1, 2), b"xy"),
                 (b"none", DOUBLE, 0, (0, 3), b""))


def check_values(values):
    expected = {"double": [[1, 2], [3, 4]], "single": 1.5, "int": [[7], [8]], "sparse": [[0, 5]],
                "truth": True, "truths": [[1, 0]], "text": "abc", "cube": np.ones((2, 1, 2))}
    for name, value in expected.items():
        assert np.array_equal(values.pop(name), value), name
    assert values.pop("none").shape == (0, 0)
    assert values == {"empty": ""}, values


def check_message_types():
    """The client of scripts has their numbers, since it also speaks where nothing is compiled."""
    (table,) = re.findall(r"message = struct\('nothing', 0, (.*?)\);", CLIENT.read_text(), re.DOTALL)
    numbers = {name.upper(): int(number) for name, number in re.findall(r"'(\w+)', (\d+)", table)}
    names = "HELLO INIT INIT_DONE STEP MOTOR FINAL_MOTOR ERROR BYE".split()
    assert numbers == {name: getattr(messages, name) for name in names}, numbers


def main(*octave):
    check_message_types()
    with tempfile.TemporaryDirectory() as folder, socket.socket(socket.AF_UNIX) as door:
        door.settimeout(60)
        door.bind(f"{folder}/door")
        door.listen()
        program = subprocess.Popen(octave, env=os.environ | {"SMILE_BRAIN_ADDRESS": f"{folder}/door"})
        with door.accept()[0] as simulator:
            simulator.settimeout(60)
            kind, _, values = decode(simulator.recv(1 << 16))
            assert kind == HELLO
            check_values(values)
            simulator.sendall(step(5, 1) + step(6, 9))
            assert decode(simulator.recv(1 << 16)) == (MOTOR, 6, {"after": 1.0})
            simulator.sendall(frame(7, (b"rows", BYTE, 2, (2, 2), bytes(4))))
            simulator.sendall(struct.pack("<4I", 0x31424D53, 4, 8, 2**32 - 1))
            door.accept()[0].close()
        return program.wait(60)


sys.exit(main(*sys.argv[1:]))
