"""Perception of the rack, the drives and the bin. Lengths are in units."""
import numpy as np

from common.vision import Place, between, points_of, rectangle_around

PANEL, WALL = (0xd5, 0xda, 0xe0), (0x8a, 0x93, 0x9d)
GREEN_LAMP, RED_LAMP = (0x20, 0xd0, 0x40), (0xff, 0, 0)
GOOD_LABEL, PLATE, BIN = (0x20, 0xa0, 0x40), (0xc8, 0xcc, 0xd2), (0x7a, 0x5c, 0x3e)

# In the rack, from its middle:
SLOTS = -1.1, 1.1  # the slots along its width
PANEL_DEPTH, SWITCH_DEPTH, SLOT_DEPTH = -1.3, -1.5, 0.8


def find_rack(sensor, aux):
    """Returns the place of the rack: it has two light panels in front of its slots."""
    panels = between(points_of(PANEL, sensor, aux), 0.3, 0.4)
    if len(panels) < 500:
        raise RuntimeError("no rack is visible")
    middle, (_, depth_axis), _ = rectangle_around(panels)
    walls = between(points_of(WALL, sensor, aux), 0.5, 0.6)[:, :2].mean(axis=0)
    if (walls - middle) @ depth_axis < 0:
        depth_axis = -depth_axis
    return Place(middle - PANEL_DEPTH * depth_axis, depth_axis)


def find_bin(sensor, aux):
    """Returns the place of the bin, whose rim is 0.6 high and longer than wide."""
    rim = between(points_of(BIN, sensor, aux), 0.58, 0.62)
    if len(rim) < 100:
        raise RuntimeError("no bin is visible")
    middle, (depth_axis, _), _ = rectangle_around(rim)
    return Place(middle, depth_axis)


def find_spare(sensor, aux):
    """Returns the place of a good drive that stands on the table, where labels are 1.71 high."""
    label = between(points_of(GOOD_LABEL, sensor, aux), 1.6, 1.8)
    plate = between(points_of(PLATE, sensor, aux), 1.6, 1.8)
    if len(label) < 50 or len(plate) < 50:
        raise RuntimeError("no spare drive is visible")
    # The label is at the near end of the drive, and the plate continues behind it.
    back = plate[:, :2].mean(axis=0) - label[:, :2].mean(axis=0)
    middle, axes, _ = rectangle_around(np.vstack([label, plate]))
    axis = axes[np.argmax(np.abs(axes @ back))]
    if axis @ back < 0:
        axis = -axis
    # Label and plate reach from 1.0 in front of the middle to 0.7 behind it.
    return Place(middle + 0.15 * axis, axis)


def lamp_at(x, rack, sensor, aux):
    """Returns "failed", "ready" or "off": the lamp of the slot at x of the rack."""
    for word, color in ("failed", RED_LAMP), ("ready", GREEN_LAMP):
        lamps = rack.inside(between(points_of(color, sensor, aux), 0.36, 0.5))
        if np.count_nonzero(np.abs(lamps - [x, PANEL_DEPTH]).max(axis=1) < 0.7) > 20:
            return word
    return "off"
