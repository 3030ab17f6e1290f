"""Facts about objects at one moment of a demonstration: on, in, beside, held, dragged."""
