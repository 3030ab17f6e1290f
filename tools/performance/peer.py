"""Simulates one scene in another simulator, and prints what it costs and what it is worth.

Run by tools/measure_performance.py with the Python of build/peers. Reads a problem from stdin:

    {"simulator": "mujoco" or "pybullet", "rate": steps per second, "may_sleep": bool,
     "blocks": [{"position": [x, y, z], "size": [x, y, z], "mass": kg}, ...],
     "table": {"position": ..., "size": ...} or null for a plane z = 0,
     "robot": {"urdf": path, "start": {joint: rad}, "apart": [[link, link], ...]} or null,
     "settle": seconds, "seconds": seconds}

Lengths are in meters; with a robot, the frame is that of its base. Both simulators run with their
own defaults, on one thread; what differs from them stands below, with the reason. Prints a JSON
object with `cpu_ms_per_s` (CPU milliseconds per simulated second after settling), and either
`sag_mm` (the deepest that a block lies below its place when settled) and `creep_mm` (the farthest
that one moves afterwards), or `joint_error_rad` of the robot's swinging arms.
"""

import json
import os
import sys
import tempfile
import time
import xml.etree.ElementTree as ET

FRICTION = 0.6  # of each of our objects; that of a contact is the product
SPEED = 0.3  # of each joint [rad/s]
HALF_PERIOD = 0.5  # after which the joints turn back [s]


def triangle(seconds):
    """Where the joints should be, relative to their start [rad]."""
    phase = seconds % (2 * HALF_PERIOD)
    return SPEED * min(phase, 2 * HALF_PERIOD - phase)


class MuJoCo:
    def __init__(self, problem):
        import mujoco
        self.mujoco = mujoco
        self.model = mujoco.MjModel.from_xml_string(self._mjcf(problem))
        self.data = mujoco.MjData(self.model)
        if problem["robot"]:
            for i, (name, angle) in enumerate(self.start.items()):
                self.data.joint(name).qpos[0] = angle
                self.data.act[i] = angle
        mujoco.mj_forward(self.model, self.data)

    def _mjcf(self, problem):
        root = self._robot(problem["robot"]) if problem["robot"] else ET.Element("mujoco")
        option = ET.SubElement(root, "option", timestep=str(1 / problem["rate"]))
        if problem["may_sleep"]:
            ET.SubElement(option, "flag", sleep="enable")
        if problem["robot"]:
            # Stiff servos are unstable with the default integrator.
            option.set("integrator", "implicitfast")
        world = root.find("worldbody")
        if world is None:
            world = ET.SubElement(root, "worldbody")
        # A contact has the larger friction of its geoms.
        friction = str(FRICTION * FRICTION)
        if problem["table"]:
            self._box(world, problem["table"], friction)
        else:
            ET.SubElement(world, "geom", type="plane", size="0 0 1", friction=friction)
        for i, block in enumerate(problem["blocks"]):
            body = ET.SubElement(world, "body", name=f"block{i}", pos=words(block["position"]))
            ET.SubElement(body, "freejoint")
            self._box(body, {**block, "position": [0, 0, 0]}, friction)
        return ET.tostring(root, encoding="unicode")

    @staticmethod
    def _box(parent, box, friction):
        geom = ET.SubElement(parent, "geom", type="box", size=words(s / 2 for s in box["size"]),
                             pos=words(box["position"]), friction=friction)
        if "mass" in box:
            geom.set("mass", str(box["mass"]))

    def _robot(self, robot):
        """The MJCF that MuJoCo makes of the URDF, with servos."""
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "robot.xml")
            model = self.mujoco.MjModel.from_xml_path(robot["urdf"])
            self.mujoco.mj_saveLastXML(path, model)
            root = ET.parse(path).getroot()
        bodies = {body.get("name") for body in root.iter("body")}
        for body in root.iter("body"):
            body.set("gravcomp", "1")  # as the controllers of the robot do
        contact = ET.SubElement(root, "contact")
        for a, b in robot["apart"]:
            # Fixed links have become part of the world.
            ET.SubElement(contact, "exclude", body1=a if a in bodies else "world", body2=b if b in bodies else "world")
        efforts = {joint.get("name"): joint.find("limit").get("effort")
                   for joint in ET.parse(robot["urdf"]).getroot().iter("joint") if joint.find("limit") is not None}
        actuators = ET.SubElement(root, "actuator")
        self.start = robot["start"]
        for name in self.start:
            # A servo to a position that moves with the commanded velocity, as ours does.
            ET.SubElement(actuators, "intvelocity", joint=name, kp="2000", kv="60", actrange="-4 4",
                          forcerange=f"-{efforts[name]} {efforts[name]}")
        return root

    def command(self, velocity):
        self.data.ctrl[:] = velocity

    def step(self, count):
        self.mujoco.mj_step(self.model, self.data, count)

    def positions(self, count):
        return [list(self.data.body(f"block{i}").xpos) for i in range(count)]

    def angles(self):
        return [float(self.data.joint(name).qpos[0]) for name in self.start]


