"""From a recording to its goal and its steps: what was done, and what of it matters."""
