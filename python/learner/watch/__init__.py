"""From the pictures of a demonstration alone to the blocks in it and their ways, also behind hands."""
