"""Python client of SMILE, for brains."""
