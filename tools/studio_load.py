#!/usr/bin/env python3
"""Measures what many people cost a studio, or many studios at once: of build/release, or of $SMILE_PROGRAM.

tools/studio_load.py crowd [OBJECTS [WATCHERS [SECONDS]]]
    One studio with so many blocks (100), which so many clients watch (20), while one more drags a block to and fro 60
    times a second: the studio's share of one core, messages and bytes that each watcher got, and how long a drag takes
    until poses acknowledge it.
tools/studio_load.py sessions [NUMBER [SECONDS]]
    So many studios (10) at once, as in a study, with the table of UM; in each, a hand carries a block in circles, and
    the recorder records: how fast time passes in each, and its share of one core.
"""

import json
import math
import os
import pathlib
import re
import selectors
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import time

PROJECT = pathlib.Path(__file__).resolve().parent.parent
PROGRAM = os.environ.get("SMILE_PROGRAM", PROJECT / "build/release/bin/smile")


class Client:
    """A WebSocket that counts what it is sent."""

    def __init__(self, port):
        self.socket = socket.create_connection(("127.0.0.1", port))
        self.socket.sendall(
            b"GET /ws HTTP/1.1\r\nHost: localhost\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
            b"Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n")
        self.bytes = b""
        while b"\r\n\r\n" not in self.bytes:
            self.bytes += self.socket.recv(4096)
        self.bytes = self.bytes.split(b"\r\n\r\n", 1)[1]
        self.num_messages = self.num_bytes = self.seq = self.ack = 0
        self.asked = {}
        self.tick = 0
        self.delays = []
        self.ask({"do": "hello", "version": 1})

    def ask(self, request):
        self.seq += 1
        text = json.dumps({"seq": self.seq, **request}).encode()
        size = struct.pack(">B", 0x80 | len(text)) if len(text) < 126 else struct.pack(">BH", 0x80 | 126, len(text))
        # A mask of zeros changes nothing.
        self.socket.sendall(b"\x81" + size + bytes(4) + text)
        self.asked[self.seq] = time.monotonic()

    def read(self):
        self.bytes += self.socket.recv(1 << 16)
        while len(self.bytes) >= 2:
            size, begin = self.bytes[1], 2
            if size >= 126:
                begin = 4 if size == 126 else 10
                size = int.from_bytes(self.bytes[2:begin], "big")
            if len(self.bytes) < begin + size:
                return
            self.take(self.bytes[0] & 15, self.bytes[begin:begin + size])
            self.bytes = self.bytes[begin + size:]

    def take(self, opcode, payload):
        self.num_messages += 1
        self.num_bytes += len(payload)
        if opcode == 1 and b'"t":"state"' in payload[:20]:
            self.tick = json.loads(payload)["tick"]
        if opcode != 2 or payload[0] != 1:
            return
        for seq in range(self.ack + 1, struct.unpack_from("<I", payload, 12)[0] + 1):
            self.delays.append(time.monotonic() - self.asked[seq])
            self.ack = seq


def scene_of(num_blocks):
    blocks = [f'<block id="b{k}" location="({k % 15 - 7}, {k // 15 - 8}, 0.25)" xspan=".5" yspan=".5" zspan=".5"/>'
              for k in range(num_blocks)]
    return ('<tabletop xmlns="http://synapse.cs.umd.edu/tabletop-xml" xspan="20" yspan="20">'
            + "".join(blocks) + "</tabletop>")


