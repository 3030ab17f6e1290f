"""`smile ros serve`: the simulated robot on a ROS graph."""

from __future__ import annotations

import os

import rospy

import smile
from smile.ros.description import describe
from smile.ros.graph import join_graph, master_is_lost
from smile.ros.served_graph import ServedGraph
from smile.ros.served_robot import ServedRobot
from smile.simulation import Simulation


def serve(scene: str, *, robot: str, rate: float, lockstep: bool, picture_rate: float, picture_size: tuple[int, int],
          record: str | None, pose: str | None) -> None:
    """Serves the robot until Ctrl-C or the end of the master.

    rate    at most so many times as fast as real time
    record  folder of a recording of everything that happens; None: none
    pose    named pose in which the robot begins; None: its own start
    """
    model = smile.load(scene, robot)
    description = describe(model)
    join_graph("smile_robot", anonymous=False)
    with Simulation(model) as sim:
        if record is not None:
            sim.record(record, pictures=False, title=f"{model.name}, served to ROS")
        if pose is not None:
            sim.apply({"do": "pose", "name": pose, "speed": 0.5})
            sim.run_until("arrived")
        graph = ServedGraph(ServedRobot(sim, description), picture_rate=picture_rate, picture_size=picture_size,
                            lockstep=lockstep)
        print(f"serving {description.name} in {model.name} at {os.environ['ROS_MASTER_URI']}; Ctrl-C ends it", flush=True)
        lost = master_is_lost()
        graph.run(rate, lambda: rospy.is_shutdown() or lost())
        if record is not None:
            sim.finish()
        if lost():
            raise RuntimeError(f"the ROS master at {os.environ['ROS_MASTER_URI']} no longer answers")
