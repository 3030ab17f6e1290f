// Runs all pairs of brain (with a version of the demonstration) and seed, each in a process of its
// own: a crash, a leak or a hang costs one run. The disk is the only memory: a run is done when its
// folder says so, hence an evaluation can be interrupted at any time and continued by the same
// command.

#include "experiment/evaluation.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <map>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>

#include "base/diagnostic.h"
#include "base/files.h"
#include "base/version.h"
#include "base/wording.h"
#include "brain/brain_process.h"
#include "experiment/content_hash.h"
#include "experiment/folder_lock.h"
#include "experiment/program_pool.h"
#include "experiment/rerender.h"
#include "report/evaluation_page.h"
#include "task/demonstrated_structure.h"
#include "task/imitation_result.h"

namespace smile::experiment {
namespace {

constexpr std::size_t kMaxNameLetters = 40;
constexpr int kRunsFormat = 2;  ///< of brain.json and run.json

/// Returns what a name of a brain is made of.
std::string StemOf(const std::string& brain) {
  // Of an address all but its beginning, whose letters say nothing.
  if (brain::IsServedBrain(brain))
    return brain.substr(brain.find_first_not_of('/', brain.find(':') + 1));
  const auto path = std::filesystem::absolute(brain).lexically_normal();
  return (path.has_filename() ? path.filename() : path.parent_path().filename()).stem().string();
}

/// Short unique names of brains, suitable as names of folders.
std::vector<std::string> NamesOf(const std::vector<std::string>& brains) {
  constexpr std::string_view kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
  std::vector<std::string> names;
  // Names become folders beside this one.
  std::set<std::string> taken{kDemonstratorsFolder};
  for (const std::string& brain : brains) {
    std::string name = StemOf(brain).substr(0, kMaxNameLetters);
    for (char& letter : name) {
      if (kPlain.find(letter) == std::string_view::npos) letter = '_';
    }
    std::string unique = name;
    for (int i = 2; !taken.insert(unique).second; ++i) unique = name + "-" + std::to_string(i);
    names.push_back(unique);
  }
  return names;
}

/// Finds errors of the plan before any run.
/// @returns everything the results of a brain depend on, except the program and the seed.
Json CheckAndDescribe(const EvaluationPlan& plan) {
  // Called for their exceptions: the same checks happen in each run, but here before the first one,
  // in seconds instead of hours.
  task::MakeImitationTask("", recording::OpenRecording(plan.demonstration), plan.scene);
  for (const std::string& brain : plan.brains) brain::BrainProcess{brain};
  return {{"format", kRunsFormat},
          {"program", ProgramName()},
          {"build", ContentOf(plan.program)},
          {"demo", ContentOf(plan.demonstration)},
          {"scene", ContentOf(plan.scene)},
          {"robot", ContentOf(plan.robot)},
          {"level", plan.level},
          {"options", plan.settings}};
}

/// Seeds of an evaluation: those that are run, and those left out.
struct Seeds {
  std::vector<std::uint64_t> possible;
  std::vector<report::ImpossibleLayout> impossible;
};

/// Lays out the scene for each seed. A layout that is not possible, or in which everything is done
/// already, says nothing about a brain and would be a failure in every run.
/// @throws InputError if none is possible.
Seeds SeedsOf(const EvaluationPlan& plan, const Callbacks& callbacks) {
  const task::Structure structure = task::StructureOf(recording::OpenRecording(plan.demonstration));
  Seeds seeds;
  for (std::uint64_t seed = plan.first_seed; seed < plan.first_seed + plan.num_scenes; ++seed) {
    std::string reason;
    try {
      if (plan.layout) task::RequireSomethingToDo(structure, plan.layout(seed));
    } catch (const std::invalid_argument& error) {
      reason = error.what();
    } catch (const InputError& error) {
      reason = error.what();
    }
    if (reason.empty()) {
      seeds.possible.push_back(seed);
    } else {
      callbacks.Say("seed " + std::to_string(seed) + " is left out: " + reason);
      seeds.impossible.push_back({seed, reason});
    }
  }
  if (seeds.possible.empty()) {
    throw InputError({plan.scene_name, 0, "",
                      "no layout is possible of " + std::to_string(plan.num_scenes) + ": " +
                          seeds.impossible.front().reason});
  }
  return seeds;
}

/// Demonstration with one of the demonstrators.
struct Showing {
  std::string demonstrator;  ///< empty: as recorded
  std::filesystem::path demonstration;
};

/// @param depends_on  see CheckAndDescribe().
std::vector<Showing> ShowingsOf(const EvaluationPlan& plan, const Json& depends_on,
                                const Callbacks& callbacks) {
  if (plan.demonstrators.empty()) return {{"", plan.demonstration}};
  const DemonstratorCopies copies{.demonstration = plan.demonstration,
                                  .demonstrators = plan.demonstrators,
                                  .has_symbols = plan.has_symbols,
                                  // Less than for runs: a copy depends on neither scene nor robot
                                  // of the imitation.
                                  .depends_on = {{"build", depends_on["build"]},
                                                 {"demo", depends_on["demo"]},
                                                 {"symbols", plan.has_symbols}}};
  const auto paths = MakeCopies(copies, plan.out / kDemonstratorsFolder, callbacks);
  std::vector<Showing> showings;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    showings.push_back({plan.demonstrators[i], paths[i]});
  }
  return showings;
}

/// Brain of an evaluation, with its version of the demonstration.
struct Candidate {
  std::string name, brain;
  Showing showing;
  EvaluationFolder folder;
  std::map<std::uint64_t, report::EvaluatedRun> runs;  ///< by seed
};

/// Run that is still to be done.
struct OpenRun {
  Candidate* candidate;
  std::uint64_t seed;
};

report::EvaluatedRun FailedRun(std::uint64_t seed, const PoolEnd& end, double wall_seconds) {
  report::EvaluatedRun run{.seed = seed};
  // `no_result` means that the program ended by itself but left no result, `crashed` that a signal
  // ended it.
  if (end.was_late) {
    run.failure_reason = {"hung",
                          "no end after " + NumberText(wall_seconds) + " s of wall-clock time"};
  } else {
    run.failure_reason = {end.exit_code ? "no_result" : "crashed", end.how};
  }
  if (!end.last_line.empty()) run.failure_reason->text += ": " + end.last_line;
  return run;
}

/// Counts runs and estimates the time that is left.
class StatusCounter {
 public:
  StatusCounter(std::size_t runs, const std::vector<Candidate>& candidates)
      : status_{.runs = runs} {
    for (const Candidate& candidate : candidates) {
      for (const auto& [seed, run] : candidate.runs) Count(run);
    }
    found_ = status_.done;
  }

