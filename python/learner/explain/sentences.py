"""Says in sentences what an explanation contains: a page for people."""

PHRASES = {"on": "on {0}", "in": "in {0}", "beside": "beside {0}", "aligned": "aligned with {0}",
           "held": "in {0}", "place": "at ({1}, {2}) of {0}, rotated by {3} degrees",
           "joint": "dragged by ({0}, {1})", "state": "in state {0}", "fastened": "fastened to {0}",
           "cut": "cut with {0}", "gone": "gone", "turned": "turned onto another face"}


def page_of(explanation):
    """Returns the lines of the page."""
    start, *deeds = explanation.keyframes
    lines = ["At the start:", *indented(start.facts)]
    for k, it in enumerate(deeds):
        means = " (only a means: nothing of it is kept)" if it.is_means else ""
        lines += [f"{k + 1}. {it.deed}{means}. New:", *indented(it.made)]
    return [*lines, "The goal, made and kept:", *indented(explanation.goal)]


def indented(facts):
    """Returns a sentence for each object that facts are about."""
    phrases = {}
    for fact in facts:
        word, name, *rest = ["the table" if it == "table" else it for it in fact.split()]
        phrases.setdefault(name, []).append(PHRASES[word].format(*rest))
    return [f"  {name} is {', '.join(it)}." for name, it in phrases.items()] or ["  Nothing known."]
