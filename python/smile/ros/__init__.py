"""Robots behind ROS: the simulated robot as a real one, and recorded motions on a real one.

`python3 -m smile.ros` is the program `smile ros` (docs/real-robot.md). Its modules that speak ROS need Debian's
packages of ROS 1 (tools/get_ros.sh).
"""
