"""Baxter's torso and pedestal, in the frames of these links: x forward, z up, meters.

Sizes are our own measurements of the real robot's proportions.
"""

import math

import numpy as np

from .frames import ALONG_MINUS_Y, ALONG_X
from .glb import Piece
from .materials import CHARCOAL, DARK_GRAY, RUBBER_BLACK, SCREEN_PRINT, STEEL
from .modeling import (Cut, about_z, axes, circle, extrusion, joined, lathe, loft, on_both_sides, placed, rectangle,
                       rounded, rounded_box, section_at, skin, stadium, translation, tube)


def both_halves(left):
    """The outline whose left half (y > 0) is given, from the front to the back."""
    return left + [(x, -y) for x, y in reversed(left) if y > 0]


def back_body():
    """The rucksack: flat flanks, round edges, a back that bulges most at shoulder height."""
    outline = rounded(both_halves([(-0.028, 0.118), (-0.048, 0.168), (-0.075, 0.1765), (-0.175, 0.172),
                                   (-0.204, 0.110), (-0.2045, 0.0)]), 0.03, 3)
    sections = []
    for z, inset, bulge in [(0.006, 0.030, 0), (0.016, 0.010, 0), (0.04, 0, 0), (0.25, 0, 0), (0.36, 0, 0.008),
                            (0.50, 0, 0.016), (0.530, 0.005, 0.013), (0.552, 0.018, 0.011), (0.563, 0.044, 0.010)]:
        section = []
        for x, y in outline:
            x -= bulge * max(0.0, -x - 0.1) / 0.1 * math.cos(7 * y)
            # Towards the middle by `inset`, in proportion, so that no edge folds over.
            section.append(np.array([x - inset * (x + 0.118) / 0.09, y - inset * y / 0.176, z]))
        sections.append(section)
    return skin(sections)


def keel():
    """The chest: a keel in front of the rucksack, its top sloping forward."""
    outline = rounded(both_halves([(0.127, 0.036), (0.114, 0.0645), (0.036, 0.0625), (-0.09, 0.0640)]), 0.016, 3)
    sections = [section_at(outline, 0.150)]
    for below, inset in [(0.026, 0), (0.014, 0.003), (0.006, 0.009), (0.001, 0.017), (0, 0.024)]:
        section = []
        for x, y in outline:
            x -= inset * (x - 0.018) / 0.108
            section.append(np.array([x, y * (1 - inset / 0.065), 0.584 - 0.26 * (x + 0.03) - below]))
        sections.append(section)
    return skin(sections)


def scoops():
    """Between keel and rucksack: they give the upper arms room."""
    outline = rounded(both_halves([(0.034, 0.050), (0.028, 0.064), (0.012, 0.070), (-0.008, 0.100), (-0.040, 0.163),
                                   (-0.070, 0.163)]), 0.02, 3)
    return extrusion(outline, 0.150, 0.553, 0.018, 2)


def shelf():
    """What the upper arms pass over, at both sides of the keel's foot."""
    outline = rounded(both_halves([(0.126, 0.052), (0.108, 0.098), (0.030, 0.140), (-0.04, 0.172), (-0.15, 0.172)]),
                      0.03, 3)
    return extrusion(outline, 0.14, 0.225, 0.018, 2)


def waist():
    outline = rounded(both_halves([(0.1275, 0.092), (0.112, 0.110), (0.02, 0.150), (-0.15, 0.150), (-0.19, 0.10)]),
                      0.02, 4)
    return extrusion(outline, 0.012, 0.19, 0.012, 1)


def shoulder_pod():
    """The left arm stands on it: a disc with a web to the waist, rounded upwards underneath."""
    x_middle, y_middle, radius = 0.064, 0.259, 0.077
    outline = [(-0.035, 0.09), (0.112, 0.09)]
    for k in range(19):
        angle = math.pi * k / 18
        outline.append((x_middle + radius * math.cos(angle), y_middle + radius * math.sin(angle)))
    sections = []
    for z, inset in [(0.022, 0.055), (0.028, 0.036), (0.038, 0.018), (0.052, 0.006), (0.070, 0.0), (0.150, 0.0),
                     (0.154, 0.001), (0.156, 0.004)]:
        section = []
        for x, y in outline:
            far = min(1.0, max(0.0, (y - 0.09) / 0.246))
            section.append(np.array([x - inset * (x - x_middle) / 0.11, y - 1.3 * inset * far, z]))
        sections.append(section)
    return skin(sections)


def turret():
    return lathe([(0.180, -0.062), (0.182, -0.055), (0.180, -0.038), (0.153, -0.032), (0.150, -0.006),
                  (0.156, -0.004), (0.156, 0.013)], 32)


