"""Satin shells and what is between them, as they look in daylight (sRGB)."""

BRICK_RED = (0.620, 0.180, 0.145)
CHARCOAL = (0.400, 0.400, 0.410)
RUBBER_BLACK = (0.145, 0.145, 0.155)
DARK_GRAY = (0.285, 0.285, 0.295)
STEEL = (0.46, 0.46, 0.47)
PALE = (0.784, 0.784, 0.784)
SCREEN_PRINT = (0.769, 0.769, 0.761)  # the strip on the chest
BEZEL = (0.30, 0.30, 0.31)
