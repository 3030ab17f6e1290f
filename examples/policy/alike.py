"""Objects that look alike: no picture tells them apart, and no task does, so they may change their names."""

import itertools
import xml.etree.ElementTree as ElementTree

import numpy as np

OWN = ("id", "location", "rotation")  # what objects of a scene differ in though they look alike


def looks_of(scene, names):
    """(N,) numbers: the same for objects that look alike in the file `scene`."""
    found = {}
    for element in ElementTree.parse(scene).iter():
        if element.get("id") in names:
            rest = sorted((key, value) for key, value in element.items() if key not in OWN)
            found[element.get("id")] = element.tag, rest, [
                ElementTree.canonicalize(ElementTree.tostring(child), strip_text=True) for child in element]
    kinds = list(found.values())
    return np.array([kinds.index(found[name]) for name in names])


def order_by(xp, looks, keys):
    """(…, N): for each object, which one takes its place when those that look alike are sorted by keys (…, N)."""
    by_look = xp.lexsort((keys, xp.broadcast_to(xp.asarray(looks), keys.shape)))
    return by_look[..., np.argsort(np.argsort(looks, kind="stable"))]


def order_as_before(looks, places, before):
    """The same for places (N, 4), so that objects that look alike are as near as possible to where they were before."""
    order = np.arange(len(looks))
    for look in set(looks):
        alike = np.flatnonzero(looks == look)
        away = np.linalg.norm(places[None, alike, :3] - before[alike, None, :3], axis=-1)
        ways = itertools.permutations(range(len(alike)))
        order[alike] = alike[list(min(ways, key=lambda way: away[range(len(alike)), way].sum()))]
    return order
