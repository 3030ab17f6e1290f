"""A robot in the process of a test, behind the interface of a real one; knows nothing of ROS."""

import json

import numpy as np
from smile.ros.link import CameraReading, GripperReading, Reading, RobotLink, SeeingLink, TrajectoryReading


class SimulatedLink(RobotLink):
    """A robot in this process: each reading is a tick. `damage` makes another reading of it."""

    def __init__(self, robot, damage=lambda tick, reading: reading, moves=True):
        self.robot, self._damage, self._moves = robot, damage, moves
        self.commands, self._trajectories = 0, {}
        self.enabled = True

    def wait(self, timeout):
        self.robot.step()
        names = [name for joints in self.robot.description.arms.values() for name in joints]
        q = np.concatenate([self.robot.robot.arms[arm].q for arm in self.robot.limbs]).tolist()
        return self._damage(self.robot.sim.tick, Reading(self.robot.time, 0.0, dict(zip(names, q))))

    def command(self, arm, names, positions):
        self.commands += 1
        if self._moves:
            self.robot.command_joints(arm, 4, names, positions, "/perform")

    def follow(self, paths, tolerance):
        for arm, path in paths.items():
            refusal = self.robot.follow(arm, path, "/perform") if self._moves else None
            self._trajectories[arm] = path, self.robot.time, refusal

    def trajectory(self, arm):
        path, begin, refusal = self._trajectories[arm]
        return TrajectoryReading(True, refusal is not None or self._moves and self.robot.time > begin + path.duration + 0.1, refusal)

    def cancel(self):
        for arm in self._trajectories:
            self.robot.stop(arm)

    def grip(self, arm, percent):
        self.robot.command_gripper(arm, "go", json.dumps({"position": percent}), "/perform",
                                   self.robot.grippers[arm].sequence + 1)
        return self.robot.grippers[arm].sequence

    def gripper(self, arm):
        gripper, hand = self.robot.grippers[arm], self.robot.robot.arms[arm]
        return GripperReading(gripper.sequence, self.robot.description.openings[arm].percent(hand.gripper),
                              gripper.is_moving, bool(hand.held))

    def enable(self):
        self.robot.enable(True)

    def motors_fault(self):
        return None if self.robot.is_enabled else "the motors are off"

    def connection_fault(self):
        return None

    def words(self):
        return []


class SeeingSimulatedLink(SimulatedLink, SeeingLink):
    """The same with a camera: a picture at each of `ticks`, of which `blur` makes another one."""

    def __init__(self, robot, camera="eye", size=(320, 240), ticks=6, blur=lambda tick, seen: seen, **more):
        super().__init__(robot, **more)
        self._camera, self._size, self._ticks, self._blur = camera, size, ticks, blur
        self._has_depth, self._seen = False, None

    def wait(self, timeout):
        reading = super().wait(timeout)
        if self.robot.sim.tick % self._ticks == 0:
            self._seen = None
        return reading

    def watch(self, topic, depth_topic):
        self._has_depth = depth_topic is not None

    def seen(self):
        sim = self.robot.sim
        if self._seen is None:
            picture = sim.render(self._camera, self._size, channels=("rgb", "depth"))
            K = picture.intrinsics - [[0, 0, 0.5], [0, 0, 0.5], [0, 0, 0]]
            self._seen = CameraReading(picture.rgb, K, np.zeros(5), sim.time, picture.depth if self._has_depth else None)
        return self._blur(sim.tick, self._seen)

    def picture(self, topic, timeout):
        return self.seen()
