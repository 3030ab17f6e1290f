"""Baxter's arm, each link in its own frame: x forward along the joint's common normal, z along the joint, meters.

The bottles (s0, e0, w0) stand along z and end in a ring about y; the forks (s1, e1, w1) are two cheeks about z, then
a stub along x. Sizes are our own measurements of the real robot's proportions.
"""

import math

import numpy as np

from .frames import ALONG_MINUS_Y, ALONG_X
from .glb import Piece
from .materials import BRICK_RED, CHARCOAL, PALE, RUBBER_BLACK, STEEL
from .modeling import (Cut, Pose, axes, circle, extrusion, joined, lathe, loft, mirrored, on_both_sides, placed, rounded,
                       section_at, skin, stadium, superellipse, translation, tube, upright)

BOTTLE_SIDES, DISC_SIDES = 22, 26


def bottle(cuts):
    return loft([Cut(*cut) for cut in cuts], BOTTLE_SIDES)


def web(outline, y_min, y_max, edge_radius):
    """A flat body around the next joint, drawn in (x, z), from y_min to y_max."""
    return placed(ALONG_MINUS_Y, extrusion(outline, -y_max, -y_min, edge_radius, 1))


def ring_body(x, z, radius, y_min, y_max):
    return web([(x + dx, z + dz) for dx, dz in circle(radius, DISC_SIDES)], y_min, y_max, 0.003)


def cheek(radius, flank, x_end):
    """A cheek of a fork: round about z, with straight flanks, half as wide as `flank`, to where the stub begins."""
    start, sides = math.asin(flank / radius), 22  # where the flanks leave the circle
    outline = []
    for k in range(sides + 1):
        angle = start + (2 * math.pi - 2 * start) * k / sides
        outline.append((radius * math.cos(angle), radius * math.sin(angle)))
    return outline + [(x_end, -flank), (x_end, flank)]


def stub(cuts):
    """From the cheeks of a fork to the round flange of the next bottle: cuts in (y, z), along x."""
    return placed(ALONG_X, bottle(cuts))


def square(at, half_y, half_z, exponent):
    return at, -half_y, half_y, -half_z, half_z, exponent


def dished_disc(radius, z_min, z_max):
    """The black disc that covers a cheek: edge round, face dished within a rim, its outer face towards +z."""
    return lathe([(radius, z_min), (radius, z_max - 0.008), (radius - 0.0025, z_max - 0.0025), (radius - 0.008, z_max),
                  (radius - 0.015, z_max), (radius - 0.019, z_max - 0.0045), (0, z_max - 0.0045)], DISC_SIDES)


def turned_over(surface):
    """What lies at -z as its image lies at +z."""
    return placed(Pose(np.diag([1.0, -1, -1])), surface)


def coil(start, end, radius, rings):
    """A coil spring, as the rings one sees of it."""
    length = float(np.linalg.norm(end - start))
    pitch, profile = length / rings, [(0, 0)]
    for k in range(rings):
        profile += [(radius - 0.003, pitch * k), (radius, pitch * (k + 0.5))]
    return placed(upright(start, end), lathe(profile + [(radius - 0.003, length), (0, length)], 10))


def springs():
    """The coil springs of a shoulder, and what holds them."""
    coils, boots = [], []
    for side in (-1, 1):
        foot, middle, head = (np.array(p) for p in [(0.046, side * 0.118, 0.118), (0.088, side * 0.118, 0.265),
                                                    (0.122, side * 0.118, 0.362)])
        coils.append(coil(foot, middle, 0.0095, 9))
        length = float(np.linalg.norm(head - middle))
        boots.append(placed(upright(middle, head),
                            lathe([(0, 0), (0.011, 0), (0.0145, 0.012), (0.0195, 0.03), (0.020, length - 0.02),
                                   (0.017, length - 0.006), (0.011, length), (0, length)], 18)))
        boots.append(placed(upright(foot - (0.004, 0, 0.012), foot),
                            lathe([(0, 0), (0.014, 0), (0.014, 0.022), (0, 0.022)], 14)))
    return coils, boots


def bumper():
    """The left half of the bumper on the elbow's back edge: a little larger than the bottle, open in the middle."""
    gap, arc, sections = 0.005, 9, []
    for z, x_min, half_y, x_front in [(0.250, -0.0915, 0.0765, -0.062), (0.251, -0.0930, 0.0780, -0.060),
                                      (0.275, -0.0925, 0.0770, -0.048), (0.288, -0.0900, 0.0740, -0.043),
                                      (0.297, -0.0845, 0.0680, -0.040), (0.3025, -0.0765, 0.0600, -0.040),
                                      (0.3045, -0.0680, 0.0500, -0.041)]:
        # Each cut is one of the whole elbow; only its rear quarter is used.
        whole = superellipse(Cut(z, x_min, -0.004, -half_y, half_y, 3), 4 * arc)
        outline = [(x_front, gap), (x_front, whole[arc][1])]
        outline += [(min(x, x_front), max(y, gap)) for x, y in whole[arc + 1:2 * arc + 1]]
        sections.append(section_at(outline, z))
    return skin(sections)


