"""Switches, buttons and tools in a demonstration, in the order in which they were used."""

from constants import USES
from explain.drives import Drive, drive_at
from explain.limits import NotUnderstood
from explain.needs import closed
from explain.parts_of_controls import own_part
from explain.presses import Press, changes, place_of, unchanged_by
from explain.uses import use_at


def infer_devices(demo, steps, needs=None):
    """Returns the Presses, Uses and Drives of a demonstration, in their order. Raises NotUnderstood if the pictures do
    not show what one of them changed.

    needs: what the goal needs, if it is known: Needs
    """
    placed = set()  # names of the objects that were released so far for the last time
    last = {n: k for k, n in enumerate(demo.placed)}
    presses, num_released, is_driving = [], 0, False
    for i, (frame, word, fields) in enumerate(demo.events):
        if word == "release":
            n = demo.placed[num_released]
            if last[n] == num_released:
                placed.add(demo.ids[n])
            num_released += 1
        after = [k for k, step in enumerate(steps) if step.stays or step.name in placed]
        is_driving &= word != "grasp"
        if needs and word in ("use", "trigger", "press"):
            if not needs.needs(demo.segments[i]):
                continue
            after = closed([k for k in after if steps[k].stays or needs.must_precede(steps[k], demo.segments[i])], steps)
        if word == "use" and fields[2] in USES.turning:
            if not is_driving:
                presses.append(drive_at(demo, frame, after, [it for it in presses if isinstance(it, Drive)]))
            is_driving = True
        elif word == "use":
            presses.append(use_at(demo, frame, fields, after))
        elif word in ("trigger", "press"):
            control = fields[1] if word == "trigger" else fields[0]
            before, later, changed = changes(demo, frame, frame + 1, control)
            presses.append(Press(control, after, before, later, own_part(changed, demo, control, frame)))
    for press in [it for it in presses if not it.tool]:
        press.changed &= place_of(press.control, presses)
        if not press.changed.any():
            raise NotUnderstood(f"no picture of the demonstration shows what was changed at {press.control}")
    for press in presses:
        press.unchanged = unchanged_by(press, presses)
    return presses
