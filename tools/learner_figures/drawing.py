"""Drawings as SVG files."""

import base64
import io
from html import escape

import numpy as np
from PIL import Image

INK, FAINT, EXPECTED, FOUND, BAD = "#20262c", "#8a939c", "#e8a200", "#1f7a4d", "#c0392b"


def css(color):
    """Returns a color of 3 numbers from 0 to 1 as text."""
    return "#%02x%02x%02x" % tuple(int(round(255 * it)) for it in np.clip(color, 0, 1))


class Drawing:
    """A drawing on white; x to the right and y down [pixels]."""

    def __init__(self, width, height):
        self._parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" '
                       f'height="{height}" font-family="sans-serif">',
                       f'<rect width="{width}" height="{height}" fill="white"/>']

    def picture(self, rgb, x, y, width, height):
        """Draws HxWx3, 0 to 1, into a rectangle."""
        image = Image.fromarray(np.uint8(np.round(255 * np.clip(rgb, 0, 1)))).resize((width, height), Image.BOX)
        file = io.BytesIO()
        image.save(file, "png", optimize=True)
        data = base64.b64encode(file.getvalue()).decode()
        self._parts.append(f'<image x="{x}" y="{y}" width="{width}" height="{height}" '
                           f'href="data:image/png;base64,{data}"/>')

    def line(self, points, color=INK, width=1.5, dashes="", closed=False, fill="none"):
        """Draws a line through points, Nx2."""
        coordinates = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
        self._parts.append(f'<{"polygon" if closed else "polyline"} points="{coordinates}" fill="{fill}" stroke="{color}" '
                           f'stroke-width="{width}" stroke-dasharray="{dashes}" stroke-linejoin="round"/>')

    def arrow(self, start, end, color=INK):
        """Draws an arrow between two points."""
        start, end = np.array(start, float), np.array(end, float)
        along = (end - start) / np.linalg.norm(end - start)
        across = np.array([-along[1], along[0]])
        self.line([start, end], color)
        self.line([end - 8 * along + 4 * across, end, end - 8 * along - 4 * across], color)

    def text(self, x, y, words, color=INK, size=12, anchor="start", weight="normal"):
        """Writes one line; y is that of its baseline."""
        self._parts.append(f'<text x="{x:.1f}" y="{y:.1f}" fill="{color}" font-size="{size}" text-anchor="{anchor}" '
                           f'font-weight="{weight}">{escape(str(words))}</text>')

    def save(self, file):
        """Writes the file."""
        file.write_text("\n".join([*self._parts, "</svg>"]) + "\n")
