"""Runs a robot program in Python for the SMILE simulator until the simulator says goodbye.

The simulator starts `python3 -m smile.brain` and tells it in the environment

    SMILE_BRAIN_TRANSPORT  `socket`
    SMILE_BRAIN_ADDRESS    the Unix socket to connect to
    SMILE_BRAIN_PROGRAM    the robot program, a .py file
    SMILE_BRAIN_FOLDER     the folder it lies in

The program is a module with a function `step(sensor, motor, aux)` and, if it likes, `init(aux)`.
docs/brains.md tells what these are, docs/brain-protocol.md describes the messages. Needs numpy only.
"""

import importlib.util
import itertools
import math
import operator
import os
import platform
import signal
import socket
import struct
import sys
import traceback

try:
    import numpy as np
except ImportError:
    sys.exit(f"{sys.executable} has no numpy; install it, or name another Python in SMILE_PYTHON")

MAGIC = 0x31424D53
HEADER = struct.Struct("<4I")
MAX_BODY_BYTES = 64 << 20
HELLO, INIT, INIT_DONE, STEP, MOTOR, FINAL_MOTOR, ERROR, BYE = range(1, 9)
DOUBLE, BYTE, LOGICAL, TEXT = range(4)
NO_MARKERS = np.zeros((0, 3))
NUMPY_TYPES = {DOUBLE: "<f8", BYTE: "u1", LOGICAL: "?", TEXT: "u1"}
STRUCT_TYPES = {DOUBLE: "d", BYTE: "B", LOGICAL: "?"}
ROW_MAJOR = 2  # of the flags
INBOX_BYTES = 64 << 10  # all but pictures come in one piece
MANY_ELEMENTS = 1000  # from here on an array is not copied together with others


class TookTooLong(BaseException):
    """Raised in a program that is late. No Exception: `except Exception` shall not swallow it."""


# ---- what a program sees ---------------------------------------------------------------------------


class Fields:
    """What the simulator tells, each array as an attribute: `sensor.jointAngles`.

    A field that comes only sometimes is asked for with `"rgbVision" in sensor`.
    """

    def __init__(self, values):
        self.__dict__ = values

    def __contains__(self, name):
        return name in self.__dict__

    def __getattr__(self, name):  # only asked when there is none
        raise AttributeError(f"there is no {name}, only {', '.join(self.__dict__) or 'nothing'}")

    def __repr__(self):
        return "\n".join(f"{name}: {brief(value)}" for name, value in self.__dict__.items())


class Motor:
    """What the robot shall do. Keeps its fields until they are changed; others cannot be made.

    jointVelocities    limbs x joints [rad/s]
    gripperVelocities  a number for each limb [units/s]
    jointAngles        None, or limbs x joints: be there at once [rad]
    headVelocity       None, or a number [rad/s]
    """

    def __init__(self, num_limbs, num_joints):
        arms = (num_limbs, num_joints)
        self.__dict__["shapes"] = {
            "jointVelocities": arms,
            "gripperVelocities": (num_limbs,),
            "jointAngles": arms,
            "headVelocity": (),
        }
        self.jointVelocities = np.zeros(arms)
        self.gripperVelocities = np.zeros(num_limbs)
        self.jointAngles = None
        self.headVelocity = None

    def __setattr__(self, name, value):
        if name not in self.shapes:
            raise AttributeError(f"motor.{name} is unknown, expected {', '.join(self.shapes)}")
        if value is None and name in ("jointVelocities", "gripperVelocities"):
            raise ValueError(f"motor.{name} is None, expected numbers")
        self.__dict__[name] = None if value is None else self.numbers(name, value)

    def __delattr__(self, name):
        setattr(self, name, None)

    def numbers(self, name, value):
        expected = self.shapes[name]
        array = real_numbers(f"motor.{name}", value)
        if name == "gripperVelocities" and array.size == expected[0]:
            array = array.reshape(expected)  # a row, a column: all the same
        if name == "headVelocity" and array.size == 1:
            array = array.reshape(())
        if array.shape != expected:
            raise ValueError(f"motor.{name} is {shape_text(array.shape)}, "
                             f"expected {shape_text(expected)}")
        return array

    def values(self):
        """As the message has them; checked once more, since elements can be set as well."""
        values = {}
        for name, shape in self.shapes.items():
            array = self.__dict__[name]
            if array is None:
                continue
            if array.shape != shape:
                array = self.numbers(name, array)
            if not math.isfinite(sum(array.ravel().tolist())):  # the fast way for few numbers
                check_finite(f"motor.{name}", array)
            values[name] = array.reshape(-1, 1) if array.ndim < 2 else array
        return values


