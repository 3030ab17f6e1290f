"""What carries a block that does not stand on the table."""

from dataclasses import replace

import numpy as np

from constants import BELIEFS as C


def assumed_support(block):
    """Returns the support of a block that does not stand on the table, as one Block from the table
    to its bottom: something must carry it, even if it is hidden. A list, empty for a block on the
    table."""
    if block.bottom < C.min_support_height:
        return []
    x, y, _ = block.position
    return [replace(block, size=np.append(block.size[:2], block.bottom),
                    position=np.array([x, y, block.bottom / 2]))]
