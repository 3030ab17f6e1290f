#pragma once

#include <vector>

#include "scene/solid.h"

namespace smile::model {

/// What a convex piece covers of the ground seen from above: the corners of a convex polygon,
/// counter-clockwise [m]. Round things have 16 corners.
using Outline = std::vector<Eigen::Vector2d>;
Outline OutlineOf(const scene::SolidShape& shape, const RigidTransform& X_WS);

/// How far one would have to be shifted at least to be beside the other; not positive if it is [m].
double OverlapOf(const Outline& a, const Outline& b);

}  // namespace smile::model
