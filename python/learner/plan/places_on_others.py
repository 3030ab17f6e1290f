"""Places for blocks on top of others: where a crowded table has no room, what stands on it has."""

from dataclasses import replace

import numpy as np

from constants import TASK_PLANNING as C
from plan.obstruction import has_objects_on
from see.framing import is_in_view
from things.kinds import is_same_kind


def places_on_others(block, others, needed, eye):
    """Returns places for a block on others that are as large, flat and free, and that no step needs, within the eye's view:
    a list, the closest first.

    needed: blocks existing or planned, which may need one like them
    """
    carriers = [it for it in others if can_carry(it, block) and not has_objects_on(it, others)
                and not any(is_same_kind(it, other) for other in needed)]
    carriers.sort(key=lambda it: np.linalg.norm(it.position[:2] - block.position[:2]))
    places = [replace(block, position=np.append(it.position[:2], it.top + block.size[2] / 2), yaw=it.yaw) for it in carriers]
    return [it for it in places if is_in_view(it, eye)]


def can_carry(lower, block):
    """Returns true if a block can stand on another one: it has a flat top that is as large."""
    is_flat = not (lower.is_round or lower.has_knob or lower.parts or lower.outline)
    return is_flat and (lower.size[:2] > block.size[:2] - C.max_overhang).all()
