"""Draws a URDF file with RViz, which shows the robot of a ROS graph on a screen: both are started here, for the picture.

Usage: PYTHONPATH=python/test draw_rviz.py MODEL SCENE PICTURE; SCENE has the camera `visitor`, which URDF lacks.
"""

import math
import os
import sys
import tempfile
import time
import xml.etree.ElementTree as ElementTree
from contextlib import ExitStack
from pathlib import Path

import rospy
from geometry_msgs.msg import TransformStamped
from PIL import ImageGrab
from ros_graph import Graph, Program, wait_until
from tf2_msgs.msg import TFMessage

WIDTH, HEIGHT = 640, 400
BACKGROUND = (221, 228, 234)
# A picture is still when this many of them, taken at these intervals [s], are equal.
STILL_PICTURES, PICTURE_SECONDS = 6, 0.5
# No panels, and in full screen no bars either: the whole screen is the picture.
SETTINGS = """
Panels: []
Window Geometry: {{X: 0, Y: 0, Width: {width}, Height: {height}}}
Visualization Manager:
  Displays:
    - {{Class: rviz/RobotModel, Enabled: true, Name: model, Robot Description: robot_description}}
  Global Options: {{Background Color: {background}, Fixed Frame: world}}
  Tools:
    - Class: rviz/MoveCamera
  Views:
    Current:
      Class: rviz/Orbit
      Distance: {distance}
      Field of View: {field_of_view}
      Focal Point: {{X: {x}, Y: {y}, Z: {z}}}
      Near Clip Distance: 0.01
      Pitch: {pitch}
      Target Frame: world
      Yaw: {yaw}
"""


def triple(text):
    return [float(number) for number in text.strip("()").split(",")]


def orbit(camera):
    """The same camera in RViz's terms, m and rad; scene files have units of 0.1 m and degrees."""
    position, target = triple(camera.get("location")), triple(camera.get("target"))
    back = [(p - t) / 10 for p, t in zip(position, target)]
    distance = math.hypot(*back)
    x, y, z = (t / 10 for t in target)
    return {"x": x, "y": y, "z": z, "distance": distance, "pitch": math.asin(back[2] / distance),
            "yaw": math.atan2(back[1], back[0]), "field_of_view": math.radians(float(camera.get("fov")))}


def rotation_of(roll, pitch, yaw):
    """x, y, z, w of URDF's angles: about the fixed axes x, y and z, in this order."""
    (cr, sr), (cp, sp), (cy, sy) = ((math.cos(a / 2), math.sin(a / 2)) for a in (roll, pitch, yaw))
    return (sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy, cr * cp * sy - sr * sp * cy, cr * cp * cy + sr * sp * sy)


def transforms(model):
    """The pose of each link in its parent, with all joints at 0."""
    for joint in model.iter("joint"):
        transform = TransformStamped()
        transform.header.frame_id = joint.find("parent").get("link")
        transform.child_frame_id = joint.find("child").get("link")
        origin = joint.find("origin")
        place, turn = transform.transform.translation, transform.transform.rotation
        place.x, place.y, place.z = map(float, origin.get("xyz").split())
        turn.x, turn.y, turn.z, turn.w = rotation_of(*map(float, origin.get("rpy").split()))
        yield transform


def publish(model):
    """Publishes the model and the poses of its links, also for programs that join the graph later."""
    rospy.init_node("model", anonymous=True, disable_signals=True)
    rospy.set_param("robot_description", model)
    publisher = rospy.Publisher("/tf_static", TFMessage, queue_size=1, latch=True)
    publisher.publish(TFMessage(list(transforms(ElementTree.fromstring(model)))))
    return publisher


def is_drawn(picture):
    """Whether a picture shows something before the background, and not what RViz shows while it starts."""
    return picture.getpixel((0, 0)) == BACKGROUND and len(picture.getcolors(WIDTH * HEIGHT)) > 1


def take_picture(display):
    """Returns the picture of the screen as soon as it shows something and no longer changes."""
    pictures = []

    def is_still():
        time.sleep(PICTURE_SECONDS)
        pictures.append(ImageGrab.grab(xdisplay=display))
        last = pictures[-STILL_PICTURES:]
        return len(last) == STILL_PICTURES and is_drawn(last[0]) and all(picture == last[0] for picture in last)

    wait_until(is_still, "a picture by RViz that no longer changes")
    return pictures[-1]


def main(source, scene, picture):
    camera = next(element for element in ElementTree.parse(scene).getroot() if element.get("id") == "visitor")
    with tempfile.TemporaryDirectory() as folder, ExitStack() as programs:
        settings = Path(folder) / "tower.rviz"
        background = "; ".join(map(str, BACKGROUND))
        settings.write_text(SETTINGS.format(background=background, width=WIDTH, height=HEIGHT, **orbit(camera)), encoding="utf-8")
        screen = Program(folder, "screen", ["Xvfb", "-displayfd", 1, "-screen", 0, f"{WIDTH}x{HEIGHT}x24", "-nolisten", "tcp"])
        programs.callback(screen.end)
        screen.wait_for_output("\n")
        display = f":{int(screen.output)}"
        # RViz keeps settings at home: these are neither read nor changed.
        os.environ.update(HOME=folder, DISPLAY=display, QT_QPA_PLATFORM="xcb", LIBGL_ALWAYS_SOFTWARE="1")
        graph = Graph(folder)
        programs.callback(graph.master.end)
        publisher = publish(Path(source).read_text(encoding="utf-8"))
        programs.callback(publisher.unregister)
        viewer = Program(folder, "rviz", ["rviz", "--fullscreen", "--display-config", settings])
        programs.callback(viewer.end)
        try:
            take_picture(display).save(picture, optimize=True)
        except AssertionError as error:
            sys.exit(f"{error}; RViz wrote: {viewer.output}")


main(*sys.argv[1:])