def real_numbers(name, value):
    array = np.asarray(value)
    if array.dtype.kind not in "fiub":
        raise TypeError(f"{name} is {type(value).__name__} of {array.dtype}, expected real numbers")
    return array.astype(float)


def check_finite(name, array):
    wrong = np.argwhere(~np.isfinite(array))
    if len(wrong):
        place = f"[{', '.join(map(str, wrong[0]))}]" if array.ndim else ""
        raise ValueError(f"{name}{place} is {array[tuple(wrong[0])]}, expected a finite number")


def shape_text(shape):
    return "x".join(map(str, shape)) or "one number"


def brief(value):
    if isinstance(value, np.ndarray) and value.size > 20:
        return f"{shape_text(value.shape)} {value.dtype}"
    return repr(value)


# ---- messages --------------------------------------------------------------------------------------


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


# ---- from messages to what a program sees ----------------------------------------------------------


def sensor_of(values):
    names = values.pop("trackerNames", None)
    if names is not None:
        values["trackerLoc"] = dict(zip(lines_of(names), values.pop("trackerPositions")))
    if "heldObject" in values:
        values["heldObject"] = values["heldObject"].split("\n")
    if "segmentNames" in values:
        values["segmentNames"] = lines_of(values["segmentNames"])
    if "cameraPose" in values:
        take_cameras(values)
    return Fields(values)


def take_cameras(values):
    cameras = {}
    for name in [name for name in values if name.startswith("cameras_")]:
        camera, _, field = name.removeprefix("cameras_").rpartition("_")
        cameras.setdefault(camera, {})[field] = values.pop(name)
    if cameras:
        values["cameras"] = Fields({name: Fields(fields) for name, fields in cameras.items()})


def lines_of(text):
    return text.split("\n") if text else []


def aux_of(values):
    lines = [line.split(",") for line in lines_of(values.get("attention", ""))]
    values["attention"] = {words[0]: words[1:] for words in lines}
    values["cameraNames"] = lines_of(values.get("cameraNames", ""))
    for name in ("numLimbs", "numJoints"):
        values[name] = int(values[name])
    return Fields(values)


def wishes_of(aux):
    """What init left in aux for the simulator."""
    values = {}
    for name in ("initJointAngles", "drawMarkers", "imageSeconds"):
        if name in aux:
            values[name] = wish_of(aux, name)
    for name in ("channels", "cameras"):
        if name in aux:
            values[name] = in_one_line(f"aux.{name}", getattr(aux, name))
    return values


def wish_of(aux, name):
    array = real_numbers(f"aux.{name}", getattr(aux, name))
    check_finite(f"aux.{name}", array)
    return array


def in_one_line(name, words):
    words = [words] if isinstance(words, str) else words
    if not isinstance(words, (list, tuple)) or not all(isinstance(word, str) for word in words):
        raise TypeError(f"{name} is {words!r:.80}, expected a list of names")
    return ",".join(words)


# ---- running the program ---------------------------------------------------------------------------


class Guard:
    """Turns SIGUSR2 into TookTooLong, while the program runs and not in the middle of a message."""

    def __init__(self):
        self.is_watching = False
        signal.signal(signal.SIGUSR2, self.on_signal)

    def on_signal(self, *_):
        if self.is_watching:
            self.is_watching = False
            raise TookTooLong("this took too long and was stopped")

    def __enter__(self):
        self.is_watching = True

    def __exit__(self, *_):
        self.is_watching = False


