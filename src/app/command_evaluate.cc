// `smile evaluate`: robot programs do the same task from the same random starting layouts.

#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <thread>

#include "app/commands.h"
#include "app/content_hash.h"
#include "app/dress.h"
#include "app/evaluation_folder.h"
#include "app/exit_code.h"
#include "app/folder_lock.h"
#include "app/interrupt.h"
#include "app/open_recording.h"
#include "app/options.h"
#include "app/program_pool.h"
#include "app/progress.h"
#include "base/diagnostic.h"
#include "base/files.h"
#include "base/version.h"
#include "base/wording.h"
#include "brain/brain_process.h"
#include "layout/layout_level.h"
#include "report/evaluation.h"
#include "report/evaluation_page.h"
#include "scene_xml/scene_reader.h"
#include "task/imitation_result.h"

namespace smile::app {
namespace {

constexpr std::uint64_t kMaxSeed = std::uint64_t{1} << 53;
constexpr std::size_t kMaxScenes = 100'000, kMaxJobs = 1024;
constexpr std::size_t kMaxNameLetters = 40;
constexpr int kRunsFormat = 1;  ///< of what agent.json and run.json say
constexpr const char* kDemonstratorsFolder = "demonstrators";  ///< with dressed copies
constexpr const char* kThisProgram = "/proc/self/exe";

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

const std::map<std::string, Keep> kKeepWords{
    {"all", Keep::kAll}, {"failures", Keep::kFailures}, {"none", Keep::kNone}};

/// What `smile imitate` is told besides what has a name of its own in an evaluation.
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

/// What to type to see a run again, with pictures.
std::string AgainText(const EvaluateOptions& options, const std::filesystem::path& out) {
  const std::string demo = options.demonstrators.empty()
                               ? options.demo
                               : (out / kDemonstratorsFolder / "DEMONSTRATOR").string();
  std::string line = "smile";
  for (const std::string& word : ImitateArguments(options, demo, "BRAIN", "SEED", "out/again")) {
    line += " " + ShellWord(word);
  }
  return line;
}

/// Short names of robot programs, each another, that are fit for folders.
std::vector<std::string> NamesOf(const std::vector<std::string>& brains) {
  constexpr std::string_view kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
  std::vector<std::string> names;
  std::set<std::string> taken{kDemonstratorsFolder};
  for (const std::string& brain : brains) {
    const auto path = std::filesystem::absolute(brain).lexically_normal();
    const auto file = path.has_filename() ? path.filename() : path.parent_path().filename();
    std::string name = file.stem().string().substr(0, kMaxNameLetters);
    for (char& letter : name) {
      if (kPlain.find(letter) == std::string_view::npos) letter = '_';
    }
    std::string unique = name;
    for (int i = 2; !taken.insert(unique).second; ++i) unique = name + "-" + std::to_string(i);
    names.push_back(unique);
  }
  return names;
}

/// Says what is wrong with the whole before any run is begun.
/// @returns what the results of a robot program depend on, but for the program itself and the seed.
Json CheckAndDescribe(const EvaluateOptions& options) {
  const record::Recording demonstration = OpenAndTell(options.demo);
  const scene::SceneSpec scene = scene_xml::LoadScene(options.scene, options.path.reader());
  task::MakeExercise("", demonstration, scene);
  EyeSpecOf(options.eye);
  ParseNoise(options.noise);
  const auto robot = PlaceRobot(options.robot, options.path);
  for (const std::string& brain : options.brains) brain::BrainProcess{brain};
  return {{"format", kRunsFormat},
          {"program", ProgramName()},
          {"build", ContentOf(std::filesystem::path(kThisProgram))},
          {"demo", ContentOf(std::filesystem::path(options.demo))},
          {"scene", ContentOf(scene)},
          {"robot", ContentOf(robot->files)},
          {"level", options.level},
          {"options", OtherArguments(options)}};
}

/// How the demonstration is shown.
struct Showing {
  std::string demonstrator;  ///< empty: as it was recorded
  std::string demo;
};

/// A copy of the demonstration for each demonstrator that is wanted; if none is, itself.
/// @param depends_on  see CheckAndDescribe().
std::vector<Showing> ShowingsOf(const EvaluateOptions& options, const std::filesystem::path& out,
                                const Json& depends_on) {
  if (options.demonstrators.empty()) return {{"", options.demo}};
  const Json source{{"build", depends_on["build"]},
                    {"demo", depends_on["demo"]},
                    {"symbols", !options.no_symbols}};
  const auto copies = DressAll(options.demo, options.demonstrators, !options.no_symbols,
                               out / kDemonstratorsFolder, source);
  std::vector<Showing> showings;
  for (std::size_t i = 0; i < copies.size(); ++i) {
    showings.push_back({options.demonstrators[i], copies[i].string()});
  }
  return showings;
}

/// One robot program of an evaluation, and what it watches.
struct Agent {
  std::string name, brain;
  Showing showing;
  AgentFolder folder;
  std::map<std::uint64_t, report::EvaluatedRun> runs;
};

/// A run that still has to be done.
struct OpenRun {
  Agent* agent;
  std::uint64_t seed;
};

report::EvaluatedRun FailedRun(std::uint64_t seed, const PoolEnd& end, double wall_seconds) {
  report::EvaluatedRun run{.seed = seed};
  if (end.was_late) {
    run.cause = {"hung",
                 "no end after " + NumberText(wall_seconds) + " s by the clock on the wall"};
  } else {
    run.cause = {end.exit_code ? "no_result" : "crashed", end.how};
  }
  if (!end.last_line.empty()) run.cause->text += ": " + end.last_line;
  return run;
}

/// Tells how far it is.
class EvaluationProgress {
 public:
  EvaluationProgress(std::size_t all, const std::vector<Agent>& agents) : all_(all) {
    for (const Agent& agent : agents) {
      for (const auto& [seed, run] : agent.runs) Count(run);
    }
    found_ = done_;
  }

