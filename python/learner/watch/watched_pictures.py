"""The pictures of a recording."""

import csv
from pathlib import Path

import numpy as np
from PIL import Image

from see.regions import label_regions


def pictures_of(folder):
    """Returns the pictures of a recording: a list of frame, file, and whether the scene was still then, so that
    the next frame needed no picture of its own."""
    folder = Path(folder)
    with open(folder / "frames.csv", newline="") as file:
        rows = [(int(row["frame"]), row["image"]) for row in csv.DictReader(file)]
    found = []
    for k, (frame, image) in enumerate(rows):
        if image:
            found.append((frame, folder / image, k + 1 == len(rows) or not rows[k + 1][1]))
    if not found:
        raise ValueError(f"there are no pictures in {folder}")
    return found


def codes_in(file):
    """Reads a picture as codes 65536 red + 256 green + blue, HxW."""
    picture = np.asarray(Image.open(file).convert("RGB")).astype(np.int32)
    return picture[:, :, 0] << 16 | picture[:, :, 1] << 8 | picture[:, :, 2]


def colors_of(codes):
    """Returns the colors of codes, with one more axis, 0 to 1."""
    codes = np.asarray(codes)
    return np.stack([codes >> 16, codes >> 8 & 255, codes & 255], -1) / 255


def areas_in(mask, smallest):
    """Returns the rows and columns of the connected regions of a mask with some number of pixels or more: a list."""
    rows, columns = np.flatnonzero(mask.any(axis=1)), np.flatnonzero(mask.any(axis=0))
    if not len(rows):
        return []
    number = label_regions(mask[rows[0]:rows[-1] + 1, columns[0]:columns[-1] + 1])
    areas = []
    for region in np.flatnonzero(np.bincount(number.ravel()) >= smallest):
        if region:
            row, column = np.nonzero(number == region)
            areas.append((row + rows[0], column + columns[0]))
    return areas
