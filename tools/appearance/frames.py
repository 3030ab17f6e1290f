"""Directions in which the parts of a robot are drawn."""

from .modeling import axes

# Turns what is drawn in the xy plane and grows along z into a profile, drawn in (x, z), that grows along -y.
ALONG_MINUS_Y = axes((1, 0, 0), (0, 0, 1), (0, -1, 0))
# Into a cut, drawn in (y, z), that grows along x.
ALONG_X = axes((0, 1, 0), (0, 0, 1), (1, 0, 0))
