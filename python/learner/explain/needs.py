"""What of a demonstration its goal needs, and in which order, as `smile analyze` found out (aux.plan)."""

import numpy as np


class Needs:
    """The plan of a Demonstration, asked about segments: the numbers of its text files."""

    def __init__(self, plan, demo):
        self.goals = set(plan.goals)  # ids of the objects whose places count
        self.sufficient = set(np.ravel(plan.sufficient).tolist())
        self.firsts = [subtask.segments[0] for subtask in plan.subtasks]
        self.before = [set() for _ in plan.subtasks]  # of each subtask, those that must come before it
        for before, after in sorted(np.reshape(plan.order, (-1, 2)).tolist(), key=lambda pair: pair[1]):
            self.before[after] |= {before} | self.before[before]
        released = [segment for segment, (_, word, _) in zip(demo.segments, demo.events) if word == "release"]
        self.releases = {name: [segment for segment, n in zip(released, demo.placed) if demo.ids[n] == name]
                         for name in demo.ids}  # of each object, the segments in which it was released

    def subtask_of(self, segment):
        """Returns the number of the subtask that a segment belongs to."""
        return int(np.searchsorted(self.firsts, segment, "right")) - 1

    def needs(self, segment):
        """Returns true if what was done in a segment is needed."""
        return self.subtask_of(segment) in self.sufficient

    def needs_object(self, name):
        """Returns true if the place of an object counts, or if it was moved in a needed subtask."""
        return name in self.goals or any(map(self.needs, self.releases[name]))

    def must_precede(self, step, segment):
        """Returns true if a step must be done before what was done in a segment, as far as the plan knows."""
        later = self.subtask_of(segment)
        earlier = {self.subtask_of(it) for it in self.releases[step.name] if it < segment}
        return not earlier.isdisjoint({later} | self.before[later])

    def required_before(self, steps, k):
        """Returns the numbers of the steps that must be done before step k and that it does not stand on."""
        last = self.releases[steps[k].name][-1]
        return [i for i, it in enumerate(steps[:k])
                if not it.stays and i not in steps[k].on and self.must_precede(it, last)]


def needs_of(aux, demo):
    """Returns the Needs of a Demonstration; None without a plan, and for pictures alone, which show no segments."""
    return Needs(aux.plan, demo) if "plan" in aux and demo.segments else None


def needed_of(moved, demo, needs):
    """Returns the needed ones of some moved objects, their numbers; all of them if none would remain."""
    return [n for n in moved if needs is None or needs.needs_object(demo.ids[n])] or moved


def closed(numbers, steps):
    """Returns numbers of steps with those of all steps that must be done before them, in order."""
    found = set(numbers)
    for k in range(len(steps) - 1, -1, -1):
        if k in found:
            found.update(steps[k].on, steps[k].after)
    return sorted(found)