def neck():
    return loft([Cut(*cut) for cut in [
        (0.520, -0.212, -0.045, -0.100, 0.100, 3), (0.560, -0.205, -0.040, -0.088, 0.088, 3),
        (0.590, -0.193, -0.046, -0.078, 0.078, 2.8), (0.606, -0.184, -0.055, -0.071, 0.071, 2.6),
        (0.618, -0.176, -0.058, -0.058, 0.058, 2.4), (0.632, -0.167, -0.058, -0.046, 0.046, 2.2),
        (0.648, -0.156, -0.052, -0.040, 0.040, 2), (0.668, -0.143, -0.036, -0.0385, 0.0385, 2),
        (0.690, -0.127, -0.014, -0.0385, 0.0385, 2), (0.712, -0.109, 0.008, -0.0385, 0.0385, 2),
        (0.735, -0.089, 0.030, -0.038, 0.038, 2), (0.757, -0.066, 0.045, -0.036, 0.036, 2),
        (0.772, -0.043, 0.050, -0.032, 0.032, 2), (0.780, -0.020, 0.050, -0.024, 0.024, 2)]], 24)


PAN_X = 0.0595  # where the head pans, and the middle of its cap


def head_cap():
    cap = lathe([(0.0740, 0.712), (0.0755, 0.735), (0.0775, 0.765), (0.0795, 0.805), (0.0825, 0.829), (0.0830, 0.840),
                 (0.0815, 0.852), (0.0770, 0.862), (0.0690, 0.869), (0.0500, 0.873), (0.0250, 0.8748), (0, 0.8753)], 40)
    return placed(translation(PAN_X, 0, 0), cap)


def sonar_dots():
    """The twelve ears of the sonar, around the cap."""
    dot = placed(ALONG_X, lathe([(0.0060, 0.075), (0.0060, 0.0834)], 10))
    return [placed(translation(PAN_X, 0, 0.829) @ about_z(math.pi * (2 * k + 1) / 12), dot) for k in range(12)]


def tube_frame():
    radius, bend, sides = 0.0135, 0.05, 13
    tubes = on_both_sides(tube([(-0.070, 0.185, 0.000), (-0.155, 0.212, 0.020), (-0.165, 0.212, 0.490),
                                (-0.152, 0.165, 0.555), (-0.135, 0.070, 0.592)], radius, bend, sides))
    bumper = [(-0.16, 0.206, 0.188), (0.13, 0.157, 0.188), (0.185, 0.105, 0.188), (0.185, -0.105, 0.188),
              (0.13, -0.157, 0.188), (-0.16, -0.206, 0.188)]
    tubes.append(tube(bumper, radius, bend, sides))
    bolt = tube([(-0.155, 0.118, 0.565), (-0.155, 0.128, 0.602)], 0.005, 0, 12)
    return tubes + on_both_sides(bolt)


def on_left_flank(outline, proud, edge_radius):
    """An oval pad with a knob, like the forearm's; the outline is drawn with x upwards."""
    pose = translation(-0.1, 0, 0.385) @ axes((0, 0, 1), (1, 0, 0), (0, 1, 0))
    return placed(pose, extrusion(outline, 0.165, proud, edge_radius, 2))


def chest_plate(half_width, z_min, z_max, x_front):
    outline = rounded([(-half_width, z_min), (half_width, z_min), (half_width, z_max), (-half_width, z_max)],
                      half_width * 0.55, 6)
    return placed(ALONG_X, extrusion(outline, 0.115, x_front, 0.0008, 1))


def slots():
    """Slots of the vent at the neck's root, and recesses beside the strip, where the waist is bolted."""
    result = [placed(translation(-0.2075 + 0.0045 * k, 0, 0.526 + 0.0125 * k),
                     rounded_box((0.012, 0.126 - 0.006 * k, 0.0055), 0.002, 0.001)) for k in range(5)]
    recess = extrusion(rounded(rectangle(0.018, 0.028), 0.005, 3), -0.01, 0.0016)
    for y in (-0.072, 0.072):
        for z in (0.05, 0.105):
            result.append(placed(ALONG_X @ translation(y, z, 0.1265), recess))
    return result


def torso():
    shells = [back_body(), keel(), scoops(), shelf(), waist(), turret(), neck(), head_cap(),
              *on_both_sides(shoulder_pod())]
    frame = tube_frame() + on_both_sides(on_left_flank(stadium(0.125, 0.052, 20), 0.1805, 0.002))
    black = [*slots(), *sonar_dots(), chest_plate(0.0475, 0.110, 0.5225, 0.1290)]
    knobs = on_both_sides(on_left_flank(circle(0.0175, 18), 0.193, 0.004))
    return [Piece(CHARCOAL, joined(shells)), Piece(DARK_GRAY, joined(frame)), Piece(RUBBER_BLACK, joined(black)),
            Piece(STEEL, joined(knobs)), Piece(SCREEN_PRINT, chest_plate(0.0435, 0.114, 0.5185, 0.1305))]


