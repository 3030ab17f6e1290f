#pragma once

#include <vector>

#include "scene/scene_spec.h"

namespace smile::scene {

/// Guest or host point in the frame B of its object.
template <class Point>
struct PlacedPoint {
  const Point* point;
  RigidTransform X_BP;
};

/// Return the bond points of an object, in the order of the file: for a composite first its own,
/// then those of its parts.
std::vector<PlacedPoint<GuestPoint>> GuestsOf(const Part& whole);
std::vector<PlacedPoint<HostPoint>> HostsOf(const Part& whole);

}  // namespace smile::scene
