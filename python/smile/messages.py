"""Messages between simulator and robot program, as docs/brain-protocol.md describes them."""

import itertools
import math
import operator
import socket
import struct
import sys

import numpy as np

MAGIC = 0x31424D53
HEADER = struct.Struct("<4I")
MAX_BODY_BYTES = 64 << 20
HELLO, INIT, INIT_DONE, STEP, MOTOR, FINAL_MOTOR, ERROR, BYE = range(1, 9)
DOUBLE, BYTE, LOGICAL, TEXT = range(4)
NUMPY_TYPES = {DOUBLE: "<f8", BYTE: "u1", LOGICAL: "?", TEXT: "u1"}
STRUCT_TYPES = {DOUBLE: "d", BYTE: "B", LOGICAL: "?"}
ROW_MAJOR = 2  # of the flags
INBOX_BYTES = 64 << 10  # all but pictures come in one piece
MANY_ELEMENTS = 1000  # from here on an array is not copied together with others


class Connection:
    def __init__(self, address):
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.connect(address)
        self.inbox = memoryview(bytearray(INBOX_BYTES))
        self.layouts = {}  # by the size of the body
        self.frames = {}  # by names and shapes

    def receive(self):
        """Type, sequence and arrays of the next message; a goodbye when the simulator has gone."""
        count = self.read_into(self.inbox, HEADER.size)
        if count is None:
            return BYE, 0, {}
        magic, kind, sequence, size = HEADER.unpack_from(self.inbox)
        begun = count - HEADER.size
        if magic != MAGIC or size > MAX_BODY_BYTES or begun > size:
            sys.exit("what arrived is not a message")
        body = np.empty(size, "u1")  # each message its own: the program's arrays may lie in it
        whole = memoryview(body)
        whole[:begun] = self.inbox[HEADER.size:count]
        if begun < size and self.read_into(whole[begun:], size - begun) is None:
            return BYE, 0, {}
        return kind, sequence, self.decode(body)

    def read_into(self, room, least):
        """How many bytes have come, at least so many; None when the simulator has gone."""
        filled = 0
        while filled < least:
            count = self.socket.recv_into(room[filled:])
            if count == 0:
                return None
            filled += count
        return filled

    def decode(self, body):
        # One step is told like the other: only the first of its kind is read head by head.
        layout = self.layouts.get(len(body))
        values = layout.read(body) if layout else None
        if values is None:
            forget_if_many(self.layouts)
            layout = self.layouts[len(body)] = Layout(body)
            values = layout.read(body)
        return values

    def send(self, kind, sequence, values):
        shapes = tuple([(name, getattr(value, "shape", None)) for name, value in values.items()])
        frame = self.frames.get(shapes)
        if frame is None:
            frame = Frame(values)
            if frame.views:
                forget_if_many(self.frames)
                self.frames[shapes] = frame
        self.socket.sendall(frame.filled(kind, sequence, values))


def forget_if_many(known):
    if len(known) >= 32:
        known.clear()


class Layout:
    """Where the arrays lie in a body, for all bodies with the same names, types and shapes."""

    def __init__(self, body):
        self.names = {}  # to None; in the order of the message
        self.single = []  # name, place among the items of `format`
        self.texts = []  # the same
        self.matrices = []  # name, slice of what `order` picks, shape
        self.others = []  # name, shape, type, place in the body, order
        heads, formats, order, end = [], [], [], 0
        items = itertools.count()
        for name, kind, flags, dims, at in arrays_of(body):
            self.names[name] = None
            size = math.prod(dims)
            heads.append(next(items))
            formats.append(f"{at - end}s")
            end = at + size * np.dtype(NUMPY_TYPES[kind]).itemsize
            index_order = "C" if flags & ROW_MAJOR else "F"
            if kind == TEXT:
                self.texts.append((name, next(items)))
                formats.append(f"{size}s")
            elif size == 1 and len(dims) == 2:
                self.single.append((name, next(items)))
                formats.append(STRUCT_TYPES[kind])
            else:
                formats.append(f"{end - at}x")
                if kind == DOUBLE and size < MANY_ELEMENTS:
                    self.matrices.append((name, slice(len(order), len(order) + size), dims))
                    places = np.arange(at // 8, at // 8 + size)
                    order.extend(places.reshape(dims, order=index_order).ravel())
                else:
                    self.others.append((name, dims, NUMPY_TYPES[kind], at, index_order))
        self.format = struct.Struct("<" + "".join(formats))
        self.order = np.array(order, int)
        # Two places at least, or what it gives is no tuple.
        self.heads_of = operator.itemgetter(0, *heads)
        self.heads = self.heads_of(self.format.unpack_from(body)) if heads else ()

    def read(self, body):
        """Text as str, 1x1 as a plain number, all else as an array in numpy's own order. None when
        the body is laid out in another way."""
        items = self.format.unpack_from(body)
        if self.names and self.heads_of(items) != self.heads:
            return None
        values = self.names.copy()
        for name, place in self.single:
            values[name] = items[place]
        for name, place in self.texts:
            values[name] = items[place].decode(errors="replace")
        numbers = body.view("<f8")[self.order]
        for name, places, shape in self.matrices:
            values[name] = numbers[places].reshape(shape)
        for name, shape, kind, at, order in self.others:
            array = np.ndarray(shape, kind, body, at, order=order)
            values[name] = np.ascontiguousarray(array)
        return values


def arrays_of(body):
    """Name, type, flags, dimensions and place of the elements of each array."""
    body = bytes(body)
    (count,) = struct.unpack_from("<I", body)
    at = 8
    for _ in range(count):
        letters, kind, num_dims, flags = struct.unpack_from("4B", body, at)
        dims = struct.unpack_from(f"<{num_dims}I", body, at + 4)
        at += 4 + 4 * num_dims
        name = body[at:at + letters].decode()
        at = padded(at + letters)
        yield name, kind, flags, dims, at
        at = padded(at + math.prod(dims) * np.dtype(NUMPY_TYPES[kind]).itemsize)


class Frame:
    """A message; one that has nothing but matrices can be filled with others of the same shapes."""

    def __init__(self, values):
        body = encode(values)
        self.bytes = bytearray(HEADER.size) + body
        self.views = {}
        if all(isinstance(value, np.ndarray) and value.ndim == 2 for value in values.values()):
            for name, _, _, dims, at in arrays_of(body):
                self.views[name] = np.ndarray(dims, "<f8", self.bytes, HEADER.size + at, order="F")

    def filled(self, kind, sequence, values):
        HEADER.pack_into(self.bytes, 0, MAGIC, kind, sequence, len(self.bytes) - HEADER.size)
        for name, view in self.views.items():
            view[...] = values[name]
        return self.bytes


def padded(size):
    return (size + 7) & ~7


def encode(values):
    parts = [struct.pack("<II", len(values), 0)]
    for name, value in values.items():
        if isinstance(value, str):
            kind, array = TEXT, np.frombuffer(value.encode(), "u1").reshape(1, -1)
        else:
            kind, array = DOUBLE, np.atleast_2d(np.asarray(value, "<f8"))
        head = struct.pack(f"<4B{array.ndim}I", len(name), kind, array.ndim, 0, *array.shape)
        for part in (head + name.encode(), array.tobytes(order="F")):
            parts.append(part + bytes(padded(len(part)) - len(part)))
    return b"".join(parts)
