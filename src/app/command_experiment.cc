// `smile experiment`: hands demonstrate a task, the robot imitates it elsewhere.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "app/commands.h"
#include "app/console_reporter.h"
#include "app/exit_code.h"
#include "app/layout_options.h"
#include "app/options.h"
#include "experiment/task_experiment.h"

namespace smile::app {
namespace {

struct ExperimentOptions {
  std::string name{experiment::kTasks.front().name}, out, brain;
  LayoutOptions layout;
  bool has_level = false;  ///< given by the user
  bool analyze = false, no_films = false, json = false;
};

/// Prints the reached and the wanted positions in units of the scene, the errors, and the files.
void PrintSummary(const experiment::ImitationResult& outcome, const std::filesystem::path& out,
                  bool has_films) {
  const Json& result = outcome.json;
  std::printf("\nThe robot watched the task '%s' and %s.\n",
              result["task"].get<std::string>().c_str(),
              outcome.has_succeeded ? "repeated it" : "failed to repeat it");
  for (const auto& [id, goal] : result["goal"]["objects"].items()) {
    const std::string scene_id = result["match"][id];
    const Json& at = result["final"]["objects"][scene_id]["position"];
    const Json& wanted = goal["position"];
    std::printf("  %-12s is at (%6.2f, %6.2f, %5.2f), wanted at (%6.2f, %6.2f, %5.2f)\n",
                scene_id.c_str(), at[0].get<double>(), at[1].get<double>(), at[2].get<double>(),
                wanted[0].get<double>(), wanted[1].get<double>(), wanted[2].get<double>());
  }
  if (!result["cause"].is_null()) {
    std::printf("  because: %s\n", result["cause"]["text"].get<std::string>().c_str());
  }
  std::printf("  mean error %.1f mm; %.1f s of robot time, %.1f x faster than real time\n\n",
              result["mean_error_mm"].get<double>(), result["seconds"].get<double>(),
              result["realtime_factor"].get<double>());
  std::printf("  %s/demonstration   recording of the hands\n", out.c_str());
  std::printf("  %s/imitation       recording of the robot\n", out.c_str());
  if (has_films) {
    std::printf("  %s/demonstration.mp4, %s/imitation.mp4   films, at %gx speed\n", out.c_str(),
                out.c_str(), experiment::kFilmSpeed);
  }
  std::printf("  %s/result.json, %s/report.html   the result, as data and as a page\n", out.c_str(),
              out.c_str());
}

std::vector<std::string> TaskNames() {
  std::vector<std::string> names;
  for (const experiment::ShippedTask& task : experiment::kTasks) names.emplace_back(task.name);
  return names;
}

int RunExperiment(const ExperimentOptions& options) {
  const std::filesystem::path out = options.out.empty()
                                        ? std::filesystem::path("out") / options.name
                                        : std::filesystem::path(options.out);
  layout::LayoutChoice layout = options.layout.choice();
  if (!options.has_level) layout.level = experiment::FindTask(options.name)->level;
  ConsoleReporter console;
  const experiment::ImitationResult outcome =
      experiment::RunTaskExperiment({.task = options.name,
                                     .out = out,
                                     .robot = *PlaceRobot({}),
                                     .brain = options.brain,
                                     .layout = layout,
                                     .is_analyzed = options.analyze,
                                     .has_films = !options.no_films},
                                    console.callbacks());
  console.Clear();
  if (options.json) {
    std::printf("%s\n", ToText(outcome.json, 2).c_str());
  } else {
    PrintSummary(outcome, out, !options.no_films);
  }
  if (outcome.brain_error) {
    std::fprintf(stderr, "%s\n", ToString(*outcome.brain_error).c_str());
    return kInputWrong;
  }
  // Scripts see from the exit status if the robot succeeded.
  return outcome.has_succeeded ? kDone : kInputWrong;
}

}  // namespace

void AddExperiment(CLI::App* program, ExitAnswer answer) {
  auto options = std::make_shared<ExperimentOptions>();
  CLI::App* experiment =
      program->add_subcommand("experiment",
                              "Demonstrate a task with invisible hands, let the robot imitate it "
                              "in another layout, and score the result");
  experiment->add_option("NAME", options->name, "name of the task")
      ->capture_default_str()
      ->check(CLI::IsMember(TaskNames()));
  experiment->add_option("--out", options->out, "directory for the results (default: out/NAME)");
  experiment->add_option("--brain", options->brain, "brain (default: matlab/learner)")
      ->transform(PresentBrain());
  AddLayoutOptions(experiment, &options->layout);
  experiment->add_flag("--analyze", options->analyze,
                       "analyze the demonstration first, as `smile analyze` does, and give the "
                       "brain the result");
  experiment->add_flag("--no-films", options->no_films, "no mp4 files");
  experiment->add_flag("--json", options->json, "result.json on stdout");
  CLI::Option* level = experiment->get_option("--level");
  level->default_str("that of the task");
  experiment->callback([options, level, answer] {
    options->has_level = level->count() > 0;
    *answer = RunExperiment(*options);
  });
}

}  // namespace smile::app