  void Add(const std::string& agent, const report::EvaluatedRun& run) {
    Count(run);
    if (!run.cause) return;
    line_.Wipe();
    std::fprintf(stderr, "%s, seed %llu: %s: %s\n", agent.c_str(),
                 static_cast<unsigned long long>(run.seed), Printable(run.cause->word).c_str(),
                 Printable(run.cause->text).c_str());
  }

  void Show() {
    std::string words = std::to_string(done_) + " of " + std::to_string(all_) + " runs, " +
                        std::to_string(rebuilt_) + " rebuilt, " + std::to_string(done_ - rebuilt_) +
                        " failed";
    if (done_ > found_ && done_ < all_) words += ", " + TimeLeft();
    line_.Say(words);
  }

 private:
  void Count(const report::EvaluatedRun& run) {
    ++done_;
    if (run.is_rebuilt) ++rebuilt_;
  }
  std::string TimeLeft() const {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
    const double seconds =
        passed.count() / static_cast<double>(done_ - found_) * static_cast<double>(all_ - done_);
    const bool is_long = seconds >= 90;
    return "about " + NumberText(std::ceil(is_long ? seconds / 60 : seconds)) +
           (is_long ? " min" : " s") + " left";
  }

  std::size_t all_, done_ = 0, found_ = 0, rebuilt_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  ProgressLine line_{"evaluating"};
};

std::size_t NumCores() { return std::max(1u, std::thread::hardware_concurrency()); }

/// Does what is to be done.
/// @throws std::runtime_error when the user does not want to wait for it.
class Evaluator {
 public:
  Evaluator(const EvaluateOptions& options, const std::filesystem::path& out)
      : options_(options), out_(out), keep_(kKeepWords.at(options.keep)) {
    const Json depends_on = CheckAndDescribe(options);
    lock_.emplace(out_);
    const std::vector<Showing> showings = ShowingsOf(options, out, depends_on);
    const std::vector<std::string> names = NamesOf(options.brains);
    for (std::size_t i = 0; i < names.size(); ++i) {
      for (const Showing& showing : showings) {
        AddAgent(names[i], options.brains[i], showing, depends_on);
      }
    }
  }

  void Run() {
    const std::vector<OpenRun> open = FindOpenRuns();
    std::vector<PoolJob> jobs;
    for (const OpenRun& run : open) jobs.push_back(JobOf(run));
    EvaluationProgress progress(agents_.size() * options_.scenes, agents_);
    const bool is_done = RunAll(
        jobs, at_once(),
        {.on_start = [&](std::size_t job) { open[job].agent->folder.BeginRun(open[job].seed); },
         .on_end =
             [&](std::size_t job, const PoolEnd& end) {
               progress.Add(open[job].agent->name, Take(open[job], end));
             },
         .on_wait = [&] { progress.Show(); },
         .is_cancelled = &IsInterrupted});
    if (is_done) return;
    throw std::runtime_error("interrupted; " + std::to_string(NumDone()) + " of " +
                             std::to_string(agents_.size() * options_.scenes) +
                             " runs are done and kept: the same command goes on with the others");
  }

  report::Evaluation Outcome() {
    report::Evaluation evaluation{.program = ProgramName(),
                                  .demo = options_.demo,
                                  .scene = options_.scene,
                                  .level = options_.level,
                                  .ways = OtherArguments(options_),
                                  .agents = {},
                                  .again = AgainText(options_, out_)};
    for (Agent& agent : agents_) {
      report::EvaluatedAgent evaluated{.name = agent.name,
                                       .brain = agent.brain,
                                       .runs = {},
                                       .demonstrator = agent.showing.demonstrator};
      for (auto& [seed, run] : agent.runs) {
        agent.folder.Tidy(keep_, out_, &run);
        evaluated.runs.push_back(run);
      }
      evaluation.agents.push_back(std::move(evaluated));
    }
    return evaluation;
  }

