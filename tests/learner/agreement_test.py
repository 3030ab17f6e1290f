"""The learner's functions in Python and in Octave return the same numbers.

    agreement_test.py OCTAVE...     the command that runs agreement.m, with the same inputs
"""

import math
import subprocess
import sys
from unittest.mock import patch

import numpy as np

from act.finger_room import grasp_yaws, is_grasp_blocked
from check.task_state import TaskState
from plan.free_places import is_free
from plan.loads import belongs_to, load_of, whole_of
from plan.making_room import room_moves
from plan.moves import Move
from plan.skyline import skyline_of
from see.denoising import without_noise
from see.eye import Eye, onto_plane, to_pixel
from see.faces import fit_face
from see.gains import brightened, gains_between
from see.light import clear_matches, color_changes
from see.pictures import noise_of
from things.areas import overlap
from things.blocks import Block, yaw_difference
from things.steps import Step


def answers():
    c, s = math.cos(2.55), math.sin(2.55)
    eye = Eye(np.array([[415.7, 0, 320], [0, 415.7, 240], [0, 0, 1]]),
              np.array([[1, 0, 0, 0.1], [0, c, -s, -6.1], [0, s, c, 11.6], [0, 0, 0, 1]]))
    rectangles = []
    for k in range(40):
        column, row = np.meshgrid(100 + 9 * k + np.arange(4 + k % 5), 120 + 7 * k + np.arange(10))
        column, row = (column + row // 4).T.ravel(), row.T.ravel()
        x, y, area = onto_plane(row, column, eye, 0.1 * k)
        yield np.column_stack([x, y, area])
        face = fit_face(x, y, area)
        yield [*face.center, face.yaw, *face.sides, face.misfit]
        face = fit_face(x, y, area, 0.1 * k)
        yield [face.yaw, *face.sides, face.misfit]
        yield to_pixel([x[0], y[0], 0.1 * k], eye)

        rectangles.append([37 * k % 11 / 2, 23 * k % 7 / 2, 0.5 + k % 4, 1, 0.3 * k])
        yield overlap(rectangles[-1], rectangles)
        x, y, side, _, yaw = rectangles[-1]
        size = np.array([side + 1, 1, 1])
        place = Block(None, size, np.array([x, y, 0.5]), yaw)
        other = Block(None, size, np.array([2, 1, 0.5 + k % 3]), yaw)
        yield grasp_yaws(place, [other])
        yield is_grasp_blocked(place, [other])
        yield yaw_difference(place, 1 - 0.2 * k)
        yield is_free(np.array(rectangles), [place, other])
    x, y = (it.T.ravel() for it in np.meshgrid(np.arange(-20, 21), np.arange(-20, 21)))
    inside = np.hypot(x, y) < 20
    face = fit_face(x[inside], y[inside], np.ones(inside.sum()))
    assert face.is_round and abs(face.sides[0] - 40) < 0.5
    yield [*face.center, *face.sides, face.misfit, face.is_round]
    robot_pose = np.array([[1, 0, 0, 0.1], [0, c, s, -6.1], [0, -s, c, 11.6], [0, 0, 0, 1]])
    yield from moves_that_make_room(Eye(eye.intrinsics, robot_pose))


def moves_that_make_room(eye):
    """Of which blocks, and for which place of a plank, if any plan succeeds."""
    color, cube = np.zeros(3), np.ones(3)
    plank = Block(color, np.array([5.0, 1, 1]), np.array([-4, -0.2, 0.5]), 0.0)
    cubes = [Block(color, cube, np.array([x, y, 0.5]), 0.0) for x in range(-6, 7, 3) for y in (-4.5, -2.8, -1)]
    step = Step(color, cube, np.array([0, -2, 0.5]), 0.0, "step", [])
    state = TaskState([step])
    state.known = [plank, *cubes]
    state.unexplained = np.zeros((0, 2))
    for goal in None, step:
        with patch("plan.making_room.is_suitable", return_value=True), \
                patch("plan.making_room.plan_to_place", return_value=([0], None)):
            moves = room_moves(state, step, [Move(plank, goal)], state.known, [], eye, None)
        assert moves
        for move in moves:
            yield [*move.block.position, *move.room.position, move.room.yaw]

    yield from what_a_tool_passes()
    yield from colors_in_another_light()
    yield from flat_colors()


def what_a_tool_passes():
    """Visible points as a skyline, as parts of a tool, and as a load."""
    k = np.arange(400)
    points = np.column_stack([37 * k % 101 / 20, 23 * k % 67 / 20, 11 * k % 29 / 10 + 0.1])
    for margin in 0.1, 0.65:
        skyline = skyline_of(points).widened(margin)
        yield skyline.corner
        yield skyline.heights.T
        yield [skyline.is_below(points[i:i + 1] + [0, 0, 0.5]) for i in k]
    tool = Block(None, np.array([2, 0.5, 1]), np.array([1, 1.5, 0.5]), 0.4)
    is_tool = belongs_to(tool, points[::3])
    yield is_tool
    pose = np.array([[1, 0, 0, 1], [0, -1, 0, 2], [0, 0, -1, 3], [0, 0, 0, 1]])
    yield load_of(whole_of(points[::3][is_tool], 0.5), pose).points.T


def colors_in_another_light():
    """By how much colors changed, and which are the same; 9 and 0 if they are not; and how much brighter it is."""
    for k in range(60):
        wanted = np.array([[37 * i * k % 11, (23 * i + k) % 7, (i + 1) * k % 5] for i in range(1, 4)]) / 10
        seen = np.array([[31 * i * k % 11, (23 * i + k) % 6, (i + 1) * k % 5] for i in range(1, 6)]) / 12
        changes = color_changes(wanted, seen)
        yield np.minimum(changes, 9).T
        yield [0 if it is None else it + 1 for it in clear_matches(changes)]
        shown = 0.05 + 0.9 * ((np.outer(np.arange(1, 25), [0.754877, 0.569840, 0.430159]) + 0.1 * k) % 1)
        seen = brightened(shown[:15], [0.5 + 0.02 * k, 0.6 + 0.01 * k, 1])
        yield gains_between(shown, shown)
        yield gains_between(shown, np.round(255 * seen) / 255)


def flat_colors():
    """A picture of four faces, with noise and without."""
    row, column = np.indices((24, 30))
    face = 0.1 + 0.25 * (row // 12) + 0.4 * (column // 15)
    picture = np.stack([np.clip(face * (it / 2) + 0.04 * ((row * (31 + it) + column * 17) % 23 / 22 - 0.5), 0, 1)
                        for it in (1, 2, 3)], axis=2)
    yield [noise_of(picture)]
    yield from without_noise(picture, 0.04, 4).T
    yield from without_noise(picture, 0.08, 1).T


def main():
    expected = subprocess.run(sys.argv[1:], check=True, stdout=subprocess.PIPE, text=True).stdout
    expected = np.array(expected.split(), float)
    found = np.concatenate([np.ravel(answer) for answer in answers()]).astype(float)
    assert len(expected) == len(found) > 5000, f"{len(found)} answers, {len(expected)} expected"
    wrong = np.flatnonzero(~np.isclose(found, expected, rtol=1e-9, atol=1e-9))
    for i in wrong[:10]:
        print(f"answer {i} is {found[i]}, in Octave {expected[i]}")
    sys.exit(len(wrong) > 0)


main()