def on_back(outline, z, proud, edge_radius):
    """Something flat on the back of the forearm, drawn with x along the arm; `proud` is its face."""
    pose = translation(0, 0, z) @ axes((0, 0, 1), (0, 1, 0), (-1, 0, 0))
    return placed(pose, extrusion(outline, 0.050, proud, edge_radius, 1))


def upper_shoulder():
    shell = bottle([(0.031, -0.076, 0.076, -0.0755, 0.0755, 2), (0.064, -0.076, 0.075, -0.075, 0.075, 2.1),
                    (0.094, -0.081, 0.068, -0.0745, 0.0745, 2.3), (0.118, -0.084, 0.046, -0.075, 0.075, 2.5),
                    (0.150, -0.086, 0.041, -0.076, 0.076, 2.5), (0.182, -0.088, 0.041, -0.078, 0.078, 2.6),
                    (0.198, -0.088, 0.034, -0.0795, 0.0795, 2.8), (0.206, -0.088, 0.010, -0.080, 0.080, 3),
                    (0.230, -0.088, -0.002, -0.081, 0.081, 3), (0.265, -0.088, -0.006, -0.081, 0.081, 3),
                    (0.283, -0.0865, -0.008, -0.079, 0.079, 3), (0.295, -0.082, -0.012, -0.073, 0.073, 3),
                    (0.302, -0.074, -0.018, -0.062, 0.062, 3), (0.305, -0.062, -0.026, -0.048, 0.048, 3)])
    ring = web([(-0.045, 0.17), (0.035, 0.17), (0.050, 0.21), (0.045, 0.330), (-0.045, 0.300)], -0.0355, 0.0355, 0.003)
    wedge = extrusion([(0.028, -0.094), (0.052, -0.094), (0.056, -0.05), (0.056, 0.05), (0.052, 0.094), (0.028, 0.094)],
                      0.117, 0.140, 0.002, 1)
    wedge_top = skin([section_at([(0.03, -0.08), (0.054, -0.08), (0.054, 0.08), (0.03, 0.08)], 0.138),
                      section_at([(0.03, -0.04), (0.048, -0.04), (0.048, 0.04), (0.03, 0.04)], 0.186)])
    coils, boots = springs()
    axle = tube([(0.046, -0.135, 0.121), (0.046, 0.135, 0.121)], 0.0075, 0, 12)
    return [Piece(CHARCOAL, joined([shell, ring, ring_body(0.069, 0.27035, 0.066, -0.0355, 0.0355)])),
            Piece(RUBBER_BLACK, joined([wedge, wedge_top, *boots, axle])), Piece(STEEL, joined(coils))]


def lower_shoulder():
    outline = cheek(0.073, 0.061, 0.080)
    end = stub([square(0.0735, 0.0609, 0.0970, 8), square(0.090, 0.0635, 0.0970, 6), square(0.100, 0.067, 0.0955, 4),
                square(0.107, 0.071, 0.0900, 3), square(0.113, 0.075, 0.0800, 2.2), square(0.116, 0.076, 0.076, 2),
                square(0.121, 0.076, 0.076, 2)])
    return [Piece(BRICK_RED, joined([extrusion(outline, 0.0362, 0.0975, 0.006, 2),
                                     extrusion(outline, -0.0975, -0.0362, 0.006, 2), end]))]


def upper_elbow():
    shell = bottle([(0.0124, -0.0757, 0.0757, -0.0757, 0.0757, 2), (0.016, -0.0765, 0.0765, -0.0765, 0.0765, 2),
                    (0.040, -0.079, 0.077, -0.078, 0.078, 2), (0.070, -0.083, 0.078, -0.079, 0.079, 2.1),
                    (0.097, -0.085, 0.077, -0.079, 0.079, 2.2), (0.108, -0.086, 0.073, -0.079, 0.079, 2.2),
                    (0.142, -0.088, 0.057, -0.079, 0.079, 2.4), (0.170, -0.089, 0.044, -0.078, 0.078, 2.5),
                    (0.186, -0.089, 0.036, -0.078, 0.078, 2.6), (0.194, -0.089, 0.012, -0.0775, 0.0775, 3),
                    (0.215, -0.0895, 0.000, -0.077, 0.077, 3), (0.250, -0.0905, -0.004, -0.0755, 0.0755, 3),
                    (0.275, -0.090, -0.006, -0.0745, 0.0745, 3), (0.291, -0.086, -0.010, -0.0695, 0.0695, 3),
                    (0.299, -0.077, -0.018, -0.060, 0.060, 3), (0.302, -0.066, -0.026, -0.048, 0.048, 3)])
    ring = web([(-0.045, 0.16), (0.038, 0.165), (0.060, 0.21), (0.050, 0.322), (-0.045, 0.298)], -0.035, 0.035, 0.003)
    return [Piece(BRICK_RED, joined([shell, ring, ring_body(0.069, 0.26242, 0.0635, -0.035, 0.035)])),
            Piece(RUBBER_BLACK, joined(on_both_sides(bumper())))]


