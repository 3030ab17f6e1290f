// `smile evaluate`: robot programs do the same task from the same random starting layouts.

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>

#include "app/commands.h"
#include "app/console_reporter.h"
#include "app/exit_code.h"
#include "app/layout_options.h"
#include "app/open_recording.h"
#include "app/options.h"
#include "base/wording.h"
#include "experiment/evaluation.h"
#include "scene_xml/scene_reader.h"

namespace smile::app {
namespace {

constexpr std::uint64_t kMaxSeed = std::uint64_t{1} << 53;
constexpr std::size_t kMaxScenes = 100'000, kMaxJobs = 1024;

struct EvaluateOptions {
  std::string demo, scene, level, out, keep = "failures";
  std::vector<std::string> brains, demonstrators;
  bool no_symbols = false;
  std::size_t scenes = 10, jobs = 0;
  std::uint64_t seed = 1;
  double max_seconds = 600, wall_seconds = 3600, patience = 60;
  EyeOptions eye;
  std::string noise;
  RobotOptions robot;
  PathOptions path;
  bool json = false;
};

const std::map<std::string, experiment::Keep> kKeepWords{{"all", experiment::Keep::kAll},
                                                         {"failures", experiment::Keep::kFailures},
                                                         {"none", experiment::Keep::kNone}};

/// Options that `smile imitate` is given for every run.
std::vector<std::string> OtherArguments(const EvaluateOptions& options) {
  std::vector<std::string> arguments{"--seconds", NumberText(options.max_seconds)};
  const auto add = [&arguments](const char* name, const std::string& value) {
    if (!value.empty()) arguments.insert(arguments.end(), {name, value});
  };
  const auto add_flag = [&arguments](const char* name, bool is_set) {
    if (is_set) arguments.emplace_back(name);
  };
  add("--patience", NumberText(options.patience));
  if (options.eye.camera != EyeOptions().camera) add("--eye", options.eye.camera);
  add("--size", options.eye.size);
  add("--noise", options.noise);
  add("--robot", options.robot.urdf);
  add("--side-file", options.robot.side_file);
  add("--gripper", options.robot.gripper);
  add_flag("--classic", options.robot.classic);
  add_flag("--kinematic", options.robot.body.is_kinematic);
  add_flag("--friction-grasp", options.robot.body.grasps_by_friction);
  for (const std::string& root : options.path.roots) add("--path", root);
  return arguments;
}

/// Arguments of `smile imitate` for a run.
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

/// A word of a line of shell.
std::string ShellWord(const std::string& word) {
  constexpr std::string_view kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._/=,:+";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string quoted = "'";
  for (char letter : word) quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return quoted + "'";
}

/// The command that repeats a run with pictures, for people.
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

std::string StatusText(const experiment::EvaluationStatus& status) {
  std::string text = std::to_string(status.done) + " of " + std::to_string(status.runs) +
                     " runs, " + std::to_string(status.rebuilt) + " rebuilt, " +
                     std::to_string(status.done - status.rebuilt) + " failed";
  if (status.seconds_left) {
    const bool is_long = *status.seconds_left >= 90;
    text += ", about " + NumberText(std::ceil(*status.seconds_left / (is_long ? 60 : 1))) +
            (is_long ? " min" : " s") + " left";
  }
  return text;
}

/// @throws InputError or std::invalid_argument if an option is wrong, before anything is written.
experiment::EvaluationPlan PlanOf(const EvaluateOptions& options) {
  const std::filesystem::path out =
      options.out.empty()
          ? std::filesystem::path("out/evaluate") / std::filesystem::path(options.scene).stem()
          : std::filesystem::path(options.out);
  RequireOutsideOfRecordings(out.string());
  if (std::set<std::string>(options.demonstrators.begin(), options.demonstrators.end()).size() <
      options.demonstrators.size()) {
    throw std::invalid_argument("--demonstrators names one of them twice");
  }
  OpenAndTell(options.demo);
  EyeSpecOf(options.eye);
  ParseNoise(options.noise);
  experiment::EvaluationPlan plan{
      .demonstration = options.demo,
      .scene_name = options.scene,
      .scene = scene_xml::LoadScene(options.scene, options.path.reader()),
      .level = options.level,
      .robot = PlaceRobot(options.robot, options.path)->files,
      .brains = options.brains,
      .demonstrators = options.demonstrators,
      .has_symbols = !options.no_symbols,
      .num_scenes = options.scenes,
      .first_seed = options.seed,
      .jobs = options.jobs,
      .wall_seconds = options.wall_seconds,
      .keep = kKeepWords.at(options.keep),
      .out = out,
      .program = std::filesystem::read_symlink("/proc/self/exe"),
      .settings = OtherArguments(options),
      .again = AgainText(options, out)};
  plan.arguments = [options](const experiment::ImitationJob& job) {
    std::vector<std::string> arguments =
        ImitateArguments(options, job.demonstration.string(), job.brain.string(),
                         std::to_string(job.seed), job.out.string());
    arguments.emplace_back("--no-pictures");
    return arguments;
  };
  return plan;
}

int Evaluate(const EvaluateOptions& options) {
  const experiment::EvaluationPlan plan = PlanOf(options);
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
                                Printable(run.cause->word).c_str(),
                                Printable(run.cause->text).c_str());
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
  CLI::App* evaluate = program->add_subcommand(
      "evaluate",
      "Robot programs imitate a recording from the same random starting layouts: how well each "
      "does, and how they compare");
  evaluate->add_option("DEMO", options->demo, "directory of a recording")->required();
  evaluate->add_option("--scene", options->scene, "scene file the robot has never seen")
      ->required()
      ->check(NotEmpty());
  Repeatable(evaluate->add_option("--brain", options->brains,
                                  "a robot program; repeated for each of several"))
      ->required()
      ->check(NotEmpty());
  CLI::Option* demonstrators =
      Repeatable(
          evaluate->add_option("--demonstrators", options->demonstrators,
                               "who is seen in the pictures of the recording, to be compared: "
                               "some of invisible, ghost and forearm, with commas between them"))
          ->delimiter(',')
          ->check(CLI::IsMember(std::vector<std::string>(record::kDemonstratorLooks.begin(),
                                                         record::kDemonstratorLooks.end())));
  evaluate
      ->add_flag("--no-symbols", options->no_symbols,
                 "with --demonstrators: without the texts of the classic view")
      ->needs(demonstrators);
  evaluate->add_option("--scenes", options->scenes, "how many starting layouts")
      ->capture_default_str()
      ->check(CLI::Range(std::size_t{1}, kMaxScenes));
  evaluate->add_option("--seed", options->seed, "of the first layout; the others follow")
      ->capture_default_str()
      ->check(CLI::Range(std::uint64_t{0}, kMaxSeed));
  evaluate->add_option("--level", options->level, "how hard the layouts are")
      ->check(IsLayoutLevel());
  evaluate
      ->add_option("--jobs", options->jobs,
                   "how many runs at once; as many as there are cores if not given")
      ->check(CLI::Range(std::size_t{1}, kMaxJobs));
  evaluate->add_option("--seconds", options->max_seconds, "simulated, at most, each run")
      ->capture_default_str()
      ->check(NumberBetween(0.0, 86400.0));
  evaluate
      ->add_option("--wall-seconds", options->wall_seconds,
                   "by the clock on the wall, at most, each run: then it counts as hung")
      ->capture_default_str()
      ->check(NumberBetween(0.1, 1e6));
  evaluate
      ->add_option("--patience", options->patience,
                   "as for `imitate`; more for more jobs than cores")
      ->capture_default_str()
      ->check(NumberBetween(0.01, 86400.0));
  evaluate->add_option("--out", options->out,
                       "directory for the results; out/evaluate/SCENE if not given");
  evaluate->add_option("--keep", options->keep, "which recordings stay: all, failures or none")
      ->capture_default_str()
      ->check(CLI::IsMember({"all", "failures", "none"}));
  evaluate->add_flag("--json", options->json, "print evaluation.json on stdout");
  AddEyeOptions(evaluate, &options->eye);
  AddNoiseOption(evaluate, &options->noise);
  AddRobotOptions(evaluate, /*may_be_absent=*/false, &options->robot);
  AddPathOption(evaluate, &options->path);
  evaluate->callback([options, answer] { *answer = Evaluate(*options); });
}

}  // namespace smile::app
