"""The brain of a trained policy, for two arms. train.py writes a small program for each of its policies:

    from policy import Policy
    init, step = Policy(WEIGHTS).functions()

It sees its joint angles, the openings of its grippers, and either pictures or the true poses of all objects:
see eye.py.
"""

import numpy as np

import network
from deciding import Deciding
from eye import Eye, Told
from smile.motion import robot_of

ACTED = 5            # steps of a chunk, until the next one
GRIP_SPEED = 2.0     # [units/s]
PATIENCE = 3.0       # seconds without a motion after which it ends


class Policy:
    """What the brain does. The networks decide to what an arm moves, and how it goes on, every half second."""

    def __init__(self, file):
        with np.load(file) as data:
            self.names, self.looks = data["names"].tolist(), data["looks"]
            self.start, self.sites = data["start"], data["sites"]
            self.nets = {name: [(data[f"{name}_weights{k}"], data[f"{name}_biases{k}"])
                                for k in range(sum(key.startswith(f"{name}_weights") for key in data))]
                         for name in data["nets"]}

    def functions(self):
        return self.init, self.step

    def init(self, aux):
        self.robot = robot_of(aux)
        self.arms = list(aux.arms)
        for arm, joints in zip(self.arms, self.start):
            arm.initJoints = joints
        poses = [self.robot.forward(arm.name, joints) for arm, joints in zip(self.arms, self.start)]
        waiting = np.array([[*pose[:3, 3], network.yaw_of_tool(pose[:3, :3])] for pose in poses])
        self.yaws = waiting[:, 3]
        self.moved = 0.0
        self.deciding = Deciding(self.nets, self.sites, waiting)
        self.eye = Eye(self.nets, self.looks, aux) if "look" in self.nets else Told(self.names, aux)

    def step(self, sensor, motor, aux):
        tools = self.tools(sensor.arms)
        self.deciding.update(tools, sensor.simTime)
        objects = self.eye.objects(sensor, tools, self.deciding.is_open)
        goals, kinds = self.deciding.goals(tools, objects, sensor.simTime)
        for k, arm in enumerate(sensor.arms):
            chunk = self.chunk(tools, objects, goals[k], kinds[k], k)
            velocities, openings = self.follow(k, arm, tools[k], chunk[:ACTED])
            motor.arms[k].velocities = velocities
            motor.arms[k].gripperVelocity = openings
            if np.abs(chunk[:, :3]).max() > 0.2 or (np.abs(openings) > 0.2).any() and arm.gripper > network.HELD:
                self.moved = sensor.simTime
        motor.ticks = ACTED * network.STEP_TICKS
        if sensor.simTime - self.moved > PATIENCE:
            aux.claim, aux.exit = "done", True

    def tools(self, arms):
        """Rows as in network.py; a yaw goes on where it was before."""
        rows = []
        for k, arm in enumerate(arms):
            yaw = network.yaw_of_tool(arm.endEffector[:3, :3])
            yaw += 2 * np.pi * round((self.yaws[k] - yaw) / (2 * np.pi))
            rows.append([*arm.endEffector[:3, 3], yaw, arm.gripper])
        self.yaws = [row[3] for row in rows]
        return np.array(rows)

    def chunk(self, tools, objects, goal, kind, k):
        """(STEPS, OUTPUTS): where an arm's tool should be, and its opening [units]."""
        own, _, things, side = network.seen_by(tools, objects, k)
        if k == 1:
            goal = network.mirrored(np, goal)
        chunk = network.chunk(np, self.nets["move"], own, things, goal, kind, side)
        if k == 1:
            chunk = network.mirrored(np, chunk)
        chunk[:, 4] = chunk[:, 4] / network.OPENING_SCALE + network.OPENING
        return chunk

    def follow(self, k, arm, tool, chunk):
        """Velocities of the joints and of the gripper, for each tick of some steps."""
        limits, joints = self.arms[k].maxVelocities, np.array(arm.joints)
        opening, duration = arm.gripper, network.STEP_TICKS / 60
        velocities, rates = [], []
        for *place, turn, wanted in chunk:
            reached = self.solve(self.arms[k], joints, tool[:3] + place, tool[3] + turn)
            velocity = (reached - joints) / duration
            velocity /= max(1, np.abs(velocity / limits).max())
            joints = joints + velocity * duration
            # Any opening drops what is held, so a gripper that is to be closed presses on.
            is_closed = wanted < network.OPENING
            rate = -GRIP_SPEED if is_closed else np.clip((wanted - opening) / duration, -GRIP_SPEED, GRIP_SPEED)
            opening += rate * duration
            velocities += [velocity] * network.STEP_TICKS
            rates += [rate] * network.STEP_TICKS
        return np.array(velocities).T, np.array(rates)

    def solve(self, arm, joints, place, yaw):
        """Joint angles near the given ones that bring the tool to a place, pointing straight down."""
        c, s = np.cos(yaw), np.sin(yaw)
        wanted = np.array([[-s, c, 0], [c, s, 0], [0, 0, -1.0]])
        for _ in range(4):
            pose = self.robot.forward(arm.name, joints)
            turn = 0.5 * sum(np.cross(pose[:3, i], wanted[:, i]) for i in range(3))
            error = np.concatenate([place - pose[:3, 3], turn])
            jacobian = self.robot.jacobian(arm.name, joints)
            change = jacobian.T @ np.linalg.solve(jacobian @ jacobian.T + 1e-3 * np.eye(6), error)
            joints = np.clip(joints + change, arm.minJoints, arm.maxJoints)
        return joints
