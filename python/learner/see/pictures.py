"""Noise of pictures, and how many of them have little together."""

import math

import numpy as np

from constants import PICTURES as C

# Of the difference of two values with normally distributed noise of 1, half are below this.
_MEDIAN_DIFFERENCE = 0.6745 * math.sqrt(2)


def noise_of(picture):
    """Returns the standard deviation of the noise of a picture, HxWx3, in the unit of its values.
    Most neighboring pixels show the same surface and differ by noise only."""
    differences = np.abs(np.diff(picture.astype(float), axis=1))
    return np.median(differences) / _MEDIAN_DIFFERENCE


def num_pictures(picture):
    """Returns of how many pictures like this one (HxWx3, 0 to 255) the mean has little noise."""
    fraction = noise_of(picture) / 255 / C.max_noise
    return int(np.clip(math.ceil(fraction ** 2), 1, C.max_pictures))
