"""How much brighter or darker things are in one light than in another, in red, green and blue."""

import numpy as np

from constants import GAINS as C


def gains_between(shown, seen):
    """Returns the factors of red, green and blue that make colors in one light, Nx3, to those in another one, Mx3: the
    factors that explain most of the latter; ones if no others explain clearly more. Not all need be the same things."""
    ones = np.ones(3)
    best, most = ones, max(C.min_advantage * explained(shown, seen, ones)[0].sum(), C.min_explained)
    for color in shown[shown.max(axis=1) > C.bright]:
        for other in seen:
            gains = gains_of(color, other)
            number = 0 if gains is None else explained(shown, seen, gains)[0].sum()
            if number > most:
                best, most = gains, number
    for _ in range(C.num_refinements if best is not ones else 0):
        best = refined(shown, seen, best)
    return best


def gains_of(color, other):
    """Returns the factors that make one color to another one; None if they differ too much. A channel that is dark or
    saturated has the mean factor of the others."""
    is_clear = (color > C.dark) & (other < C.saturated)
    if not is_clear.any():
        return None
    gains = np.full(3, (other[is_clear] / color[is_clear]).mean())
    gains[is_clear] = other[is_clear] / color[is_clear]
    is_light = C.range[0] < gains.min() and gains.max() < min(C.range[1], C.max_tint * gains.min())
    return gains if is_light else None


def explained(shown, seen, gains):
    """Returns which of some seen colors are shown ones with some gains, M bool, and the numbers of the nearest ones."""
    away = np.abs(brightened(shown, gains)[:, None] - seen).max(axis=2)
    return away.min(axis=0) < C.same_color, away.argmin(axis=0)


def refined(shown, seen, gains):
    """Returns the gains that agree best with all colors that some gains explain."""
    is_explained, nearest = explained(shown, seen, gains)
    color, other = shown[nearest[is_explained]], seen[is_explained]
    weights = color * (other < C.saturated)
    total = (weights * color).sum(axis=0)
    return np.where(total > 0, (weights * other).sum(axis=0) / np.maximum(total, np.finfo(float).eps), gains)


def brightened(colors, gains):
    """Returns colors or a picture, ...x3, in a light with some gains."""
    return np.minimum(colors * gains, 1)
