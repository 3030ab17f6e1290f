#include "app/options.h"

#include <charconv>
#include <stdexcept>

#include "base/files.h"
#include "base/wording.h"
#include "robot/urdf_reader.h"

namespace smile::app {
namespace {

/// The original put its robot this far behind the table [m].
constexpr double kClassicGap = 0.30;

}  // namespace

void AddRobotOptions(CLI::App* command, bool may_be_absent, RobotOptions* options) {
  if (may_be_absent) {
    command->add_flag("--no-robot", options->no_robot, "a table without a robot");
  }
  command->add_flag("--classic", options->classic, "the robot where the original put it");
  CLI::Option* kinematic = command->add_flag("--kinematic", options->body.is_kinematic,
                                             "a robot that nothing stops; it costs less time");
  command
      ->add_flag("--friction-grasp", options->body.grasps_by_friction,
                 "grippers hold by friction alone")
      ->excludes(kinematic);
}

std::optional<sim::RobotPlacement> PlaceRobot(const RobotOptions& options) {
  if (options.no_robot) return std::nullopt;
  const std::filesystem::path urdf = DataFile("robots/baxter.urdf");
  sim::RobotPlacement placement{
      .model = robot::ReadRobot(urdf), .urdf = urdf, .body = options.body};
  if (options.classic) placement.gap = kClassicGap;
  return placement;
}

void AddPathOption(CLI::App* command, PathOptions* options) {
  command
      ->add_option("--path", options->roots,
                   "folder to look in for included files, after the scene's own; may be repeated")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

CLI::Validator NumberBetween(double low, double high) {
  const auto check = [low, high](const std::string& text) -> std::string {
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error == std::errc() && end == text.data() + text.size() && number >= low &&
        number <= high) {
      return "";
    }
    return Quoted(text) + " is not a number from " + NumberText(low) + " to " + NumberText(high);
  };
  return CLI::Validator(check, "FROM " + NumberText(low) + " TO " + NumberText(high));
}

sim::EyeSpec ParseSize(const std::string& text) {
  sim::EyeSpec spec;
  const char* end = text.data() + text.size();
  auto read = std::from_chars(text.data(), end, spec.width_px);
  const bool has_width = read.ec == std::errc() && read.ptr != end && *read.ptr == 'x';
  if (has_width) read = std::from_chars(read.ptr + 1, end, spec.height_px);
  if (!has_width || read.ec != std::errc() || read.ptr != end || spec.width_px < 1 ||
      spec.height_px < 1 || spec.width_px > 8192 || spec.height_px > 8192) {
    throw std::invalid_argument("size is '" + text +
                                "', expected WIDTHxHEIGHT like 640x480, 1 to "
                                "8192 each");
  }
  return spec;
}

CLI::Validator NotEmpty() {
  return CLI::Validator(
      [](const std::string& text) {
        return text.empty() ? std::string("is empty, expected a name") : std::string();
      },
      "");
}

}  // namespace smile::app
