#pragma once

#include <Eigen/Core>
#include <vector>

#include "math/rigid_transform.h"
#include "scene/custom_mesh.h"

namespace smile::mesh {

// Surfaces made by rule, for whatever is drawn but comes from no file: turned, extruded, lofted,
// bent. All are closed, their triangles run counter-clockwise seen from outside, and neighbours
// share corners, so that SmoothSurface() finds what is round. Lengths are in metres.

/// A closed line in the xy plane, counter-clockwise seen from +z; the last point joins the first.
using Outline = std::vector<Eigen::Vector2d>;

/// A closed line in space: one cut through a body.
using Section = std::vector<Vector3>;

/// The outline of a circle about the origin, its first corner towards +x.
Outline CircleOutline(double radius, int sides);

/// Two half circles joined by straight lines: `length` long along x, `width` wide along y.
/// @param sides  corners of both half circles together; even.
Outline StadiumOutline(double length, double width, int sides);

/// The outline with its corners cut round, where there is room for it: an arc takes no more than
/// half of a side.
/// @param corner_sides  chords of each arc.
Outline RoundedOutline(const Outline& outline, double radius, int corner_sides);

/// What a superellipse |x/a|^n + |y/b|^n = 1 fills: 2 is an ellipse, 4 nearly a rectangle.
struct Cut {
  double z = 0;
  double x_min = 0, x_max = 0, y_min = 0, y_max = 0;
  double exponent = 2;
};

/// The outline of a cut, its first corner towards +x.
Outline SuperellipseOutline(const Cut& cut, int sides);

/// The outline in the plane at `z`.
Section SectionAt(const Outline& outline, double z);

/// The skin over sections one after the other, closed at both ends: a section whose points all lie
/// in one place is a tip, others get a flat lid. Seen against the way they follow each other, all
/// run counter-clockwise (outlines at growing z do).
/// @throws std::invalid_argument unless there are two sections or more, all of as many points, at
///         least three.
scene::SurfaceMesh Skin(const std::vector<Section>& sections);

/// A body turned about the z axis.
/// @param profile  (radius, z) with growing z; a radius of 0 is a tip.
scene::SurfaceMesh Lathe(const std::vector<Eigen::Vector2d>& profile, int sides);

/// The outline moved along z, its upper and lower edges rounded.
/// @param edge_radius  0 leaves them sharp; at most half of the height.
/// @param edge_sides   chords of each rounding; 1 is a bevel.
scene::SurfaceMesh Extrusion(const Outline& outline, double z_min, double z_max,
                             double edge_radius = 0, int edge_sides = 3);

/// The skin over superellipses with growing z.
scene::SurfaceMesh Loft(const std::vector<Cut>& cuts, int sides);

/// A cuboid about the origin with all edges rounded.
/// @param size           full lengths along x, y, z.
/// @param corner_radius  of the edges along z; at least `edge_radius`, at most half of x or y.
/// @param edge_radius    of those around top and bottom.
scene::SurfaceMesh RoundedBox(const Vector3& size, double corner_radius, double edge_radius);

/// A rod of round section along a line of points, its bends rounded.
/// @param bend_radius  of the middle line in the bends, where there is room for it.
scene::SurfaceMesh Tube(const std::vector<Vector3>& path, double radius, double bend_radius,
                        int sides);

/// One side of a flat piece, seen from +z only: open, the one exception here.
scene::SurfaceMesh FlatPiece(const Outline& outline, double z);

/// Several surfaces as one. They may reach into each other.
scene::SurfaceMesh Joined(const std::vector<scene::SurfaceMesh>& pieces);

/// The surface, described in A, that was described in B.
scene::SurfaceMesh Placed(const RigidTransform& X_AB, scene::SurfaceMesh surface_B);

/// Its image in the mirror y = 0.
scene::SurfaceMesh Mirrored(scene::SurfaceMesh surface);

}  // namespace smile::mesh
