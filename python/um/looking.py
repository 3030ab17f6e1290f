"""From a picture to the blocks in it.

Pictures are HxWx3, 0 to 1; row 0 is the top, column 0 the left.
"""

import math
from dataclasses import dataclass, replace

import numpy as np

from blocks import Block, same_color, same_size, turn_between
from constants import SEE
from places import is_inside


@dataclass
class Eye:
    """A camera that stands still."""

    intrinsics: np.ndarray  # 3x3 [pixels]
    pose: np.ndarray  # 4x4, x right, y down, z forward; translation in units


@dataclass
class Face:
    """A rectangle in a plane."""

    center: np.ndarray  # x y [units]
    yaw: float  # how its first side is turned [rad]
    sides: np.ndarray  # how long it is along the direction of yaw, and across [units]
    misfit: float  # by how much, in proportion, its pieces are less or more than such a rectangle


def find_blocks(picture, eye, like, container=None):
    """The blocks in a picture that look like some others (Blocks or Steps), wherever they are; some
    may lie in a container. A block of which something hides a part is not found."""
    table = table_color(picture)
    blocks = []
    for color in colors_in(picture, like):
        sizes = sizes_of(like, color)
        number = label_regions(is_color(picture, color))
        for region, size in enumerate(np.bincount(number.ravel())):
            if region == 0 or size < SEE.top_pixels:
                continue
            row, column = np.nonzero(number == region)
            blocks += fit_blocks(row, column, eye, color, sizes, container,
                                 lambda block: is_held_up(block, picture, eye, table))
    return blocks


def colors_in(picture, like):
    """The colors to look for, a list: those of some blocks; and if for one of them color does not
    matter, every color that is in the picture."""
    colors = [it.color for it in like if it.color is not None]
    if len(colors) < len(like):
        colors += colors_of(picture)
    return different_ones(colors)


def colors_of(picture):
    """Every color of a picture that more than a few pixels have, a list."""
    flat = np.round(picture * 255).astype(int).reshape(-1, 3)
    flat = flat[(flat > 0).all(axis=1) | (flat > SEE.bright_of_255).any(axis=1)]
    found, count = np.unique(flat @ [65536, 256, 1], return_counts=True)
    return different_ones([unpacked(color) for color in found[count > SEE.frequent_color_pixels]])


def different_ones(colors):
    """Colors that is_color cannot tell apart are one."""
    different = []
    for color in colors:
        if all(np.abs(color - other).max() >= SEE.different_colors for other in different):
            different.append(color)
    return different