class PyBullet:
    def __init__(self, problem):
        import pybullet
        self.p = p = pybullet
        p.connect(p.DIRECT)
        p.setGravity(0, 0, -9.81)
        p.setTimeStep(1 / problem["rate"])
        sleep = p.ACTIVATION_STATE_ENABLE_SLEEPING if problem["may_sleep"] else p.ACTIVATION_STATE_DISABLE_SLEEPING
        if problem["robot"]:
            self._robot(problem["robot"])
        if problem["table"]:
            table = self._box({**problem["table"], "mass": 0})
        else:
            table = p.createMultiBody(0, p.createCollisionShape(p.GEOM_PLANE))
        p.changeDynamics(table, -1, lateralFriction=FRICTION)
        self.blocks = [self._box(block) for block in problem["blocks"]]
        for block in self.blocks:
            p.changeDynamics(block, -1, lateralFriction=FRICTION, activationState=sleep)

    def _box(self, box):
        shape = self.p.createCollisionShape(self.p.GEOM_BOX, halfExtents=[s / 2 for s in box["size"]])
        return self.p.createMultiBody(box["mass"], shape, basePosition=box["position"])

    def _robot(self, robot):
        p = self.p
        self.robot = p.loadURDF(robot["urdf"], useFixedBase=True, flags=p.URDF_USE_SELF_COLLISION |
                                p.URDF_USE_SELF_COLLISION_EXCLUDE_PARENT | p.URDF_MERGE_FIXED_LINKS |
                                p.URDF_USE_INERTIA_FROM_FILE)
        infos = [p.getJointInfo(self.robot, i) for i in range(p.getNumJoints(self.robot))]
        links = {info[12].decode(): info[0] for info in infos}
        for a, b in robot["apart"]:
            # Fixed links have become part of the base, -1.
            p.setCollisionFilterPair(self.robot, self.robot, links.get(a, -1), links.get(b, -1), 0)
        joints = {info[1].decode(): info for info in infos}
        self.joints = [joints[name][0] for name in robot["start"]]
        self.efforts = [joints[name][10] for name in robot["start"]]
        for joint, angle in zip(self.joints, robot["start"].values()):
            p.resetJointState(self.robot, joint, angle)

    def command(self, velocity):
        self.p.setJointMotorControlArray(self.robot, self.joints, self.p.VELOCITY_CONTROL,
                                         targetVelocities=[velocity] * len(self.joints), forces=self.efforts)

    def step(self, count):
        for _ in range(count):
            self.p.stepSimulation()

    def positions(self, _):
        return [list(self.p.getBasePositionAndOrientation(block)[0]) for block in self.blocks]

    def angles(self):
        return [state[0] for state in self.p.getJointStates(self.robot, self.joints)]


def words(numbers):
    return " ".join(repr(float(number)) for number in numbers)


def stand(simulator, problem):
    """Lets blocks stand."""
    blocks = problem["blocks"]
    simulator.step(round(problem["settle"] * problem["rate"]))
    settled = simulator.positions(len(blocks))
    start = time.process_time()
    simulator.step(round(problem["seconds"] * problem["rate"]))
    cpu = time.process_time() - start
    end = simulator.positions(len(blocks))
    return {
        "cpu_ms_per_s": 1000 * cpu / problem["seconds"],
        "sag_mm": 1000 * max(block["position"][2] - p[2] for block, p in zip(blocks, settled)),
        "creep_mm": 1000 * max(sum((a - b) ** 2 for a, b in zip(p, q)) ** 0.5 for p, q in zip(settled, end)),
    }


def swing(simulator, problem):
    """Swings the arms of the robot while blocks lie on the table."""
    simulator.command(0)
    simulator.step(round(problem["settle"] * problem["rate"]))
    start_angles = simulator.angles()
    # Joints that begin at a limit cannot follow.
    follows = [angle + SPEED * HALF_PERIOD < limit for angle, limit in zip(start_angles, problem["robot"]["upper"])]
    cpu = error = 0
    for i in range(round(problem["seconds"] / HALF_PERIOD)):
        simulator.command(SPEED if i % 2 == 0 else -SPEED)
        start = time.process_time()
        simulator.step(round(HALF_PERIOD * problem["rate"]))
        cpu += time.process_time() - start
        wanted = triangle((i + 1) * HALF_PERIOD)
        for angle, first, counts in zip(simulator.angles(), start_angles, follows):
            if counts:
                error = max(error, abs(angle - first - wanted))
    return {"cpu_ms_per_s": 1000 * cpu / problem["seconds"], "joint_error_rad": error}


def main():
    problem = json.load(sys.stdin)
    simulator = {"mujoco": MuJoCo, "pybullet": PyBullet}[problem["simulator"]](problem)
    result = (swing if problem["robot"] else stand)(simulator, problem)
    # Libraries may print, too: the result is the last line.
    print("\n" + json.dumps(result))


if __name__ == "__main__":
    main()
