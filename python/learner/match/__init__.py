"""Where in this scene the things of the demonstration are, and where the building goes."""
