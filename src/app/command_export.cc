#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/export_world.h"
#include "app/open_recording.h"
#include "app/options.h"
#include "app/python_program.h"
#include "base/diagnostic.h"
#include "base/files.h"
#include "base/wording.h"
#include "datasets/dataset_formats.h"
#include "interchange/world_formats.h"
#include "motion/limit_check.h"
#include "motion/trajectory_files.h"
#include "motion/trajectory_shape.h"
#include "recording/joint_motion.h"

namespace smile::app {
namespace {

struct ExportOptions {
  std::vector<std::string> runs;
  std::string format, out;
  recording::TimeRange range;
  std::optional<double> rate;       ///< points per second; unset: that of ticks
  std::optional<std::string> part;  ///< of the robot; unset: all of it
  bool no_grippers = false, slow_down = false, allow_breaches = false;

  std::string part_or_all() const { return part.value_or("all"); }

  /// Returns an option that is set and only for trajectories of the robot; empty without one.
  std::string OfTrajectories() const {
    if (part) return "--arm is";
    if (no_grippers) return "--no-grippers is";
    if (slow_down) return "--slow-down is";
    return allow_breaches ? "--allow-breaches is" : "";
  }
};

/// Options of datasets, which the Python package smile.datasets makes; all are optional.
struct DatasetOptions {
  std::vector<std::string> cameras, maps;
  std::string size, fps, action, task, parts;
  bool include_failed = false, drop_constant = false, no_extras = false, language = false;

  /// Returns them as arguments of the package.
  std::vector<std::string> arguments() const {
    std::vector<std::string> words;
    for (const std::string& camera : cameras) words.insert(words.end(), {"--camera", camera});
    for (const std::string& map : maps) words.insert(words.end(), {"--map", map});
    for (const auto& [name, value] :
         {std::pair{"--size", &size}, std::pair{"--fps", &fps}, std::pair{"--action", &action},
          std::pair{"--task", &task}, std::pair{"--parts", &parts}}) {
      if (!value->empty()) words.insert(words.end(), {name, *value});
    }
    for (const auto& [name, is_set] :
         {std::pair{"--include-failed", include_failed},
          std::pair{"--drop-constant", drop_constant}, std::pair{"--no-extras", no_extras},
          std::pair{"--language", language}}) {
      if (is_set) words.emplace_back(name);
    }
    return words;
  }
};

/// Trajectory with the limits of its robot.
struct Motion {
  motion::JointTrajectory trajectory;
  std::vector<motion::TrajectoryChannel> channels;

