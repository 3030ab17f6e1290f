#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/commands.h"
#include "app/console_reporter.h"
#include "app/exit_code.h"
#include "app/interrupt.h"
#include "app/open_recording.h"
#include "app/options.h"
#include "base/hash_text.h"
#include "experiment/run.h"
#include "recording/time_range.h"
#include "recording/view_sample.h"

namespace smile::app {
namespace {

struct CorrectOptions {
  std::string run, demo, commands, out;
  double at = 0;
  std::optional<double> seconds;
  bool json = false;
  BrainOptions brain;
};

experiment::RunPlan PlanOf(const CorrectOptions& options, const recording::Recording& recording) {
  experiment::RunPlan plan{.scene = recording.start_scene(),
                           .robot = recording.robot(),
                           .brain = options.brain.brain,
                           .callback_seconds = options.brain.timeout,
                           .is_attached = options.brain.attach,
                           .demonstration = options.demo,
                           .seconds = options.seconds,
                           .record = options.out,
                           .recording = {.frames_per_second = recording.info.frames_per_second,
                                         .has_symbols = recording.info.has_symbols},
                           .has_pictures = recording.info.eye.has_value(),
                           .eye = EyeOf(recording.info).value_or(sim::EyeSpec()),
                           .label = "correcting"};
  plan.correction = {options.run, options.at};
  if (!options.commands.empty()) {
    plan.script = sim::ReadScript(options.commands, plan.scene.meters_per_unit);
  }
  return plan;
}

/// Opens the recording, and refuses what cannot correct it.
recording::Recording RecordingToCorrect(const CorrectOptions& options) {
  const bool has_brain = !options.brain.brain.empty();
  if (!options.seconds && !has_brain && options.commands.empty()) {
    throw std::invalid_argument("the correction has no end: give --commands, --brain or --seconds");
  }
  RequireOutsideOfRecordings(options.out);
  recording::Recording recording = OpenAndReport(options.run);
  if (has_brain && !recording.robot()) {
    throw std::invalid_argument("--brain needs a robot, but the recording has none");
  }
  return recording;
}

/// Repeats a recording up to a moment, from which others act, and records both.
int Correct(const CorrectOptions& options) {
  const recording::Recording recording = RecordingToCorrect(options);
  ConsoleReporter console;
  const experiment::RunResult outcome =
      experiment::Run(PlanOf(options, recording), console.callbacks());
  console.Clear();
  if (options.json) {
    std::printf("%s\n", ToText(ToJson(outcome), 2).c_str());
  } else {
    std::printf("%s: corrects %s from %.2f s, ends at %.2f s, state %s\n", options.out.c_str(),
                options.run.c_str(), options.at, recording::SecondsInto(recording, outcome.ticks),
                HashText(outcome.state_hash).c_str());
  }
  if (!outcome.brain_error || IsInterrupted()) return kDone;
  std::fprintf(stderr, "%s\n", ToString(*outcome.brain_error).c_str());
  return kInputWrong;
}

/// Adds the options that say who takes over.
void AddActors(CLI::App* correct, CorrectOptions* options) {
  correct->add_option("--commands", options->commands, "script of commands that takes over");
  AddBrainOptions(correct, &options->brain);
  correct->add_option("--demo", options->demo,
                      "demonstration for the brain: directory of a recording");
}

}  // namespace

void AddCorrect(CLI::App* program, ExitAnswer answer) {
  auto options = std::make_shared<CorrectOptions>();
  CLI::App* correct = program->add_subcommand(
      "correct", "Take over in a recording before it goes wrong, and record a better end");
  correct->add_option("RUN", options->run, "directory of a recording; it is not changed")
      ->required();
  correct->add_option("--at", options->at, "time at which others take over [s]")
      ->required()
      ->check(NumberBetween(0.0, 1e6));
  correct->add_option("--out", options->out, "new directory for the corrected recording")
      ->required()
      ->check(NotEmpty());
  AddActors(correct, options.get());
  correct
      ->add_option("--seconds", options->seconds,
                   "duration from then on [s] (default: until the script or the brain ends)")
      ->check(NumberBetween(0.0, 86400.0));
  correct->add_flag("--json", options->json, "result as one JSON object on stdout");
  correct->callback([options, answer] { *answer = Correct(*options); });
}

}  // namespace smile::app