class Program:
    """The robot program, and what it has been told and has answered so far."""

    def __init__(self):
        self.file = os.environ["SMILE_BRAIN_PROGRAM"]
        self.folder = os.path.join(os.environ["SMILE_BRAIN_FOLDER"], "")

    def start(self, values):
        """INIT -> INIT_DONE"""
        # The name of the file, so that its classes can be pickled and its helpers import it.
        name = os.path.splitext(os.path.basename(self.file))[0]
        spec = importlib.util.spec_from_file_location(name, self.file)
        self.module = importlib.util.module_from_spec(spec)
        sys.modules[name] = self.module
        spec.loader.exec_module(self.module)
        if not callable(getattr(self.module, "step", None)):
            raise NameError("there is no function step(sensor, motor, aux)")
        self.aux = aux_of(values)
        self.motor = Motor(self.aux.numLimbs, self.aux.numJoints)
        if hasattr(self.module, "init"):
            self.module.init(self.aux)
        wishes = wishes_of(self.aux)
        self.markers = np.array(wishes.get("drawMarkers", NO_MARKERS))
        return INIT_DONE, wishes

    def step(self, values):
        """STEP -> MOTOR or FINAL_MOTOR"""
        self.module.step(sensor_of(values), self.motor, self.aux)
        is_last = "exit" in self.aux and bool(np.any(self.aux.exit))
        return FINAL_MOTOR if is_last else MOTOR, self.motor.values() | self.new_markers()

    def new_markers(self):
        """aux.drawMarkers, when they are others than those sent last."""
        if "drawMarkers" not in self.aux and not len(self.markers):
            return {}  # most programs have none, and array_equal is slow
        markers = wish_of(self.aux, "drawMarkers") if "drawMarkers" in self.aux else NO_MARKERS
        if np.array_equal(markers, self.markers):
            return {}
        self.markers = np.array(markers)
        return {"drawMarkers": self.markers}

    def describe(self, error):
        """An exception as the arrays of ERROR: what, and where in the program's own folder."""
        file, line = self.place_of(error)
        message = f"{type(error).__name__}: {error}" if str(error) else type(error).__name__
        if isinstance(error, SyntaxError):
            message = f"{type(error).__name__}: {error.msg}"
        if isinstance(error, SystemExit):
            message = f"the program called exit({error.code})"
        return {"message": message, "file": file, "line": line}

    def place_of(self, error):
        if isinstance(error, SyntaxError) and error.filename and error.lineno:
            return os.path.abspath(error.filename), error.lineno
        for frame in reversed(traceback.extract_tb(error.__traceback__)):
            file = os.path.abspath(frame.filename)
            if file.startswith(self.folder):
                return file, frame.lineno
        return self.file, 0

    def show(self, error):
        """Prints the traceback, from the program's own first line on."""
        trace = error.__traceback__
        while trace and not trace.tb_frame.f_code.co_filename.startswith(self.folder):
            trace = trace.tb_next
        traceback.print_exception(type(error), error, trace)


def serve(connection, program, guard):
    connection.send(HELLO, 0, {
        "version": 1, "guard": 1, "rows": 1, "client": "python", "language": platform.python_version()})
    while True:
        kind, sequence, values = connection.receive()
        if kind == BYE:
            return
        try:
            with guard:
                kind, values = program.start(values) if kind == INIT else program.step(values)
        except BaseException as error:  # whatever it is, the simulator is told
            program.show(error)
            kind, values = ERROR, program.describe(error)
        connection.send(kind, sequence, values)


def main():
    if "SMILE_BRAIN_ADDRESS" not in os.environ:
        sys.exit("a robot program is started by the simulator: smile run SCENE --brain PROGRAM.py")
    # Modules come from the program's folder, not from the one it happens to be started in.
    os.environ.pop("PYTHONSAFEPATH", None)
    sys.path[:] = [path for path in sys.path if path not in ("", os.getcwd())]
    sys.path.insert(0, os.environ["SMILE_BRAIN_FOLDER"])
    serve(Connection(os.environ["SMILE_BRAIN_ADDRESS"]), Program(), Guard())


if __name__ == "__main__":
    main()
