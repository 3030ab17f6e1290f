#include "app/viewpoint.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <stdexcept>

#include "math/angles.h"
#include "mesh/primitives.h"
#include "scene/visual_model.h"

namespace smile::app {
namespace {

constexpr double kFieldOfView = DegreesToRadians(40);

struct Preset {
  const char* name;
  Vector3 p_WC, p_WQ;  ///< from where, to what [m]
};

const std::array<Preset, 5>& Presets() {
  static const std::array<Preset, 5> kPresets{{
      {"nice", {1.75, 1.75, 1.3}, {0, -0.5, 0.22}},
      {"front", {0, 2.3, 0.9}, {0, -0.3, 0.2}},
      {"left", {-2.3, -0.2, 0.9}, {0, -0.3, 0.2}},
      {"right", {2.3, -0.2, 0.9}, {0, -0.3, 0.2}},
      {"top", {0, -0.1, 2.6}, {0, -0.099, 0}},
  }};
  return kPresets;
}

constexpr const char* kClose = "close";

/// A ball around something to be seen, in the world.
struct Ball {
  Vector3 center;
  double radius;
};

/// What the scene's objects are made of, where they are at the start: a film keeps its view.
std::vector<Ball> BallsOf(const scene::SceneSpec& scene) {
  std::vector<Ball> balls;
  for (const scene::ObjectSpec& object : scene.objects) {
    for (const scene::Visual& visual : scene::VisualsOf(object.whole)) {
      balls.push_back({object.pose_in_world() * visual.X_FV.translation(),
                       mesh::BoundingRadiusOf(visual.shape)});
    }
  }
  return balls;
}

/// As near as shows all balls, from where the robot stands, a little from the left and above.
RigidTransform ClosePose(const std::vector<Ball>& balls, const CameraIntrinsics& intrinsics) {
  constexpr double kNearest = 0.3;  // [m]
  Eigen::AlignedBox3d bounds;
  for (const Ball& ball : balls) {
    bounds.extend(Vector3(ball.center.array() - ball.radius));
    bounds.extend(Vector3(ball.center.array() + ball.radius));
  }
  const Vector3 center = balls.empty() ? Vector3(0, 0, 0) : Vector3(bounds.center());
  const Vector3 away = Vector3(-0.35, -1, 0.75).normalized();
  const Matrix3 R_CW = LookAt(center + away, center).rotation().transpose();
  double distance = kNearest;
  for (const Ball& ball : balls) {
    const Vector3 p_C = R_CW * (ball.center - center);
    const auto fit = [&](double sideways, double half_size_px, double focal_px) {
      // The edge of the picture, a plane through the camera, must leave the ball inside.
      const double edge = std::atan(half_size_px / focal_px);
      const double needed = (std::abs(sideways) + ball.radius / std::cos(edge)) / std::tan(edge);
      distance = std::max(distance, needed - p_C.z());
    };
    fit(p_C.x(), intrinsics.width_px / 2.0, intrinsics.fx);
    fit(p_C.y(), intrinsics.height_px / 2.0, intrinsics.fy);
  }
  return LookAt(center + away * distance, center);
}

}  // namespace

std::vector<std::string> ViewNames() {
  std::vector<std::string> names{"eye", kClose};
  for (const Preset& preset : Presets()) names.emplace_back(preset.name);
  return names;
}

CameraView FindView(std::string_view name, const sim::Simulation& simulation,
                    std::span<const double> q, const sim::EyeSpec& size) {
  if (name == "eye") return EyeView(simulation, q, size);
  const auto intrinsics =
      CameraIntrinsics::FromVerticalFieldOfView(size.width_px, size.height_px, kFieldOfView);
  if (name == kClose) {
    return {.intrinsics = intrinsics, .X_WC = ClosePose(BallsOf(simulation.scene()), intrinsics)};
  }
  for (const Preset& preset : Presets()) {
    if (preset.name != name) continue;
    return {.intrinsics = intrinsics, .X_WC = LookAt(preset.p_WC, preset.p_WQ)};
  }
  std::string names;
  for (const std::string& known : ViewNames()) names += (names.empty() ? "" : ", ") + known;
  throw std::invalid_argument("camera is '" + std::string(name) + "', expected one of " + names);
}

}  // namespace smile::app
