// `smile evaluate`: runs brains on the same task from the same random starting layouts.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/commands.h"
#include "app/console_reporter.h"
#include "app/evaluation_plan.h"
#include "app/exit_code.h"
#include "app/layout_options.h"
#include "app/slurm_job.h"
#include "base/wording.h"
#include "recording/demo_info.h"

namespace smile::app {
namespace {

constexpr std::size_t kMaxScenes = 100'000;

/// Returns the progress line.
std::string StatusText(const experiment::EvaluationStatus& status) {
  std::string text = std::to_string(status.done) + " of " + std::to_string(status.runs) +
                     " runs, " + std::to_string(status.successes) + " succeeded, " +
                     std::to_string(status.done - status.successes) + " failed";
  if (status.seconds_left) text += TimeLeftText(*status.seconds_left);
  return text;
}

int Evaluate(const EvaluateOptions& options) {
  const experiment::EvaluationPlan plan = PlanOf(options);
  if (options.pool.slurm_shards > 0) {
    SubmitToSlurm(options.pool.slurm_shards, plan.num_scenes, plan.jobs, plan.out);
    return kDone;
  }
  ConsoleReporter console;
  ProgressLine line("evaluating");
  const report::Evaluation evaluation = experiment::Evaluate(
      plan, {.common = console.callbacks(),
             .on_status =
                 [&](const experiment::EvaluationStatus& status) {
                   console.Clear();
                   line.Say(StatusText(status));
                 },
             .on_failed_run =
                 [&](const std::string& brain, const report::EvaluatedRun& run) {
                   line.Wipe();
                   std::fprintf(stderr, "%s, seed %llu: %s: %s\n", brain.c_str(),
                                static_cast<unsigned long long>(run.seed),
                                Printable(run.failure_reason->code).c_str(),
                                Printable(run.failure_reason->text).c_str());
                 }});
  line.Wipe();
  if (options.json) {
    std::printf("%s\n", ToText(ToJson(evaluation), 2).c_str());
  } else {
    std::printf("%s\n%s\n%s\n", report::ToText(evaluation).c_str(),
                (plan.out / "evaluation.json").c_str(), (plan.out / "report.html").c_str());
  }
  return kDone;
}

}  // namespace

void AddEvaluate(CLI::App* program, ExitAnswer answer) {
  auto options = std::make_shared<EvaluateOptions>();
  CLI::App* evaluate =
      program->add_subcommand("evaluate",
                              "Run brains that imitate a recording from the same random starting "
                              "layouts, and compare their results");
  evaluate->add_option("DEMO", options->demo, "directory of a recording")->required();
  evaluate->add_option("--scene", options->scene, "scene file in which the robot imitates")
      ->required()
      ->check(NotEmpty());
  Repeatable(
      evaluate->add_option("--brain", options->brains, "brain; may be repeated to compare several"))
      ->required()
      ->check(NotEmpty())
      ->transform(PresentBrain());
  CLI::Option* demonstrators =
      Repeatable(
          evaluate->add_option("--demonstrators", options->demonstrators,
                               "demonstrators to draw into the pictures of the recording and "
                               "compare: comma-separated list of invisible, ghost and forearm"))
          ->delimiter(',')
          ->check(
              CLI::IsMember(std::vector<std::string>(recording::kDemonstratorAppearances.begin(),
                                                     recording::kDemonstratorAppearances.end())));
  evaluate
      ->add_flag("--no-symbols", options->no_symbols,
                 "classic view without texts, with --demonstrators")
      ->needs(demonstrators);
  evaluate->add_option("--scenes", options->scenes, "number of starting layouts")
      ->capture_default_str()
      ->check(CLI::Range(std::size_t{1}, kMaxScenes));
  evaluate
      ->add_option("--seed", options->seed,
                   "seed of the first layout; the following layouts have the following seeds")
      ->capture_default_str()
      ->check(CLI::Range(std::uint64_t{0}, kMaxSeed));
  evaluate->add_option("--level", options->level, "difficulty of the layouts (docs/experiments.md)")
      ->check(IsLayoutLevel());
  AddPoolOptions(evaluate, &options->pool);
  evaluate->add_option("--out", options->out,
                       "directory for the results (default: out/evaluate/SCENE)");
  evaluate->add_option("--keep", options->keep, "recordings to keep: all, failures or none")
      ->capture_default_str()
      ->check(CLI::IsMember({"all", "failures", "none"}));
  evaluate->add_flag("--json", options->json, "evaluation.json on stdout");
  AddEyeOptions(evaluate, &options->eye);
  AddNoiseOption(evaluate, &options->noise);
  AddPlanOption(evaluate, &options->settings.plan);
  AddImitateSettings(evaluate, &options->settings);
  evaluate->callback([options, answer] { *answer = Evaluate(*options); });
}

}  // namespace smile::app
