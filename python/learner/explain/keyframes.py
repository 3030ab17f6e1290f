"""The deeds of a demonstration, and the moments of rest after them."""

from dataclasses import dataclass

DEEDS = {"release": "carries", "trigger": "triggers", "use": "uses", "fasten": "fastens",
         "loosen": "loosens", "destroy": "destroys", "press": "presses"}
# Lines that are no actions.
EFFECTS = {"create", "initializeControl", "changeControlState", "delete", "attend"}


@dataclass
class Keyframe:
    """A moment of rest after a deed."""

    deed: str  # one line: who did what; empty at the start
    facts: list  # as from relate.facts_at
    made: list  # those of the facts that were not true before, without what hands hold
    is_means: bool = False  # true if the deed made something, and nothing of it is kept


def deed_of(word, fields, held):
    """Returns what an action ends, in words; empty if it ends nothing, like a grasp."""
    if word not in DEEDS:
        return ""
    if word == "use" and fields[2] in DEEDS:
        return f"{fields[0]} {DEEDS[fields[2]]} {fields[3]} with {fields[1]}"
    objects = [held.get(fields[0], "")] if word in ("release", "destroy") else fields[1:2]
    return " ".join([fields[0] or "something", DEEDS[word], *objects])


def apply(word, fields, held, others):
    """Updates what hands hold, and the facts about controls and joints, after an action."""
    if word == "grasp":
        held[fields[0]] = fields[1]
    elif word in ("release", "destroy"):
        held.pop(fields[0], None)
    elif word == "delete":
        others[f"gone {fields[0]}"] = ""
    elif word == "initializeControl":
        others[f"state {fields[0]}"] = fields[-1]
    elif word == "changeControlState":
        others[f"state {fields[0]}"] = fields[1]
    elif word == "use" and fields[2] == "cut":
        others[f"cut {fields[3].split()[0]}"] = fields[1]
    elif word == "fasten":
        others[f"fastened {fields[2]} {fields[4]}"] = ""
    elif word == "loosen" and float(fields[5]) == 0:
        others.pop(f"fastened {fields[2]} {fields[4]}", None)