def unpacked(number):
    """The color of a number 65536 red + 256 green + blue, each from 0 to 255."""
    return np.array([number // 65536, number // 256 % 256, number % 256]) / 255


def sizes_of(like, color):
    """The different sizes of blocks of a color among some, a list."""
    sizes = []
    for it in like:
        if same_color(it.color, color) and not any(same_size(size, it.size) for size in sizes):
            sizes.append(it.size)
    return sizes


def is_color(picture, color):
    """The pixels of a color: HxW bool. In the robot's eye each face of a block has one flat color:
    the true one on top, darker ones at the sides."""
    tolerance = SEE.color_tolerance + SEE.color_tolerance_bright * max(color)
    mask = np.abs(picture[:, :, 0] - color[0]) < tolerance
    for channel in (1, 2):
        mask &= np.abs(picture[:, :, channel] - color[channel]) < tolerance
    return mask


def label_regions(mask):
    """Numbers the connected regions of a picture's pixels: 0 where the mask (HxW bool) is false."""
    # Pixels that touch in a column are a run. Counting where runs begin numbers them.
    begins = mask.copy()
    begins[1:] &= ~mask[:-1]
    run = np.cumsum(begins.T).reshape(mask.T.shape).T * mask
    num_runs = run.max(initial=0)

    # Runs that touch side by side are of one region; the first of its runs stands for it.
    side_by_side = mask[:, :-1] & mask[:, 1:]
    left, right = run[:, :-1][side_by_side], run[:, 1:][side_by_side]
    touching = np.unique(left * (num_runs + 1) + right)
    first = list(range(num_runs + 1))

    def first_of(k):
        while first[k] != k:
            k = first[k]
        return k

    for pair in touching.tolist():
        one, other = sorted(map(first_of, divmod(pair, num_runs + 1)))
        first[other] = one
    numbers = np.unique([first_of(k) for k in range(num_runs + 1)], return_inverse=True)[1]
    return numbers[run]


def fit_blocks(row, column, eye, color, sizes, container, is_possible):
    """The block of a color and one of some sizes whose top these pixels are; or several equal ones
    in a row, or in rows, that touch. A list, empty if they are neither.

    container:   in which they may lie, or None
    is_possible: tells of a Block, as it seems to be, whether it can be there

    On a lower plane the same pixels would be a larger top, on a higher one a smaller. Blocks lie on
    blocks, so there are only few planes to try: the one on which the top is as large as it should
    be is the one it lies on. In a container, if there is one, all planes are higher by its floor.
    """
    best = SEE.side_error  # by how much, in proportion, a side may be wrong
    blocks = []
    for most in (1, SEE.most_abreast):
        for size in sizes:
            for floor in range(SEE.most_floors):
                top = size[2] + floor
                face = describe_face(*onto_plane(row, column, eye, top))
                if is_inside(container, face.center):
                    top += container.floor
                    face = describe_face(*onto_plane(row, column, eye, top))
                count = np.clip(np.round(face.sides / size[:2]), 1, most)
                wrong = max(*np.abs(face.sides / (count * size[:2]) - 1), face.misfit)
                if wrong >= best:
                    continue
                found = in_rows(face, count.astype(int), top, color, size)
                if all(map(is_possible, found)):
                    best = wrong
                    blocks = found
        if blocks:
            break
    return blocks


def in_rows(face, count, top, color, size):
    """Equal blocks side by side, as many along as across a Face as `count` tells: a list."""
    along = np.array([math.cos(face.yaw), math.sin(face.yaw)])
    across = np.array([-along[1], along[0]])
    blocks = []
    for i in np.arange(count[0]) - (count[0] - 1) / 2:
        for j in np.arange(count[1]) - (count[1] - 1) / 2:
            at = face.center + i * size[0] * along + j * size[1] * across
            blocks.append(Block(color, size, np.append(at, top - size[2] / 2), face.yaw))
    return blocks


def is_held_up(block, picture, eye, table):
    """Whether a block may be where it seems to be: if the table, of a color, is seen right below
    all of the edge that is nearest to the eye, it is not so high up but larger and nearer to the
    table."""
    under = block.bottom - SEE.below_edge
    if under < SEE.on_table:
        return True
    way = eye.pose[:2, 3] - block.position[:2]
    turns = round((math.atan2(way[1], way[0]) - block.yaw) / (math.pi / 2))
    toward = block.yaw + turns * math.pi / 2  # from the middle to that edge
    far, half = np.roll(block.size[:2], turns) / 2
    edge = block.position[:2] + far * np.array([math.cos(toward), math.sin(toward)])
    is_table = []
    for share in SEE.edge_shares:
        x, y = edge + share * half * np.array([-math.sin(toward), math.cos(toward)])
        spot = pixel_at(picture, eye, [x, y, under])
        if spot is not None:
            is_table.append(np.abs(picture[spot] - table).max() < SEE.table_tolerance)
    return not is_table or not all(is_table)


def table_color(picture):
    """The table's is the most frequent color but black, which is where there is nothing."""
    step = SEE.table_pixel_step
    pixels = np.round(255 * picture[::step, ::step]).astype(int).reshape(-1, 3) @ [65536, 256, 1]
    colors, count = np.unique(pixels[pixels > 0], return_counts=True)
    return unpacked(colors[count.argmax()]) if len(colors) else np.full(3, np.nan)


def find_outlines(picture, eye, color, height):
    """The rectangles of a color that may be rims of open boxes, at a height [units]: a list of
    Faces, the largest first, the first side the longer one. What is inside of them does not
    matter."""
    number = label_regions(is_color(picture, color))
    faces = []
    for region in np.flatnonzero(np.bincount(number.ravel()) >= SEE.outline_pixels):
        if region == 0:
            continue
        mask = number == region
        filled = np.logical_or.accumulate(mask, axis=1)
        filled &= np.logical_or.accumulate(mask[:, ::-1], axis=1)[:, ::-1]
        face = describe_face(*onto_plane(*np.nonzero(filled), eye, height))
        if face.misfit < SEE.misfit:
            faces.append(face)
    return sorted(faces, key=lambda face: -face.sides.prod())


def find_container(picture, eye, container):
    """A container of the demonstration where it stands in a picture, and how far it is turned from
    there [rad]; None and 0 if it is not seen."""
    for face in find_outlines(picture, eye, container.color, container.size[2]):
        if same_size(face.sides, container.size[:2]):
            turn = turn_between(container, face.yaw)
            position = np.append(face.center, container.position[2])
            return replace(container, position=position, yaw=container.yaw + turn), turn
    return None, 0


def onto_plane(row, column, eye, z):
    """Where the table's points at height z are that these pixels show, and how large each pixel is
    there: x, y [units], area [units squared], N numbers each."""
    p = eye.pose[:3, 3]
    R = eye.pose[:3, :3]
    K = eye.intrinsics
    # A ray through the middle of each pixel; camera axes are x right, y down, z forward.
    ray = R @ [(column + 0.5 - K[0, 2]) / K[0, 0], (row + 0.5 - K[1, 2]) / K[1, 1],
               np.ones(len(row))]
    along = (z - p[2]) / ray[2]  # how far along its ray each point lies
    # A plane seen at an angle: far pixels are larger, by the third power of the distance.
    area = along**3 / abs(z - p[2]) / (K[0, 0] * K[1, 1])
    return p[0] + along * ray[0], p[1] + along * ray[1], area


def describe_face(x, y, area, yaw=None):
    """The Face that small pieces of it make up: where they are and how large, N numbers each
    [units, units squared]. Its yaw is found by itself unless given [rad]."""
    total = area.sum()
    center = np.array([(x * area).sum(), (y * area).sum()]) / total
    x = x - center[0]
    y = y - center[1]
    if yaw is None:
        yaw = yaw_of(x, y, area)
    along = x * math.cos(yaw) + y * math.sin(yaw)
    across = y * math.cos(yaw) - x * math.sin(yaw)
    # The points of a rectangle lie around its center with a variance of a twelfth of the side,
    # squared.
    sides = np.sqrt(12 * np.array([(along**2 * area).sum(), (across**2 * area).sum()]) / total)
    return Face(center, yaw, sides, abs(sides.prod() / total - 1))


def yaw_of(x, y, area):
    """How a rectangle around the origin is turned [rad].

    Multiplying complex numbers adds their angles. So the squares of the pieces of something long
    all point about the same way, at twice its angle.
    """
    z = x + 1j * y
    long = (area * z**2).sum()
    spread = (area * abs(z) ** 2).sum()
    if abs(long) > SEE.elongated * spread:
        return float(np.angle(long)) / 2
    # A square has no long side, but its fourth power has a direction: the corners are farthest out
    # and count most, at 0 degrees they lie at 45, and four times that is 180; hence the minus.
    return float(np.angle(-(area * z**4).sum())) / 4


def to_pixel(point, eye):
    """Where the eye sees a point (x y z [units]) in its picture: u, v from the top left corner
    [pixels]."""
    seen = eye.pose[:3, :3].T @ (point - eye.pose[:3, 3])
    K = eye.intrinsics
    return np.array([K[0, 0], K[1, 1]]) * seen[:2] / seen[2] + K[:2, 2]


def pixel_at(picture, eye, point):
    """Row and column of the pixel that shows a point (x y z [units]); None outside the picture."""
    column, row = np.floor(to_pixel(point, eye)).astype(int)
    inside = 0 <= row < picture.shape[0] and 0 <= column < picture.shape[1]
    return (row, column) if inside else None
