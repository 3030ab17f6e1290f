"""Baxter's head in its link's frame, and the faces its screen shows: x forward, z up, meters."""

import math
from dataclasses import dataclass

from .glb import Piece
from .materials import BEZEL, BRICK_RED, CHARCOAL
from .modeling import (Surface, axes, circle, extrusion, flat_piece, joined, lathe, placed, rectangle, rounded,
                       section_at, skin, translation)

PITCH = math.radians(25.3)
# The middle of the screen's slab: x to the robot's left, y up along the slab, z out of it, 25.3 degrees below the horizon.
SLAB = translation(0.104, 0, -0.011) @ axes((0, 1, 0), (math.sin(PITCH), 0, math.cos(PITCH)),
                                            (math.cos(PITCH), 0, -math.sin(PITCH)))


def screen_outline(width, height, corner_radius):
    return rounded(rectangle(width, height), corner_radius, 4)


def slab():
    """The red slab; its back is domed."""
    return skin([section_at(screen_outline(width, height, 0.024), z) for width, height, z in [
        (0.150, 0.090, -0.0205), (0.215, 0.140, -0.0190), (0.246, 0.168, -0.0160), (0.260, 0.181, -0.0110),
        (0.266, 0.187, -0.0040), (0.268, 0.189, 0.0040), (0.2665, 0.1875, 0.0100), (0.262, 0.183, 0.0140),
        (0.2555, 0.1765, 0.0158), (0.248, 0.169, 0.0158)]])


def bowl():
    """Below the cap; the cap itself is the torso's."""
    return lathe([(0, -0.066), (0.028, -0.065), (0.044, -0.0605), (0.0535, -0.054), (0.0605, -0.046), (0.0645, -0.037),
                  (0.0665, -0.025), (0.0690, -0.013), (0.0720, 0.007), (0.0745, 0.030)], 32)


def head():
    boss = placed(SLAB, extrusion(screen_outline(0.052, 0.044, 0.008), -0.075, -0.015, 0.002, 1))
    bezel = placed(SLAB, extrusion(screen_outline(0.2475, 0.1685, 0.014), 0.012, 0.0164))
    return [Piece(CHARCOAL, joined([bowl(), boss])), Piece(BRICK_RED, placed(SLAB, slab())), Piece(BEZEL, bezel)]


# Faces. They are drawn on the display with x away from the nose; the eye at -x is the mirror image. Lengths of an eye
# are in its own frame: y up.

WHITE, INK, IRIS = (1, 1, 1), (0.16, 0.17, 0.20), (0.25, 0.45, 0.58)
DISPLAY = SLAB @ translation(0, 0, 0.0166)
LAYER = 0.0004  # between one layer of the drawing and the next
EYE_X, EYE_Y = 0.054, -0.016  # of the eyes' middle on the display
HALF_WIDTH, HALF_HEIGHT = 0.0375, 0.0330


@dataclass(frozen=True)
class Eye:
    upper_lid: float = 1  # where the lids cut the eye: 1 is its top, -1 its bottom
    lower_lid: float = -1
    lid_slant: float = 0  # rise of the upper lid per meter away from the nose
    gaze: tuple = (0, 0)  # middle of the pupil
    pupil: float = 0.0098  # its radius
    brow_height: float = 0.050  # of its middle
    brow_slant: float = 0  # its rise per meter away from the nose
    brow_arch: float = 0.004  # by how much its middle is above its ends


@dataclass(frozen=True)
class Face:
    background: tuple
    left: Eye  # as an observer of the face sees it
    right: Eye
    is_smiling: bool = False  # both eyes are closed, and laugh


def symmetric(background, eye, **options):
    return Face(background, eye, eye, **options)


FACES = {
    "idle": symmetric((0.93, 0.94, 0.96), Eye(upper_lid=0.22, lower_lid=-0.92, gaze=(0, -0.009), brow_height=0.0435,
                                              brow_slant=-0.10)),
    "watching": symmetric((1.00, 1.00, 0.98), Eye(gaze=(-0.002, -0.008), pupil=0.0115, brow_height=0.0555,
                                                  brow_slant=-0.05, brow_arch=0.0075)),
    "working": symmetric((0.78, 0.92, 1.00), Eye(upper_lid=0.50, lower_lid=-0.86, lid_slant=0.06, gaze=(-0.003, -0.0115),
                                                 brow_height=0.0455, brow_slant=0.09, brow_arch=0.0035)),
    "puzzled": Face((1.00, 0.86, 0.50),
                    Eye(upper_lid=0.25, lower_lid=-0.62, lid_slant=0.15, gaze=(0.006, 0.000), pupil=0.0080,
                        brow_height=0.0390, brow_slant=0.20, brow_arch=0.001),
                    Eye(gaze=(-0.006, 0.003), pupil=0.0080, brow_height=0.0575, brow_slant=-0.38, brow_arch=0.006)),
    "done": symmetric((0.74, 0.98, 0.76), Eye(brow_height=0.0500, brow_arch=0.0085), is_smiling=True),
}


