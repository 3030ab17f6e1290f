"""Perception of housing, screwdriver, fuses and bin. Lengths are in units."""
from common.vision import Place, between, points_of, rectangle_around

BRASS, HANDLE = (0xd8, 0xb0, 0x4a), (0xd7, 0x26, 0x3d)
CAP, WOOD = (0x20, 0xa0, 0x40), (0x7a, 0x5c, 0x3e)


def find_housing(sensor, aux):
    """Returns the place of the housing: the middle of the heads of its screws, two by two."""
    return find("screws", BRASS, 1.55, sensor, aux)


def find_screwdriver(sensor, aux):
    """Returns the place of the screwdriver, which stands in its holder."""
    return find("screwdriver", HANDLE, 2.6, sensor, aux)


def find_spare(sensor, aux):
    """Returns the place of a good fuse that stands on the table."""
    return find("good fuse", CAP, 0.8, sensor, aux)


def find_stand(sensor, aux):
    """Returns the place of the stand for the cover."""
    return find("stand", WOOD, 0.8, sensor, aux)


def find_bin(sensor, aux):
    """Returns the place of the bin."""
    return find("bin", WOOD, 0.6, sensor, aux)


def find(name, color, height, sensor, aux):
    """Returns the place of what has upper faces of this color at a height. Its depth is its
    shorter side."""
    faces = between(points_of(color, sensor, aux), height - 0.03, height + 0.03)
    if len(faces) < 30:
        raise RuntimeError(f"no {name} is visible")
    middle, (_, depth_axis), _ = rectangle_around(faces)
    return Place(middle, depth_axis)
