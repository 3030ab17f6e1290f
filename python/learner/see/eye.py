"""The eye: from points to pixels and back."""

from dataclasses import dataclass

import numpy as np


@dataclass
class Eye:
    """A camera at a fixed place, and the table that it looks at."""

    intrinsics: np.ndarray  # 3x3 [pixels]
    pose: np.ndarray  # 4x4, x right, y down, z forward; translation in units
    table: tuple = (20, 12)  # size of the table top along x and y [units]; this one if a scene does not say

    @property
    def near_edge(self):
        """The y of the edge of the table at which the robot stands [units]."""
        return -self.table[1] / 2


def height_map(depth, eye):
    """Returns the height above the table of the surface in each pixel, HxW [units]; 0 where there is none.

    depth: HxW, distance along the axis of the camera [units]; 0 where there is no surface
    """
    row, column = np.indices(depth.shape) + 0.5
    K = eye.intrinsics
    right, down, forward = eye.pose[2, :3]
    rise = right * (column - K[0, 2]) / K[0, 0] + down * (row - K[1, 2]) / K[1, 1] + forward
    return np.where(depth > 0, eye.pose[2, 3] + depth * rise, 0)


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


def to_pixel(point, eye):
    """Projects a point (x y z [units]) into the eye's picture: u, v from the top left corner
    [pixels]."""
    p = eye.pose[:3, :3].T @ (point - eye.pose[:3, 3])
    K = eye.intrinsics
    return np.array([K[0, 0], K[1, 1]]) * p[:2] / p[2] + K[:2, 2]


def pixels_in_view(points, eye):
    """Projects points, Nx3 [units], like to_pixel: u, v from the top left corner, Nx2 [pixels]."""
    p = (points - eye.pose[:3, 3]) @ eye.pose[:3, :3]
    K = eye.intrinsics
    return p[:, :2] / p[:, 2:] * [K[0, 0], K[1, 1]] + K[:2, 2]


def pixels_of(points, eye, picture):
    """Returns rows and columns of the pixels that show N points, Nx3 [units], and which of these are inside a
    picture, N bool; rows and columns of the others are 0."""
    p = eye.pose[:3, :3].T @ (points - eye.pose[:3, 3]).T
    K = eye.intrinsics
    column, row = np.floor([K[0, 0] * p[0] / p[2] + K[0, 2], K[1, 1] * p[1] / p[2] + K[1, 2]]).astype(int)
    inside = (row >= 0) & (row < picture.shape[0]) & (column >= 0) & (column < picture.shape[1])
    return row * inside, column * inside, inside


def pixel_at(picture, eye, point):
    """Returns row and column of the pixel that shows a point (x y z [units]); None outside the
    picture."""
    column, row = np.floor(to_pixel(point, eye)).astype(int)
    inside = 0 <= row < picture.shape[0] and 0 <= column < picture.shape[1]
    return (row, column) if inside else None
