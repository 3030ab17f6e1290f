#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <stdexcept>

#include "app/commands.h"
#include "app/console_reporter.h"
#include "app/exit_code.h"
#include "app/interrupt.h"
#include "app/layout_options.h"
#include "app/options.h"
#include "base/files.h"
#include "experiment/imitation.h"
#include "experiment/robot_region.h"
#include "experiment/variation.h"
#include "scene_xml/scene_reader.h"

namespace smile::app {
namespace {

struct ImitateOptions {
  std::string demo, scene, out;
  double max_seconds = experiment::kMaxImitationSeconds;
  double hold = task::kRestSeconds;
  std::string plan;
  bool no_pictures = false, json = false, verify = false, oracle = false;
  LayoutOptions layout;
  EyeOptions eye;
  std::string noise, variation;
  RobotOptions robot;
  BrainOptions brain;
  PathOptions path;
};

void PrintResult(const experiment::ImitationResult& outcome) {
  const Json& result = outcome.json;
  std::printf("%s after %.1f s: %.0f %% of the structure, mean error %.1f mm\n",
              outcome.has_succeeded ? "success" : "failure", result["seconds"].get<double>(),
              100 * result["score"].get<double>(), result["mean_error_mm"].get<double>());
  // Printed even with a full score: objects may have been in place from the start, although the
  // program failed.
  const Json& cause = result["cause"];
  if (!cause.is_null()) std::printf("%s\n", cause["text"].get<std::string>().c_str());
}

int ImitateDemo(const ImitateOptions& options) {
  const std::filesystem::path out = options.out;
  ConsoleReporter console;
  const auto robot = PlaceRobot(options.robot, options.path);
  const experiment::Variation changes = experiment::ParseChanges(options.variation);
  const experiment::ImitationResult outcome = experiment::Imitate(
      {.task = std::filesystem::path(options.scene).stem().string(),
       .demonstration = options.demo,
       .analysis = options.plan,
       .scene = layout::LaidOut(
           scene_xml::LoadScene(options.scene, options.path.reader()), options.layout.choice(),
           [&](double height) { return experiment::RegionOf(robot.value(), height); }),
       .looks = changes.looks,
       .brain = options.brain.brain,
       .callback_seconds = options.brain.timeout,
       .is_attached = options.brain.attach,
       .record = out / "imitation",
       .has_pictures = !options.no_pictures,
       .max_seconds = options.max_seconds,
       .hold_seconds = options.hold,
       .is_verified = options.verify,
       .eye = EyeSpecOf(options.eye),
       .noise = ParseNoise(options.noise),
       .behavior = changes.behavior,
       .gives_poses = options.oracle,
       .disturbance = changes.disturbance,
       .robot = robot},
      console.callbacks());
  console.Clear();
  // The result is written even after an interrupt or an error of the program.
  WriteFile(out / "result.json", ToText(outcome.json, 2) + "\n");
  if (options.json) {
    std::printf("%s\n", ToText(outcome.json, 2).c_str());
  } else {
    PrintResult(outcome);
    std::printf("%s\n", (out / "result.json").c_str());
  }
  if (IsInterrupted()) throw std::runtime_error("interrupted; the recording so far is kept");
  if (!outcome.brain_error) return kDone;
  std::fprintf(stderr, "%s\n", ToString(*outcome.brain_error).c_str());
  return kInputWrong;
}

}  // namespace

void AddImitate(CLI::App* program, ExitAnswer answer) {
  auto options = std::make_shared<ImitateOptions>();
  CLI::App* imitate = program->add_subcommand(
      "imitate",
      "Run a brain that watches a recording and imitates it in a scene, and score the result");
  imitate->add_option("DEMO", options->demo, "directory of a recording")->required();
  imitate->add_option("SCENE", options->scene, "scene file in which the robot imitates")
      ->required();
  AddBrainOptions(imitate, &options->brain)->required();
  imitate->add_option("--out", options->out, "directory for imitation/ and result.json")
      ->required();
  imitate->add_option("--seconds", options->max_seconds, "time limit in seconds of simulated time")
      ->capture_default_str()
      ->check(NumberBetween(0.0, 86400.0));
  imitate
      ->add_option("--hold", options->hold,
                   "seconds that the result must stand after the end of the brain")
      ->capture_default_str()
      ->check(NumberBetween(0.0, 3600.0));
  imitate->add_flag("--verify", options->verify,
                    "replay the recording at the end: a success must replay to the last bit");
  AddLayoutOptions(imitate, &options->layout);
  imitate->add_flag("--no-pictures", options->no_pictures,
                    "recording without the robot's pictures");
  AddEyeOptions(imitate, &options->eye);
  AddNoiseOption(imitate, &options->noise);
  AddPlanOption(imitate, &options->plan);
  AddOracleOption(imitate, &options->oracle);
  imitate->add_option("--variation", options->variation,
                      "looks, behavior and disturbance of an attempt of `smile generate`, as JSON "
                      "(docs/generation.md)");
  imitate->add_flag("--json", options->json, "result.json on stdout");
  AddRobotOptions(imitate, /*may_be_absent=*/false, &options->robot);
  AddPathOption(imitate, &options->path);
  imitate->callback([options, answer] { *answer = ImitateDemo(*options); });
}

}  // namespace smile::app