def cpu_seconds(process):
    fields = pathlib.Path(f"/proc/{process.pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def measure(port, process, num_watchers, seconds):
    watchers = [Client(port) for _ in range(num_watchers)]
    hand = Client(port)
    hand.ask({"do": "take_control"})
    hand.ask({"do": "command", "command": {"hand": "right", "do": "grasp", "object": "b0"}})
    selector = selectors.DefaultSelector()
    for client in [*watchers, hand]:
        selector.register(client.socket, selectors.EVENT_READ, client)
    # What comes first, the scene and pictures, is not counted.
    start, begun, step = time.monotonic() + 2, False, 0
    while time.monotonic() < start + seconds:
        now = time.monotonic()
        if not begun and now >= start:
            begun, cpu = True, cpu_seconds(process)
            hand.delays.clear()
            for client in watchers:
                client.num_messages = client.num_bytes = 0
        if now >= start - 2 + step / 60:
            step += 1
            place = [-7 + 2 * abs(step % 120 / 60 - 1), -9, 3]
            hand.ask({"do": "command", "command": {"hand": "right", "do": "move_to", "position": place}})
        for key, _ in selector.select(timeout=0.002):
            key.data.read()
    return watchers, sorted(hand.delays), cpu_seconds(process) - cpu


class Studio:
    """A studio with a scene, which writes recordings into a folder."""

    def __init__(self, scene, folder):
        self.process = subprocess.Popen(
            [PROGRAM, "studio", scene, "--no-open", "--recordings", folder], stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL, text=True)
        self.port = int(re.search(r":(\d+)/", self.process.stdout.readline())[1])

    def close(self):
        self.process.send_signal(signal.SIGINT)
        self.process.wait()


def measure_crowd(num_objects=100, num_watchers=20, seconds=10):
    with tempfile.TemporaryDirectory() as folder:
        scene = pathlib.Path(folder) / "crowd.xml"
        scene.write_text(scene_of(num_objects))
        studio = Studio(scene, folder)
        try:
            watchers, delays, cpu = measure(studio.port, studio.process, num_watchers, seconds)
        finally:
            studio.close()
    messages = sum(client.num_messages for client in watchers) / num_watchers
    num_bytes = sum(client.num_bytes for client in watchers) / num_watchers
    print(f"{num_objects} objects, {num_watchers} watchers, {seconds} s:")
    print(f"  {100 * cpu / seconds:.0f} % of one core")
    print(f"  {messages / seconds:.0f} messages a second to each, {num_bytes / max(messages, 1):.0f} bytes each")
    print(f"  drag to pose: {1000 * delays[len(delays) // 2]:.0f} ms, {1000 * delays[len(delays) * 95 // 100]:.0f} ms p95")


def measure_sessions(number=10, seconds=30):
    with tempfile.TemporaryDirectory() as folder:
        studios = []
        try:
            for k in range(number):
                studios.append(Studio(PROJECT / "scenes/um.xml", pathlib.Path(folder) / str(k)))
            hands = [Client(it.port) for it in studios]
            for hand in hands:
                hand.ask({"do": "take_control"})
                hand.ask({"do": "command", "command": {"do": "start"}})
                hand.ask({"do": "command", "command": {"hand": "right", "do": "grasp", "object": "Red1"}})
            # Until the first pictures are drawn and the block is held.
            carry(hands, 3)
            ticks, cpu, begin = [it.tick for it in hands], [cpu_seconds(it.process) for it in studios], time.monotonic()
            carry(hands, seconds)
            passed = time.monotonic() - begin
            speeds = [(it.tick - tick) / 60 / passed for it, tick in zip(hands, ticks)]
            shares = [(cpu_seconds(it.process) - before) / passed for it, before in zip(studios, cpu)]
        finally:
            for studio in studios:
                studio.close()
    print(f"{number} sessions, {seconds} s:")
    print(f"  {min(speeds):.3f} to {max(speeds):.3f} of real time")
    print(f"  {100 * min(shares):.0f} to {100 * max(shares):.0f} % of one core each")


def carry(hands, seconds):
    selector = selectors.DefaultSelector()
    for hand in hands:
        selector.register(hand.socket, selectors.EVENT_READ, hand)
    begin, step = time.monotonic(), 0
    while time.monotonic() < begin + seconds:
        if time.monotonic() >= begin + step / 20:
            step += 1
            x, y = 2 * math.cos(step / 20), math.sin(step / 20)
            for hand in hands:
                hand.ask({"do": "command", "command": {"hand": "right", "do": "move_to", "position": [x, y, 2.5]}})
        for key, _ in selector.select(timeout=0.002):
            key.data.read()


def main():
    what = {"crowd": measure_crowd, "sessions": measure_sessions}.get(sys.argv[1] if len(sys.argv) > 1 else "")
    numbers = sys.argv[2:]
    if not what or len(numbers) > (3 if what is measure_crowd else 2) or not all(re.fullmatch("[1-9][0-9]*", it) for it in numbers):
        sys.exit(__doc__)
    what(*map(int, numbers))


main()
