"""Which part of a picture shows a control, and which only what it drives."""

import numpy as np

from explain.presses import large_regions
from see.eye import onto_plane


def own_part(changed, demo, control, frame):
    """Returns the part of a mask of what a press in a frame changed that belongs to the object of the control: the lights that a switch
    drives may be on another one. All of it, if nothing else is visible. Regions belong to the nearest of the objects with
    controls."""
    owners = {fields[0]: fields[2] for _, word, fields in demo.events if word == "initializeControl"}
    if len(set(owners.values())) < 2 or control not in owners:
        return changed
    own = np.zeros_like(changed)
    number = large_regions(changed)
    for region in np.unique(number[number > 0]):
        row, column = np.nonzero(number == region)
        if nearest_object(row, column, demo, sorted(set(owners.values())), frame) == owners[control]:
            own |= number == region
    return own if own.any() else changed


def nearest_object(row, column, demo, names, frame):
    """Returns the one of some objects of a demonstration that is nearest to what some pixels show, each at its own height."""
    def distance(name):
        x, y, z = demo.pose(demo.ids.index(name), frame)[:3]
        at_x, at_y, _ = onto_plane(row, column, demo.eye, z)
        return np.hypot(at_x.mean() - x, at_y.mean() - y)

    return min(names, key=distance)
