"""Closed surfaces made by rule: turned, extruded, lofted and bent bodies, as lists of triangles.

The counterpart of src/mesh/modeling.h for what is made once and kept as data. Lengths are in meters. Triangles run
counter-clockwise seen from outside; neighbors share corners, so that a renderer finds which edges are smooth.
"""

import math
from dataclasses import dataclass, field

import numpy as np

FULL_TURN = 2 * math.pi


@dataclass
class Surface:
    vertices: list = field(default_factory=list)  # arrays of x, y, z
    triangles: list = field(default_factory=list)  # three indices each


@dataclass(frozen=True)
class Cut:
    """A superellipse |x/a|^n + |y/b|^n = 1 at a height; exponent 2 is an ellipse, 4 nearly a rectangle."""

    z: float
    x_min: float
    x_max: float
    y_min: float
    y_max: float
    exponent: float = 2


@dataclass(frozen=True)
class Pose:
    """X_AB: the pose of frame B in frame A; `pose @ p` and `pose @ pose` compose."""

    rotation: np.ndarray = field(default_factory=lambda: np.eye(3))
    position: np.ndarray = field(default_factory=lambda: np.zeros(3))

    def __matmul__(self, other):
        if isinstance(other, Pose):
            return Pose(self.rotation @ other.rotation, self.rotation @ other.position + self.position)
        return self.rotation @ other + self.position


def translation(x, y, z):
    return Pose(position=np.array([x, y, z], float))


def axes(x, y, z):
    """The rotation whose columns are these axes."""
    return Pose(np.array([x, y, z], float).T)


def about_z(angle):
    c, s = math.cos(angle), math.sin(angle)
    return Pose(np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]))


def unit(v):
    return v / np.linalg.norm(v)


def any_perpendicular(v):
    """A unit vector perpendicular to `v`, along the plane of its two largest components."""
    x, y, z = v
    if abs(x) > 1e-12 * abs(z) or abs(y) > 1e-12 * abs(z):
        return np.array([-y, x, 0]) / math.hypot(x, y)
    return np.array([0, -z, y]) / math.hypot(y, z)


def upright(start, end):
    """A frame at `start` whose z axis points to `end`, turned by the shortest rotation from the parent's z axis."""
    z, to = np.array([0.0, 0, 1]), unit(np.asarray(end, float) - start)
    axis, c = np.cross(z, to), float(z @ to)
    k = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    return Pose(np.eye(3) + k + k @ k / (1 + c), np.asarray(start, float))  # Rodrigues' formula


# Outlines: closed lines in the xy plane, counter-clockwise, as lists of (x, y).


def circle(radius, sides):
    return [(radius * math.cos(FULL_TURN * k / sides), radius * math.sin(FULL_TURN * k / sides)) for k in range(sides)]


def rectangle(length, width):
    x, y = length / 2, width / 2
    return [(-x, -y), (x, -y), (x, y), (-x, y)]


def stadium(length, width, sides):
    """Two half circles joined by straight lines: `length` along x, `width` along y."""
    radius, shift, half = width / 2, length / 2 - width / 2, sides // 2
    outline = []
    for end in (1, -1):
        for k in range(half + 1):
            angle = math.pi * (k / half - 0.5)
            outline.append((end * (shift + radius * math.cos(angle)), end * radius * math.sin(angle)))
    return outline


def superellipse(cut, sides):
    def bulged(fraction):
        return math.copysign(abs(fraction) ** (2 / cut.exponent), fraction)

    outline = []
    for k in range(sides):
        angle = FULL_TURN * k / sides
        outline.append(((cut.x_min + cut.x_max) / 2 + (cut.x_max - cut.x_min) / 2 * bulged(math.cos(angle)),
                        (cut.y_min + cut.y_max) / 2 + (cut.y_max - cut.y_min) / 2 * bulged(math.sin(angle))))
    return outline


def corner_turn(u, v):
    """By how much a line turns where it comes from `u` and continues to `v`, both unit vectors away from the corner."""
    return math.pi - math.acos(min(1.0, max(-1.0, float(u @ v))))


