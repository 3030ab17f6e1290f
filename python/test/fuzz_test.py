"""Calls the simulator in Python at random, rightly and wrongly: it answers or raises, and never crashes.

Usage: fuzz_test.py PROJECT_FOLDER [--seed N] [--calls N] [--say]

The same seed makes the same calls. --say prints each call before it is made, so that the last line of a
crash names its cause. tools/fuzz.sh python runs this under the address sanitizer.
"""

import argparse
import faulthandler
import gc
import math
import pickle
import random
import sys
import tempfile
import threading
from pathlib import Path

import numpy as np

import smile
from smile import motion
from smile.picture import Picture

# What calls may raise. Anything else is a finding: SystemError, MemoryError, AssertionError, …
ALLOWED = (ValueError, TypeError, KeyError, IndexError, AttributeError, TimeoutError, RuntimeError, OSError,
           OverflowError, ZeroDivisionError,  # the last by a function that is passed
           ImportError)  # of pandas, where it is missing
# These take any number as an order: a large one is valid, and without end or too large for this machine.
NUMBERS_ARE_ORDERS = {"step", "run_until", "record", "render", "poses_at"}
# Nothing of the simulator, or of its threads.
LEFT_OUT = {"register", "count", "index", "index_of", "mro"}
WORDS = ["", "left", "right", "both", "any", "arm", "left_arm", "RedBlock", "GreenBlock", "nobody", "eye", "close",
         "arrived", "still", "rgb", "depth", "id", "scattered", "stacked", "ready", "\0", "é" * 300, "a\nb", "\ud800",
         "0,0,9:0,0,0", "0,0,9:0,0,9:400", "tern"]
NUMBERS = [0, 1, -1, 2, 3, 7, 60, 255, 2**31 - 1, 2**31, -(2**63), 2**63, 2**64, 10**30, 0.0, -0.0, 0.1, 1.5, -3.0,
           1e-300, 1e300, math.nan, math.inf, -math.inf, True, False, 1j, np.float32(0.5), np.int64(3), np.uint8(200)]
SMALL = [0, 1, 2, 5, 20, 64, -1, 10**30, 2**64, 0.5, math.nan, math.inf, None, "1", True]
KINDS = ["grasp", "move_to", "rotate", "release", "destroy", "attend", "point", "trigger", "fasten", "loosen", "use",
         "joint_velocities", "joint_angles", "pose", "trajectory", "head", "undo", "redo", "stop", "nothing", "add",
         "remove", "camera", "mark", "simplify_robot", "clear"]
FIELDS = ["hand", "object", "position", "speed", "angles", "properties", "part", "control", "name", "arms", "arm",
          "grippers", "points", "text", "xml", "scene", "seconds", "velocities", "id", "to"]


