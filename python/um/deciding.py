"""What is known of this scene, how far the building is, and what to do next."""

import math
from dataclasses import dataclass, field, replace
from typing import NamedTuple, Optional

import numpy as np

from acting import Action
from blocks import Block, Container, Step, has_equal_sides, is_drawn, is_like, turn_between
from carrying import is_within_reach, plan_carry
from constants import DECIDE, ROOM, SEE, numbers_of
from looking import find_blocks, find_container, pixel_at, table_color, to_pixel
from places import footprint, grip_room, is_walled_in, overlap, walls_of
from strangers import find_strangers


@dataclass
class Building:
    """What the brain remembers of the building."""

    steps: list  # what was shown; once a site is chosen, where it shall be in this scene
    container: Optional[Container] = None  # that some go into; then where it is in this scene
    has_site: bool = False
    known: list = field(default_factory=list)  # the blocks, where they were last seen
    strangers: list = field(default_factory=list)  # none of the steps', as they look; where they
    #                                                are is among the known
    done: list = field(init=False)  # whether each step's block is in its place
    tries: list = field(init=False)  # how often each step's block was carried there so far
    tidied: int = 0  # how often blocks were put somewhere else
    miss: dict = field(default_factory=dict)  # of a step: how far off its block was, units and rad
    stuck: int = 0  # how many steps in a row could not be gone on with, and
    trouble: str = ""  # why the first of them could not
    summary: str = ""  # one line for people, at the end

    def __post_init__(self):
        self.done = [False] * len(self.steps)
        self.tries = [0] * len(self.steps)


class Move(NamedTuple):
    """Something that might be moved next."""

    block: Block  # one of those known
    goal: Optional[Step] = None  # None puts the block aside, where it disturbs nothing


def decide(building, sensor, eye, robot):
    """Looks where the blocks are and says what to do next: actions; [] when all is built or nothing
    helps."""
    picture = sensor.rgbVision / 255
    # Where the container stands here is not known before a site is chosen.
    container = building.container if building.has_site else None
    seen = find_blocks(picture, eye, building.steps + building.strangers, container)
    if not building.has_site or building.stuck > 0:
        building.strangers += find_strangers(picture, eye, seen + building.known)
        seen = find_blocks(picture, eye, building.steps + building.strangers, container)
    building.known = remember(building.known, seen, picture, eye)
    if not building.has_site:
        choose_site(building, robot, picture, eye)
        if not building.has_site:
            return []

    used = compare(building)
    steps = open_steps(building)
    if not steps:
        far, turned = np.max(list(building.miss.values()), axis=0)
        building.summary = "built, as seen within %.2f units and %.1f degrees" % (
            far, math.degrees(turned))
        return []

    # The next step in the order shown; when nothing helps there, one of those that can be done as
    # well.
    k = steps[building.stuck % len(steps)]
    step = building.steps[k]
    reason = "it cannot be seen"
    if building.tries[k] >= DECIDE.most_tries:
        reason = f"{DECIDE.most_tries} tries were not enough"
    elif building.tidied >= DECIDE.most_tidied:
        reason = f"{DECIDE.most_tidied} blocks had to be put somewhere else already"
    else:
        free = [block for block in building.known if block not in used]
        for move in propose_moves(building, step, free):
            actions, place, reason = plan_move(building, step, move, eye, robot,
                                               sensor.jointAngles)
            if not actions:
                continue
            if place:
                building.tidied += 1
            else:
                building.tries[k] += 1
            building.known.remove(move.block)
            building.known += place
            building.stuck = 0
            return actions
    if building.stuck == 0:
        building.trouble = f"{step}: {reason}"
    building.stuck += 1
    if building.stuck > len(steps) + 1:
        building.summary = f"gave up at {building.trouble}"
        return []
    return [Action("look")]


def open_steps(building):
    """Numbers of the steps that are not done and stand on what is done, in the order shown."""
    return [k for k, step in enumerate(building.steps)
            if not building.done[k] and all(building.done[lower] for lower in step.on)]


def remember(known, seen, picture, eye):
    """What is known of the blocks after a look, a list: those seen, and those that were known
    before and may be hidden now, by what was built or by what lies on them. Where the table is
    seen, nothing is left."""
    table = table_color(picture)
    now = list(seen)
    for block in known:
        same = any(np.linalg.norm(it.position - block.position) < DECIDE.same_block for it in now)
        if not same and not shows_table(picture, eye, block, table):
            now.append(block)
    return now


def shows_table(picture, eye, block, table):
    """At the middle of its top."""
    spot = pixel_at(picture, eye, [*block.position[:2], block.top])
    return spot is not None and np.abs(picture[spot] - table).max() < SEE.table_tolerance


