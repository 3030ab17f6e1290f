"""A learner uses only information that a robot could have, nothing that only the simulator knows; and
joints and colors may be measured inexactly.

    inputs_only_test.py SMILE SOURCE BRAIN COMMAND...

SMILE is the program, SOURCE the folder of the project, BRAIN the learner, COMMAND runs its client.

The learner rebuilds a tower with noise in the joint sensors and pictures, while all messages between it and the
simulator are recorded. Then this script alone repeats them to a new learner: the simulator has ended,
scene and recordings are deleted, of the demonstration only pictures and symbols remain, and in each
step everything is false except the pictures, their depth, the measured joints, and the time. The answers must be
the same, byte by byte.
"""

import contextlib
import json
import math
import os
import shutil
import socket
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

from smile.messages import BYE, INIT, STEP, decode, encode

HEADER = struct.Struct("<4I")  # magic, type, sequence, length of the body
DOUBLE, BYTE, LOGICAL, TEXT = range(4)  # kinds of elements
TRUE = {"timeElapsed", "simTime", "armJoints", "armGrippers", "rgbVision", "depthVision"}


def main(smile, source, brain, *command):
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        subprocess.run([smile, "run", f"{source}/scenes/tower.xml", "--commands",
                        f"{source}/examples/tower.jsonl", "--record", "shown"], check=True)
        listener = Path("listener")
        listener.write_text("#!/bin/sh\nexec " + " ".join(
            f"'{word}'" for word in (sys.executable, __file__, "--listen", folder, brain, *command)))
        listener.chmod(0o755)
        subprocess.run([smile, "imitate", "shown", f"{source}/scenes/tower_robot.xml", "--seed", "3",
                        "--brain", "./listener", "--out", "built", "--no-pictures", "--timeout",
                        "60", "--noise", "joints=0.01,image=0.03"], check=True)
        result = json.loads(Path("built/result.json").read_text())
        assert result["success"], "the tower was not rebuilt"
        assert result["mean_error_mm"] < 5
        subprocess.run([smile, "replay", "built/imitation", "--verify"], check=True)

        Path("demonstration").mkdir()
        for file in [Path("shown/demo.json"), *Path("shown").glob("[0-9]*")]:
            file.rename(Path("demonstration") / file.name)
        shutil.rmtree("shown")
        shutil.rmtree("built")
        count, difference = repeat(folder, brain, command, TRUE)
        assert difference is None, difference
        assert count > 100, f"only {count} answers"
        _, difference = repeat(folder, brain, command, TRUE - {"rgbVision", "depthVision"})
        assert difference, "the answers do not depend on the pictures"


def listen(folder, brain, *command):
    """Stands between simulator and brain, and records their messages."""
    simulator = socket.socket(socket.AF_UNIX)
    simulator.connect(os.environ["SMILE_BRAIN_ADDRESS"])
    folder = Path(folder)
    with started(brain, command) as program, open(folder / "messages", "wb") as messages:
        question = b""
        while kind_of(question) != BYE:
            answer = receive(program)
            messages.write(struct.pack("<2Q", len(question), len(answer)) + question + answer)
            simulator.sendall(answer)
            question = receive(simulator)
            if kind_of(question) == INIT:
                shutil.copytree(Path(values_of(question)["robot"]).parent, folder / "robot")
            program.sendall(question)


def repeat(folder, brain, command, true):
    """Repeats the recorded messages to the brain. Returns the number of answers that were the same as
    before, and a description of the first difference, or None."""
    count = 0
    with started(brain, command) as program, open(Path(folder) / "messages", "rb") as messages:
        while sizes := messages.read(16):
            question, expected = map(messages.read, struct.unpack("<2Q", sizes))
            program.sendall(altered(question, folder, true))
            answer = receive(program)
            if answer != expected:
                return count, (f"answer {count} is {values_of(answer)}, "
                               f"expected {values_of(expected)}")
            count += 1
    return count, None


def altered(question, folder, true):
    """Returns a message in which only some arrays still have their true values."""
    if kind_of(question) == INIT:
        kind, sequence, values = decode(question)
        robot = Path(folder) / "robot" / Path(values["robot"]).name
        return encode(kind, sequence,
                      values | {"robot": str(robot), "demonstration": f"{folder}/demonstration"})
    if kind_of(question) != STEP:
        return question
    frame = bytearray(question)
    for name, kind, at, end in arrays_of(question):
        if name in true:
            continue
        if kind == LOGICAL:
            frame[at:end] = bytes(not it for it in frame[at:end])
        elif kind == TEXT:
            frame[at:end] = bytes(it if it == ord("\n") else ord("x") for it in frame[at:end])
        else:
            frame[at:end] = bytes(end - at)
    return bytes(frame)


def arrays_of(message):
    """Yields name and kind of each array of a message, and the begin and end of its elements."""
    (count,) = struct.unpack_from("<I", message, HEADER.size)
    at = HEADER.size + 8
    for _ in range(count):
        letters, kind, num_dims = struct.unpack_from("3B", message, at)
        dims = struct.unpack_from(f"<{num_dims}I", message, at + 4)
        at += 4 + 4 * num_dims
        name = message[at:at + letters].decode()
        at = padded(at + letters)
        end = at + math.prod(dims) * (8 if kind == DOUBLE else 1)
        yield name, kind, at, end
        at = padded(end)


def padded(size):
    return (size + 7) // 8 * 8


@contextlib.contextmanager
def started(brain, command):
    """Starts a brain with this script as its simulator. Yields the connection to it."""
    with tempfile.TemporaryDirectory() as scratch, socket.socket(socket.AF_UNIX) as door:
        door.bind(f"{scratch}/door")
        door.listen()
        door.settimeout(60)
        folder = brain if Path(brain).is_dir() else str(Path(brain).parent)
        process = subprocess.Popen(command, cwd=scratch, stdin=subprocess.DEVNULL, env=os.environ | {
            "SMILE_BRAIN_TRANSPORT": "socket", "SMILE_BRAIN_ADDRESS": f"{scratch}/door",
            "SMILE_BRAIN_SCRATCH": scratch, "SMILE_BRAIN_FOLDER": folder,
            "SMILE_BRAIN_PROGRAM": brain})
        try:
            connection, _ = door.accept()
            with connection:
                connection.settimeout(60)
                yield connection
        finally:
            process.kill()
            process.wait()


def receive(connection):
    """Receives a whole message, as bytes."""
    head = receive_bytes(connection, HEADER.size)
    return head + receive_bytes(connection, HEADER.unpack(head)[3])


def receive_bytes(connection, size):
    parts = []
    while size > 0:
        part = connection.recv(size)
        if not part:
            raise ConnectionError("the other side closed the connection")
        parts.append(part)
        size -= len(part)
    return b"".join(parts)


def kind_of(message):
    return HEADER.unpack_from(message)[1] if message else None


def values_of(message):
    return decode(message)[2]


if sys.argv[1] == "--listen":
    listen(*sys.argv[2:])
else:
    main(*sys.argv[1:])