def lower_elbow():
    outline = cheek(0.068, 0.0555, 0.070)
    end = stub([square(0.0640, 0.0554, 0.0802, 8), square(0.072, 0.059, 0.0800, 5), square(0.079, 0.064, 0.0780, 3),
                square(0.086, 0.069, 0.0725, 2.2), square(0.089, 0.070, 0.070, 2), square(0.0925, 0.070, 0.070, 2)])
    disc = dished_disc(0.0691, 0.080, 0.0946)
    return [Piece(BRICK_RED, joined([extrusion(outline, 0.0357, 0.0806, 0.002, 1),
                                     extrusion(outline, -0.0806, -0.0357, 0.002, 1), end])),
            Piece(RUBBER_BLACK, joined([disc, turned_over(disc)]))]


def upper_forearm():
    shell = bottle([(-0.018, -0.0690, 0.0690, -0.0690, 0.0690, 2), (-0.013, -0.0700, 0.0700, -0.0700, 0.0700, 2),
                    (0.011, -0.072, 0.072, -0.072, 0.072, 2), (0.060, -0.0735, 0.072, -0.074, 0.074, 2.1),
                    (0.105, -0.074, 0.0705, -0.074, 0.074, 2.2), (0.140, -0.074, 0.0665, -0.0735, 0.0735, 2.3),
                    (0.160, -0.073, 0.058, -0.0725, 0.0725, 2.4), (0.178, -0.071, 0.046, -0.071, 0.071, 2.6),
                    (0.190, -0.069, 0.038, -0.069, 0.069, 2.8), (0.200, -0.063, 0.036, -0.063, 0.063, 3),
                    (0.207, -0.054, 0.035, -0.056, 0.056, 3), (0.210, -0.045, 0.034, -0.050, 0.050, 3)])
    ring = web([(-0.037, 0.19), (0.033, 0.19), (0.040, 0.222), (0.060, 0.262), (-0.042, 0.262), (-0.039, 0.225)],
               -0.031, 0.015, 0.002)
    pad, button = 0.1157, [(x, 1.35 * y) for x, y in circle(0.011, 14)]
    return [Piece(BRICK_RED, joined([shell, ring, ring_body(0.010, 0.2707, 0.053, -0.031, 0.015)])),
            Piece(PALE, on_back(stadium(0.113, 0.053, 24), pad, 0.0768, 0.002)),
            Piece(RUBBER_BLACK, on_back(stadium(0.099, 0.039, 24), pad, 0.0778, 0)),
            Piece(STEEL, joined([on_back(button, 0.0805, 0.0792, 0.001), on_back(button, 0.151, 0.0792, 0.001),
                                 on_back(circle(0.0175, 18), pad, 0.0905, 0.004)]))]


def lower_forearm():
    outline = cheek(0.058, 0.050, 0.054)
    end = stub([(0.0535, -0.0500, 0.0500, -0.0660, 0.0655, 5), (0.0580, -0.0545, 0.0555, -0.0668, 0.0663, 3.5),
                (0.0700, -0.0575, 0.0595, -0.0662, 0.0662, 2.6), (0.0850, -0.0585, 0.0615, -0.0655, 0.0655, 2.3),
                (0.105, -0.059, 0.062, -0.065, 0.065, 2.1), (0.125, -0.0585, 0.0605, -0.0635, 0.0635, 2),
                (0.145, -0.058, 0.059, -0.061, 0.061, 2), (0.164, -0.057, 0.057, -0.0575, 0.0575, 2),
                (0.168, -0.056, 0.056, -0.056, 0.056, 2)])
    return [Piece(CHARCOAL, joined([extrusion(outline, 0.0157, 0.0700, 0.002, 1),
                                    extrusion(outline, -0.0730, -0.0317, 0.002, 1), end])),
            Piece(RUBBER_BLACK, joined([dished_disc(0.0591, 0.068, 0.0826),
                                        turned_over(dished_disc(0.0591, 0.071, 0.0856))]))]


def wrist():
    """Up to the tool flange."""
    def plate(x_min, x_max, half_y, radius):
        return rounded([(x_min, -half_y), (x_max, -half_y), (x_max, half_y), (x_min, half_y)], radius, 5)

    cuff = extrusion(plate(-0.038, 0.054, 0.0385, 0.030), 0.0565, 0.1100, 0.003, 1)
    pod = extrusion(plate(0.023, 0.055, 0.037, 0.010), 0.100, 0.1390, 0.005, 1)
    lens, window = translation(0.038, 0.012, 0.1385), translation(0.038, -0.018, 0)
    return [Piece(PALE, joined([lathe([(0.0565, 0.0535), (0.0565, 0.0570)], DISC_SIDES),
                                placed(lens, lathe([(0.0075, 0), (0.0075, 0.0012)], 16))])),
            Piece(RUBBER_BLACK, joined([cuff, pod, placed(lens, lathe([(0.0055, 0), (0.0055, 0.0018)], 16))])),
            Piece(STEEL, placed(window, extrusion(stadium(0.014, 0.007, 16), 0.13, 0.1396)))]
