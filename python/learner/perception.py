"""Detects blocks in pictures.

Pictures are HxWx3, 0 to 1; row 0 is the top, column 0 the left.
"""

import math
from dataclasses import dataclass, replace

import numpy as np

from blocks import Block, same_color, same_size, yaw_difference
from clearance import footprint, is_inside, overlap
from constants import PERCEPTION as C, numbers_of


@dataclass
class Eye:
    """A camera at a fixed place."""

    intrinsics: np.ndarray  # 3x3 [pixels]
    pose: np.ndarray  # 4x4, x right, y down, z forward; translation in units


@dataclass
class Face:
    """A rectangle in a plane."""

    center: np.ndarray  # x y [units]
    yaw: float  # of its first side [rad]
    sides: np.ndarray  # lengths along the direction of yaw, and across it [units]
    misfit: float  # relative difference between the area of its pixels and that of the rectangle


def height_map(depth, eye):
    """Returns the height above the table of the surface in each pixel, HxW [units]; 0 where there
    is none.

    depth: HxW, distance along the axis of the camera [units]; 0 where there is no surface
    """
    row, column = np.indices(depth.shape) + 0.5
    K = eye.intrinsics
    right, down, forward = eye.pose[2, :3]
    rise = right * (column - K[0, 2]) / K[0, 0] + down * (row - K[1, 2]) / K[1, 1] + forward
    return np.where(depth > 0, eye.pose[2, 3] + depth * rise, 0)


def detect_blocks(picture, eye, like, container=None, heights=None):
    """Detects the blocks in a picture that look like given ones (Blocks or Steps), at any place and
    height; some may lie in a container. Partly occluded blocks are not detected. Returns a list.

    heights: as from height_map: separates tops of one color that meet in the picture; None if the
             eye measures no depth
    """
    table = table_color(picture)
    blocks = []
    for color in colors_to_detect(picture, like):
        sizes = block_sizes(like, color)
        bottoms = [likely_bottoms(like, color, size, heights) for size in sizes]
        number = label_regions(color_mask(picture, color), heights)
        for region, count in enumerate(np.bincount(number.ravel())):
            if region == 0 or count < C.min_top_pixels:
                continue
            row, column = np.nonzero(number == region)
            top, max_error = None, C.max_side_error
            if heights is not None:
                if not is_level(heights[row, column]):
                    continue
                top = np.median(heights[row, column])
                if is_cut(row, column, top, heights):
                    max_error = C.max_cut_side_error
            blocks += fit_blocks(row, column, eye, color, sizes, container,
                                 lambda block: is_supported(block, picture, eye, table), bottoms,
                                 top, max_error)
    return blocks


def is_cut(row, column, top, heights):
    """Returns true if something higher hides a part of a top face, or the border of the picture
    cuts it off: it touches pixels of higher surfaces."""
    edge = np.pad(heights > top + C.height_step, 1, constant_values=True)
    beside = np.zeros(edge.shape, bool)
    for down, right in ((0, 1), (2, 1), (1, 0), (1, 2)):
        beside[row + down, column + right] = True
    return (beside & edge).sum() >= C.min_cut_pixels


def likely_bottoms(like, color, size, heights):
    """Returns the heights at which the bottom of a block of some color and size may be expected
    [units]: on the table, where such blocks are or must go, and, without measured heights, on
    whole layers."""
    bottoms = [it.bottom for it in like if same_color(it.color, color) and same_size(size, it.size)]
    layers = range(C.max_layers) if heights is None else [0]
    return np.unique(np.round(100 * np.array([*layers, *bottoms])) / 100)


def colors_to_detect(picture, like):
    """Returns the colors to detect, a list: those of some blocks and, if the color of one of them
    does not matter, every frequent color of the picture."""
    colors = [it.color for it in like if it.color is not None]
    if len(colors) < len(like):
        colors += frequent_colors(picture)
    return distinct_colors(colors)


