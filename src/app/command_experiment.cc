// `smile experiment`: the main job. A person shows a tower, the robot builds one.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string_view>

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

/// What an experiment is made of, all of it shipped.
struct Experiment {
  std::string_view name;
  const char* demonstration_scene;
  const char* demonstration_script;
  const char* robot_scene;
  const char* brain;
  task::LayoutRegion region;  ///< where its brain may find things
};

constexpr std::array kExperiments{
    // Its brain keeps its elbows out, which costs reach, and builds where the strip would be.
    Experiment{"tower",
               "scenes/tower.xml",
               "examples/tower.jsonl",
               "scenes/tower_robot.xml",
               "matlab/examples/tower",
               {.most_x = 0.42, .least_depth = 0.16, .most_depth = 0.44, .strip_half_width = 0}}};

const Experiment& FindExperiment(const std::string& name) {
  return *std::ranges::find(kExperiments, name, &Experiment::name);
}

std::vector<std::string> ExperimentNames() {
  std::vector<std::string> names;
  for (const Experiment& experiment : kExperiments) names.emplace_back(experiment.name);
  return names;
}

/// Films show two seconds in one: the robot takes its time.
constexpr double kFilmSpeed = 2;

struct ExperimentOptions {
  std::string name{kExperiments.front().name}, out;
  LayoutOptions layout;
  bool no_films = false, json = false;
};

void RecordDemonstration(const Experiment& experiment, const std::filesystem::path& directory) {
  RunPlan plan{.scene = scene_xml::LoadScene(DataFile(experiment.demonstration_scene)),
               .robot = PlaceRobot({})};
  plan.script =
      sim::ReadScript(DataFile(experiment.demonstration_script), plan.scene.meters_per_unit);
  plan.record = directory;
  plan.recording.title = std::string(experiment.name);
  plan.label = "showing the " + std::string(experiment.name);
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

void WriteReport(const Experiment& experiment, const Json& result, const std::filesystem::path& out,
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
  WriteFile(out / "report.html", report::PageOf({.name = std::string(experiment.name),
                                                 .demonstration = demonstration,
                                                 .imitation = imitation,
                                                 .result = result,
                                                 .enclosures = enclosures}));
}

void PrintSummary(const ImitationOutcome& outcome, const std::filesystem::path& out,
                  bool has_films) {
  const Json& result = outcome.result;
  std::printf("\nThe robot watched a %s and %s.\n", result["task"].get<std::string>().c_str(),
              outcome.is_rebuilt ? "built one of its own" : "did not manage to rebuild it");
  for (const auto& [id, goal] : result["goal"]["objects"].items()) {
    const std::string scene_id = result["match"][id];
    const Json& at = result["final"]["objects"][scene_id]["position"];
    const Json& wanted = goal["position"];
    std::printf("  %-12s is at (%6.2f, %6.2f, %5.2f), wanted at (%6.2f, %6.2f, %5.2f)\n",
                scene_id.c_str(), at[0].get<double>(), at[1].get<double>(), at[2].get<double>(),
                wanted[0].get<double>(), wanted[1].get<double>(), wanted[2].get<double>());
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
  const Experiment& experiment = FindExperiment(options.name);
  const std::filesystem::path out = options.out.empty()
                                        ? std::filesystem::path("out") / experiment.name
                                        : std::filesystem::path(options.out);
  MoveAside(out);
  MakeDirectories(out);
  RecordDemonstration(experiment, out / "demonstration");
  if (IsInterrupted()) throw std::runtime_error("interrupted; what was recorded is kept");

  scene::SceneSpec scene = LaidOut(scene_xml::LoadScene(DataFile(experiment.robot_scene)),
                                   options.layout, experiment.region);
  const ImitationOutcome outcome = Imitate({.task = std::string(experiment.name),
                                            .demonstration = out / "demonstration",
                                            .scene = std::move(scene),
                                            .brain = DataFile(experiment.brain),
                                            .record = out / "imitation",
                                            .robot = PlaceRobot({})});
  WriteFile(out / "result.json", ToText(outcome.result, 2) + "\n");
  if (!options.no_films) FilmBoth(out);
  WriteReport(experiment, outcome.result, out, !options.no_films);
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
      ->check(CLI::IsMember(ExperimentNames()));
  experiment->add_option("--out", options->out, "directory for the results; out/NAME if not given");
  AddLayoutOptions(experiment, &options->layout);
  experiment->add_flag("--no-films", options->no_films, "leave out the mp4 files");
  experiment->add_flag("--json", options->json, "print result.json on stdout");
  experiment->callback([options, answer] { *answer = RunExperiment(*options); });
}

}  // namespace smile::app
