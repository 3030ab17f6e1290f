#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <stdexcept>

#include "app/commands.h"
#include "app/console_reporter.h"
#include "app/exit_code.h"
#include "app/interrupt.h"
#include "app/options.h"
#include "base/hash_text.h"
#include "experiment/run.h"
#include "motion/trajectory_files.h"
#include "scene_xml/scene_reader.h"

namespace smile::app {
namespace {

struct RunOptions {
  std::string scene, commands, trajectory, record, recordings = "recordings";
  std::optional<double> seconds;
  double rate = 4;
  std::string title, notes;
  bool no_pictures = false, no_symbols = false, realtime = false, json = false;
  EyeOptions eye;
  std::string noise;
  RobotOptions robot;
  BrainOptions brain;
  PathOptions path;
};

/// Runs a scene without a window, by a script, a trajectory or a brain.
int RunScene(const RunOptions& options) {
  experiment::RunPlan plan{.scene = scene_xml::LoadScene(options.scene, options.path.reader())};
  if (!options.seconds && options.brain.brain.empty() && options.commands.empty() &&
      options.trajectory.empty()) {
    throw std::invalid_argument(
        "the run has no end: give --seconds, --commands, --trajectory or --brain");
  }
  plan.robot = PlaceRobot(options.robot, options.path);
  if (!options.brain.brain.empty() && !plan.robot) {
    throw std::invalid_argument("--brain needs a robot, but --no-robot was given");
  }
  if (!options.commands.empty()) {
    // Files that commands name are searched in the same folders as those of the scene.
    const auto& roots = options.path.roots;
    plan.script =
        sim::ReadScript(options.commands, plan.scene.meters_per_unit, {roots.begin(), roots.end()});
  }
  if (!options.trajectory.empty()) {
    plan.script = sim::ScriptOf(motion::ReadTrajectory(options.trajectory), options.trajectory);
  }
  plan.brain = options.brain.brain;
  plan.callback_seconds = options.brain.timeout;
  plan.is_attached = options.brain.attach;
  plan.seconds = options.seconds;
  plan.record = options.record;
  plan.recordings = options.recordings;
  plan.recording = {.frames_per_second = options.rate,
                    .has_symbols = !options.no_symbols,
                    .title = options.title,
                    .notes = options.notes};
  plan.has_pictures = !options.no_pictures;
  plan.eye = EyeSpecOf(options.eye);
  plan.noise = ParseNoise(options.noise);
  plan.is_realtime = options.realtime;
  plan.label = "running " + plan.scene.name;

  ConsoleReporter console;
  const experiment::RunResult outcome = experiment::Run(plan, console.callbacks());
  console.Clear();
  if (options.json) {
    std::printf("%s\n", ToText(ToJson(outcome), 2).c_str());
  } else {
    std::printf("%s: %.2f s simulated in %.2f s (%.1f x real time), state %s\n",
                plan.scene.name.c_str(), outcome.seconds, outcome.wall_seconds,
                outcome.realtime_factor, HashText(outcome.state_hash).c_str());
    if (outcome.late_ticks > 0) {
      std::printf("%llu of %llu ticks were late, by up to %.0f ms\n",
                  static_cast<unsigned long long>(outcome.late_ticks),
                  static_cast<unsigned long long>(outcome.ticks), 1000 * outcome.worst_delay);
    }
    for (const auto& directory : outcome.recordings) {
      std::printf("recorded in %s\n", directory.c_str());
    }
  }
  if (!outcome.brain_error || IsInterrupted()) return kDone;
  std::fprintf(stderr, "%s\n", ToString(*outcome.brain_error).c_str());
  return kInputWrong;
}

}  // namespace

void AddRun(CLI::App* program, ExitAnswer answer) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* run = program->add_subcommand("run", "Run a scene without a window");
  run->add_option("SCENE", options->scene, "scene file")->required();
  run->add_option("--commands", options->commands,
                  "script of commands, one JSON object per line (see: smile commands)");
  run->add_option("--trajectory", options->trajectory,
                  ".csv or .json file with a trajectory for the robot (see: smile export)")
      ->excludes("--commands");
  AddBrainOptions(run, &options->brain);
  run->add_option(
         "--seconds", options->seconds,
         "duration in seconds of simulated time (default: until the script or the brain ends)")
      ->check(NumberBetween(0.0, 86400.0));
  run->add_option("--record", options->record, "new directory for a recording of the run")
      ->check(NotEmpty());
  run->add_option("--recordings", options->recordings,
                  "folder of the recordings that the script starts")
      ->capture_default_str()
      ->check(NotEmpty());
  run->add_flag("--no-pictures", options->no_pictures, "recordings without the robot's pictures");
  run->add_flag("--no-symbols", options->no_symbols,
                "recordings without texts in the classic view");
  run->add_option("--title", options->title, "title of the recording");
  run->add_option("--notes", options->notes, "notes about the recording");
  run->add_option("--rate", options->rate, "pictures per second of the recording")
      ->capture_default_str()
      ->check(NumberBetween(0.001, sim::kTicksPerSecond));
  AddEyeOptions(run, &options->eye);
  AddNoiseOption(run, &options->noise);
  run->add_flag("--realtime", options->realtime, "run at real time, not faster");
  run->add_flag("--json", options->json, "result as one JSON object on stdout");
  AddRobotOptions(run, /*may_be_absent=*/true, &options->robot);
  AddPathOption(run, &options->path);
  run->callback([options, answer] { *answer = RunScene(*options); });
}

}  // namespace smile::app
