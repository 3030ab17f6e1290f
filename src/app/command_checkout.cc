#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/commands.h"
#include "app/console_reporter.h"
#include "app/exit_code.h"
#include "app/open_recording.h"
#include "app/options.h"
#include "base/hash_text.h"
#include "experiment/run.h"
#include "recording/recording_history.h"
#include "recording/time_range.h"
#include "recording/view_sample.h"

namespace smile::app {
namespace {

struct CheckoutOptions {
  std::string demo, commands, recordings = "recordings";
  std::optional<std::size_t> at;
  std::optional<double> after, seconds;
  bool json = false;
};

/// Returns the point of the options; the end of the recording without any.
recording::HistoryPoint HistoryPointOf(const CheckoutOptions& options,
                                       const recording::Recording& recording) {
  const std::vector<recording::Segment> steps = recording::HistoryOf(recording);
  // By default from the last step that was not undone; the first step is always on the path.
  std::size_t at = steps.size() - 1;
  while (!options.at && !steps[at].is_on_path) --at;
  return recording::HistoryPointOf(recording, steps, options.at.value_or(at), options.after);
}

/// Continues a recording from a point of its history, and records what follows into it.
int CheckOut(const CheckoutOptions& options) {
  const recording::Recording recording = OpenAndReport(options.demo);
  const recording::HistoryPoint from = HistoryPointOf(options, recording);
  experiment::RunPlan plan{.scene = recording.start_scene(),
                           .robot = recording.robot(),
                           // Without a script and a duration, the recording only goes back to the
                           // point.
                           .seconds = options.commands.empty()
                                          ? std::optional(options.seconds.value_or(0))
                                          : options.seconds,
                           .has_pictures = recording.info.eye.has_value(),
                           .eye = EyeOf(recording.info).value_or(sim::EyeSpec()),
                           .label = "continuing"};
  plan.recordings = options.recordings;
  if (!options.commands.empty()) {
    plan.script = sim::ReadScript(options.commands, plan.scene.meters_per_unit);
  }
  plan.continuation = {options.demo, from};
  ConsoleReporter console;
  const experiment::RunResult outcome = experiment::Run(plan, console.callbacks());
  console.Clear();
  if (options.json) {
    std::printf("%s\n", ToText(ToJson(outcome), 2).c_str());
  } else {
    std::printf("%s: continued from %.2f s, ends at %.2f s, state %s\n", options.demo.c_str(),
                recording::SecondsInto(recording, from.tick),
                recording::SecondsInto(recording, outcome.ticks),
                HashText(outcome.state_hash).c_str());
    // The first recording is the continued one; others were started by the script.
    for (std::size_t i = 1; i < outcome.recordings.size(); ++i) {
      std::printf("recorded in %s\n", outcome.recordings[i].c_str());
    }
  }
  return kDone;
}

}  // namespace

void AddCheckout(CLI::App* program, ExitAnswer answer) {
  auto options = std::make_shared<CheckoutOptions>();
  CLI::App* checkout = program->add_subcommand(
      "checkout", "Continue a recording from any of its steps; later steps remain in its history");
  checkout->add_option("DEMO", options->demo, "directory of a recording")->required();
  checkout
      ->add_option("--at", options->at,
                   "number of the step to continue from, as in smile history (default: the last)")
      ->check(NumberBetween(0, 1e9));
  checkout->add_option("--after", options->after, "time within that step [s] (default: its end)")
      ->check(NumberBetween(0.0, 86400.0));
  checkout->add_option("--commands", options->commands, "script of commands to continue with");
  checkout
      ->add_option("--seconds", options->seconds, "duration [s] (default: until the script ends)")
      ->check(NumberBetween(0.0, 86400.0));
  checkout
      ->add_option("--recordings", options->recordings,
                   "folder of the recordings that the script starts")
      ->capture_default_str()
      ->check(NotEmpty());
  checkout->add_flag("--json", options->json, "result as one JSON object on stdout");
  checkout->callback([options, answer] { *answer = CheckOut(*options); });
}

}  // namespace smile::app