def rounded(outline, radius, corner_sides):
    """The outline with each corner replaced by a curve that takes no more than half of a side.

    A quadratic Bezier curve: close to the arc, and the same for every angle.
    """
    points = [np.asarray(p, float) for p in outline]
    result = []
    for i, corner in enumerate(points):
        back, ahead = points[i - 1] - corner, points[(i + 1) % len(points)] - corner
        u, v = unit(back), unit(ahead)
        reach = min(radius * math.tan(corner_turn(u, v) / 2), 0.499 * min(np.linalg.norm(back), np.linalg.norm(ahead)))
        for k in range(corner_sides + 1):
            t = k / corner_sides
            result.append(tuple(corner + (1 - t) ** 2 * reach * u + t * t * reach * v))
    return result


def inset(outline, distance):
    """The outline with each side moved inwards by `distance`; as many corners."""
    points = [np.asarray(p, float) for p in outline]
    result = []
    for i, p in enumerate(points):
        before, after = unit(p - points[i - 1]), unit(points[(i + 1) % len(points)] - p)
        # Along the bisector, far enough to be `distance` from both sides; no further at sharp tips.
        along = before + after
        inwards = np.array([-along[1], along[0]])
        result.append(tuple(p + distance * inwards / max(0.5, inwards @ inwards / 2)))
    return result


# Sections: closed lines in space, as lists of points.


def section_at(outline, z):
    return [np.array([x, y, z]) for x, y in outline]


def triangulated(section):
    """A flat section, possibly concave, as triangles of its corners, by cutting ears.

    Of the ears the one with the shortest cut goes first: slim triangles are drawn badly.
    Source: G. H. Meisters, "Polygons Have Ears" (1975).
    """
    normal = sum(np.cross(p, section[(i + 1) % len(section)]) for i, p in enumerate(section))  # Newell's method
    x = any_perpendicular(normal)
    y = np.cross(unit(normal), x)
    flat = [(float(x @ p), float(y @ p)) for p in section]

    def turn(a, b, c):
        return (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0])

    def is_ear(a, b, c, rest):
        if not turn(a, b, c) > 0:
            return False
        return not any(p not in (a, b, c) and turn(a, b, p) >= 0 and turn(b, c, p) >= 0 and turn(c, a, p) >= 0
                       for p in (flat[k] for k in rest))

    rest, triangles = list(range(len(section))), []
    while len(rest) > 2:
        best, shortest = 0, math.inf
        for i in range(len(rest)):
            a, b, c = flat[rest[i - 1]], flat[rest[i]], flat[rest[(i + 1) % len(rest)]]
            cut = math.dist(a, c)
            if cut < shortest and is_ear(a, b, c, rest):
                best, shortest = i, cut
        triangles.append((rest[best - 1], rest[best], rest[(best + 1) % len(rest)]))
        del rest[best]
    return triangles


# Surfaces.


def skin(sections):
    """The skin over sections one after the other, closed at both ends.

    A section whose points coincide is a tip. All have as many points and run counter-clockwise against the direction
    in which they follow one another.
    """
    assert len(sections) >= 2 and len({len(section) for section in sections}) == 1
    surface = Surface()

    def add(section):
        is_tip = all(np.array_equal(p, section[0]) for p in section)
        first, count = len(surface.vertices), 1 if is_tip else len(section)
        surface.vertices += section[:count]
        return first, count

    def close(section, row, is_top):
        first, count = row
        if count == 1:
            return
        for a, b, c in triangulated(section):
            if not is_top:
                b, c = c, b
            surface.triangles.append((first + a, first + b, first + c))

    row = add(sections[0])
    close(sections[0], row, False)
    for section in sections[1:]:
        following = add(section)
        for k in range(max(row[1], following[1])):
            a, b = row[0] + k % row[1], row[0] + (k + 1) % row[1]
            c, d = following[0] + (k + 1) % following[1], following[0] + k % following[1]
            if a != b:
                surface.triangles.append((a, b, c))
            if c != d:
                surface.triangles.append((a, c, d))
        row = following
    close(sections[-1], row, True)
    return surface


