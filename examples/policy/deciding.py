"""What the policy decides: which arm moves now, and to what, until its gripper has closed or opened."""

from typing import NamedTuple

import numpy as np

import network

RISEN = 0.1     # below the place above where a tool rises no further [units]
ENOUGH = 8.0    # seconds after which a decision that led nowhere is replaced by another


class Decision(NamedTuple):
    """An arm moves to a target: an object, or the table, which has the number after the last object."""

    arm: int
    target: int
    holds: bool       # whether the arm holds something at first
    site: np.ndarray  # (4,) where the target was then: the table's is where something is put


class Deciding:
    """Asks the networks decide, place and turn, and remembers what is not to be seen."""

    def __init__(self, nets, sites, waiting):
        self.nets, self.sites, self.waiting = nets, sites, waiting
        self.decision = None
        self.rising = None               # arm, and the place above its last grasp or release
        self.since = 0.0                 # when either began
        self.yaw = 0.0                   # in which the tool arrives
        self.taken = [None, None]        # of each arm: the number of what it holds, None if it never decided on that
        self.refused = set()             # arms and targets that are not decided again until the next grasp or release

    @property
    def is_open(self):
        return self.decision is None and self.rising is None

    def update(self, tools, now):
        """Ends what is done, or leads nowhere. After a grasp or release the tool first goes straight up."""
        if self.decision is not None and (tools[self.decision.arm, 4] < network.HELD) != self.decision.holds:
            arm, target, held, _ = self.decision
            # What an arm has just put down, it does not take again.
            self.refused = {(arm, self.taken[arm])} if held and self.taken[arm] is not None else set()
            self.taken[arm] = None if held else target
            self.decision, self.rising, self.since = None, (arm, tools[arm, :4] + [0, 0, network.RISE, 0]), now
        is_long = now > self.since + ENOUGH
        if self.rising is not None and (is_long or tools[self.rising[0], 2] > self.rising[1][2] - RISEN):
            self.rising = None
        if self.decision is not None and is_long:
            self.refused.add((self.decision.arm, self.decision.target))
            self.decision = None

    def goals(self, tools, objects, now):
        """Returns where each arm moves, rows as of network.py, and of which kind that is."""
        goals, kinds = self.waiting.copy(), np.tile([0.0, 1.0, 0.0], (2, 1))
        if self.rising is not None:
            arm, above = self.rising
            goals[arm], kinds[arm] = above, [0, 0, 1]
            return goals, kinds
        if self.decision is None:
            self.decision, self.since = self.decide(tools, objects), now
        if self.decision is not None:
            arm, target, _, site = self.decision
            spot = objects[target] if target < len(objects) else site
            # The object may turn a little, not by a quarter.
            self.yaw += network.upright(spot[3] - self.yaw)
            goals[arm], kinds[arm] = [*spot[:3], self.yaw], [target == len(objects), 0, 0]
        return goals, kinds

    def decide(self, tools, objects):
        """Returns a decision, and sets the yaw; None if both arms are to wait."""
        says = [network.run(np, self.nets["decide"], network.see(np, *network.seen_by(tools, objects, k)))
                for k in range(2)]
        # The right arm's view names itself first.
        targets = 1 + len(objects)
        scores = says[0] + np.concatenate([says[1][:1], says[1][1 + targets:], says[1][1:1 + targets]])
        chances = np.exp(scores - scores.max())
        if chances[0] > chances[1:].sum():
            return None
        chances = chances[1:].reshape(2, targets)
        for arm, target in self.refused:
            chances[arm, target] = 0
        arm, target = map(int, np.unravel_index(chances.argmax(), chances.shape))
        own, other, things, side = network.seen_by(tools, objects, arm)
        spot = things[target] if target < len(objects) else self.site(own, other, things, side)
        turn = network.run(np, self.nets["turn"], network.aim(np, own, spot, side)).argmax() - network.TURNS
        if arm == 1:
            spot, turn = network.mirrored(np, spot), -turn
        self.yaw = spot[3] + np.pi / 2 * turn
        return Decision(arm, target, tools[arm, 4] < network.HELD, spot)

    def site(self, *seen):
        """Where on the table an arm puts down what it holds, as this arm sees it."""
        likeliest = network.run(np, self.nets["place"], network.see(np, *seen)).argmax()
        return np.array([*self.sites[likeliest], 0, 0])
