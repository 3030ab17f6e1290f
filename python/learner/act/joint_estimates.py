"""Where the joints are: noisy measurements, filtered with the motion that the motors were told."""

import numpy as np

from constants import JOINT_ESTIMATES as C


class JointEstimates:
    """The joint angles of all arms.

    A Kalman filter for each arm, with one variance for all its joints: they move as the motors are
    told, but for a drift, and are measured with the noise that shows while nothing moves yet.
    Sensors without noise are believed.

    starts: joint angles of each arm in the first step, n numbers each [rad]
    """

    def __init__(self, starts):
        self.starts = [np.array(q, dtype=float) for q in starts]
        self.angles = [q.copy() for q in self.starts]
        self.variances = [0.0] * len(starts)  # of the estimates [rad2]
        self.surprises = [[] for _ in starts]  # measured less predicted, the last few
        self.rest = []  # measured less known, while nothing has moved
        self.told = []  # velocities of each arm, n or nxN for N ticks [rad/s]
        self.has_moved = False
        self.last = [np.zeros_like(q) for q in self.starts]  # the last velocities told [rad/s]

    def correct(self, sensor, tick_seconds):
        """Replaces the measured joint angles in `sensor` by estimates."""
        num_ticks = round(sensor.timeElapsed / tick_seconds)
        self.has_moved = self.has_moved or any(np.any(told) for told in self.told)
        if not self.has_moved:
            self.rest += [arm.joints - q for arm, q in zip(sensor.arms, self.starts)]
        noise = np.sqrt(np.mean(np.concatenate(self.rest) ** 2))
        for k, arm in enumerate(sensor.arms):
            if noise < C.least_noise_rad:
                self.angles[k] = arm.joints
                continue
            self.predict(k, num_ticks, tick_seconds)
            self.believe(k, arm.joints - self.angles[k], noise)
            arm.joints = self.angles[k].copy()

    def predict(self, k, num_ticks, tick_seconds):
        """Moves the estimate of an arm as its motors were told for some ticks."""
        if not self.told or num_ticks == 0:
            return
        told = self.told[k]
        told = told[:, None].repeat(num_ticks, 1) if told.ndim == 1 else told[:, :num_ticks]
        # The servos run ahead of what they are told, in proportion to the velocity.
        ahead = C.ahead_s * (told[:, -1] - self.last[k])
        self.angles[k] += told.sum(1) * tick_seconds + ahead
        self.last[k] = told[:, -1]
        if np.any(told):
            self.variances[k] += num_ticks * C.drift_rad ** 2

    def believe(self, k, surprise, noise):
        """Corrects the estimate of an arm by what was measured beyond it."""
        # Noise has no direction. Measurements that differ from the prediction in one direction again
        # and again tell of an obstacle: then the motors are not to be believed.
        last = self.surprises[k] = [*self.surprises[k], surprise][-C.num_surprises:]
        error = noise / np.sqrt(C.num_surprises)
        if len(last) == C.num_surprises and np.abs(np.mean(last, axis=0)).max() > C.doubt * error:
            self.variances[k] = noise ** 2
            self.surprises[k] = []
        gain = self.variances[k] / (self.variances[k] + noise ** 2)
        self.angles[k] += gain * surprise
        self.variances[k] *= 1 - gain

    def remember(self, motor):
        """Remembers what the motors are told in this step."""
        self.told = [np.array(arm.velocities, dtype=float) for arm in motor.arms]
