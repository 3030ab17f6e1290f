"""Switches, buttons and tools in a demonstration, in the order in which they were used."""

from explain.presses import Press, changes, place_of
from explain.uses import use_at


def infer_devices(demo, steps):
    """Returns the Presses and Uses of a demonstration, in their order. Raises ValueError if the pictures do not show
    what one of them changed."""
    placed = set()  # names of the objects that were released so far for the last time
    last = {n: k for k, n in enumerate(demo.placed)}
    presses, num_released = [], 0
    for frame, word, fields in demo.events:
        if word == "release":
            n = demo.placed[num_released]
            if last[n] == num_released:
                placed.add(demo.ids[n])
            num_released += 1
        after = [k for k, step in enumerate(steps) if step.stays or step.name in placed]
        if word == "use":
            presses.append(use_at(demo, frame, fields, after))
        elif word in ("trigger", "press"):
            control = fields[1] if word == "trigger" else fields[0]
            presses.append(Press(control, after, *changes(demo, frame, frame + 1, control)))
    for press in [it for it in presses if not it.tool]:
        press.changed &= place_of(press.control, presses)
    return presses
