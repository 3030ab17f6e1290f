"""Pictures in which each face has one flat color, as without noise."""

import math

import numpy as np

from constants import PICTURES as C
from see.colors import color_of_code


def without_noise(picture, noise, count):
    """Returns the mean of some pictures of the same, HxWx3 from 0 to 1, without the noise that it still has.

    noise: of each of them, as from noise_of
    count: number of the pictures
    """
    channels = np.ascontiguousarray(picture.transpose(2, 0, 1))
    for _ in range(C.num_evenings):
        channels = evened(channels, C.num_deviations * noise / math.sqrt(count))
    codes = np.tensordot([65536, 256, 1], np.round(255 * channels).astype(int), 1)
    found, which, counts = np.unique(codes, return_inverse=True, return_counts=True)
    colors = unsaturated(joined(color_of_code(found).T, counts), noise)
    return (np.round(255 * colors) / 255)[which.reshape(codes.shape)]


def evened(picture, tolerance):
    """Returns a picture, 3xHxW, in which each pixel has the mean color of those around it that have about its color,
    so that edges stay sharp."""
    _, height, width = picture.shape
    wide = np.pad(picture, ((0, 0), (1, 1), (1, 1)), mode="edge")
    total, count = np.zeros(picture.shape), np.zeros((height, width))
    for right in range(3):
        for down in range(3):
            other = wide[:, down:down + height, right:right + width]
            is_alike = np.abs(other - picture).max(axis=0) < tolerance
            total += other * is_alike
            count += is_alike
    return total / count


def joined(colors, counts):
    """Replaces colors that differ by noise only, Nx3, by their mean: those around the most frequent ones.
    counts: of pixels that have each of them, N numbers"""
    colors, is_free = colors.copy(), np.ones(len(colors), bool)
    for k in np.argsort(-counts, kind="stable"):
        if counts[k] < C.min_even_pixels:
            break
        if is_free[k]:
            near = is_free & (np.abs(colors - colors[k]).max(axis=1) < C.same_color)
            colors[near] = counts[near] @ colors[near] / counts[near].sum()
            is_free &= ~near
    return colors


def unsaturated(means, noise):
    """Returns the values, from 0 to 1, that have some means with a noise that is cut off at 0 and at 1."""
    values = np.arange(256) / 255
    if noise == 0:
        return means
    cut = np.array([cut_off(value / noise) - cut_off((1 - value) / noise) for value in values])
    return np.interp(means, values + noise * cut, values)


def cut_off(value):
    """Returns by how much the mean of a value with a noise of 1 is higher if nothing is below 0."""
    density = math.exp(-value**2 / 2) / math.sqrt(2 * math.pi)
    return density - value * math.erfc(value / math.sqrt(2)) / 2
