#include "app/viewpoint.h"

#include <array>
#include <stdexcept>

#include "math/angles.h"

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

}  // namespace

std::vector<std::string> ViewNames() {
  std::vector<std::string> names{"eye"};
  for (const Preset& preset : Presets()) names.emplace_back(preset.name);
  return names;
}

CameraView FindView(std::string_view name, const sim::Simulation& simulation,
                    std::span<const double> q, const sim::EyeSpec& size) {
  if (name == "eye") return EyeView(simulation, q, size);
  for (const Preset& preset : Presets()) {
    if (preset.name != name) continue;
    return {.intrinsics = CameraIntrinsics::FromVerticalFieldOfView(size.width_px, size.height_px,
                                                                    kFieldOfView),
            .X_WC = LookAt(preset.p_WC, preset.p_WQ)};
  }
  std::string names;
  for (const std::string& known : ViewNames()) names += (names.empty() ? "" : ", ") + known;
  throw std::invalid_argument("camera is '" + std::string(name) + "', expected one of " + names);
}

}  // namespace smile::app
