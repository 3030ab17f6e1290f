"""Switches, buttons and tools in a demonstration, in the order in which they were used."""

from constants import USES
from explain.drives import Drive, drive_at
from explain.presses import Press, changes, place_of
from explain.uses import use_at


def infer_devices(demo, steps):
    """Returns the Presses, Uses and Drives of a demonstration, in their order. Raises ValueError if the pictures do
    not show what one of them changed."""
    placed = set()  # names of the objects that were released so far for the last time
    last = {n: k for k, n in enumerate(demo.placed)}
    presses, num_released, is_driving = [], 0, False
    for frame, word, fields in demo.events:
        if word == "release":
            n = demo.placed[num_released]
            if last[n] == num_released:
                placed.add(demo.ids[n])
            num_released += 1
        after = [k for k, step in enumerate(steps) if step.stays or step.name in placed]
        is_driving &= word != "grasp"
        if word == "use" and fields[2] in USES.turning:
            if not is_driving:
                presses.append(drive_at(demo, frame, after, [it for it in presses if isinstance(it, Drive)]))
            is_driving = True
        elif word == "use":
            presses.append(use_at(demo, frame, fields, after))
        elif word in ("trigger", "press"):
            control = fields[1] if word == "trigger" else fields[0]
            presses.append(Press(control, after, *changes(demo, frame, frame + 1, control)))
    for press in [it for it in presses if not it.tool]:
        press.changed &= place_of(press.control, presses)
    return presses
