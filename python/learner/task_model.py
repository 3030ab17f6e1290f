"""Infers from a demonstration what is to be done."""

import math
from dataclasses import replace

import numpy as np

from appearances import measure_objects
from blocks import same_size
from constants import BLOCKS, TASK_MODEL as C
from containers import measure_container
from handles import measure_handle, was_dragged
from parts import turned
from resting import resting_at
from steps import Step, is_above, is_dragged, stands_on


def infer_task(demo, attention):
    """Returns a list of Steps in the order shown, one for each object that takes part, and the
    Container that some of them were put into, or None. Objects that were not moved but support
    others come first.

    attention: the properties of objects that matter, if the demonstrator specified some, as in aux
    """
    moved = moved_objects(demo)
    carried = [n for n in moved if not was_dragged(demo.moves[n])]
    if demo.appearances is None:  # pictures alone have shown them already
        demo.appearances = measure_objects(demo, carried)
    appearances = demo.appearances
    moved = [n for n in moved if n not in tools_of(demo)]
    placed = [step_of(demo, n, appearances[n], attention) if n in carried
              else measure_handle(demo, n) for n in moved]
    steps = supports_of(placed, [
        replace(step_of(demo, n, appearances[n], attention), stays=True)
        for n in range(len(demo.ids)) if n in appearances and n not in moved]) + placed
    set_order(steps, {name for name, properties in attention.items() if "order" in properties})
    for step in steps:
        if not step.on and step.bottom > C.min_inside_bottom and not is_dragged(step):
            step.takes_place_of = former_owner(demo, step)
    return steps, measure_container(demo, steps)


def set_order(steps, ordered):
    """Determines what each step stands on, and what else must be done before it: what it will cover, and,
    where the order of an object matters, all that was placed before.

    ordered: names of objects whose order the demonstrator attended
    """
    carriers = []  # of each step, the numbers of those that carry it, directly or not
    for k, step in enumerate(steps):
        step.on = [i for i, lower in enumerate(steps[:k]) if stands_on(step, lower)]
        carriers.append(set(step.on).union(*(carriers[i] for i in step.on)))
        step.after = [i for i, lower in enumerate(steps[:k])
                       if i not in carriers[k] and is_above(step, lower)
                       or not lower.stays and not {step.name, lower.name}.isdisjoint(ordered)]


def former_owner(demo, step):
    """Returns the name of another moved object that began at the place of a step; empty if there is none."""
    end = demo.moves[demo.ids.index(step.name)][-1, 1:]
    for n in moved_objects(demo):
        if demo.ids[n] != step.name and is_same_pose(demo.moves[n][0, 1:], end):
            return demo.ids[n]
    return ""


def moved_objects(demo):
    """Returns the numbers of the objects that hands moved, in the order of their last release."""
    last = {n: when for when, n in enumerate(demo.placed)}
    if not last:
        raise ValueError("in this demonstration no hand moved anything")
    return sorted(last, key=last.get)


def supports_of(steps, others):
    """Returns those of some other steps on which steps stand at the end, directly or on others: a
    list, the lowest first."""
    found = []
    upper = list(steps)
    while upper:
        step = upper.pop()
        below = [it for it in others if it not in found and stands_on(step, it)]
        found += below
        upper += below
    return sorted(found, key=lambda step: (step.position[2], others.index(step)))


def step_of(demo, n, appearance, attention):
    """Returns the Step of a carried object, at its final place; appearance: the Block at its first
    place."""
    color = appearance.color if color_matters(attention, demo.ids[n]) else None
    there = resting_at(appearance, demo.moves[n][-1, 1:])
    size, yaw, parts = there.size, there.yaw, there.parts
    if size[1] > BLOCKS.equal_sides * size[0]:
        size = size[[1, 0, 2]]
        yaw += math.pi / 2
        parts = turned(parts, math.pi / 2)
    began = np.append(np.sort(appearance.size[:2])[::-1], appearance.size[2])
    return Step(color, size, there.position, yaw, demo.ids[n], [],
                start_size=None if same_size(began, size) else began, start=demo.moves[n][0, 1:4],
                form=appearance.form, has_knob=appearance.has_knob, parts=parts,
                begins_there=is_same_pose(demo.moves[n][0, 1:], demo.moves[n][-1, 1:]))


def tools_of(demo):
    """Returns the numbers of the objects that were used as tools and put back where they began."""
    used = {demo.ids.index(fields[1]) for _, word, fields in demo.events if word == "use"}
    return {n for n in used if is_same_pose(demo.moves[n][0, 1:], demo.moves[n][-1, 1:])}


def color_matters(attention, name):
    """Returns true unless the demonstrator specified the properties of an object that matter,
    without color."""
    return "color" in (attention.get(name) or ["color"])


def is_same_pose(one, other):
    """Returns true if two poses, x y z [units] and three angles [degrees], are almost equal."""
    away = np.abs(one - other)
    return away[:3].max() < C.max_rest_error and away[3:].max() < C.max_rest_degrees
