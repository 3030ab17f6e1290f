"""What the learner does not understand."""


class NotUnderstood(ValueError):
    """A demonstration shows what this learner does not understand: why, in one line."""
