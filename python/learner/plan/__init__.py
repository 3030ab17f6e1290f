"""The next actions: for which step, which move of which block, on which path."""
