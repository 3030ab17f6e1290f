#include "app/evaluation_plan.h"

#include <map>
#include <set>
#include <stdexcept>

#include "app/open_recording.h"
#include "app/shell_word.h"
#include "base/wording.h"
#include "experiment/robot_region.h"
#include "layout/layout_choice.h"
#include "scene_xml/scene_reader.h"

namespace smile::app {
namespace {

const std::map<std::string, experiment::Keep> kKeepWords{{"all", experiment::Keep::kAll},
                                                         {"failures", experiment::Keep::kFailures},
                                                         {"none", experiment::Keep::kNone}};

/// Returns the options of `smile imitate` that are the same for every run.
std::vector<std::string> OtherArguments(const EvaluateOptions& options) {
  ImitateSettings settings = options.settings;
  settings.size = options.eye.size;
  return ArgumentsOf(settings, options.eye.camera, options.noise);
}

/// Returns the arguments of `smile imitate` for a run.
std::vector<std::string> ImitateArguments(const EvaluateOptions& options, const std::string& demo,
                                          const std::string& brain, const std::string& seed,
                                          const std::string& out) {
  std::vector<std::string> arguments{"imitate", demo, options.scene, "--brain", brain,
                                     "--seed",  seed, "--out",       out};
  if (!options.level.empty()) arguments.insert(arguments.end(), {"--level", options.level});
  const std::vector<std::string> others = OtherArguments(options);
  arguments.insert(arguments.end(), others.begin(), others.end());
  return arguments;
}

/// Returns the command that repeats a run with pictures, for people.
std::string AgainText(const EvaluateOptions& options, const std::filesystem::path& out) {
  const std::string demo = options.demonstrators.empty()
                               ? options.demo
                               : (out / experiment::kDemonstratorsFolder / "DEMONSTRATOR").string();
  std::string line = "smile";
  for (const std::string& word : ImitateArguments(options, demo, "BRAIN", "SEED", "out/again")) {
    line += " " + ShellWord(word);
  }
  return line;
}

}  // namespace

experiment::EvaluationPlan PlanOf(const EvaluateOptions& options) {
  const std::filesystem::path out =
      options.out.empty()
          ? std::filesystem::path("out/evaluate") / std::filesystem::path(options.scene).stem()
          : std::filesystem::path(options.out);
  RequireOutsideOfRecordings(out.string());
  if (std::set<std::string>(options.demonstrators.begin(), options.demonstrators.end()).size() <
      options.demonstrators.size()) {
    throw std::invalid_argument("--demonstrators contains a demonstrator twice");
  }
  // Checks all inputs now, since an error in a run would appear as many times as there are runs.
  OpenAndReport(options.demo);
  EyeSpecOf(options.eye);
  ParseNoise(options.noise);
  const experiment::Shard shard = experiment::ParseShard(options.pool.shard);
  experiment::EvaluationPlan plan{
      .demonstration = options.demo,
      .analysis = options.settings.plan,
      .scene_name = options.scene,
      .scene = scene_xml::LoadScene(options.scene, options.settings.path.reader()),
      .level = options.level,
      .robot = PlaceRobot(options.settings.robot, options.settings.path)->files,
      .brains = options.brains,
      .demonstrators = options.demonstrators,
      .has_symbols = !options.no_symbols,
      .num_scenes = options.scenes,
      .first_seed = options.seed,
      .shard = shard,
      .jobs = options.pool.jobs,
      .wall_seconds = options.pool.wall_seconds,
      .keep = kKeepWords.at(options.keep),
      .out = out,
      .program = std::filesystem::read_symlink("/proc/self/exe"),
      .settings = OtherArguments(options),
      .again = AgainText(options, out)};
  const layout::LayoutLevel level =
      layout::ParseLayoutLevel(options.level).value_or(layout::LayoutChoice().level);
  plan.layout =
      [scene = plan.scene, level,
       robot = PlaceRobot(options.settings.robot, options.settings.path)](std::uint64_t seed) {
        return layout::LaidOut(scene, {.seed = seed, .level = level}, [&](double height) {
          return experiment::RegionOf(robot.value(), height);
        });
      };
  plan.arguments = [options](const experiment::ImitationJob& job) {
    std::vector<std::string> arguments =
        ImitateArguments(options, job.demonstration.string(), job.brain.string(),
                         std::to_string(job.seed), job.out.string());
    arguments.emplace_back("--no-pictures");
    return arguments;
  };
  return plan;
}

}  // namespace smile::app