def legs():
    """The flat casting with four legs: it lies lower towards its tips and arches underneath."""
    front = [(0.182, 0.0), (0.195, 0.07), (0.235, 0.13), (0.30, 0.172), (0.41, 0.228), (0.41, 0.40), (0.305, 0.40),
             (0.292, 0.31), (0.20, 0.235), (0.09, 0.195), (0.0, 0.184), (-0.10, 0.178), (-0.18, 0.19), (-0.29, 0.232),
             (-0.36, 0.28), (-0.388, 0.40), (-0.48, 0.40), (-0.495, 0.205), (-0.35, 0.106), (-0.29, 0.05),
             (-0.278, 0.0)]
    outline, sections = rounded(both_halves(front), 0.05, 2), []
    # Fractions from the underside (0) to the top (1).
    for fraction, inset in [(0, 0.006), (0.10, 0), (0.84, 0), (0.95, 0.006), (1.0, 0.020)]:
        section = []
        for x, y in outline:
            reach = math.hypot(x, y)
            out = min(1.0, max(0.0, (reach - 0.18) / 0.4))
            top, bottom = -0.655 - 0.045 * out**2, -0.735 - 0.058 * out**3
            scale = 1 - inset / reach
            section.append(np.array([x * scale, y * scale, bottom + fraction * (top - bottom)]))
        sections.append(section)
    return skin(sections)


def column():
    return lathe([(0.165, -0.672), (0.160, -0.662), (0.140, -0.652), (0.118, -0.644), (0.107, -0.634),
                  (0.104, -0.620), (0.104, -0.165)], 32)


def collar():
    """The clamp the robot stands in: a drum of twelve faces."""
    return extrusion(rounded(circle(0.196, 12), 0.05, 2), -0.176, -0.060, 0.006, 2)


def clamps():
    clamp = placed(translation(0.184, 0, 0), rounded_box((0.034, 0.05, 0.132), 0.006, 0.004))
    return [placed(translation(0, 0, -0.118) @ about_z(math.pi / 2 * k), clamp) for k in range(4)]


def wheel():
    tire = lathe([(0.045, -0.0135), (0.060, -0.010), (0.063, 0.0), (0.060, 0.010), (0.045, 0.0135)], 16)
    return placed(ALONG_MINUS_Y, tire)


def hub():
    return placed(ALONG_MINUS_Y, lathe([(0, -0.038), (0.034, -0.036), (0.034, 0.036), (0, 0.038)], 24))


def star_knob():
    """The hand wheel of a foot: a star of six lobes."""
    star = []
    for k in range(24):
        angle = 2 * math.pi * k / 24
        radius = 0.0335 + 0.0045 * math.cos(6 * angle)
        star.append((radius * math.cos(angle), radius * math.sin(angle)))
    return extrusion(star, -0.010, 0.010, 0.003, 1)


def pedestal():
    castings, black, steel = [legs(), column(), collar(), *clamps()], [], []
    for side in (-1, 1):
        for x, y in [(0.33, 0.285), (-0.37, 0.262)]:
            axle = np.array([x, side * y, -0.8605])
            black += [placed(translation(*(axle + (0, offset, 0))), wheel()) for offset in (-0.0235, 0.0235)]
            steel.append(placed(translation(*axle), hub()))
            # The fork between the twin wheels, up to the leg.
            castings.append(placed(translation(*(axle + (0, 0, 0.045))), rounded_box((0.04, 0.018, 0.11), 0.006, 0.003)))
            castings.append(placed(translation(*(axle + (0, 0, 0.085))), rounded_box((0.075, 0.07, 0.05), 0.015, 0.006)))
        for x, y in [(0.352, 0.365), (-0.435, 0.365)]:
            floor = np.array([x, side * y, -0.924])
            steel.append(placed(translation(*floor), lathe([(0.011, 0.01), (0.011, 0.262)], 16)))
            castings.append(placed(translation(*floor), lathe([(0.024, 0), (0.024, 0.010), (0.012, 0.022), (0.012, 0.07),
                                                               (0.018, 0.072), (0.018, 0.13)], 20)))
            black.append(placed(translation(*(floor + (0, 0, 0.269))), star_knob()))
    # Where the column opens, in front and behind.
    black += [placed(translation(x, 0, -0.40), rounded_box((0.003, 0.007, 0.44), 0.0012, 0.001)) for x in (-0.104, 0.104)]
    return [Piece(DARK_GRAY, joined(castings)), Piece(RUBBER_BLACK, joined(black)), Piece(STEEL, joined(steel))]
