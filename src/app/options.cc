#include "app/options.h"

#include <array>
#include <charconv>
#include <cstdio>
#include <sstream>
#include <stdexcept>

#include "base/files.h"
#include "base/wording.h"
#include "catalog/placed_robot.h"
#include "library/brain_choices.h"

namespace smile::app {
namespace {

/// Distance of the original's robot from the table [m].
constexpr double kClassicGap = 0.30;

/// Parses a number from 0 to `most`.
template <class Number>
Number NumberUpTo(Number most, const std::string& text, const std::string& what) {
  Number number = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  if (error == std::errc() && rest == end && number >= 0 && number <= most) return number;
  throw std::invalid_argument(what + " is " + Quoted(text) + ", expected a number from 0 to " +
                              NumberText(static_cast<double>(most)));
}

}  // namespace

void AddRobotOptions(CLI::App* command, bool may_be_absent, RobotOptions* options) {
  if (may_be_absent) {
    command->add_flag("--no-robot", options->no_robot, "no robot at the table");
  }
  command->add_flag("--classic", options->classic, "robot at the position of the 2015 program");
  command
      ->add_option("--robot", options->urdf,
                   "robot: a name that `smile robots` lists, or a URDF file (default: baxter)")
      ->check(NotEmpty());
  command
      ->add_option("--side-file", options->side_file,
                   "file that names the robot's arms, grippers and poses (default: NAME.robot.json "
                   "beside NAME.urdf)")
      ->check(NotEmpty());
  command
      ->add_option("--gripper", options->gripper,
                   "gripper of the robot; for Baxter: classic, electric or none")
      ->check(NotEmpty());
  CLI::Option* kinematic =
      command->add_flag("--kinematic", options->body.is_kinematic,
                        "kinematic robot: faster to simulate, not stopped by obstacles");
  command
      ->add_flag("--friction-grasp", options->body.grasps_by_friction,
                 "grippers that hold by friction alone")
      ->excludes(kinematic);
}

void AddTimeoutOption(CLI::App* command, CLI::Option* brain, double* seconds) {
  CLI::Option* timeout = command->add_option(
      "--timeout", *seconds,
      "timeout per callback in seconds of wall-clock time; init has 12 times as "
      "long");
  CLI::Option* earlier = command->add_option("--patience", *seconds)->group("");
  for (CLI::Option* option : {timeout, earlier}) {
    option->capture_default_str()->check(NumberBetween(0.01, 86400.0));
    if (brain != nullptr) option->needs(brain);
  }
}

CLI::Option* AddBrainOptions(CLI::App* command, BrainOptions* options) {
  CLI::Option* brain =
      command
          ->add_option(
              "--brain", options->brain,
              "brain: a folder with agentBehavior.m, a Python file, an executable, or the address "
              "of one that is served, tcp://HOST:PORT or unix:PATH")
          ->transform(PresentBrain());
  AddTimeoutOption(command, brain, &options->timeout);
  command
      ->add_flag("--attach", options->attach,
                 "print how to start the brain in a debugger, and wait for it without a time limit")
      ->needs(brain);
  return brain;
}

std::optional<sim::RobotPlacement> PlaceRobot(const RobotOptions& options, const PathOptions& path,
                                              const std::string& start_pose) {
  if (options.no_robot) {
    // With `--no-robot`, any other option of the robot would have no effect, and is an error.
    if (options == RobotOptions{.no_robot = true}) return std::nullopt;
    throw std::invalid_argument("--no-robot excludes all other options of the robot");
  }
  catalog::PlacedRobot placed =
      catalog::PlaceRobot(options.urdf.empty() ? "baxter" : options.urdf,
                          {.side_file = options.side_file,
                           .package_roots = {path.roots.begin(), path.roots.end()},
                           .gripper = options.gripper,
                           .start_pose = start_pose,
                           .body = options.body});
  // A URDF file alone describes links and joints, but not which of them are arms or grippers.
  if (!placed.has_side_file) {
    std::fprintf(stderr,
                 "%s: the robot has no side file and cannot move; `smile robots add` makes one\n",
                 placed.urdf.c_str());
  }
  if (options.classic) placed.placement.gap = kClassicGap;
  return std::move(placed.placement);
}

// CLI11 otherwise takes all following words as further values, even positional ones.
CLI::Option* Repeatable(CLI::Option* option) { return option->allow_extra_args(false); }

void AddPathOption(CLI::App* command, PathOptions* options) {
  Repeatable(command->add_option("--path", options->roots,
                                 "folder in which to search for files of scenes and robots, after "
                                 "their own folders; may be repeated"));
}

CLI::Option* AddDemonstratorOption(CLI::App* command, std::string* appearance) {
  return command->add_option("--demonstrator", *appearance,
                             "appearance of the demonstrator: invisible, ghost (translucent hands) "
                             "or forearm (opaque hands and arms)");
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

PictureSize ParseSize(const std::string& text) {
  PictureSize size;
  const char* end = text.data() + text.size();
  auto read = std::from_chars(text.data(), end, size.width_px);
  const bool has_width = read.ec == std::errc() && read.ptr != end && *read.ptr == 'x';
  if (has_width) read = std::from_chars(read.ptr + 1, end, size.height_px);
  if (!has_width || read.ec != std::errc() || read.ptr != end || size.width_px < 1 ||
      size.height_px < 1 || size.width_px > 8192 || size.height_px > 8192) {
    throw std::invalid_argument("size is '" + text +
                                "', expected WIDTHxHEIGHT like 640x480, 1 to "
                                "8192 each");
  }
  return size;
}

void AddEyeOptions(CLI::App* command, EyeOptions* options) {
  command
      ->add_option(
          "--eye", options->camera,
          "camera of the robot: `eye`, above its head as in 2015, or `head`, the real head camera")
      ->capture_default_str()
      ->check(CLI::IsMember({sim::kEyeCamera, sim::kHeadCamera}));
  command->add_option(
      "--size", options->size,
      "size of the robot's pictures (default: 640x480; 640x400 for the eye `head`)");
}

sim::EyeSpec EyeSpecOf(const EyeOptions& options) {
  const bool is_head = options.camera == sim::kHeadCamera;
  const PictureSize size = ParseSize(!options.size.empty() ? options.size
                                     : is_head             ? "640x400"
                                                           : "640x480");
  return {.width_px = size.width_px, .height_px = size.height_px, .camera = options.camera};
}

brain::SensorNoise ParseNoise(const std::string& text) {
  constexpr double kMost = 1000;
  constexpr std::uint64_t kMostSeed = std::uint64_t{1} << 53;
  constexpr std::array<std::string_view, 4> kKeys{"depth", "image", "joints", "seed"};
  brain::SensorNoise noise;
  // A part is KEY=VALUE; without `=`, the value is empty and its number cannot be parsed.
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const std::size_t equals = std::min(part.find('='), part.size());
    const std::string key = part.substr(0, equals);
    const std::string value = part.substr(std::min(equals + 1, part.size()));
    const std::string what = "noise: " + key;
    if (key == "joints") {
      noise.joints = NumberUpTo(kMost, value, what);
    } else if (key == "image") {
      noise.image = NumberUpTo(kMost, value, what);
    } else if (key == "depth") {
      noise.depth = NumberUpTo(kMost, value, what);
    } else if (key == "seed") {
      noise.seed = NumberUpTo(kMostSeed, value, what);
    } else {
      throw std::invalid_argument("noise: found " + Quoted(key) + ", expected " + OneOf(kKeys) +
                                  DidYouMean(key, kKeys));
    }
  }
  return noise;
}

void AddNoiseOption(CLI::App* command, std::string* text) {
  command
      ->add_option("--noise", *text,
                   "Gaussian noise in the sensors of the brain: any of the standard deviations "
                   "joints=RAD, image=FRACTION and depth=UNITS, and seed=N, comma-separated")
      ->needs("--brain");
}

void AddPlanOption(CLI::App* command, std::string* file) {
  command
      ->add_option("--plan", *file,
                   "analysis.json of DEMO, which the brain is given (default: none; "
                   "docs/analysis.md)")
      ->check(NotEmpty());
}

void AddOracleOption(CLI::App* command, bool* gives_poses) {
  command->add_flag("--oracle", *gives_poses,
                    "give the brain the true poses, sizes and colors of all objects "
                    "(docs/brains.md)");
}

CLI::Validator PresentBrain() {
  return CLI::Validator(
      [](std::string& brain) {
        brain = library::PresentBrainPath(brain).string();
        return std::string();
      },
      "");
}

CLI::Validator NotEmpty() {
  return CLI::Validator(
      [](const std::string& text) {
        return text.empty() ? std::string("is empty, expected a name") : std::string();
      },
      "");
}

}  // namespace smile::app
