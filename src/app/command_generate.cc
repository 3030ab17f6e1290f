// `smile generate`: many recordings of a robot from one demonstration.

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <memory>

#include "app/commands.h"
#include "app/console_reporter.h"
#include "app/exit_code.h"
#include "app/generation_plan.h"
#include "app/layout_options.h"
#include "app/slurm_job.h"
#include "base/wording.h"

namespace smile::app {
namespace {

constexpr std::size_t kMaxTries = 1000;

std::string StatusText(const experiment::GenerationStatus& status) {
  std::string text = std::to_string(status.episodes) + " of " + std::to_string(status.wanted) +
                     " episodes, " + std::to_string(status.attempts) + " attempts";
  if (status.attempts_per_hour) {
    text += ", " + NumberText(std::round(*status.attempts_per_hour)) + " per hour";
  }
  if (status.seconds_left) text += TimeLeftText(*status.seconds_left);
  return text;
}

int Generate(const GenerateOptions& options) {
  const experiment::GenerationPlan plan = PlanOf(options);
  if (options.pool.slurm_shards > 0) {
    SubmitToSlurm(options.pool.slurm_shards, plan.count, plan.jobs, plan.out);
    return kDone;
  }
  ConsoleReporter console;
  ProgressLine line("generating");
  const experiment::GenerationSummary summary = experiment::Generate(
      plan, {.common = console.callbacks(),
             .on_status =
                 [&](const experiment::GenerationStatus& status) {
                   console.Clear();
                   line.Say(StatusText(status));
                 },
             .on_failure =
                 [&](const experiment::EndedAttempt& ended) {
                   line.Wipe();
                   std::fprintf(stderr, "seed %llu: %s: %s\n",
                                static_cast<unsigned long long>(ended.attempt.seed),
                                Printable(ended.cause->code).c_str(),
                                Printable(ended.cause->text).c_str());
                 }});
  line.Wipe();
  if (options.json) {
    std::printf("%s\n", ToText(ToJson(summary), 2).c_str());
  } else {
    std::printf("%s%s\n", experiment::SummaryText(summary).c_str(),
                (plan.out / "manifest.jsonl").c_str());
  }
  if (summary.yield.successes == summary.wanted) return kDone;
  std::fprintf(stderr, "%s: %zu episodes are missing: no attempt at them succeeded; see --tries\n",
               plan.out.c_str(), summary.wanted - summary.yield.successes);
  return kInputWrong;
}

void AddChoices(CLI::App* generate, GenerateOptions* options) {
  Repeatable(generate->add_option("--scene", options->scenes,
                                  "scene file in which the robot imitates; may be repeated: each "
                                  "attempt draws one"))
      ->required()
      ->check(NotEmpty());
  Repeatable(generate->add_option("--level", options->levels,
                                  "difficulty of the layouts (docs/experiments.md); of a "
                                  "comma-separated list, each attempt draws one (default: "
                                  "scattered)"))
      ->delimiter(',')
      ->check(IsLayoutLevel());
  Repeatable(generate->add_option("--eye", options->eyes,
                                  "camera of the robot: `eye` or `head`; of a comma-separated "
                                  "list, each attempt draws one (default: eye)"))
      ->delimiter(',')
      ->check(CLI::IsMember({sim::kEyeCamera, sim::kHeadCamera}));
  generate->add_option("--size", options->settings.size,
                       "size of the robot's pictures (default: 640x480; 640x400 for the eye "
                       "`head`)");
  generate->add_option(
      "--noise", options->noise,
      "Gaussian noise in the sensors of the brain: standard deviations joints=RAD, "
      "image=FRACTION and depth=UNITS, comma-separated; of a range such as "
      "joints=0..0.01, each attempt draws one");
  AddVariationOptions(generate, &options->variation);
}

}  // namespace

void AddGenerate(CLI::App* program, ExitAnswer answer) {
  auto options = std::make_shared<GenerateOptions>();
  CLI::App* generate = program->add_subcommand(
      "generate",
      "Make many recordings of a robot from one demonstration: a brain imitates it in random "
      "layouts, and what succeeds, holds and replays to the last bit is kept");
  generate->add_option("DEMO", options->demo, "directory of a recording")->required();
  AddChoices(generate, options.get());
  generate->add_option("--brain", options->brain, "brain")
      ->required()
      ->check(NotEmpty())
      ->transform(PresentBrain());
  generate->add_option("--count", options->count, "number of wanted episodes")
      ->capture_default_str()
      ->check(CLI::Range(std::size_t{1}, experiment::kMaxEpisodes));
  generate
      ->add_option("--tries", options->tries,
                   "limit of attempts at an episode, each in a layout of its own")
      ->capture_default_str()
      ->check(CLI::Range(std::size_t{1}, kMaxTries));
  generate
      ->add_option("--seed", options->seed,
                   "seed of the first episode; the following episodes have the following seeds, "
                   "and each further attempt at one has a seed 1,000,000 higher")
      ->capture_default_str()
      ->check(CLI::Range(std::uint64_t{0}, kMaxSeed / 2));
  generate
      ->add_option("--hold", options->hold,
                   "seconds that the result must stand after the end of the brain")
      ->capture_default_str()
      ->check(NumberBetween(0.0, 3600.0));
  AddPoolOptions(generate, &options->pool);
  generate->add_option("--out", options->out,
                       "directory for the episodes (default: out/generate/SCENE)");
  generate->add_flag("--json", options->json, "summary.json on stdout");
  AddImitateSettings(generate, &options->settings);
  generate->callback([options, answer] {
    if (options->levels.empty()) options->levels = {"scattered"};
    if (options->eyes.empty()) options->eyes = {sim::kEyeCamera};
    *answer = Generate(*options);
  });
}

}  // namespace smile::app
