"""Relates the objects of a demonstration: facts at one moment, as rows of words, like "on Green Red".

    on A B           A stands on B, or on the table
    in A B           A is between the walls of the container B
    beside A B       A and B are side by side, with no room for a finger between them
    aligned A B      A, on or beside B, is parallel to it
    held A HAND      a hand holds A
    place A B x y r  A is at x, y [units], rotated by r [degrees], in the frame of B: what it stands on, the
                     nearest object that is never moved, or the table; inside a container, of that
    joint A x y      A was dragged by x, y [units] from where it began
    state C S        the control C is in state S
    fastened A B     B is fastened to A
    cut A B          A was cut with the tool B
    gone A           A is no longer there
    turned A         A is on another face than at the start
"""

from relate.dragging import was_dragged
from relate.relations import hundredths, relations
from things.kinds import same_size
from things.resting import resting_at


def facts_at(demo, containers, frame, held, others):
    """Returns the facts before an action of a frame, in the order of the objects.

    containers: as from infer_task
    held:      name of each held object -> hand
    others:    facts about controls and joints at that time
    """
    facts = list(others)
    there = {}  # name -> Block, of all objects that rest
    for n, name in enumerate(demo.ids):
        if f"gone {name}" in others:
            continue
        if name in held:
            facts.append(f"held {name} {held[name]}")
        elif was_dragged(demo, n):
            x, y = demo.pose(n, frame)[:2] - demo.moves[n][0, 1:3]
            facts.append(f"joint {name} {hundredths(x)} {hundredths(y)}")
        elif n in demo.appearances:
            there[name] = resting_at(demo.appearances[n], demo.pose(n, frame))
            if not same_size(there[name].size, demo.appearances[n].size):
                facts.append(f"turned {name}")
    for k, name in enumerate(there):
        facts += relations(demo, k, name, there, containers)
    return facts