def lathe(profile, sides):
    """A body turned about the z axis; the profile is a list of (radius, z) with growing z."""
    return skin([section_at(circle(radius, sides), z) for radius, z in profile])


def loft(cuts, sides):
    return skin([section_at(superellipse(cut, sides), cut.z) for cut in cuts])


def extrusion(outline, z_min, z_max, edge_radius=0, edge_sides=3):
    """The outline moved along z, its lower and upper edges rounded by `edge_sides` chords each."""
    if edge_radius <= 0:
        return skin([section_at(outline, z_min), section_at(outline, z_max)])
    sections = []
    for end in (0, 1):
        for k in range(edge_sides + 1):
            angle = math.pi / 2 * (k if end == 0 else edge_sides - k) / edge_sides
            rise = edge_radius * (1 - math.cos(angle))
            sections.append(section_at(inset(outline, edge_radius * (1 - math.sin(angle))),
                                       z_min + rise if end == 0 else z_max - rise))
    return skin(sections)


def rounded_box(size, corner_radius, edge_radius):
    """A cuboid about the origin, its edges along z rounded by `corner_radius`, the others by `edge_radius`."""
    x, y, z = size
    return extrusion(rounded(rectangle(x, y), corner_radius, 3), -z / 2, z / 2, edge_radius, 1)


def bent(path, bend_radius):
    """The path with its corners replaced by arcs, where there is room for them."""
    points = [np.asarray(p, float) for p in path]
    line = [points[0]]
    for i in range(1, len(points) - 1):
        back, ahead = points[i - 1] - points[i], points[i + 1] - points[i]
        u, v = unit(back), unit(ahead)
        turn = corner_turn(u, v)
        if turn < 0.01:
            line.append(points[i])
            continue
        reach = min(bend_radius * math.tan(turn / 2), 0.499 * min(np.linalg.norm(back), np.linalg.norm(ahead)))
        # On the arc between the touching points, about its center.
        radius = reach / math.tan(turn / 2)
        center = points[i] + unit(u + v) * math.hypot(reach, radius)
        start = points[i] + reach * u - center
        chords = max(1, math.ceil(turn / (math.pi / 8)))
        for k in range(chords + 1):
            angle = turn * k / chords
            line.append(center + math.cos(angle) * start - radius * math.sin(angle) * u)
    return line + [points[-1]]


def tube(path, radius, bend_radius, sides):
    """A rod of round section along a path, its bends rounded by `bend_radius`."""
    line, sections, side = bent(path, bend_radius), [], None
    for i, p in enumerate(line):
        # Square to the mean direction: equal halves of the bend on both sides.
        along = np.zeros(3)
        if i > 0:
            along = along + unit(p - line[i - 1])
        if i + 1 < len(line):
            along = along + unit(line[i + 1] - p)
        along = unit(along)
        # Turned no more about the line than needed, so that the rows of corners do not wind.
        if side is None:
            side = any_perpendicular(along)
        side = unit(side - (side @ along) * along)
        up = np.cross(along, side)
        sections.append([p + x * side + y * up for x, y in circle(radius, sides)])
    return skin(sections)


def flat_piece(outline, z):
    """One side of a flat piece, seen from +z only: open, the one exception here."""
    section = section_at(outline, z)
    return Surface(section, triangulated(section))


def placed(pose, surface):
    return Surface([pose @ p for p in surface.vertices], surface.triangles)


def mirrored(surface):
    """Its image in the mirror y = 0."""
    return Surface([p * (1, -1, 1) for p in surface.vertices], [(a, c, b) for a, b, c in surface.triangles])


def on_both_sides(left):
    return [left, mirrored(left)]


def joined(surfaces):
    """Several surfaces as one; they may reach into each other."""
    everything = Surface()
    for surface in surfaces:
        first = len(everything.vertices)
        everything.vertices += surface.vertices
        everything.triangles += [(first + a, first + b, first + c) for a, b, c in surface.triangles]
    return everything