def left_of(a, b, outline):
    """The part of a convex outline to the left of the line through `a` and `b`."""
    def side(p):
        return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])

    kept = []
    for i, p in enumerate(outline):
        q = outline[(i + 1) % len(outline)]
        at_p, at_q = side(p), side(q)
        if at_p >= 0:
            kept.append(p)
        if (at_p >= 0) != (at_q >= 0):
            t = at_p / (at_p - at_q)
            kept.append((p[0] + (q[0] - p[0]) * t, p[1] + (q[1] - p[1]) * t))
    return kept


def intersection(a, b):
    """The intersection of two convex outlines."""
    for i, p in enumerate(a):
        b = left_of(p, a[(i + 1) % len(a)], b)
    return b


def opening(eye, rim):
    """The opening between the lids, `rim` larger than the white of the eye all around."""
    outline = [(x * (HALF_WIDTH + rim), y * (HALF_HEIGHT + rim)) for x, y in circle(1, 40)]
    upper = eye.upper_lid * HALF_HEIGHT + 1.6 * rim  # lashes: the upper rim is bolder
    lower = eye.lower_lid * HALF_HEIGHT - rim
    outline = left_of((1, upper + eye.lid_slant), (-1, upper - eye.lid_slant), outline)
    return left_of((-1, lower), (1, lower), outline)


def disc(center, radius):
    return [(center[0] + x, center[1] + y) for x, y in circle(radius, 28)]


def stroke(length, width, slant, arch):
    """A bold line, curved upwards by `arch` in the middle, with round ends."""
    parts, end_sides, line, outline = 12, 6, [], []
    for k in range(parts + 1):
        t = 2 * k / parts - 1
        line.append((t * length / 2, slant * t * length / 2 + arch * (1 - t * t)))

    def offset(k, distance):
        x, y = line[k + 1][0] - line[k - 1][0], line[k + 1][1] - line[k - 1][1]
        norm = math.hypot(x, y)
        return line[k][0] - distance * y / norm, line[k][1] + distance * x / norm

    def end(center, inner):
        start = math.atan2(center[1] - inner[1], center[0] - inner[0]) - math.pi / 2
        for k in range(end_sides + 1):
            angle = start + math.pi * k / end_sides
            yield center[0] + width / 2 * math.cos(angle), center[1] + width / 2 * math.sin(angle)

    outline += [offset(k, -width / 2) for k in range(1, parts)]
    outline += end(line[-1], line[parts - 1])
    outline += [offset(k, width / 2) for k in range(parts - 1, 0, -1)]
    return outline + list(end(line[0], line[1]))


class Painting:
    """Collects the drawn outlines by color."""

    def __init__(self):
        self.paints = {INK: [], WHITE: [], IRIS: []}

    def add(self, color, outline, layer, side):
        if len(outline) < 3:
            return  # hidden by a lid
        piece = flat_piece(outline, LAYER * layer)
        vertices = [(p + (EYE_X, 0, 0)) * (side, 1, 1) + (0, EYE_Y, 0) for p in piece.vertices]
        triangles = piece.triangles if side > 0 else [(a, c, b) for a, b, c in piece.triangles]
        self.paints[color].append(placed(DISPLAY, Surface(vertices, triangles)))

    def add_eye(self, eye, side):
        white = opening(eye, 0)
        self.add(INK, opening(eye, 0.0032), 1, side)
        self.add(WHITE, white, 2, side)
        self.add(IRIS, intersection(white, disc(eye.gaze, 0.0195)), 3, side)
        self.add(INK, intersection(white, disc(eye.gaze, eye.pupil)), 4, side)
        # Light comes from above: the same side in both eyes.
        glint = (eye.gaze[0] - side * 0.0068, eye.gaze[1] + 0.0075)
        self.add(WHITE, intersection(white, disc(glint, 0.0042)), 5, side)

    def add_smile(self, side):
        self.add(INK, [(x, y - 0.010) for x, y in stroke(0.062, 0.0085, 0, 0.026)], 1, side)

    def add_brow(self, eye, side):
        brow = stroke(0.060, 0.0088, eye.brow_slant, eye.brow_arch)
        self.add(INK, [(x, y + eye.brow_height) for x, y in brow], 1, side)


def face(name):
    drawing, painting = FACES[name], Painting()
    for side, eye in ((-1, drawing.left), (1, drawing.right)):
        if drawing.is_smiling:
            painting.add_smile(side)
        else:
            painting.add_eye(eye, side)
        painting.add_brow(eye, side)
    display = placed(DISPLAY, flat_piece(screen_outline(0.224, 0.148, 0.008), 0))
    return [Piece(drawing.background, display),
            *(Piece(color, joined(paint)) for color, paint in painting.paints.items() if paint)]
