"""Aligns a scene with a picture of the demonstration, which has no depth: what the eye sees in the scene, moved to
where it was in the demonstration, must look there as it does in the picture."""

import math
from dataclasses import dataclass

import numpy as np

from constants import ALIGNMENT as C
from see.eye import onto_plane, pixels_of
from see.surfaces import is_alike, references
from things.areas import rotated


@dataclass
class Alignment:
    """How a scene lies in the demonstration: a point p of it, x y, was at place + p rotated by angle [rad]."""

    angle: float
    place: np.ndarray  # x y [units]

    def moved(self, points):
        """Returns where points of the scene were in the demonstration, Nx3."""
        return np.column_stack([rotated(points[:, :2].T, self.angle).T + self.place, points[:, 2]])


def agreement(surface, alignment, picture, eye):
    """Returns the fraction of a Surface that looks in a picture of the demonstration as it does in the scene."""
    row, column, inside = pixels_of(alignment.moved(surface.points), eye, picture)
    return (is_alike(picture[row, column], surface.colors) & inside).mean()


def align(surface, picture, eye, pixels):
    """Finds the Alignment of a scene with a picture of the demonstration around some pixels (rows, columns), and
    its agreement. The pixels' most frequent colors are looked for in the scene: each point of such a color may be
    what one of the pixels shows."""
    found = [(0, None, None)]
    for row, column in references(picture, pixels):
        of_color = surface.part(is_alike(np.broadcast_to(picture[row, column], surface.colors.shape), surface.colors))
        for point in of_color.points[::max(1, len(of_color.points) // C.num_points)]:
            x, y, _ = onto_plane(np.array([row]), np.array([column]), eye, point[2])
            near = surface.around(point, C.radius, C.num_coarse)
            found += turns(near, point, np.array([x[0], y[0]]), picture, eye)
    found.sort(key=lambda it: -it[0])
    best = [refined(surface.around(point, C.radius, C.num_fine), it, point, picture, eye)
            for _, it, point in found[:C.num_refined] if it]
    return max(best, key=lambda it: it[0], default=(0, None))


def turns(surface, point, place, picture, eye):
    """Returns the Alignments with which a point of the scene was at a place, x y, and their agreements: rows of
    agreement, Alignment and point."""
    found = [Alignment(angle, place - rotated(point[:2], angle)) for angle in np.arange(0, 2 * math.pi, C.turn_rad)]
    points = np.concatenate([it.moved(surface.points) for it in found])
    row, column, inside = pixels_of(points, eye, picture)
    alike = is_alike(picture[row, column], np.tile(surface.colors, (len(found), 1))) & inside
    return [(score, it, point) for score, it in zip(alike.reshape(len(found), -1).mean(axis=1), found)]


def refined(surface, alignment, pivot, picture, eye):
    """Improves an Alignment by small displacements, and turns about a pivot: its agreement, and the Alignment."""
    best, step = agreement(surface, alignment, picture, eye), 1.0
    while step > C.finest:
        before = best
        for x, y, turn in np.vstack([np.eye(3), -np.eye(3)]) * step * [C.shift, C.shift, C.turn_rad / 2]:
            place = alignment.place + rotated(pivot[:2], alignment.angle) - rotated(pivot[:2], alignment.angle + turn)
            it = Alignment(alignment.angle + turn, place + [x, y])
            score = agreement(surface, it, picture, eye)
            if score > best:
                best, alignment = score, it
        if best == before:
            step /= 2
    return best, alignment