class Caller:
    """Makes random calls, with what earlier calls returned."""

    def __init__(self, project, folder, seed, says):
        self.rng, self.folder, self.says = random.Random(seed), folder, says
        self.scene = project / "scenes/tower.xml"
        self.models = [smile.load(self.scene, robot) for robot in (None, "tern", "baxter")]
        self.pool, self.counts, self.names = [], {}, 0
        with smile.Simulation(self.models[0]) as sim:
            sim.record(folder / "demo", pictures=False)
            hand = sim.hand("left")
            hand.grasp("RedBlock")
            hand.move_to([0.3, 0.2, 0.2])
            sim.run_until("arrived")
            hand.release()
            sim.run_until("still")
            self.demo = sim.finish()
        self.hashes = [self.hash_of(model) for model in self.models]

    @staticmethod
    def hash_of(model):
        sim = smile.Simulation(model)
        sim.hand("left").grasp("RedBlock")
        sim.step(3)
        return sim.hash

    # ---- values ----

    def array(self):
        rng = self.rng
        shape = rng.choice([(), (0,), (1,), (2,), (3,), (6,), (7,), (14,), (3, 3), (7, 1), (1, 7), (0, 7), (2, 2, 2), (300,)])
        kind = rng.choice(["f8", "f8", "f8", "f4", "i8", "u1", "?", "c16", "U3", "O", "M8[s]", ">f8"])
        numbers = np.array([rng.uniform(-1, 1) for _ in range(math.prod(shape))]).reshape(shape)
        array = numbers.astype(kind if kind != "M8[s]" else "i8").astype(kind)
        if array.size and kind.endswith("f8") and rng.random() < 0.3:
            array.flat[rng.randrange(array.size)] = rng.choice([math.nan, math.inf, 1e300])
        if array.ndim == 1 and rng.random() < 0.2:
            array = np.repeat(array, 2)[::2]  # not contiguous
        if rng.random() < 0.1:
            array = np.broadcast_to(array, (2, *array.shape))
        return array

    def value(self, depth=0):
        rng = self.rng
        kind = rng.randrange(12)
        if kind < 3:
            return self.array()
        if kind < 5:
            return rng.choice(NUMBERS)
        if kind < 7:
            return rng.choice(WORDS)
        if kind == 7 and depth < 2:
            return [self.value(depth + 1) for _ in range(rng.randrange(4))]
        if kind == 8 and depth < 2:
            return {rng.choice(FIELDS): self.value(depth + 1) for _ in range(rng.randrange(4))}
        if kind == 9 and self.pool:
            return rng.choice(self.pool)
        return rng.choice([None, b"", rng.randbytes(40), lambda *_: True, lambda *_: 1 / 0, object(), int,
                           *self.models, self.demo, "RedBlock", "left"])

    def command(self):
        return {"do": self.rng.choice(KINDS), "hand": self.rng.choice(["left", "right", "both", "any", "foot", 3]),
                **{self.rng.choice(FIELDS): self.plain() for _ in range(self.rng.randrange(4))}}

    def plain(self):
        rng = self.rng
        return rng.choice([rng.choice(WORDS), rng.choice(SMALL), [rng.uniform(-5, 5) for _ in range(rng.randrange(8))],
                           {"arm": [0.1] * rng.randrange(8)}, None, "RedBlock", "RedBlock", 1e308])

    # ---- calls ----

    def call(self, what, function, *args, **kwargs):
        """Makes a call. What it returns may be used by later ones."""
        shown = [repr(one)[:80] for one in (*args, *kwargs.items())]
        if self.says:
            print(what, shown, flush=True)
        outcome = "returned"
        try:
            result = function(*args, **kwargs)
        except ALLOWED as error:
            outcome, result = type(error).__name__, None
            if not str(error):
                raise AssertionError(f"{what} raised {type(error).__name__} without a message") from error
        self.counts[outcome] = self.counts.get(outcome, 0) + 1
        if result is not None and not isinstance(result, (int, float, str)):
            self.pool.append(result)
        if len(self.pool) > 40:
            self.pool.pop(self.rng.randrange(len(self.pool)))
        return result

    def simulation(self):
        sims = [one for one in self.pool if isinstance(one, smile.Simulation)]
        return self.rng.choice(sims) if sims else None

    def sensible(self, sim):
        """A call that could succeed."""
        rng = self.rng
        name = rng.choice(["RedBlock", "GreenBlock", "BlueBlock"])
        place = [rng.uniform(-0.4, 0.4), rng.uniform(-0.3, 0.3), rng.uniform(0.06, 0.5)]
        hand = lambda: sim.hand(rng.choice(["left", "right", "both", "any"]))  # noqa: E731
        arm = lambda: rng.choice(list(sim.robot.arms.values()))  # noqa: E731
        states = [one for one in self.pool if isinstance(one, (smile.State, bytes))] or [b"x"]
        choices = {
            "grasp": lambda: hand().grasp(name), "move_to": lambda: hand().move_to(place), "release": lambda: hand().release(),
            "rotate": lambda: hand().rotate([0, 0, rng.uniform(-1, 1)]), "destroy": lambda: hand().destroy(),
            "step": lambda: sim.step(rng.randrange(20)), "undo": sim.undo, "redo": sim.redo, "save": sim.save,
            "bytes": lambda: bytes(sim.save()), "pickle": lambda: pickle.loads(pickle.dumps(sim.save())),
            "restore": lambda: sim.restore(rng.choice(states)), "damaged": lambda: sim.restore(self.damaged(bytes(sim.save()))),
            "poses": lambda: sim.poses, "events": lambda: sim.events, "pose": lambda: sim.objects[name].pose,
            "close": lambda: sim.close() if rng.random() < 0.2 else sim.is_still,
            "render": lambda: sim.render("eye", (rng.randrange(1, 40), rng.randrange(1, 40)), ("rgb", "depth", "id")),
            "record": lambda: sim.record(self.new_name(), size=(16, 12)), "finish": sim.finish,
            "move": lambda: arm().move(np.full(len(arm().q), 0.3), 0.1), "set_q": lambda: arm().set_q(arm().q * 0.9),
            "pose_of_robot": lambda: sim.robot.move_to_pose("ready"), "arms": lambda: sim.robot.arms,
            "until": lambda: sim.run_until("arrived", timeout=rng.choice([0.1, 1, 2])),
            "task": lambda: smile.Task(self.demo, sim), "hand": hand, "object": lambda: sim.objects[name], "arm": arm,
            "apply": lambda: sim.apply(self.command())}
        what = rng.choice(list(choices))
        return what, choices[what]

    def damaged(self, state):
        state = bytearray(state)
        for _ in range(self.rng.randrange(1, 4)):
            state[self.rng.randrange(len(state))] = self.rng.randrange(256)
        return bytes(state[:self.rng.choice([len(state), len(state), self.rng.randrange(len(state))])])

    def new_name(self):
        self.names += 1
        return self.folder / self.rng.choice([f"recording{self.names}", "demo", "no/where", ""])

    def blind(self, target):
        """Reads or calls any attribute, of the object or of its compiled half."""
        if not type(target).__module__.startswith("smile"):
            return
        if hasattr(target, "_native") and self.rng.random() < 0.5:
            target = target._native
        names = [name for name in dir(target) if not name.startswith("_") and name not in LEFT_OUT]
        if not names:
            return
        name = self.rng.choice(names)
        what = f"{type(target).__name__}.{name}"
        attribute = self.call(what, getattr, target, name)
        if not callable(attribute):
            return
        args = [self.value() for _ in range(self.rng.choice([0, 1, 1, 2, 2, 3, 4]))]
        if name in NUMBERS_ARE_ORDERS:
            args = [self.rng.choice(SMALL) if isinstance(one, (int, float, complex, np.generic)) else one for one in args]
        if name in ("record", "export_film", "film") and args:
            args[0] = self.new_name()
        self.call(what + "()", attribute, *args)

    def in_two_threads(self, sim):
        """One of them may find the simulation in use."""
        failures = []

        def work():
            try:
                for _ in range(10):
                    sim.step(1)
                    sim.poses  # noqa: B018
                    sim.save()
            except RuntimeError:
                pass
            except BaseException as error:  # noqa: BLE001
                failures.append(error)

        threads = [threading.Thread(target=work) for _ in range(2)]
        if self.rng.random() < 0.3:
            threads.append(threading.Thread(target=lambda: self.quietly(sim.close)))
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        assert not failures, failures

    @staticmethod
    def quietly(function):
        try:
            function()
        except RuntimeError:
            pass

    def elsewhere(self):
        """Functions of the package."""
        rng = self.rng
        choices = [("load", lambda: smile.load(rng.choice([self.scene, self.value()]), rng.choice([None, "tern", self.value()]))),
                   ("Simulation", lambda: smile.Simulation(rng.choice([*self.models, self.value()]))),
                   ("laid_out", lambda: rng.choice(self.models).laid_out(self.value(), self.value())),
                   ("laid_out", lambda: rng.choice(self.models).laid_out(rng.randrange(9), "scattered")),
                   ("State", lambda: smile.State(self.value())), ("open", lambda: smile.open(self.value())),
                   ("open", lambda: smile.open(self.folder / "demo")), ("Task", lambda: smile.Task(self.value(), self.value())),
                   ("index", lambda: self.demo[self.value()]), ("at", lambda: self.demo.at(self.value())),
                   ("replay", lambda: smile.replay(self.demo)), ("describe", lambda: smile.describe(self.demo)),
                   ("edit", lambda: smile.edit(self.demo, self.value(), self.new_name(), pictures=False)),
                   ("Robot", lambda: motion.Robot(self.value())), ("Picture", lambda: Picture(*[self.array()] * 5).to_png())]
        return rng.choice(choices)

    def run(self, calls):
        for i in range(calls):
            sim = self.simulation()
            kind = self.rng.random()
            if sim is None or kind < 0.03:
                self.call("Simulation", smile.Simulation, self.rng.choice(self.models))
            elif kind < 0.5:
                self.call(*self.sensible(sim))
            elif kind < 0.85:
                self.blind(self.rng.choice([sim, *self.pool]))
            elif kind < 0.9:
                self.call("apply", sim.apply, self.command())
            elif kind < 0.91:
                self.in_two_threads(sim)
            else:
                self.call(*self.elsewhere())
            if i % 200 == 199:
                gc.collect()
        # Models are shared: nothing of all that has changed them.
        assert [self.hash_of(model) for model in self.models] == self.hashes, "a model has changed"


def main():
    faulthandler.enable()
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("project", type=Path)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--calls", type=int, default=2000)
    parser.add_argument("--say", action="store_true")
    options = parser.parse_args()
    print(f"seed {options.seed}, {options.calls} calls", flush=True)
    with tempfile.TemporaryDirectory() as folder:
        caller = Caller(options.project, Path(folder), options.seed, options.say)
        caller.run(options.calls)
        print(", ".join(f"{count} {outcome}" for outcome, count in sorted(caller.counts.items())))
        returned = caller.counts.get("returned", 0)
        assert returned > options.calls / 4, f"only {returned} calls returned: the others tell little"
        caller.pool.clear()


if __name__ == "__main__":
    sys.exit(main())