 private:
  std::size_t at_once() const { return options_.jobs > 0 ? options_.jobs : NumCores(); }

  void AddAgent(std::string name, const std::string& brain, const Showing& showing,
                Json depends_on) {
    depends_on["brain"] = ContentOfBrain(brain);
    if (!showing.demonstrator.empty()) {
      name += "." + showing.demonstrator;  // no program has a name with a dot
      depends_on["demonstrator"] = showing.demonstrator;
      depends_on["symbols"] = !options_.no_symbols;
    }
    agents_.push_back({name, brain, showing, AgentFolder(out_ / name, depends_on), {}});
  }

  /// Seed by seed, so that what is done when somebody interrupts can be compared.
  std::vector<OpenRun> FindOpenRuns() {
    std::vector<OpenRun> open;
    for (std::uint64_t seed = options_.seed; seed < options_.seed + options_.scenes; ++seed) {
      for (Agent& agent : agents_) {
        if (auto run = agent.folder.FindRun(seed)) {
          agent.runs.emplace(seed, std::move(*run));
        } else {
          open.push_back({&agent, seed});
        }
      }
    }
    return open;
  }

  PoolJob JobOf(const OpenRun& run) const {
    PoolJob job{.command = {.arguments = {std::filesystem::read_symlink(kThisProgram).string()},
                            .environment = {},
                            .working_directory = std::filesystem::current_path()},
                .log = run.agent->folder.LogOf(run.seed),
                .max_seconds = options_.wall_seconds};
    for (std::string& argument : ImitateArguments(options_, run.agent->showing.demo,
                                                  run.agent->brain, std::to_string(run.seed),
                                                  run.agent->folder.FolderOf(run.seed).string())) {
      job.command.arguments.push_back(std::move(argument));
    }
    job.command.arguments.emplace_back("--no-pictures");
    // Software that draws shares cores badly: processes beside one another do better with a thread
    // each. What it draws is the same.
    if (at_once() > 1 && std::getenv("LP_NUM_THREADS") == nullptr) {
      job.command.environment.emplace_back("LP_NUM_THREADS", "0");
    }
    return job;
  }

  /// What came of a run. One that failed to tell is a failure, too.
  const report::EvaluatedRun& Take(const OpenRun& open, const PoolEnd& end) {
    const bool may_have_result =
        !end.was_late && (end.exit_code == kDone || end.exit_code == kInputWrong);
    report::EvaluatedRun run = FailedRun(open.seed, end, options_.wall_seconds);
    if (may_have_result) {
      try {
        run = open.agent->folder.CompleteRun(open.seed);
      } catch (const InputError&) {
        // It says why on its last line.
      }
    }
    open.agent->folder.Tidy(keep_, out_, &run);
    return open.agent->runs.emplace(open.seed, std::move(run)).first->second;
  }

  std::size_t NumDone() const {
    std::size_t count = 0;
    for (const Agent& agent : agents_) count += agent.runs.size();
    return count;
  }

  const EvaluateOptions& options_;
  std::filesystem::path out_;
  std::optional<FolderLock> lock_;
  Keep keep_;
  std::vector<Agent> agents_;
};

int Evaluate(const EvaluateOptions& options) {
  const std::filesystem::path out =
      options.out.empty()
          ? std::filesystem::path("out/evaluate") / std::filesystem::path(options.scene).stem()
          : std::filesystem::path(options.out);
  RequireOutsideOfRecordings(out.string());
  if (std::set<std::string>(options.demonstrators.begin(), options.demonstrators.end()).size() <
      options.demonstrators.size()) {
    throw std::invalid_argument("--demonstrators names one of them twice");
  }
  Evaluator evaluator(options, out);
  evaluator.Run();
  const report::Evaluation evaluation = evaluator.Outcome();
  const std::string json = ToText(ToJson(evaluation), 2) + "\n";
  WriteFile(out / "evaluation.json", json);
  WriteFile(out / "report.html", report::PageOf(evaluation));
  if (options.json) {
    std::printf("%s", json.c_str());
  } else {
    std::printf("%s\n%s\n%s\n", report::ToText(evaluation).c_str(),
                (out / "evaluation.json").c_str(), (out / "report.html").c_str());
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
  evaluate->add_option("--brain", options->brains, "a robot program; repeated for each of several")
      ->required()
      ->check(NotEmpty())
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  CLI::Option* demonstrators =
      evaluate
          ->add_option("--demonstrators", options->demonstrators,
                       "who is seen in the pictures of the recording, to be compared: some of "
                       "invisible, ghost and forearm, with commas between them")
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
      ->check(CLI::IsMember(std::vector<std::string>(layout::kLayoutLevelWords.begin(),
                                                     layout::kLayoutLevelWords.end())));
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
