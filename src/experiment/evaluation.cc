// Runs all pairs of brain (with a version of the demonstration) and seed, each in a process of its
// own, see imitation_runs.h. The disk is the only memory: a run is done when its
// folder says so, hence an evaluation can be interrupted at any time and continued by the same
// command.

#include "experiment/evaluation.h"

#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include "base/diagnostic.h"
#include "base/files.h"
#include "base/version.h"
#include "brain/brain_process.h"
#include "experiment/content_hash.h"
#include "experiment/folder_lock.h"
#include "experiment/imitation_runs.h"
#include "experiment/plan_file.h"
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
  const recording::Recording demonstration = recording::OpenRecording(plan.demonstration);
  task::MakeImitationTask("", demonstration, plan.scene);
  for (const std::string& brain : plan.brains) brain::BrainProcess{brain};
  Json description = {{"format", kRunsFormat},
                      {"program", ProgramName()},
                      {"build", ContentOf(plan.program)},
                      {"demo", ContentOf(plan.demonstration)},
                      {"scene", ContentOf(plan.scene)},
                      {"robot", ContentOf(plan.robot)},
                      {"level", plan.level},
                      {"options", plan.settings}};
  if (!plan.analysis.empty()) {
    ReadPlan(plan.analysis, demonstration);
    description["plan"] = ContentOf(plan.analysis);
  }
  return description;
}

/// Seeds of an evaluation: those that are run, and those left out.
struct Seeds {
  std::vector<std::uint64_t> possible;
  std::vector<report::ImpossibleLayout> impossible;
};

/// Keeps the seeds of the plan's shard. All shards lay out all scenes, which is quick, so that they
/// agree on what is left out and share the rest evenly.
/// @throws InputError if none remains.
void KeepShard(const EvaluationPlan& plan, std::vector<std::uint64_t>* seeds) {
  std::vector<std::uint64_t> kept;
  for (std::size_t i = 0; i < seeds->size(); ++i) {
    if (plan.shard.Contains(i)) kept.push_back((*seeds)[i]);
  }
  if (kept.empty()) {
    throw InputError({plan.scene_name, 0, "",
                      "shard " + ToString(plan.shard) + " has nothing to do: there are only " +
                          std::to_string(seeds->size()) + " layouts"});
  }
  *seeds = std::move(kept);
}

/// Returns why no brain could show anything in a layout; empty if one could.
std::string ReasonOfImpossibility(const EvaluationPlan& plan, const task::Structure& structure,
                                  std::uint64_t seed) {
  try {
    if (plan.layout) task::RequireSomethingToDo(structure, plan.layout(seed));
  } catch (const std::invalid_argument& error) {
    return error.what();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// Lays out the scene for each seed. A layout that is not possible, or in which everything is done
/// already, says nothing about a brain and would be a failure in every run.
/// @throws InputError if none is possible.
Seeds SeedsOf(const EvaluationPlan& plan, const Callbacks& callbacks) {
  const task::Structure structure = task::StructureOf(recording::OpenRecording(plan.demonstration));
  Seeds seeds;
  for (std::uint64_t seed = plan.first_seed; seed < plan.first_seed + plan.num_scenes; ++seed) {
    const std::string reason = ReasonOfImpossibility(plan, structure, seed);
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

/// Counts runs and estimates the time that is left.
class StatusCounter {
 public:
  StatusCounter(std::size_t runs, const std::vector<Candidate>& candidates)
      : status_{.runs = runs} {
    for (const Candidate& candidate : candidates) {
      for (const auto& [seed, run] : candidate.runs) Add(run);
    }
  }

  void Count(const report::EvaluatedRun& run) {
    Add(run);
    clock_.Count();
  }

  EvaluationStatus status() const {
    EvaluationStatus status = status_;
    const std::size_t left = status.runs - status.done;
    if (left > 0) status.seconds_left = clock_.SecondsFor(static_cast<double>(left));
    return status;
  }

 private:
  void Add(const report::EvaluatedRun& run) {
    ++status_.done;
    if (run.has_succeeded) ++status_.successes;
  }

  EvaluationStatus status_;
  RunClock clock_;
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
    KeepShard(plan, &seeds_.possible);
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
    const std::vector<OpenRun> open = FindOpenRuns();
    std::vector<ImitationRun> runs;
    for (const OpenRun& run : open) runs.push_back(ImitationOf(run));
    StatusCounter counter(num_runs(), candidates_);
    const auto end_run = [&](std::size_t index, report::EvaluatedRun ended) {
      Candidate* candidate = open[index].candidate;
      candidate->folder.Tidy(plan_.keep, plan_.out, &ended);
      counter.Count(ended);
      if (ended.failure_reason && callbacks_.on_failed_run) {
        callbacks_.on_failed_run(candidate->name, ended);
      }
      candidate->runs.emplace(ended.seed, std::move(ended));
    };
    const bool is_done = RunImitations(
        runs, {.program = plan_.program, .jobs = plan_.jobs, .wall_seconds = plan_.wall_seconds},
        {.on_start =
             [&](std::size_t index) { open[index].candidate->folder.BeginRun(open[index].seed); },
         .read =
             [&](std::size_t index) {
               return open[index].candidate->folder.CompleteRun(open[index].seed);
             },
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

  ImitationRun ImitationOf(const OpenRun& run) const {
    const Candidate& candidate = *run.candidate;
    const std::filesystem::path folder = candidate.folder.FolderOf(run.seed);
    return {.seed = run.seed,
            .folder = folder,
            .arguments = plan_.arguments({.demonstration = candidate.showing.demonstration,
                                          .brain = candidate.brain,
                                          .seed = run.seed,
                                          .out = folder})};
  }

  const EvaluationPlan& plan_;
  const EvaluationCallbacks& callbacks_;
  Seeds seeds_;
  std::optional<FolderLock> lock_;
  std::vector<Candidate> candidates_;
};

}  // namespace

void WriteEvaluation(const report::Evaluation& evaluation, const std::filesystem::path& folder) {
  WriteFile(folder / "evaluation.json", ToText(report::ToJson(evaluation), 2) + "\n");
  WriteFile(folder / "report.html", report::PageOf(evaluation));
}

report::Evaluation Evaluate(const EvaluationPlan& plan, const EvaluationCallbacks& callbacks) {
  Evaluator evaluator(plan, callbacks);
  evaluator.Run();
  report::Evaluation evaluation = evaluator.Outcome();
  // These files are derived from the runs on disk and are written last.
  WriteEvaluation(evaluation, plan.out);
  WriteMark({.kind = "evaluation",
             .shard = plan.shard,
             .whole = {{"first_seed", plan.first_seed},
                       {"scenes", plan.num_scenes},
                       {"keep", static_cast<int>(plan.keep)},
                       {"again", plan.again}}},
            plan.out);
  return evaluation;
}

}  // namespace smile::experiment
