"""What hands do in several tests."""

import numpy as np


def yaw(one):
    return 2 * np.arctan2(one.quaternion[3], one.quaternion[0])


def put_on(sim, mover, base):
    """Puts a block of the tower on another one, aligned with it."""
    hand, under = sim.hand("left"), sim.objects[base]
    hand.grasp(mover)
    hand.rotate([0, 0, yaw(under) - yaw(sim.objects[mover])])
    for height in (0.3, 0.151):
        hand.move_to([*under.position[:2], height])
        sim.run_until("arrived")
    hand.release()
    sim.run_until("still")
