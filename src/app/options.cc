#include "app/options.h"

#include <cstdio>
#include <stdexcept>

#include "base/files.h"
#include "robot/urdf_reader.h"

namespace smile::app {
namespace {

/// The original put its robot this far behind the table [m].
constexpr double kClassicGap = 0.30;

}  // namespace

std::optional<sim::RobotPlacement> PlaceRobot(const RobotOptions& options) {
  if (options.no_robot) return std::nullopt;
  const std::filesystem::path urdf = DataFile("robots/baxter.urdf");
  sim::RobotPlacement placement{.model = robot::ReadRobot(urdf), .urdf = urdf};
  if (options.classic) placement.gap = kClassicGap;
  return placement;
}

sim::EyeSpec ParseSize(const std::string& text) {
  sim::EyeSpec spec;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%dx%d%c", &spec.width_px, &spec.height_px, &rest) != 2 ||
      spec.width_px < 1 || spec.height_px < 1 || spec.width_px > 8192 || spec.height_px > 8192) {
    throw std::invalid_argument("size is '" + text +
                                "', expected WIDTHxHEIGHT like 640x480, 1 to "
                                "8192 each");
  }
  return spec;
}

}  // namespace smile::app