  void Count(const report::EvaluatedRun& run) {
    ++status_.done;
    if (run.has_succeeded) ++status_.successes;
  }

  EvaluationStatus status() const {
    EvaluationStatus status = status_;
    // Runs that were found on disk took no time now and must not make the estimate too good.
    if (status.done > found_ && status.done < status.runs) {
      const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
      status.seconds_left = passed.count() / static_cast<double>(status.done - found_) *
                            static_cast<double>(status.runs - status.done);
    }
    return status;
  }

 private:
  EvaluationStatus status_;
  std::size_t found_ = 0;  ///< done before
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Runs an evaluation: finds finished runs on disk, runs the others in parallel processes, and
/// collects all results. Since every run is a process with its own seed and folder, results do not
/// depend on the order or number of jobs.
class Evaluator {
 public:
  Evaluator(const EvaluationPlan& plan, const EvaluationCallbacks& callbacks)
      : plan_(plan), callbacks_(callbacks) {
    // The order of these steps matters: an invalid plan leaves no folder, and a second evaluation
    // in the same folder stops before it moves results aside.
    const Json depends_on = CheckAndDescribe(plan);
    seeds_ = SeedsOf(plan, callbacks.common);
    // Locked before anything is written, but after the plan was checked.
    lock_.emplace(plan.out);
    const std::vector<Showing> showings = ShowingsOf(plan, depends_on, callbacks.common);
    const std::vector<std::string> names = NamesOf(plan.brains);
    for (std::size_t i = 0; i < names.size(); ++i) {
      for (const Showing& showing : showings) {
        AddCandidate(names[i], plan.brains[i], showing, depends_on);
      }
    }
  }

  void Run() {
    // The pool refers to jobs by their index, which is that of `open`.
    const std::vector<OpenRun> open = FindOpenRuns();
    std::vector<PoolJob> jobs;
    for (const OpenRun& run : open) jobs.push_back(JobOf(run));
    StatusCounter counter(num_runs(), candidates_);
    const auto end_run = [&](std::size_t job, const PoolEnd& end) {
      const report::EvaluatedRun& run = Take(open[job], end);
      counter.Count(run);
      if (run.failure_reason && callbacks_.on_failed_run) {
        callbacks_.on_failed_run(open[job].candidate->name, run);
      }
    };
    const bool is_done = RunAll(
        jobs, at_once(),
        {.on_start = [&](std::size_t job) { open[job].candidate->folder.BeginRun(open[job].seed); },
         .on_end = end_run,
         .on_wait =
             [&] {
               if (callbacks_.on_status) callbacks_.on_status(counter.status());
             },
         .is_cancelled = [&] { return callbacks_.common.IsCancelled(); }});
    if (is_done) return;
    throw std::runtime_error("interrupted; " + std::to_string(counter.status().done) + " of " +
                             std::to_string(num_runs()) +
                             " runs are done and kept; the same command continues with the others");
  }

