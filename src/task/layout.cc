#include "task/layout.h"

#include <random>
#include <stdexcept>
#include <vector>

#include "base/uniform.h"
#include "math/angles.h"

namespace smile::task {
scene::SceneSpec RandomLayout(scene::SceneSpec scene, std::uint64_t seed,
                              const LayoutRegion& region) {
  constexpr int kMaxTries = 10'000;
  std::mt19937_64 random(seed);
  std::vector<Vector3> taken;
  for (scene::ObjectSpec& object : scene.objects) {
    if (object.is_static()) continue;
    bool is_placed = false;
    for (int i = 0; i < kMaxTries && !is_placed; ++i) {
      const Vector3 p(Uniform(&random, region.x_low, region.x_high),
                      Uniform(&random, region.y_low, region.y_high),
                      object.pose_in_world().translation().z());
      const double yaw_deg = Uniform(&random, -180, 180);
      is_placed = true;
      for (const Vector3& other : taken) {
        is_placed = is_placed && (p - other).head<2>().norm() >= region.min_distance;
      }
      if (!is_placed) continue;
      taken.push_back(p);
      object.whole.X_PE = RigidTransform(RotationFromFixedAxes({0, 0, yaw_deg}), p);
    }
    if (!is_placed) {
      throw std::invalid_argument("layout: there is no room for '" + object.id() + "' among " +
                                  std::to_string(taken.size()) + " others");
    }
  }
  return scene;
}

}  // namespace smile::task
