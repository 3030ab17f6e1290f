#pragma once

#include <vector>

#include "scene/solid.h"

namespace smile::model {

/// Area that a convex piece covers, seen from above: the corners of a convex polygon,
/// counter-clockwise [m]. Round shapes have 16 corners.
using Outline = std::vector<Eigen::Vector2d>;
Outline OutlineOf(const scene::SolidShape& shape, const RigidTransform& X_WS);

/// Returns the penetration depth of two outlines: the least shift that separates them [m]; not
/// positive if they are apart.
double OverlapOf(const Outline& a, const Outline& b);

}  // namespace smile::model