  report::Evaluation Outcome() {
    report::Evaluation evaluation{.program = ProgramName(),
                                  .demo = plan_.demonstration.string(),
                                  .scene = plan_.scene_name,
                                  .level = plan_.level,
                                  .options = plan_.settings,
                                  .brains = {},
                                  .impossible = seeds_.impossible,
                                  .again = plan_.again};
    for (Candidate& candidate : candidates_) {
      report::EvaluatedBrain evaluated{.name = candidate.name,
                                       .brain = candidate.brain,
                                       .runs = {},
                                       .demonstrator = candidate.showing.demonstrator};
      // Runs that were found done may have been kept under another setting than this plan's.
      for (auto& [seed, run] : candidate.runs) {
        candidate.folder.Tidy(plan_.keep, plan_.out, &run);
        evaluated.runs.push_back(run);
      }
      evaluation.brains.push_back(std::move(evaluated));
    }
    return evaluation;
  }

 private:
  std::size_t num_runs() const { return candidates_.size() * seeds_.possible.size(); }
  std::size_t at_once() const {
    // hardware_concurrency() may return 0 where it does not know.
    return plan_.jobs > 0 ? plan_.jobs : std::max(1u, std::thread::hardware_concurrency());
  }

  void AddCandidate(std::string name, const std::string& brain, const Showing& showing,
                    Json depends_on) {
    // The folder of a candidate is valid only for exactly this brain and this copy; otherwise, it
    // moves aside.
    // What a server runs is not known here.
    depends_on["brain"] = brain::IsServedBrain(brain) ? brain : ContentOfBrain(brain);
    if (!showing.demonstrator.empty()) {
      name += "." + showing.demonstrator;  // no program has a name with a dot
      depends_on["demonstrator"] = showing.demonstrator;
      depends_on["symbols"] = plan_.has_symbols;
    }
    candidates_.push_back({name,
                           brain,
                           showing,
                           EvaluationFolder(plan_.out / name, depends_on, callbacks_.common),
                           {}});
  }

  /// Seed by seed, so that the finished runs of an interrupted evaluation can be compared.
  std::vector<OpenRun> FindOpenRuns() {
    std::vector<OpenRun> open;
    for (const std::uint64_t seed : seeds_.possible) {
      for (Candidate& candidate : candidates_) {
        if (auto run = candidate.folder.FindRun(seed)) {
          candidate.runs.emplace(seed, std::move(*run));
        } else {
          open.push_back({&candidate, seed});
        }
      }
    }
    return open;
  }

  PoolJob JobOf(const OpenRun& run) const {
    const Candidate& candidate = *run.candidate;
    PoolJob job{.command = {.arguments = {plan_.program.string()},
                            .environment = {},
                            .working_directory = std::filesystem::current_path()},
                .log = candidate.folder.LogOf(run.seed),
                .max_seconds = plan_.wall_seconds};
    const ImitationJob imitation{.demonstration = candidate.showing.demonstration,
                                 .brain = candidate.brain,
                                 .seed = run.seed,
                                 .out = candidate.folder.FolderOf(run.seed)};
    for (std::string& argument : plan_.arguments(imitation)) {
      job.command.arguments.push_back(std::move(argument));
    }
    // Software rendering shares cores badly: parallel processes are faster with one thread each.
    // The pictures are the same.
    if (at_once() > 1 && std::getenv("LP_NUM_THREADS") == nullptr) {
      job.command.environment.emplace_back("LP_NUM_THREADS", "0");
    }
    return job;
  }

  /// The result of a run. One without a result is a failure, too.
  const report::EvaluatedRun& Take(const OpenRun& open, const PoolEnd& end) {
    // Exit codes 0 and 1 mean that a result was written: success and failure of the imitation. A
    // late run may have written a result just before it was ended, but wall-clock time must not
    // decide whether it counts.
    const bool may_have_result = !end.was_late && (end.exit_code == 0 || end.exit_code == 1);
    report::EvaluatedRun run = FailedRun(open.seed, end, plan_.wall_seconds);
    if (may_have_result) {
      try {
        run = open.candidate->folder.CompleteRun(open.seed);
      } catch (const InputError&) {
        // The last line of its output gives the reason.
      }
    }
    open.candidate->folder.Tidy(plan_.keep, plan_.out, &run);
    return open.candidate->runs.emplace(open.seed, std::move(run)).first->second;
  }

  const EvaluationPlan& plan_;
  const EvaluationCallbacks& callbacks_;
  Seeds seeds_;
  std::optional<FolderLock> lock_;
  std::vector<Candidate> candidates_;
};

}  // namespace

report::Evaluation Evaluate(const EvaluationPlan& plan, const EvaluationCallbacks& callbacks) {
  Evaluator evaluator(plan, callbacks);
  evaluator.Run();
  report::Evaluation evaluation = evaluator.Outcome();
  // Both files are derived from the runs on disk and are written last.
  WriteFile(plan.out / "evaluation.json", ToText(report::ToJson(evaluation), 2) + "\n");
  WriteFile(plan.out / "report.html", report::PageOf(evaluation));
  return evaluation;
}

}  // namespace smile::experiment
