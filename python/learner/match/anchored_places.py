"""Places of things that are to stand where they were shown."""

from match.landmarks import sites_by_anchor
from match.sites import NoSite, first_within_reach
from see.framing import is_in_view, is_on_table
from things.steps import TABLE


def place_at_anchor(steps, known, arms, eye):
    """Moves steps that have an anchor to where they stand relative to it.

    Raises NoSite if it is not seen, or if the places are out of reach or out of the eye's view.
    """
    anchor = steps[0].anchor
    if anchor == TABLE:
        sites = [(0, steps)]
    elif steps[-1].name != anchor:
        raise NoSite(f"{anchor}, beside which {steps[0].name} goes, could not be measured in the demonstration")
    else:
        sites = sites_by_anchor(steps, known, eye)
    if not sites:
        raise NoSite(f"nothing is seen that looks like {anchor}, beside which {steps[0].name} goes")
    visible = [site for site in sites
               if all(step.stays or is_on_table(step, eye) and is_in_view(step, eye) for step in site[1])]
    placed = first_within_reach(visible, arms)
    if not placed:
        raise NoSite(f"relative to {anchor}, the place of {steps[0].name} is out of reach or out of view")
    return placed
