"""The brain of a trained policy, for two arms. train.py writes a small program for each of its policies:

    from policy import Policy
    init, step = Policy(WEIGHTS).functions()

It sees its joint angles, the openings of its grippers, and either pictures or the true poses of all objects:
see eye.py.
"""

import numpy as np

import network
from eye import Eye, Told
from smile.motion import robot_of

ACTED = 5            # steps of a chunk, until the next one
GRIP_SPEED = 2.0     # [units/s]
RISEN = 0.1          # below the place above where it rises no further [units]
PATIENCE = 3.0       # seconds without a motion after which it ends


class Policy:
    """What the brain does. The networks decide to what an arm moves, and how it goes on, every half second."""

    def __init__(self, file):
        with np.load(file) as data:
            self.names = data["names"].tolist()
            self.start = data["start"]
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
        self.waiting = np.array([[*pose[:3, 3], network.yaw_of_tool(pose[:3, :3])] for pose in poses])
        self.yaws = self.waiting[:, 3]
        self.decided = None              # arm, number of its target, and whether it holds something
        self.rising = None               # arm, and the place above its last grasp or release
        self.moved = 0.0
        self.eye = Eye(self.nets, aux) if "look" in self.nets else Told(self.names, aux)

    def step(self, sensor, motor, aux):
        tools = self.tools(sensor.arms)
        self.update(tools)
        is_deciding = self.decided is None and self.rising is None
        objects = self.eye.objects(sensor, tools, is_deciding)
        self.decide(tools, objects)
        for k, arm in enumerate(sensor.arms):
            chunk = self.chunk(tools, objects, k)
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

    def update(self, tools):
        """A decision stands until the gripper has closed or opened; then the tool first goes straight up."""
        if self.decided is not None and (tools[self.decided[0], 4] < network.HELD) != self.decided[2]:
            arm = self.decided[0]
            self.rising, self.decided = (arm, tools[arm, :4] + [0, 0, network.RISE, 0]), None
        if self.rising is not None and tools[self.rising[0], 2] > self.rising[1][2] - RISEN:
            self.rising = None

    def decide(self, tools, objects):
        """Sets what moves, and whereto: self.goals."""
        self.goals, self.kinds = self.waiting.copy(), np.tile([0.0, 1.0, 0.0], (2, 1))
        if self.rising is not None:
            arm, above = self.rising
            self.goals[arm], self.kinds[arm] = above, [0, 0, 1]
            return
        spots = np.array([*objects, np.zeros(4)])
        if self.decided is None:
            self.decided = self.next_decision(tools, objects, spots)
        if self.decided is None:
            return
        arm, target, _ = self.decided
        # The object may turn a little, not by a quarter.
        self.yaw += network.upright(spots[target, 3] - self.yaw)
        self.goals[arm], self.kinds[arm] = [*spots[target, :3], self.yaw], [target == len(objects), 0, 0]

    def next_decision(self, tools, objects, spots):
        """Returns arm, number of its target, and whether it holds something; None if both are to wait."""
        says = [network.run(np, self.nets["decide"], network.see(np, *seen(tools, objects, k))) for k in range(2)]
        # The right arm's view names itself first.
        middle = 1 + len(spots)
        other = np.concatenate([says[1][:1], says[1][middle:], says[1][1:middle]])
        choice = int((says[0] + other).argmax())
        if choice == 0:
            return None
        arm, target = divmod(choice - 1, len(spots))
        own, _, _, side = seen(tools, objects, arm)
        spot = network.mirrored(np, spots[target]) if arm == 1 else spots[target]
        turn = network.run(np, self.nets["turn"], network.aim(np, own, spot, side)).argmax() - network.TURNS
        self.yaw = spots[target, 3] + np.pi / 2 * (-turn if arm == 1 else turn)
        return arm, target, tools[arm, 4] < network.HELD

    def chunk(self, tools, objects, k):
        """(STEPS, OUTPUTS): where an arm's tool should be, and its opening [units]."""
        own, _, things, side = seen(tools, objects, k)
        goal = network.mirrored(np, self.goals[k]) if k == 1 else self.goals[k]
        chunk = network.chunk(np, self.nets["move"], own, things, goal, self.kinds[k], side)
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


def seen(tools, objects, arm):
    """The world as an arm sees it: its own tool, the other one, objects, and its side."""
    own, other = tools[arm], tools[1 - arm]
    if arm == 1:
        own, other, objects = (network.mirrored(np, it) for it in (own, other, objects))
    return own, other, objects, np.array([float(arm)])
