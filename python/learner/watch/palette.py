"""What the pixels of a picture of a demonstration may show, by their colors."""

import numpy as np

from constants import WATCHING as C
from see.colors import is_darker_shade, table_color
from watch.watched_pictures import colors_of

# Classes of pixels: background is the table and what is beyond it, unknown whatever is neither that nor
# of the color of a known object, like hands, sleeves and robots. Tops of color k are FIRST + 2 k, and its
# darker shades, those of sides, FIRST + 2 k + 1.
UNKNOWN, BACKGROUND, FIRST = 1, 2, 4


class Palette:
    """Tells the classes of pixels by their colors, of which faces in these pictures have one each."""

    def __init__(self, codes):
        """codes: the first picture"""
        table = table_color(colors_of(codes))
        self.table = np.append(table, [0, 0, 0]).reshape(2, 3)  # and black beyond it
        self.colors = []
        self._classes = np.zeros(1 << 24, np.uint8)  # of codes; 0 where not determined yet

    def add(self, color):
        """Adds the color of a top, unless it is known."""
        if not any(np.abs(color - other).max() < C.same_top for other in self.colors):
            self.colors.append(color)
            self._classes[:] = 0

    def top(self, color):
        """Returns the class of the tops of a color."""
        return FIRST + 2 * int(np.argmin([np.abs(color - other).max() for other in self.colors]))

    def classes(self, codes):
        """Returns the classes of pixels, HxW."""
        found = self._classes[codes]
        new = np.unique(codes[found == 0])
        for code in new:
            self._classes[code] = self._class_of(colors_of(code))
        return self._classes[codes] if len(new) else found

    def _class_of(self, color):
        """Returns the class of a color."""
        if np.abs(self.table - color).max(axis=1).min() < C.same_top:
            return BACKGROUND
        for k, top in enumerate(self.colors):
            if np.abs(color - top).max() < C.same_top:
                return FIRST + 2 * k
        for k, top in enumerate(self.colors):
            if is_darker_shade(color, top):
                return FIRST + 2 * k + 1
        return UNKNOWN
