#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>

#include "app/commands.h"
#include "app/console_reporter.h"
#include "app/exit_code.h"
#include "app/options.h"
#include "base/diagnostic.h"
#include "base/files.h"
#include "base/wording.h"
#include "catalog/known_robots.h"
#include "catalog/robot_catalog.h"
#include "catalog/robot_check.h"
#include "catalog/robot_guess.h"
#include "math/angles.h"
#include "picture/recording_renderer.h"
#include "robot/kinematics.h"
#include "scene/bounds.h"

namespace smile::app {
namespace {

struct RobotsOptions {
  std::string name, urdf, side_file;
  std::vector<std::string> packages;
};

/// Prints the robots that are known by name; one that cannot be read has its fault instead of its
/// parts.
int List() {
  bool all_are_read = true;
  for (const catalog::CatalogEntry& entry : catalog::AllRobots()) {
    std::string summary;
    try {
      summary = catalog::SummaryOf(robot::ReadRobot(entry.urdf, {.has_appearance = false}));
    } catch (const InputError& error) {
      summary = "cannot be read: " + std::string(error.what());
      all_are_read = false;
    }
    std::printf("%-12s  %s (%s)\n", entry.name.c_str(), summary.c_str(),
                entry.is_shipped ? "shipped" : entry.urdf.parent_path().c_str());
  }
  return all_are_read ? kDone : kInputWrong;
}

/// Returns a view that a robot in its start pose fills, from its front and right.
std::string ViewOfRobot(const model::Model& model) {
  constexpr double kFieldOfView_deg = 40;
  /// Of the half diagonal of its box, which no robot fills.
  constexpr double kFill = 0.85;
  const robot::RobotModel& robot = *model.robot();
  const RigidTransform& X_WBase = model.robot_base_pose();
  scene::Bounds bounds = scene::BoundsOf(robot.base_solids, X_WBase);
  const auto X_WL = robot::LinkPoses(robot, X_WBase, robot.q_start);
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    bounds.Add(scene::BoundsOf(robot.links[i].solids, X_WL[i]));
  }
  if (bounds.is_empty()) return "nice";
  const double distance =
      kFill * bounds.size().norm() / 2 / std::sin(DegreesToRadians(kFieldOfView_deg / 2));
  const Vector3 p_WQ = bounds.center();
  const Vector3 p_WC = p_WQ + distance * Vector3(0.7, 0.8, 0.45).normalized();
  const auto text = [&](const Vector3& p_W) {
    const Vector3 p = p_W / model.scene().meters_per_unit;
    return NumberText(p.x()) + "," + NumberText(p.y()) + "," + NumberText(p.z());
  };
  return text(p_WC) + ":" + text(p_WQ) + ":" + NumberText(kFieldOfView_deg);
}

/// Draws a robot in its start pose at an empty table, and prints the path of the picture.
void DrawRobot(const model::RobotPlacement& robot, const std::filesystem::path& out) {
  const model::Model model(scene::SceneSpec{.name = "robot"}, robot);
  const picture::RenderRequest request{
      .camera = ViewOfRobot(model), .width_px = 960, .height_px = 720};
  picture::RecordingRenderer renderer(model, request, nullptr);
  for (const auto& path : picture::WriteChannels(out, renderer.Take(recording::StartOf(model), {}),
                                                 request.channels)) {
    std::printf("%s\n", path.c_str());
  }
}

/// Returns the text of the side file of a robot to add: the given one, its own, one that is known
/// for its description, or one made by itself, whose assumptions are printed.
std::string SideFileTextFor(const RobotsOptions& options, const robot::RobotReaderOptions& reader) {
  constexpr std::size_t kMaxBytes = 1 << 20;
  std::filesystem::path own = options.urdf;
  own.replace_extension(".robot.json");
  if (!options.side_file.empty()) return ReadFile(options.side_file, kMaxBytes);
  if (std::filesystem::exists(own)) {
    std::printf("side file: %s\n", own.c_str());
    return ReadFile(own, kMaxBytes);
  }
  if (const std::optional<catalog::KnownRobot> known = catalog::FindKnownRobot(options.urdf)) {
    std::printf("side file: %s, which ships for this description, known %s\n",
                known->side_file.c_str(), WordsFor(known->match).data());
    return ReadFile(known->side_file, kMaxBytes);
  }
  ConsoleReporter console;
  const catalog::RobotGuess guess = catalog::GuessRobot(
      options.urdf, reader, console.callbacks().ProgressOf("looking for overlaps"));
  console.Clear();
  for (const std::string& note : guess.notes) std::printf("found: %s\n", note.c_str());
  return guess.side_file;
}

int Add(const RobotsOptions& options) {
  catalog::CheckNewName(options.name);
  robot::RobotReaderOptions reader{
      .package_roots = {options.packages.begin(), options.packages.end()}};
  reader.side_file_text = SideFileTextFor(options, reader);
  const robot::RobotReading reading = robot::LoadRobot(options.urdf, reader);
  const std::filesystem::path folder = catalog::AddRobot(options.name, reading.files);
  std::printf("added: %s\n", folder.c_str());
  DrawRobot(*PlaceRobot({.urdf = options.name}), folder / (options.name + ".png"));
  return kDone;
}

/// Prints both hashes of a description, and the side file that ships for it.
void PrintDescription(const std::filesystem::path& urdf, const robot::RobotModel& model) {
  constexpr std::size_t kMaxBytes = 4 << 20;
  const std::optional<catalog::KnownRobot> known = catalog::FindKnownRobot(urdf);
  const std::string match = known ? "known " + std::string(WordsFor(known->match)) + ": " +
                                        known->side_file.filename().string()
                                  : "not known";
  std::printf("description: %s; content hash %s, kinematics hash %s\n", match.c_str(),
              catalog::UrdfHash(ReadFile(urdf, kMaxBytes)).c_str(),
              catalog::KinematicsHash(model).c_str());
}

int Check(const RobotsOptions& options) {
  const model::RobotPlacement robot = *PlaceRobot({.urdf = options.name});
  ConsoleReporter console;
  const catalog::RobotReport report =
      catalog::CheckRobot(robot, console.callbacks().ProgressOf("checking"));
  console.Clear();
  for (const std::string& fact : report.facts) std::printf("%s\n", fact.c_str());
  PrintDescription(catalog::FindRobot(options.name).urdf, robot.model);
  for (const std::string& finding : report.findings) {
    std::fprintf(stderr, "%s: %s\n", options.name.c_str(), finding.c_str());
  }
  return report.findings.empty() ? kDone : kInputWrong;
}

}  // namespace

