"""Infers from a demonstration what is to be done."""

from dataclasses import replace

from constants import TASK_MODEL as C
from explain.anchor import with_anchor
from explain.appearances import measure_objects
from explain.asides import with_asides
from explain.handles import measure_handle
from explain.needs import needed_of
from explain.object_roles import former_owner, moved_objects, tools_of
from explain.placed_steps import step_of
from explain.shown_containers import measure_containers
from explain.start_supports import with_start_supports
from relate.dragging import was_dragged
from things.standing import is_above, is_placed_by, stands_on
from things.steps import is_dragged


def infer_task(demo, attention, needs=None):
    """Returns a list of Steps in the order shown, one for each object that takes part, and the
    Containers that some of them were put into. Objects that were not moved but support
    others, or are in them, come first; one that was not moved and tells where all others go comes last.

    attention: the properties of objects that matter, if the demonstrator specified some, as in aux
    needs:     what the goal needs, if it is known: Needs
    """
    moved = moved_objects(demo)
    carried = [n for n in moved if not was_dragged(demo, n)]
    if demo.appearances is None:  # pictures alone have shown them already
        demo.appearances = measure_objects(demo, carried)
    appearances = demo.appearances
    moved = needed_of([n for n in moved if n not in tools_of(demo)], demo, needs)
    placed = [step_of(demo, n, appearances[n], attention) if n in carried
              else measure_handle(demo, n) for n in moved]
    others = [replace(step_of(demo, n, appearances[n], attention), stays=True)
              for n in range(len(demo.ids)) if n in appearances and n not in moved]
    steps = supports_of(placed, others) + placed
    set_order(steps, {name for name, properties in attention.items() if "order" in properties})
    for step in steps:
        if not step.on and step.bottom > C.min_inside_bottom and not is_dragged(step):
            step.takes_place_of = former_owner(demo, step)
    steps = with_start_supports(demo, with_asides(demo, steps, needs))
    containers = measure_containers(demo, [it for it in steps if not it.aside])
    return steps if containers else with_anchor(demo, steps, others), containers


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


def supports_of(steps, others):
    """Returns those of some other steps on which steps stand at the end, directly or on others, or which are in a ring or
    the like: a list, the lowest first."""
    found = []
    upper = list(steps)
    while upper:
        step = upper.pop()
        below = [it for it in others if it not in found and is_placed_by(step, it)]
        found += below
        upper += below
    return sorted(found, key=lambda step: (step.position[2], others.index(step)))
