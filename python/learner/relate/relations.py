"""The facts about one object among others: see relate."""

import math

import numpy as np

from constants import RELATE as C, TASK_MODEL
from things.areas import container_at, footprint, overlap
from things.blocks import yaw_difference
from things.standing import stands_on


def relations(demo, k, name, there, containers):
    """Returns the facts about object number k of those that are there."""
    block = there[name]
    below = [it for it in there if it != name and stands_on(block, there[it])]
    beside = [it for it in list(there)[k + 1:] if is_beside(block, there[it])]
    facts = [f"on {name} {it}" for it in below]
    container = container_at([it for it in containers if it.name != name], block.position)
    if container:
        facts.append(f"{'on' if stands_on(block, container) else 'in'} {name} {container.name}")
    elif not below and block.bottom < TASK_MODEL.max_support_gap:
        facts.append(f"on {name} table")
    facts += [f"beside {name} {it}" for it in beside]
    facts += [f"aligned {name} {it}" for it in below + beside if is_aligned(block, there[it])]
    if demo.ids.index(name) in demo.placed:
        inside = [container] if container else []
        still = [it for it in there if demo.ids.index(it) not in demo.placed]
        still.sort(key=lambda it: np.hypot(*(there[it].position - block.position)[:2]))
        around = [(it.name, it) for it in inside] + [(it, there[it]) for it in below + still]
        facts.append(place(name, block, around))
    return facts


def is_beside(one, other):
    """Returns true if two Blocks are side by side, almost in contact."""
    is_level = one.bottom < other.top and other.bottom < one.top
    [grown], [plain] = footprint([one], C.max_gap_beside), footprint([one], 0)
    rectangle = footprint([other], 0)
    return is_level and overlap(grown, rectangle).any() and not overlap(plain, rectangle).any()


def is_aligned(one, other):
    """Returns true if the sides of two Blocks are parallel; what looks the same at each yaw, like discs, has none."""
    if any(yaw_difference(it, it.yaw + 1) == 0 for it in (one, other)):
        return False
    angle = one.yaw - other.yaw
    return abs(angle - math.pi / 2 * round(angle / (math.pi / 2))) < C.aligned_rad


def place(name, block, around):
    """Returns where an object is, as a fact: in the frame of the first of some others, or the table.

    around: names and Blocks
    """
    x, y, yaw = *block.position[:2], block.yaw
    reference = "table"
    if around:
        reference, origin = around[0]
        x, y = (block.position - origin.position)[:2]
        c, s = math.cos(origin.yaw), math.sin(origin.yaw)
        x, y, yaw = x * c + y * s, y * c - x * s, yaw - origin.yaw
    degrees = math.degrees(yaw)
    degrees -= 360 * math.floor((degrees + 180) / 360 + C.rounding)
    return (f"place {name} {reference} {hundredths(x)} {hundredths(y)} "
            f"{math.floor(degrees + 0.5 + C.rounding)}")


def hundredths(number):
    """Returns a number as text with two decimals, rounded alike in both twins."""
    return "%.2f" % (math.floor(100 * number + 0.5 + C.rounding) / 100)
