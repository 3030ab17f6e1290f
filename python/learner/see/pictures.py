"""Noise of pictures, and how many of them have little together."""

import math

import numpy as np

from constants import PICTURES as C

# Of the difference of two values with normally distributed noise of 1, half are below this.
_MEDIAN_DIFFERENCE = 0.6745 * math.sqrt(2)


def noise_of(picture):
    """Returns the standard deviation of the noise of a picture, HxWx3 from 0 to 1. Most neighboring pixels show the
    same surface and differ by noise only. Of what is black or white, noise is cut off: it tells less of it."""
    differences = np.abs(np.diff(picture, axis=1))
    if np.median(differences) > 0:
        is_between = (picture > C.saturated) & (picture < 1 - C.saturated)
        are_between = is_between[:, 1:] & is_between[:, :-1]
        if are_between.sum() >= C.min_unsaturated:
            differences = differences[are_between]
    return np.median(differences) / _MEDIAN_DIFFERENCE


def num_pictures(noise):
    """Returns of how many pictures with a noise, as from noise_of, the mean has little."""
    return int(np.clip(math.ceil((noise / C.max_noise) ** 2), 1, C.max_pictures))