def frequent_colors(picture, min_pixels=C.frequent_color_pixels):
    """Returns the colors that more than a few pixels of a picture have, a list."""
    flat = np.round(picture * 255).astype(int).reshape(-1, 3)
    flat = flat[(flat > 0).all(axis=1) | (flat > C.bright_of_255).any(axis=1)]
    found, count = np.unique(flat @ [65536, 256, 1], return_counts=True)
    frequent = found[count > min_pixels]
    return distinct_colors([color_of_code(color) for color in frequent])


def distinct_colors(colors):
    """Merges colors that color_mask cannot distinguish: a list."""
    distinct = []
    for color in colors:
        if all(np.abs(color - other).max() >= C.distinct_colors for other in distinct):
            distinct.append(color)
    return distinct


def color_of_code(number):
    """Returns the color of a number 65536 red + 256 green + blue, each from 0 to 255."""
    return np.array([number // 65536, number // 256 % 256, number % 256]) / 255


def block_sizes(like, color):
    """Returns the distinct sizes of blocks of a color among some, a list."""
    sizes = []
    for it in like:
        if same_color(it.color, color) and not any(same_size(size, it.size) for size in sizes):
            sizes.append(it.size)
    return sizes


def color_mask(picture, color):
    """Returns the mask, HxW bool, of the pixels that have a color. In the robot's eye each face of
    a block has one flat color: its true color on top, darker ones at the sides."""
    tolerance = C.color_tolerance + C.color_tolerance_bright * max(color)
    mask = np.abs(picture[:, :, 0] - color[0]) < tolerance
    for channel in (1, 2):
        mask &= np.abs(picture[:, :, channel] - color[channel]) < tolerance
    return mask


def label_regions(mask, heights=None):
    """Labels the connected regions of a mask, HxW bool: 0 where it is false, otherwise numbers from
    1. With heights, as from height_map, a step between two pixels separates regions."""
    number = np.zeros(mask.shape, int)
    rows = np.flatnonzero(mask.any(axis=1))
    if len(rows):
        # Most masks fill a small part of the picture.
        columns = np.flatnonzero(mask.any(axis=0))
        part = np.s_[rows[0]:rows[-1] + 1, columns[0]:columns[-1] + 1]
        number[part] = labels_within(mask[part], None if heights is None else heights[part])
    return number


def labels_within(mask, heights):
    """Labels the connected regions of a mask."""
    in_column = mask[1:] & mask[:-1]
    side_by_side = mask[:, :-1] & mask[:, 1:]
    if heights is not None:
        in_column &= np.abs(np.diff(heights, axis=0)) < C.height_step
        side_by_side &= np.abs(np.diff(heights, axis=1)) < C.height_step

    # Pixels that touch in a column are a run. Counting the beginnings of runs numbers them.
    begins = mask.copy()
    begins[1:] &= ~in_column
    run = np.cumsum(begins.T).reshape(mask.T.shape).T * mask
    num_runs = run.max(initial=0)

    # Runs that touch side by side belong to one region (union-find): its first run represents it.
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


def fit_blocks(row, column, eye, color, sizes, container, is_possible, bottoms, top=None,
               max_side_error=C.max_side_error):
    """Fits blocks to the pixels of a top face: one block of a color and one of some sizes, or equal
    blocks that touch in a row or a grid. Returns a list, empty if nothing fits.

    row, column: pixels, N numbers each
    container:   in which they may lie, or None
    is_possible: predicate: returns true if there can be such a Block at its place
    bottoms:     for each size, the heights where the bottom is expected [units]
    top:         measured height of the face [units], or None
    max_side_error: greatest relative error of the sides

    On a lower plane the same pixels would be a larger top, on a higher one a smaller. Without a
    measured height, the plane is the one of the expected ones at which the size of the top is
    right. Inside the container, all planes are higher by its floor. With a measured height, blocks
    whose bottom would be where it is expected are preferred: the size of the top alone does not
    distinguish a high block from a low one on a support.
    """
    best = max_side_error
    blocks = []
    for max_count, is_expected in ((1, True), (1, False), (C.max_abreast, True),
                                   (C.max_abreast, False)):  # blocks side by side
        for size, expected in zip(sizes, bottoms):
            for plane in candidate_tops(size, expected, top, is_expected):
                face = fit_face(*onto_plane(row, column, eye, plane))
                if top is None and is_inside(container, face.center):
                    plane += container.floor
                    face = fit_face(*onto_plane(row, column, eye, plane))
                count = np.clip(np.round(face.sides / size[:2]), 1, max_count)
                max_error = max(*np.abs(face.sides / (count * size[:2]) - 1), face.misfit)
                if max_error >= best:
                    continue
                found = block_grid(face, count.astype(int), plane, color, size)
                if top is not None and is_expected or all(map(is_possible, found)):
                    best = max_error
                    blocks = found
        if blocks:
            break
    return blocks


def candidate_tops(size, bottoms, top, is_expected):
    """Returns the heights at which the top of a block may be [units], a list: its measured height,
    or, if there is none, those at which its bottom is expected.

    is_expected: whether to return the heights with an expected bottom, or the others
    """
    if top is None:
        return [size[2] + bottom for bottom in bottoms] if is_expected else []
    error = np.abs(top - size[2] - bottoms).min()
    is_above_table = top - size[2] > -C.on_table
    return [top] if (error < C.on_table) == is_expected and is_above_table else []


def block_grid(face, count, top, color, size):
    """Returns count[0] x count[1] equal Blocks that fill a Face at height `top` [units]: a list."""
    along = np.array([math.cos(face.yaw), math.sin(face.yaw)])
    across = np.array([-along[1], along[0]])
    blocks = []
    for i in np.arange(count[0]) - (count[0] - 1) / 2:
        for j in np.arange(count[1]) - (count[1] - 1) / 2:
            at = face.center + i * size[0] * along + j * size[1] * across
            blocks.append(Block(color, size, np.append(at, top - size[2] / 2), face.yaw))
    return blocks


def is_supported(block, picture, eye, table):
    """Returns true if a block may be where it appears. If the table is visible right below all of
    the edge that is closest to the eye, the block is not so high up, but larger and closer to the
    table.

    table: color of the table
    """
    below_bottom = block.bottom - C.below_edge
    if below_bottom < C.on_table:
        return True
    direction = eye.pose[:2, 3] - block.position[:2]
    quarter_turns = round((math.atan2(direction[1], direction[0]) - block.yaw) / (math.pi / 2))
    toward = block.yaw + quarter_turns * math.pi / 2  # from the middle to that edge
    far, half = np.roll(block.size[:2], quarter_turns) / 2
    edge = block.position[:2] + far * np.array([math.cos(toward), math.sin(toward)])
    is_table = []
    for fraction in C.edge_fractions:
        x, y = edge + fraction * half * np.array([-math.sin(toward), math.cos(toward)])
        pixel = pixel_at(picture, eye, [x, y, below_bottom])
        if pixel is not None:
            is_table.append(np.abs(picture[pixel] - table).max() < C.table_tolerance)
    return not is_table or not all(is_table)


def table_color(picture):
    """Returns the color of the table: the most frequent one except black, the background."""
    step = C.table_pixel_step
    pixels = np.round(255 * picture[::step, ::step]).astype(int).reshape(-1, 3) @ [65536, 256, 1]
    colors, count = np.unique(pixels[pixels > 0], return_counts=True)
    return color_of_code(colors[count.argmax()]) if len(colors) else np.full(3, np.nan)


def detect_unknown_objects(picture, eye, known, heights=None):
    """Detects Blocks that are none of the known ones; they belong to no step, but may be in the
    way. Without heights, as from height_map, only those on the table. Returns a list."""
    table = table_color(picture)
    unknown = []
    for color, row, column in segment_top_faces(picture, table, heights):
        if any(is_top_of(row, column, it, picture, eye, heights) for it in known):
            continue
        block = measure_block(color, row, column, picture, eye, table, heights)
        if not block:
            continue
        beside = [it for it in known if it.top > block.bottom + C.on_table
                  and it.bottom < block.top - C.on_table]
        if not overlap([*block.position[:2], 0, 0, 0], footprint(beside, 0)).any():
            unknown.append(block)
    return unknown


def is_top_of(row, column, block, picture, eye, heights=None):
    """Returns true if a segmented top face contains the middle of a block's top."""
    pixel = pixel_at(picture, eye, [*block.position[:2], block.top])
    if pixel is None or not ((row == pixel[0]) & (column == pixel[1])).any():
        return False
    return heights is None or abs(heights[pixel] - block.top) < C.height_step


def segment_top_faces(picture, table, heights=None):
    """Segments the flat areas of a picture that may be tops of blocks: those at one height above
    the table, or, without heights, those that are not, like the sides of blocks, below a brighter
    area of the same hue. Returns a list of color, rows and columns.

    table: color of the table
    """
    codes = np.round(255 * picture).astype(int) @ [65536, 256, 1]
    tops = []
    for color, mask in color_masks(picture, codes, heights is not None):
        if color_mask(color[None, None], table).all():
            continue
        number = label_regions(mask, heights)
        for region, size in enumerate(np.bincount(number.ravel())):
            if region == 0 or size < C.min_unknown_object_pixels:
                continue
            row, column = np.nonzero(number == region)
            if (is_level(heights[row, column]) if heights is not None
                    else not is_below_brighter(color, codes, row, column)):
                tops.append((color, row, column))
    return tops


def color_masks(picture, codes, is_tolerant):
    """Yields the frequent colors of a picture and the masks of their pixels.

    codes:       of the colors of the pixels
    is_tolerant: whether the colors may differ a little; otherwise they are exact, to distinguish
                 tops from sides
    """
    if is_tolerant:
        for color in frequent_colors(picture, C.min_unknown_object_pixels):
            yield color, color_mask(picture, color)
        return
    for code, count in zip(*np.unique(codes, return_counts=True)):
        if code > 0 and count >= C.min_unknown_object_pixels:
            yield color_of_code(code), codes == code


def is_level(heights):
    """Returns true if the heights of some pixels, N numbers, are those of one level area above the
    table."""
    ordered = np.sort(heights)
    low, middle, high = (ordered[int(fraction * (len(ordered) - 1))] for fraction in (0.1, 0.5, 0.9))
    return middle > C.on_table and high - low < C.height_step


def is_below_brighter(color, codes, row, column):
    """Returns true if an area of one color is below a brighter area of the same hue."""
    above = codes[np.maximum(row - 1, 0), column]
    colors, often = np.unique(above[(above != codes[row[0], column[0]]) & (row > 0)],
                              return_counts=True)
    return len(colors) > 0 and is_darker_shade(color, color_of_code(colors[often.argmax()]))


def is_darker_shade(color, bright):
    """Returns true if a color is a darker shade of the same hue: that of a side of a block with a
    bright top."""
    fraction = (color * bright).sum() / max((bright**2).sum(), np.finfo(float).eps)
    least, greatest = C.shade
    difference = np.abs(color - fraction * bright).max()
    return least < fraction < greatest and difference < C.shade_tolerance


def measure_block(color, row, column, picture, eye, table, heights=None):
    """Measures the Block that has a top face, of any size; None if it is not entirely visible.
    Without heights, as from height_map, it must stand on the table."""
    if heights is None:
        top, ground = estimate_height(color, row, column, picture, eye, table), 0
    else:
        top = np.median(heights[row, column])
        ground = ground_below(color, row, column, picture, eye, heights)
    if top is None or ground is None or top - ground < C.on_table:
        return None
    face = fit_face(*onto_plane(row, column, eye, top))
    if face.misfit > C.misfit:
        return None
    return Block(color, np.append(face.sides, top - ground),
                 np.append(face.center, (top + ground) / 2), face.yaw)


def ground_below(color, row, column, picture, eye, heights):
    """Returns the height of what a block stands on [units]: below the edge of its top one of its
    sides is visible, and below that the ground. None if something else hides its foot; so it is
    with the floor of a box."""
    top = np.median(heights[row, column])
    point, step = edge_toward_nadir(row, column, eye)
    row, column = np.floor(point[::-1]).astype(int)
    while 0 <= row < heights.shape[0] and 0 <= column < heights.shape[1]:
        if not is_darker_shade(picture[row, column], color):
            ground = heights[row, column]
            if ground > top - C.on_table:
                return None
            return ground if ground > C.on_table else 0
        point = point + step
        row, column = np.floor(point[::-1]).astype(int)
    return None


def estimate_height(color, row, column, picture, eye, table):
    """Estimates the height of a block on the table [units]: below the edge of its top one of its
    sides is visible, down to where the table begins. None if something else is there."""
    (u, v), _ = edge_toward_nadir(row, column, eye)
    for trial in numbers_of(*C.height_trials):
        x, y, _ = onto_plane(np.array([v - 0.5]), np.array([u - 0.5]), eye, trial)
        pixel = pixel_at(picture, eye, [x[0], y[0], 0])
        if pixel is None or not is_darker_shade(picture[pixel], color):
            break
    # The resolution of the picture allows no finer steps.
    height = round(C.heights_per_unit * trial) / C.heights_per_unit
    is_table = pixel is not None and np.abs(picture[pixel] - table).max() < C.table_tolerance
    return height if is_table and height > 0 else None


def edge_toward_nadir(row, column, eye):
    """Returns the pixel where a top ends below its middle, on the line to the nadir, the image
    point straight below the camera: u, v from the top left corner [pixels]; and half a pixel along
    this line."""
    nadir = to_pixel(eye.pose[:3, 3] - [0, 0, 1], eye)
    point = np.array([column.mean(), row.mean()]) + 0.5
    step = 0.5 * (nadir - point) / np.linalg.norm(nadir - point)
    pixels = set(zip(column.tolist(), row.tolist()))
    while tuple(np.floor(point).astype(int).tolist()) in pixels:
        point = point + step
    return point, step


def detect_rims(picture, eye, color, height):
    """Detects rectangles of a color at a height [units] that may be the rims of open boxes;
    anything may be inside. Returns a list of Faces, the largest first, each with the longer side
    first."""
    number = label_regions(color_mask(picture, color))
    faces = []
    for region in np.flatnonzero(np.bincount(number.ravel()) >= C.min_rim_pixels):
        if region == 0:
            continue
        mask = number == region
        filled = np.logical_or.accumulate(mask, axis=1)
        filled &= np.logical_or.accumulate(mask[:, ::-1], axis=1)[:, ::-1]
        face = fit_face(*onto_plane(*np.nonzero(filled), eye, height))
        if face.misfit < C.misfit:
            faces.append(face)
    return sorted(faces, key=lambda face: -face.sides.prod())


def detect_container(picture, eye, container):
    """Detects a Container of the demonstration in a picture. Returns it at its new place and its
    rotation from the old one [rad]; None and 0 if it is not visible."""
    for face in detect_rims(picture, eye, container.color, container.size[2]):
        if same_size(face.sides, container.size[:2]):
            rotation = yaw_difference(container, face.yaw)
            position = np.append(face.center, container.position[2])
            return replace(container, position=position, yaw=container.yaw + rotation), rotation
    return None, 0


def onto_plane(row, column, eye, z):
    """Projects pixels onto the horizontal plane at height z [units]. Returns their points x, y
    [units] and the area that each pixel covers there [units squared], N numbers each."""
    p = eye.pose[:3, 3]
    R = eye.pose[:3, :3]
    K = eye.intrinsics
    # Rays through the pixel centers; camera axes are x right, y down, z forward.
    ray = R @ [(column + 0.5 - K[0, 2]) / K[0, 0], (row + 0.5 - K[1, 2]) / K[1, 1],
               np.ones(len(row))]
    along = (z - p[2]) / ray[2]  # depth of each point along its ray
    # On an oblique plane, the area of a pixel grows with the third power of its depth.
    area = along**3 / abs(z - p[2]) / (K[0, 0] * K[1, 1])
    return p[0] + along * ray[0], p[1] + along * ray[1], area


def fit_face(x, y, area, yaw=None):
    """Fits a Face to small pieces of it, by their moments: their positions and areas, N numbers
    each [units, units squared]. Its yaw is estimated unless given [rad]."""
    total = area.sum()
    center = np.array([(x * area).sum(), (y * area).sum()]) / total
    x = x - center[0]
    y = y - center[1]
    if yaw is None:
        yaw = yaw_of(x, y, area)
    along = x * math.cos(yaw) + y * math.sin(yaw)
    across = y * math.cos(yaw) - x * math.sin(yaw)
    # The variance of the points of a rectangle along a side is the side squared, divided by 12.
    sides = np.sqrt(12 * np.array([(along**2 * area).sum(), (across**2 * area).sum()]) / total)
    return Face(center, yaw, sides, abs(sides.prod() / total - 1))


def yaw_of(x, y, area):
    """Estimates the yaw of a rectangle around the origin [rad].

    Multiplying complex numbers adds their angles: the squares of the points of an elongated
    rectangle point about the same way, at twice its yaw.
    """
    z = x + 1j * y
    direction = (area * z**2).sum()
    spread = (area * abs(z) ** 2).sum()
    if abs(direction) > C.elongated * spread:
        return float(np.angle(direction)) / 2
    # A square has no long side; its fourth powers have a direction. The corners are farthest out
    # and weigh most; at yaw 0 they lie at 45 degrees, and four times that is 180, hence the minus.
    return float(np.angle(-(area * z**4).sum())) / 4


def to_pixel(point, eye):
    """Projects a point (x y z [units]) into the eye's picture: u, v from the top left corner
    [pixels]."""
    p = eye.pose[:3, :3].T @ (point - eye.pose[:3, 3])
    K = eye.intrinsics
    return np.array([K[0, 0], K[1, 1]]) * p[:2] / p[2] + K[:2, 2]


def pixel_at(picture, eye, point):
    """Returns row and column of the pixel that shows a point (x y z [units]); None outside the
    picture."""
    column, row = np.floor(to_pixel(point, eye)).astype(int)
    inside = 0 <= row < picture.shape[0] and 0 <= column < picture.shape[1]
    return (row, column) if inside else None


def is_top_hidden(block, others, eye):
    """Returns true if others (Blocks or Steps) hide a part of a block's top from the eye: a line of
    sight from its middle or near one of its corners passes through one of them."""
    others = [it for it in others if it.top > block.top + C.on_table]
    if not others:
        return False
    covered = footprint(others, 0)
    tops = np.array([it.top for it in others])
    bottoms = np.maximum([it.bottom for it in others], block.top)
    c, s = np.cos(covered[:, 4]), np.sin(covered[:, 4])
    for point in top_points(block):
        for fraction in np.linspace(0, 1, C.sight_heights):
            z = bottoms + fraction * (tops - bottoms)
            along = (z - block.top) / (eye.pose[2, 3] - block.top)
            x = point[0] + along * (eye.pose[0, 3] - point[0]) - covered[:, 0]
            y = point[1] + along * (eye.pose[1, 3] - point[1]) - covered[:, 1]
            if ((2 * abs(x * c + y * s) < covered[:, 2])
                    & (2 * abs(y * c - x * s) < covered[:, 3])).any():
                return True
    return False


def top_points(block):
    """Returns the middle of a block's top and points near its corners, 5x3 [units]."""
    along = C.top_fraction * block.size[0] * np.array([math.cos(block.yaw), math.sin(block.yaw), 0])
    across = C.top_fraction * block.size[1] * np.array([-math.sin(block.yaw), math.cos(block.yaw),
                                                        0])
    middle = np.array([*block.position[:2], block.top])
    return np.array([middle, middle + along + across, middle + along - across,
                     middle - along - across, middle - along + across])