  std::vector<motion::LimitBreach> Breaches() const {
    std::vector<motion::JointLimits> limits;
    for (const motion::TrajectoryChannel& channel : channels) limits.push_back(channel.limits);
    return CheckLimits(trajectory, limits);
  }
};

/// Format of an exported file.
struct Format {
  const char* name;
  const char* meaning;
  std::string (*text_of)(const motion::JointTrajectory&);
};
constexpr std::array kFormats{
    Format{"trajectory-csv", "time and joint positions, one line per point", &motion::ToCsv},
    Format{"ros-trajectory", "trajectory_msgs/JointTrajectory as JSON", &motion::ToRosJson}};

const Format& FormatOf(const ExportOptions& options) {
  std::vector<std::string_view> names;
  for (const Format& format : kFormats) {
    if (options.format == format.name) return format;
    names.emplace_back(format.name);
  }
  names.insert(names.end(), datasets::kDatasetFormats.begin(), datasets::kDatasetFormats.end());
  const std::vector<std::string_view> worlds = interchange::WorldFormatNames();
  names.insert(names.end(), worlds.begin(), worlds.end());
  throw std::invalid_argument("--to is " + Quoted(options.format) + ", expected " + OneOf(names));
}

bool IsOfPart(const motion::TrajectoryChannel& channel, const robot::RobotModel& model,
              const std::string& part) {
  if (part == "all") return true;
  if (model.head && std::ranges::count(model.head->joints, channel.joint) > 0)
    return part == "head";
  for (int arm = 0; arm < static_cast<int>(model.arms.size()); ++arm) {
    const auto& joints = model.arms[arm].joints;
    if (channel.gripper_of == arm || std::ranges::count(joints, channel.joint) > 0)
      return part == "both" || part == model.arms[arm].name;
  }
  return false;
}

std::vector<motion::TrajectoryChannel> ChosenChannels(const robot::RobotModel& model,
                                                      const ExportOptions& options) {
  std::vector<motion::TrajectoryChannel> chosen;
  for (const motion::TrajectoryChannel& channel : motion::ChannelsOf(model)) {
    if (options.no_grippers && channel.is_gripper()) continue;
    if (IsOfPart(channel, model, options.part_or_all())) chosen.push_back(channel);
  }
  return chosen;
}

/// Scales the time of a motion so that no joint exceeds its velocity limit.
/// @returns the factor by which it takes longer.
double SlowDown(Motion* motion) {
  // A little more than exact, so that rounding does not leave a breach.
  constexpr double kRounding = 1 + 1e-9;
  double factor = 1;
  for (const motion::LimitBreach& breach : motion->Breaches()) {
    if (breach.quantity != motion::LimitedQuantity::kVelocity) continue;
    factor = std::max(factor, breach.value / breach.limit * kRounding);
  }
  motion::ScaleTime(factor, &motion->trajectory);
  return factor;
}

/// Reports on stderr where the motion exceeds the limits of the robot.
/// @returns true if a robot would refuse it. Accelerations are only a remark: descriptions of
///          robots do not limit them.
bool ReportBreaches(const Motion& motion, const std::string& demo) {
  bool is_refused = false;
  std::size_t num_jerky = 0;
  for (const motion::LimitBreach& breach : motion.Breaches()) {
    if (breach.quantity == motion::LimitedQuantity::kAcceleration) {
      ++num_jerky;
      continue;
    }
    std::fprintf(stderr, "%s: at %.3f s, %s\n", demo.c_str(), breach.seconds,
                 ToString(breach).c_str());
    is_refused = true;
  }
  if (num_jerky > 0) {
    std::fprintf(stderr, "%s: %zu joints change their speed faster than in %s s to full speed\n",
                 demo.c_str(), num_jerky, NumberText(motion::kSecondsToFullSpeed).c_str());
  }
  return is_refused;
}

/// Checks that the exported file can be read and played.
/// @throws InputError
void RequireReadable(const motion::JointTrajectory& trajectory, const std::string& demo) {
  try {
    CheckShape(trajectory);
  } catch (const std::invalid_argument& error) {
    throw InputError(
        {demo, 0, "", std::string(error.what()) + "; choose a smaller --rate or a part"});
  }
}

/// Demands that there is only one thing to export.
void RequireOne(const ExportOptions& options, const char* what) {
  if (options.runs.size() == 1) return;
  throw std::invalid_argument(options.format + " is of one " + what + ", found " +
                              std::to_string(options.runs.size()));
}

int ExportMotion(const ExportOptions& options) {
  const Format& format = FormatOf(options);
  RequireOne(options, "recording");
  const std::string& demo = options.runs.front();
  RequireOutsideOfRecordings(options.out);
  const recording::Recording recording = OpenAndReport(demo);
  Motion motion;
  if (recording.robot()) motion.channels = ChosenChannels(recording.robot()->model, options);
  if (recording.robot() && motion.channels.empty()) {
    std::vector<std::string_view> parts{"both", "all"};
    const robot::RobotModel& model = recording.robot()->model;
    if (model.head) parts.push_back("head");
    for (const robot::Arm& arm : model.arms) parts.push_back(arm.name);
    throw std::invalid_argument("the robot of " + Quoted(demo) + " has no " +
                                Printable(options.part_or_all()) + ", expected " + OneOf(parts));
  }
  motion.trajectory = JointMotionOf(recording, motion.channels, options.range,
                                    options.rate.value_or(sim::kTicksPerSecond));
  const double factor = options.slow_down ? SlowDown(&motion) : 1;
  RequireReadable(motion.trajectory, demo);
  const bool is_refused = ReportBreaches(motion, demo);
  if (is_refused && !options.allow_breaches) {
    std::fprintf(
        stderr,
        "%s: the motion exceeds the limits of the robot; see --slow-down and --allow-breaches\n",
        demo.c_str());
    return kInputWrong;
  }
  WriteFile(options.out, format.text_of(motion.trajectory));
  std::printf("%s: %zu joints, %zu points, %.2f s", options.out.c_str(), motion.channels.size(),
              motion.trajectory.points.size(), motion.trajectory.seconds());
  std::printf(factor > 1 ? ", slowed down %.3f times\n" : "\n", factor);
  return kDone;
}

/// Demands that a format is of a kind if options of that kind are set.
/// @param set  those options and `is` or `are`; empty without any.
void RequireKind(bool is_kind, const std::string& set, const char* kind, const std::string& to) {
  if (is_kind || set.empty()) return;
  throw std::invalid_argument(set + " for " + kind + ", and --to is " + Quoted(to));
}

int Export(const ExportOptions& options, const DatasetOptions& dataset, const WorldExport& world) {
  const std::string& to = options.format;
  const std::vector<std::string> arguments = dataset.arguments();
  const auto is_of = [&](const auto& names) { return std::ranges::count(names, to) > 0; };
  const bool is_world = is_of(interchange::WorldFormatNames());
  const bool is_dataset = is_of(datasets::kDatasetFormats);
  const bool has_range = options.range != recording::TimeRange() || options.rate;
  RequireKind(is_dataset, arguments.empty() ? "" : arguments.front() + " is", "datasets", to);
  RequireKind(is_world,
              world == WorldExport() ? "" : "--after, --path and options of the robot are",
              "other simulators", to);
  RequireKind(!is_world && !is_dataset, options.OfTrajectories(), "trajectories", to);
  RequireKind(!is_dataset, has_range ? "--from, --to-time and --rate are" : "", "one recording",
              to);
  if (is_dataset) {
    RequireOutsideOfRecordings(options.out);
    std::vector<std::string> words{"export"};
    words.insert(words.end(), options.runs.begin(), options.runs.end());
    words.insert(words.end(), {"--to", to, "--out", options.out});
    words.insert(words.end(), arguments.begin(), arguments.end());
    ContinueAsPythonDatasets(words);
  }
  if (!is_world) return ExportMotion(options);
  RequireOne(options, "scene or recording");
  return ExportWorld(options.runs.front(), to, options.out, world, options.range, options.rate);
}

void AddDatasetOptions(CLI::App* command, DatasetOptions* options) {
  CLI::Option_group* group = command->add_option_group("Datasets");
  Repeatable(group->add_option("--camera", options->cameras,
                               "NAME[:WxH]: camera of robot or scene, or view for people; may be "
                               "repeated; `none`: no pictures (default: eye)"));
  Repeatable(group->add_option("--map", options->maps,
                               "depth or id: what each pixel shows, beside its color; may be "
                               "repeated (robomimic, zarr, mcap, rrd)"));
  group->add_option("--size", options->size, "size of pictures (default: 320x240)");
  group->add_option("--fps", options->fps, "frames per second, a divisor of 60 (default: 30)");
  group->add_option("--action", options->action,
                    "joint_position (default), joint_velocity or end_effector");
  group->add_option("--task", options->task, "what is to be done (default: the title of the run)");
  group->add_option("--parts", options->parts,
                    "episodes of a part: an interrupted export continues after its last part");
  group->add_flag("--include-failed", options->include_failed, "also runs that failed");
  group->add_flag("--drop-constant", options->drop_constant, "no joints that never move");
  group->add_flag("--no-extras", options->no_extras, "no copies of the recordings");
  group->add_flag("--language", options->language,
                  "words of the subtask and the plan at each frame (lerobot-v3.0, lerobot-v2.1)");
}

}  // namespace

void AddExport(CLI::App* program, ExitAnswer answer) {
  auto options = std::make_shared<ExportOptions>();
  auto dataset = std::make_shared<DatasetOptions>();
  auto world = std::make_shared<WorldExport>();
  CLI::App* command = program->add_subcommand(
      "export",
      "Export the robot's motion of a recording to a file, runs as a dataset for "
      "learners (docs/datasets.md), or a scene for another simulator "
      "(docs/other-simulators.md)");
  command
      ->add_option("DEMO", options->runs,
                   "directory of a recording; for a dataset several, also of imitations, and "
                   "generations; for another simulator a scene file, for gltf and usd either")
      ->required();
  std::string formats;
  for (const Format& format : kFormats)
    formats += (formats.empty() ? "" : "; ") + std::string(format.name) + ": " + format.meaning;
  formats += "; datasets:";
  for (const std::string_view format : datasets::kDatasetFormats)
    formats += " " + std::string(format);
  formats += "; other simulators and viewers:";
  for (const std::string_view format : interchange::WorldFormatNames())
    formats += " " + std::string(format);
  command->add_option("--to", options->format, formats)->required();
  command->add_option("--out", options->out, "file to write, or directory of the dataset")
      ->required()
      ->check(NotEmpty());
  command->add_option("--from", options->range.from,
                      "start [s] (default: the start of the recording)");
  command->add_option("--to-time", options->range.to,
                      "end [s] (default: the end of the recording)");
  command->add_option("--arm", options->part,
                      "joints to export: an arm by its name (left, right), both for all arms, "
                      "head, or all movable joints (default: all)");
  command->add_flag("--no-grippers", options->no_grippers, "no gripper openings");
  command
      ->add_option("--rate", options->rate,
                   "points per second of a recording (default: " +
                       std::to_string(sim::kTicksPerSecond) + ")")
      ->check(NumberBetween(0.001, sim::kTicksPerSecond));
  command->add_flag("--slow-down", options->slow_down,
                    "stretch the time until no joint exceeds its velocity limit");
  command->add_flag("--allow-breaches", options->allow_breaches,
                    "write the file even if the motion exceeds the limits of the robot");
  AddDatasetOptions(command, dataset.get());
  AddWorldExportOptions(command, world.get());
  command->callback([=] { *answer = Export(*options, *dataset, *world); });
}

}  // namespace smile::app