void AddRobots(CLI::App* program, ExitAnswer answer) {
  auto options = std::make_shared<RobotsOptions>();
  CLI::App* robots = program->add_subcommand(
      "robots", "List the robots that --robot takes by name; add one, or check one");
  robots->require_subcommand(0, 1);
  CLI::App* add = robots->add_subcommand(
      "add",
      "Copy a robot to your own folder, find its arms, grippers and a ready pose, and draw it");
  add->add_option("NAME", options->name, "its name from now on")->required();
  add->add_option("URDF", options->urdf, "URDF file of the robot")
      ->required()
      ->check(CLI::ExistingFile);
  Repeatable(add->add_option("--package,--path", options->packages,
                             "folder that contains packages of its meshes; may be repeated"));
  add->add_option(
         "--side-file", options->side_file,
         "side file to use (default: NAME.robot.json beside the URDF, or one that is known "
         "for this URDF, or a new one)")
      ->check(CLI::ExistingFile);
  CLI::App* check = robots->add_subcommand(
      "check", "Report arms, grippers and reach of a robot, and what does not work");
  check->add_option("NAME", options->name, "name of a robot, or its URDF file")->required();
  add->callback([options, answer] { *answer = Add(*options); });
  check->callback([options, answer] { *answer = Check(*options); });
  robots->callback([robots, answer] {
    if (robots->get_subcommands().empty()) *answer = List();
  });
}

}  // namespace smile::app
