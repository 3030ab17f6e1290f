// `smile experiment`: the main job. A person shows a task, the robot does it elsewhere.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/film.h"
#include "app/imitation.h"
#include "app/interrupt.h"
#include "app/layout_options.h"
#include "app/move_aside.h"
#include "app/options.h"
#include "app/run_loop.h"
#include "base/files.h"
#include "report/experiment_page.h"
#include "scene_xml/scene_reader.h"

namespace smile::app {
namespace {

/// What there is to be shown: of each task `scenes/NAME.xml`, `examples/NAME.jsonl` and
/// `scenes/NAME_robot.xml` are shipped.
constexpr std::array kTasks{"um", "tower", "row", "bridge", "box", "hatch", "drive"};

/// The robot program that imitates, unless told otherwise.
constexpr const char* kLearner = "matlab/um";

/// A slow machine is no reason to fail [s].
constexpr double kPatience = 60;

/// Films show four seconds in one: the robot takes its time.
constexpr double kFilmSpeed = 4;

struct ExperimentOptions {
  std::string name = kTasks.front(), out, brain;
  LayoutOptions layout;
  bool no_films = false, json = false;
};

void RecordDemonstration(const std::string& task, const std::filesystem::path& directory) {
  RunPlan plan{.scene = scene_xml::LoadScene(DataFile("scenes/" + task + ".xml")),
               .robot = PlaceRobot({})};
  plan.script =
      sim::ReadScript(DataFile("examples/" + task + ".jsonl"), plan.scene.meters_per_unit);
  plan.record = directory;
  plan.recording.title = task;
  plan.label = "showing " + task;
  Run(plan);
}

void FilmBoth(const std::filesystem::path& out) {
  for (const char* name : {"demonstration", "imitation"}) {
    if (IsInterrupted()) return;
    Film(record::OpenRecording(out / name), (out / name).string() + ".mp4",
         {.shot = {.width_px = 854, .height_px = 480},
          .frames_per_second = 20,
          .speed = kFilmSpeed,
          .progress = std::string("filming the ") + name});
  }
}

void WriteReport(const std::string& task, const Json& result, const std::filesystem::path& out,
                 bool has_films) {
  if (IsInterrupted()) return;
  std::vector<report::Enclosure> enclosures;
  if (has_films) {
    enclosures.push_back({"demonstration.mp4", "film of the demonstration"});
    enclosures.push_back({"imitation.mp4", "film of the robot"});
  }
  enclosures.push_back({"demonstration", "recording of the demonstration"});
  enclosures.push_back({"imitation", "recording of the robot"});
  enclosures.push_back({"result.json", "the result, for programs"});
  const record::Recording demonstration = record::OpenRecording(out / "demonstration");
  const record::Recording imitation = record::OpenRecording(out / "imitation");
  WriteFile(out / "report.html", report::PageOf({.name = task,
                                                 .demonstration = demonstration,
                                                 .imitation = imitation,
                                                 .result = result,
                                                 .enclosures = enclosures}));
}

void PrintSummary(const ImitationOutcome& outcome, const std::filesystem::path& out,
                  bool has_films) {
  const Json& result = outcome.result;
  std::printf("\nThe robot watched the task '%s' and %s.\n",
              result["task"].get<std::string>().c_str(),
              outcome.is_rebuilt ? "did it, too" : "did not manage to do it");
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
  std::printf("  %s/demonstration   the recording of the hands\n", out.c_str());
  std::printf("  %s/imitation       the recording of the robot\n", out.c_str());
  if (has_films) {
    std::printf("  %s/demonstration.mp4, %s/imitation.mp4   films, at %gx speed\n", out.c_str(),
                out.c_str(), kFilmSpeed);
  }
  std::printf("  %s/result.json, %s/report.html   the same for programs and for people\n",
              out.c_str(), out.c_str());
}

int RunExperiment(const ExperimentOptions& options) {
  const std::filesystem::path out = options.out.empty()
                                        ? std::filesystem::path("out") / options.name
                                        : std::filesystem::path(options.out);
  MoveAside(out);
  MakeDirectories(out);
  RecordDemonstration(options.name, out / "demonstration");
  if (IsInterrupted()) throw std::runtime_error("interrupted; what was recorded is kept");

  scene::SceneSpec scene = LaidOut(
      scene_xml::LoadScene(DataFile("scenes/" + options.name + "_robot.xml")), options.layout);
  const ImitationOutcome outcome = Imitate(
      {.task = options.name,
       .demonstration = out / "demonstration",
       .scene = std::move(scene),
       .brain = options.brain.empty() ? DataFile(kLearner) : std::filesystem::path(options.brain),
       .record = out / "imitation",
       .robot = PlaceRobot({})});
  WriteFile(out / "result.json", ToText(outcome.result, 2) + "\n");
  if (!options.no_films) FilmBoth(out);
  WriteReport(options.name, outcome.result, out, !options.no_films);
  if (options.json) {
    std::printf("%s\n", ToText(outcome.result, 2).c_str());
  } else {
    PrintSummary(outcome, out, !options.no_films);
  }
  if (outcome.brain_error) {
    std::fprintf(stderr, "%s\n", ToString(*outcome.brain_error).c_str());
    return kInputWrong;
  }
  return outcome.is_rebuilt ? kDone : kInputWrong;
}

}  // namespace

void AddExperiment(CLI::App* program, ExitAnswer answer) {
  auto options = std::make_shared<ExperimentOptions>();
  CLI::App* experiment = program->add_subcommand(
      "experiment", "Show a task with invisible hands, let the robot do it elsewhere, score it");
  experiment->add_option("NAME", options->name, "which one")
      ->capture_default_str()
      ->check(CLI::IsMember(std::vector<std::string>(kTasks.begin(), kTasks.end())));
  experiment->add_option("--out", options->out, "directory for the results; out/NAME if not given");
  experiment->add_option("--brain", options->brain, "the robot program; matlab/um if not given");
  AddLayoutOptions(experiment, &options->layout);
  experiment->add_flag("--no-films", options->no_films, "leave out the mp4 files");
  experiment->add_flag("--json", options->json, "print result.json on stdout");
  experiment->callback([options, answer] { *answer = RunExperiment(*options); });
}

}  // namespace smile::app
