"""Colors in a picture."""

import numpy as np

from constants import PERCEPTION as C


def colors_to_detect(picture, like):
    """Returns the colors to detect, a list: those of some blocks and, if the color of one of them does not matter,
    every frequent color of the picture."""
    colors = [it.color for it in like if it.color is not None]
    if len(colors) < len(like):
        colors += frequent_colors(picture)
    return distinct_colors(colors)


def frequent_colors(picture, min_pixels=C.frequent_color_pixels):
    """Returns the colors that more than a few pixels of a picture have, a list."""
    flat = np.round(picture * 255).astype(int).reshape(-1, 3)
    flat = flat[(flat > 0).all(axis=1) | (flat > C.bright_of_255).any(axis=1)]
    found, count = np.unique(flat @ [65536, 256, 1], return_counts=True)
    frequent = found[count > min_pixels]
    return distinct_colors([color_of_code(color) for color in frequent])


def distinct_colors(colors):
    """Merges colors that color_mask cannot distinguish: a list."""
    distinct = []
    for color in colors:
        if all(np.abs(color - other).max() >= C.distinct_colors for other in distinct):
            distinct.append(color)
    return distinct


def color_of_code(number):
    """Returns the color of a number 65536 red + 256 green + blue, each from 0 to 255."""
    return np.array([number // 65536, number // 256 % 256, number % 256]) / 255


def color_mask(picture, color):
    """Returns the mask, HxW bool, of the pixels that have a color. In the robot's eye each face of a block has one flat
    color: its true color on top, darker ones at the sides."""
    tolerance = C.color_tolerance + C.color_tolerance_bright * max(color)
    mask = np.abs(picture[:, :, 0] - color[0]) < tolerance
    for channel in (1, 2):
        mask &= np.abs(picture[:, :, channel] - color[channel]) < tolerance
    return mask


def is_color_near(picture, color, pixel):
    """Returns true if a color appears within some distance of a pixel (row, column); false for None."""
    if pixel is None:
        return False
    row, column = np.maximum(np.array(pixel) - C.near_pixels, 0)
    part = picture[row:pixel[0] + C.near_pixels + 1, column:pixel[1] + C.near_pixels + 1]
    return bool(color_mask(part, color).any())


def table_color(picture):
    """Returns the color of the table: the most frequent one except black, the background."""
    pixels = np.round(255 * picture[::C.table_pixel_step, ::C.table_pixel_step]).astype(int).reshape(-1, 3) @ [65536, 256, 1]
    colors, count = np.unique(pixels[pixels > 0], return_counts=True)
    return color_of_code(colors[count.argmax()]) if len(colors) else np.full(3, np.nan)


def is_darker_shade(colors, bright):
    """Returns whether colors (3, or Nx3) are darker shades of the same hue, bool or N bool: those of sides of a block with a bright top."""
    fractions = (colors * bright).sum(axis=-1, keepdims=True) / max((bright**2).sum(), np.finfo(float).eps)
    least, greatest = C.shade
    is_shade = (np.abs(colors - fractions * bright) < C.shade_tolerance) & (least < fractions) & (fractions < greatest)
    return is_shade.all(axis=-1)


def is_below_brighter(color, codes, row, column):
    """Returns true if an area of one color is below a brighter area of the same hue."""
    above = codes[np.maximum(row - 1, 0), column]
    colors, often = np.unique(above[(above != codes[row[0], column[0]]) & (row > 0)],
                              return_counts=True)
    return len(colors) > 0 and is_darker_shade(color, color_of_code(colors[often.argmax()]))