def choose_site(building, robot, picture, eye):
    """Chooses where the building shall stand, and shifts the steps there: what goes into a
    container to where that is seen, what is drawn from where it is known to be, all else to where
    there is room. Without such a site, has_site stays false and the summary says so."""
    try:
        carried = [step for step in building.steps if not is_drawn(step)]
        if building.container:
            carried, building.container = into_container(carried, building.container, picture, eye)
        elif carried:
            carried = on_table(carried, building.known, robot)
        carried = iter(carried)
        building.steps = [drawn_from_here(step, building.known) if is_drawn(step)
                          else next(carried) for step in building.steps]
        building.has_site = True
    except NoSite as problem:
        building.summary = str(problem)


class NoSite(Exception):
    """There is no place for what shall be done."""


def drawn_from_here(step, known):
    """From the one block that looks like what was drawn, along the same way as seen from it."""
    found = [block for block in known if is_like(block, step)]
    if len(found) != 1:
        raise NoSite(f"{len(found)} things are seen that look like {step}")
    turn = turn_between(step, found[0].yaw)
    way = turned(step.way, turn)
    return replace(step, way=way, position=found[0].position + [*way, 0], yaw=step.yaw + turn)


def into_container(steps, container, picture, eye):
    """As they lay in the container; and where that is."""
    found, turn = find_container(picture, eye, container)
    if not found:
        raise NoSite(f"the container {container.name} cannot be seen")
    moved = []
    for step in steps:
        way = turned(step.position[:2] - container.position[:2], turn)
        position = np.append(found.position[:2] + way, step.position[2])
        moved.append(replace(step, position=position, yaw=step.yaw + turn))
    return moved, found


def turned(way, angle):
    c, s = math.cos(angle), math.sin(angle)
    return np.array([way[0] * c - way[1] * s, way[0] * s + way[1] * c])


def on_table(steps, known, robot):
    """Where the arms reach each place, with few blocks in the way."""
    shown = np.array([step.position[:2] for step in steps])
    middle = (shown.min(axis=0) + shown.max(axis=0)) / 2
    sites = []
    for y in numbers_of(*DECIDE.site_y):
        for x in numbers_of(*DECIDE.site_x):
            there = shifted(steps, [x, y] - middle)
            walled_in = [block for block in known if is_walled_in(block, there)]
            # Far from the robot the building hides little, and near it the arms reach more.
            cost = DECIDE.far_site_cost * abs(y - DECIDE.best_site_y)
            cost += DECIDE.side_site_cost * abs(x) + sum(block.size[0] for block in walled_in)
            sites.append((cost, there))
    for _, there in sorted(sites, key=lambda site: site[0]):
        if all(is_within_reach(robot, int(step.position[0] > 0), step) for step in there):
            return there
    raise NoSite("no place on the table is within reach for all of the building")


def shifted(steps, way):
    """The same building somewhere else on the table: way is x, y [units]."""
    return [replace(step, position=step.position + [*way, 0]) for step in steps]


def compare(building):
    """Which steps are done, going by what is known of the blocks. Returns the blocks that make them
    so, a list."""
    used = []
    for k, step in enumerate(building.steps):
        building.done[k] = False
        for block in building.known:
            far = np.linalg.norm(block.position - step.position)
            off = abs(turn_between(step, block.yaw))
            is_there = far < DECIDE.near and off < DECIDE.even_rad
            if block not in used and is_like(block, step) and is_there:
                building.miss[k] = far, off
                building.done[k] = True
                used.append(block)
                break
    return used


def propose_moves(building, step, free):
    """What might be moved next to get a step done, the best first: a list of Moves.

    free: those of the known blocks that are in no step's place
    """
    fits = [block for block in free if is_like(block, step)]
    in_way = [block for block in free if is_in_way(block, step)]
    walled = [block for block in free if is_walled_in(block, building.steps)]

    # First what will be hard to get at when more stands, and what looks right and is near.
    def away(block):
        return 0 if block in in_way + walled else np.linalg.norm(block.position - step.position)

    fits.sort(key=away)
    moves = [Move(block) for block in without_doubles(in_way + walled) if block not in fits]
    moves += [Move(block) for block in in_way if block in fits[1:]]
    moves += [Move(block, step) for block in fits if not set(in_way) - {block}]
    # Then what lies on other blocks: what is wanted may be below it.
    moves += [Move(block) for block in free if block.position[2] > block.size[2]]
    # What something lies on waits for that.
    return [move for move in moves if not lies_below(move.block, free)]


def is_in_way(block, step):
    """Whether a block lies where a step's shall, or where the fingers that bring it need room."""
    [room] = grip_room([step])
    return overlap(room, footprint([block], 0)).any()


def without_doubles(blocks):
    return list(dict.fromkeys(blocks))


def lies_below(block, others):
    """Whether some of the others lies on a block."""
    higher = [it for it in others if it.position[2] > block.position[2] + DECIDE.above]
    [covered] = footprint([block], 0)
    return overlap(covered, footprint(higher, 0)).any()


