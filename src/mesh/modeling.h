#pragma once

#include <Eigen/Core>
#include <vector>

#include "math/rigid_transform.h"
#include "scene/custom_mesh.h"

namespace smile::mesh {

// Parametric surfaces, for drawn objects that come from no file: lathed, extruded, lofted, bent.
// All are closed, their triangles run counter-clockwise seen from outside, and neighbors share
// corners, so that SmoothSurface() can smooth them. Lengths are in meters.

/// A closed line in the xy plane, counter-clockwise seen from +z; the last point joins the first.
using Outline = std::vector<Eigen::Vector2d>;

/// A closed line in space: a cross section of a body.
using Section = std::vector<Vector3>;

/// Returns a circle about the origin, its first corner towards +x.
Outline CircleOutline(double radius, int sides);

/// Returns two half circles joined by straight lines: `length` along x, `width` along y.
/// @param sides  corners of both half circles together; even.
Outline StadiumOutline(double length, double width, int sides);

/// Returns the outline with rounded corners; an arc takes no more than half of a side.
/// @param corner_sides  chords of each arc.
Outline RoundedOutline(const Outline& outline, double radius, int corner_sides);

/// Cross section bounded by a superellipse |x/a|^n + |y/b|^n = 1: exponent 2 is an ellipse, 4
/// nearly a rectangle.
struct Cut {
  double z = 0;
  double x_min = 0, x_max = 0, y_min = 0, y_max = 0;
  double exponent = 2;
};

/// Returns the outline of a cut, its first corner towards +x.
Outline SuperellipseOutline(const Cut& cut, int sides);

/// Returns the outline in the plane at `z`.
Section SectionAt(const Outline& outline, double z);

/// Returns the surface over consecutive sections, closed at both ends: a section whose points all
/// coincide is a tip, others get a flat lid. Seen against the direction of their order, all run
/// counter-clockwise (outlines at growing z do).
/// @throws std::invalid_argument unless there are two sections or more, all of the same number of
///         points, at least three.
scene::SurfaceMesh Skin(const std::vector<Section>& sections);

/// Returns a body of revolution about the z axis.
/// @param profile  (radius, z) with growing z; a radius of 0 is a tip.
scene::SurfaceMesh Lathe(const std::vector<Eigen::Vector2d>& profile, int sides);

/// Returns the outline extruded along z, with rounded upper and lower edges.
/// @param edge_radius  0 for sharp edges; at most half of the height.
/// @param edge_sides   chords of each rounding; 1 is a bevel.
scene::SurfaceMesh Extrusion(const Outline& outline, double z_min, double z_max,
                             double edge_radius = 0, int edge_sides = 3);

/// Returns the surface over superellipses with growing z.
scene::SurfaceMesh Loft(const std::vector<Cut>& cuts, int sides);

/// Returns a cuboid about the origin with all edges rounded.
/// @param size           full lengths along x, y, z.
/// @param corner_radius  radius of the edges along z; at least `edge_radius`, at most half of x or
/// y.
/// @param edge_radius    radius of the edges around top and bottom.
scene::SurfaceMesh RoundedBox(const Vector3& size, double corner_radius, double edge_radius);

/// Returns a rod of round section along a line of points, with rounded bends.
/// @param bend_radius  radius of the center line in the bends, smaller where space is short.
scene::SurfaceMesh Tube(const std::vector<Vector3>& path, double radius, double bend_radius,
                        int sides);

/// Returns one side of a flat piece, visible from +z only: the only open surface here.
scene::SurfaceMesh FlatPiece(const Outline& outline, double z);

/// Returns several surfaces as one. They may overlap.
scene::SurfaceMesh Joined(const std::vector<scene::SurfaceMesh>& pieces);

/// Returns a surface given in B in the frame A.
scene::SurfaceMesh Placed(const RigidTransform& X_AB, scene::SurfaceMesh surface_B);

/// Returns the mirror image at the plane y = 0.
scene::SurfaceMesh Mirrored(scene::SurfaceMesh surface);

}  // namespace smile::mesh
