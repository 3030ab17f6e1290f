#include "app/options.h"

#include <charconv>
#include <cstdio>
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
  command->add_option("--robot", options->urdf, "another robot than Baxter: a URDF file")
      ->check(NotEmpty());
  command
      ->add_option("--side-file", options->side_file,
                   "what names its arms, grippers and poses; NAME.robot.json beside NAME.urdf if "
                   "not given")
      ->check(NotEmpty());
  command
      ->add_option("--gripper", options->gripper,
                   "which of the robot's grippers; Baxter's are classic, electric and none")
      ->check(NotEmpty());
}

std::optional<sim::RobotPlacement> PlaceRobot(const RobotOptions& options,
                                              const PathOptions& path) {
  if (options.no_robot) {
    if (options == RobotOptions{.no_robot = true}) return std::nullopt;
    throw std::invalid_argument("--no-robot leaves nothing to choose of a robot");
  }
  const std::filesystem::path urdf =
      options.urdf.empty() ? DataFile("robots/baxter.urdf") : std::filesystem::path(options.urdf);
  robot::RobotReading reading =
      robot::LoadRobot(urdf, {.side_file = options.side_file,
                              .package_roots = {path.roots.begin(), path.roots.end()},
                              .gripper = options.gripper});
  if (!reading.has_side_file) {
    std::fprintf(stderr, "%s: without a side file, the robot stands there and nothing moves it\n",
                 urdf.c_str());
  }
  sim::RobotPlacement placement{.model = std::move(reading.model),
                                .gripper = std::move(reading.gripper),
                                .files = std::move(reading.files)};
  placement.gap = reading.gap.value_or(placement.gap);
  placement.height = reading.height.value_or(placement.height);
  if (options.classic) placement.gap = kClassicGap;
  return placement;
}

void AddPathOption(CLI::App* command, PathOptions* options) {
  command
      ->add_option(
          "--path", options->roots,
          "folder to look in for files a scene or a robot names, after their own; may be repeated")
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