def plan_move(building, step, move, eye, robot, q):
    """Straight to its goal, if it has one and an arm reaches both; else to somewhere else first, if
    need be where the building will stand later.

    Returns actions; the block where it will lie on the table, even if it is hidden there, in a list
    that is empty for one that is built in, as there it must be seen; and the reason if there are no
    actions.
    """
    others = [block for block in building.known if block is not move.block]
    others += support_of(move.block) + walls_of(building.container)
    container = [building.container] if building.container else []
    standing = [step for step, done in zip(building.steps, building.done) if done] + container
    sites = [building.steps + container]
    if move.goal:
        sites.append(standing)
        actions, reason = plan_carry(robot, move.block, move.goal, others, q)
        if actions:
            return actions, [], None
    elif is_in_way(move.block, step):
        sites.append(standing + [step])
    return plan_aside(robot, eye, move.block, others, sites, q, move.goal)


def support_of(block):
    """What a block stands on that is not on the table, as if it were one Block: something must be
    there, even if it hides it. In a list, empty for a block on the table."""
    if block.bottom < DECIDE.stands_high:
        return []
    x, y, _ = block.position
    return [replace(block, size=np.append(block.size[:2], block.bottom),
                    position=np.array([x, y, block.bottom / 2]))]


def plan_aside(robot, eye, block, others, sites, q, goal):
    """The actions that bring a block to a free place on the table that the eye sees.

    sites: lists of what is or will be built, to keep off: the first with which there is a place
           counts
    goal:  where another arm shall bring it from there at once; None if that does not matter yet
    Returns actions and that place, in a list, and None; or [], [] and a reason if there is none.
    """
    arms = arms_for(robot, block, goal)
    if not arms:
        return [], [], "no arm reaches it"
    reason = "there is no free place on the table"
    for site in sites:
        tries = DECIDE.place_tries
        for place in free_places(block, others + site, goal):
            if (not is_seen(place, eye) or is_walled_in(place, site)
                    or not can_pass_on(robot, arms, place, goal)):
                continue
            if goal is None or plan_carry(robot, place, goal, others, q)[0]:
                actions, reason = plan_carry(robot, block, place, others, q)
                if actions:
                    return actions, [place], None
            tries -= 1
            if tries == 0:
                break
    return [], [], reason


def free_places(block, taken, goal):
    """Where a block might lie on the table, a list of up to 100, the best places first: with room
    for fingers, its own and those of its neighbors."""
    yaw, y, x = (it.ravel() for it in np.meshgrid(
        [0, math.pi / 2, math.pi / 4, -math.pi / 4], numbers_of(*DECIDE.place_y),
        numbers_of(*DECIDE.place_x), indexing="ij"))
    sides = np.ones_like(x)[:, None] * (block.size[:2] + DECIDE.place_margin)
    covered = np.column_stack([x, y, sides, yaw])
    with_fingers = covered + [0, 0, 0, DECIDE.place_fingers, 0]
    free = np.ones(len(x), bool)
    for rectangle in footprint(taken, ROOM.site_margin):
        free &= ~overlap(rectangle, with_fingers)
    # Square blocks can be held the other way round, too.
    for rectangle in grip_room([it for it in taken if not has_equal_sides(it)]):
        free &= ~overlap(rectangle, covered)

    if goal is None:
        # The middle, where both arms reach, is for passing on.
        way = np.hypot(x - block.position[0], y - block.position[1])
        way += np.maximum(DECIDE.middle - np.abs(x), 0)
    else:
        way = np.abs(x) + DECIDE.passing_y_cost * np.abs(y - DECIDE.passing_y)
    most = min(DECIDE.most_places, free.sum())
    best = np.argsort(np.where(free, way, np.inf), kind="stable")[:most]
    return [replace(block, position=np.array([x[i], y[i], block.size[2] / 2]), yaw=yaw[i])
            for i in best]


def is_seen(place, eye):
    """Whether all of its top is in the eye's picture."""
    along = place.size[0] / 2 * np.array([math.cos(place.yaw), math.sin(place.yaw), 0])
    across = place.size[1] / 2 * np.array([-math.sin(place.yaw), math.cos(place.yaw), 0])
    middle = np.array([*place.position[:2], place.size[2]])
    corners = [middle + a * along + b * across for a in (1, -1) for b in (1, -1)]
    pixels = np.array([to_pixel(corner, eye) for corner in corners])
    margin = DECIDE.picture_margin_pixels
    return ((pixels > margin) & (pixels < 2 * eye.intrinsics[:2, 2] - margin)).all()


def arms_for(robot, block, goal):
    """The arms that can bring a block somewhere from where another can bring it to a goal, if there
    is one: a list."""
    return [arm for arm in (0, 1) if is_within_reach(robot, arm, block)
            and (goal is None or is_within_reach(robot, 1 - arm, goal))]


def can_pass_on(robot, arms, place, goal):
    """Whether one of these arms reaches a place, and the other one too if it is to go on from
    there."""
    return any(is_within_reach(robot, arm, place)
               and (goal is None or is_within_reach(robot, 1 - arm, place)) for arm in arms)
