"""What the learner understands of a demonstration, from its recording to the steps of the task."""

from explain.demonstration import has_texts, read_demonstration
from explain.devices import infer_devices
from explain.explanation import explain
from explain.needs import needs_of
from explain.sentences import page_of
from explain.task_model import infer_task
from explain.watching import watch_demonstration


def understand(aux):
    """Reads or watches the demonstration of a brain, and prints what it shows. Returns the Demonstration, the Steps of the task,
    the Containers, and the Presses and Uses."""
    read = read_demonstration if has_texts(aux.demonstration) else watch_demonstration
    demo = read(aux.demonstration)
    needs = needs_of(aux, demo)
    steps, containers = infer_task(demo, aux.attention, needs)
    presses = infer_devices(demo, steps, needs)
    page = page_of(explain(demo, containers))
    page += [f"Not understood: {it}." for it in demo.unclear]
    for line in page:
        print(line)
    aux.notes = [f"understood: {line.strip()}" for line in page]
    for k, step in enumerate(steps):
        place = ", ".join(steps[lower].name for lower in step.on) or "the table"
        where = f", where it is relative to {step.anchor}" if step.anchor else ""
        where += f"; it is the one that began on {step.began_on.name}" if step.began_on else ""
        print(f"shown: {k + 1}. {step} on {place}{where}")
    for press in presses:
        before = ", ".join(steps[k].name for k in press.after) or "nothing"
        print(f"shown: {press} after {before}")
    return demo, steps, containers, presses
