#include "picture/viewpoint.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "base/wording.h"
#include "math/angles.h"
#include "mesh/primitives.h"
#include "scene/visual_model.h"

// Named views for people, and views given by two points. They depend on the scene at its start and
// not on the moment, so that a film keeps its view.

namespace smile::picture {
namespace {

constexpr double kFieldOfView = DegreesToRadians(40);

struct Preset {
  const char* name;
  Vector3 p_WC, p_WQ;  ///< position and target [m]
};

const std::array<Preset, 5>& Presets() {
  static const std::array<Preset, 5> kPresets{{
      {"nice", {1.75, 1.75, 1.3}, {0, -0.5, 0.22}},
      {"front", {0, 2.3, 0.9}, {0, -0.3, 0.2}},
      {"left", {-2.3, -0.2, 0.9}, {0, -0.3, 0.2}},
      {"right", {2.3, -0.2, 0.9}, {0, -0.3, 0.2}},
      // Not exactly vertical, as the up direction would be undefined.
      {"top", {0, -0.1, 2.6}, {0, -0.099, 0}},
  }};
  return kPresets;
}

constexpr const char* kClose = "close";

/// Bounding sphere of a visible piece, in the world.
struct Ball {
  Vector3 center;
  double radius;
};

/// Returns the bounding spheres of all objects at their initial poses, so that a film keeps its
/// view.
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

/// Returns the nearest pose that shows all balls, from above and slightly from the side: from the
/// robot's place, or, so that a visible robot does not stand in between, from the other side of the
/// table.
RigidTransform ClosePose(const std::vector<Ball>& balls, const CameraIntrinsics& intrinsics,
                         bool has_robot) {
  constexpr double kNearest = 0.3;  // [m]
  Eigen::AlignedBox3d bounds;
  for (const Ball& ball : balls) {
    bounds.extend(Vector3(ball.center.array() - ball.radius));
    bounds.extend(Vector3(ball.center.array() + ball.radius));
  }
  const Vector3 center = balls.empty() ? Vector3(0, 0, 0) : Vector3(bounds.center());
  const Vector3 away = (has_robot ? Vector3(0.35, 1, 0.75) : Vector3(-0.35, -1, 0.75)).normalized();
  const Matrix3 R_CW = LookAt(center + away, center).rotation().transpose();
  double distance = kNearest;
  for (const Ball& ball : balls) {
    const Vector3 p_C = R_CW * (ball.center - center);
    const auto fit = [&](double sideways, double half_size_px, double focal_px) {
      // The edge of the picture is a plane through the camera; the ball must lie inside it.
      // Half of the angle of view in this direction.
      const double edge = std::atan(half_size_px / focal_px);
      const double needed = (std::abs(sideways) + ball.radius / std::cos(edge)) / std::tan(edge);
      // The camera moves back along its axis until the last ball fits; the ball's own depth counts.
      distance = std::max(distance, needed - p_C.z());
    };
    fit(p_C.x(), intrinsics.width_px / 2.0, intrinsics.fx);
    fit(p_C.y(), intrinsics.height_px / 2.0, intrinsics.fy);
  }
  return LookAt(center + away * distance, center);
}

std::vector<std::string_view> Split(std::string_view text, char separator) {
  std::vector<std::string_view> words;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(separator, start), text.size());
    words.push_back(text.substr(start, end - start));
    start = end + 1;
  }
  return words;
}

/// Parses a view `FROM:TO[:FOV]` with points in units of the scene and degrees.
CameraView FreeView(std::string_view camera, double meters_per_unit, const model::EyeSpec& size) {
  constexpr double kFarthest = 1000;  // from the middle of the table [m]
  const auto fail = [camera](const std::string& what) {
    throw std::invalid_argument("camera is " + Quoted(camera) + ": " + what);
  };
  const auto number_in = [&fail](std::string_view text, double low, double high) {
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() ||
        !(number >= low && number <= high)) {
      fail(Quoted(text) + " is not a number from " + NumberText(low) + " to " + NumberText(high));
    }
    return number;
  };
  const auto point_in = [&](std::string_view text) {
    const std::vector<std::string_view> words = Split(text, ',');
    if (words.size() != 3) fail(Quoted(text) + " is not a point x,y,z");
    const double most = kFarthest / meters_per_unit;
    Vector3 p;
    for (int i = 0; i < 3; ++i) p[i] = number_in(words[static_cast<std::size_t>(i)], -most, most);
    return Vector3(p * meters_per_unit);
  };
  const std::vector<std::string_view> words = Split(camera, ':');
  if (words.size() != 2 && words.size() != 3) {
    fail("expected FROM:TO or FROM:TO:FOV like 8,4,6:0,-3,1:40");
  }
  const Vector3 p_WC = point_in(words[0]), p_WQ = point_in(words[1]);
  if (p_WC == p_WQ) fail("it looks at its own position");
  const double angle =
      words.size() == 3 ? DegreesToRadians(number_in(words[2], 1, 170)) : kFieldOfView;
  CameraView view{
      .intrinsics = CameraIntrinsics::FromVerticalFieldOfView(size.width_px, size.height_px, angle),
      .X_WC = LookAt(p_WC, p_WQ)};
  // The target must be visible from any distance.
  view.intrinsics.far = std::max(view.intrinsics.far, 2 * (p_WQ - p_WC).norm());
  return view;
}

}  // namespace

std::vector<std::string> ViewNames() {
  std::vector<std::string> names{kClose};
  for (const Preset& preset : Presets()) names.emplace_back(preset.name);
  return names;
}

CameraView FindView(std::string_view camera, const scene::SceneSpec& scene,
                    const model::EyeSpec& size, const std::vector<std::string>& cameras,
                    bool has_robot) {
  // Names contain neither, so this is a view by points.
  if (camera.find_first_of(":,") != std::string_view::npos) {
    return FreeView(camera, scene.meters_per_unit, size);
  }
  const auto intrinsics =
      CameraIntrinsics::FromVerticalFieldOfView(size.width_px, size.height_px, kFieldOfView);
  if (camera == kClose) {
    return CameraView{.intrinsics = intrinsics,
                      .X_WC = ClosePose(BallsOf(scene), intrinsics, has_robot)};
  }
  for (const Preset& preset : Presets()) {
    if (preset.name != camera) continue;
    return CameraView{.intrinsics = intrinsics, .X_WC = LookAt(preset.p_WC, preset.p_WQ)};
  }
  std::vector<std::string> names = cameras;
  for (const std::string& view : ViewNames()) names.push_back(view);
  const std::vector<std::string_view> words(names.begin(), names.end());
  throw std::invalid_argument("camera is " + Quoted(camera) + ", expected " + OneOf(words) +
                              ", or FROM:TO[:FOV] like 8,4,6:0,-3,1:40" +
                              DidYouMean(camera, words));
}

}  // namespace smile::picture
