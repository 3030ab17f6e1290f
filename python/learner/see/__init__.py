"""From pictures and depth to blocks: what is there, and where."""
