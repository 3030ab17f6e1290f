#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "scene/solid.h"

namespace smile::physics {

/// Measures how deep solids overlap at poses of the caller's choice, without a world. For one
/// thread at a time.
class SolidProbe {
 public:
  /// @param solids  at their poses Solid::X_BS in the world.
  explicit SolidProbe(const std::vector<scene::Solid>& solids);
  ~SolidProbe();
  SolidProbe(const SolidProbe&) = delete;
  SolidProbe& operator=(const SolidProbe&) = delete;

  void SetPose(std::size_t solid, const RigidTransform& X_WS);
  /// Returns the depth of the overlap of two solids [m]; 0 if there is none.
  double Depth(std::size_t a, std::size_t b);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace smile::physics
