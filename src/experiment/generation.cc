// The disk is the only memory: an attempt is done when its folder says so. It runs in `running/`
// and moves from there, complete, to the episodes or the failures. An episode that failed is tried
// again after the first attempts at all others.

#include "experiment/generation.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "base/diagnostic.h"
#include "base/files.h"
#include "base/version.h"
#include "base/wording.h"
#include "brain/brain_process.h"
#include "experiment/content_hash.h"
#include "experiment/folder_lock.h"
#include "experiment/imitation_runs.h"
#include "experiment/json_file.h"
#include "task/demonstrated_structure.h"
#include "task/imitation_result.h"

namespace smile::experiment {
namespace {

namespace fs = std::filesystem;

constexpr const char* kKeyFile = "generation.json";
constexpr const char* kRunning = "running";

Json RangeJson(const Range& range) { return {range.low, range.high}; }

/// Finds errors of the plan before any run.
void Check(const GenerationPlan& plan, const task::Structure& structure) {
  if (plan.count < 1 || plan.count > kMaxEpisodes || plan.tries < 1) {
    throw std::invalid_argument("generation: no episode is wanted, or more than " +
                                std::to_string(kMaxEpisodes));
  }
  const brain::BrainProcess checked(plan.brain);  // throws unless it is a brain
  for (const GenerationScene& scene : plan.scenes) {
    task::RequireSomethingToDo(structure, scene.spec);
  }
}

/// Returns everything that attempts depend on.
Json KeyOf(const GenerationPlan& plan) {
  Json scenes = Json::array();
  for (const GenerationScene& scene : plan.scenes) {
    scenes.push_back({{"name", scene.name}, {"content", ContentOf(scene.spec)}});
  }
  return {{"format", 1},
          {"program", ProgramName()},
          {"build", ContentOf(plan.program)},
          {"demo", ContentOf(plan.demonstration)},
          {"scenes", scenes},
          {"robot", ContentOf(plan.robot)},
          {"brain", {{"name", plan.brain}, {"content", ContentOfBrain(plan.brain)}}},
          {"levels", plan.choices.levels},
          {"eyes", plan.choices.eyes},
          {"noise",
           {{"joints", RangeJson(plan.choices.joints)},
            {"image", RangeJson(plan.choices.image)},
            {"depth", RangeJson(plan.choices.depth)}}},
          {"variation", ToJson(plan.choices)},
          {"options", plan.settings},
          {"first_seed", plan.first_seed},
          {"tries", plan.tries}};
}

/// Returns the names of members that differ, for a message.
std::string DifferingMembers(const Json& a, const Json& b) {
  std::string names;
  for (const auto& [name, value] : a.items()) {
    if (!b.contains(name) || b[name] != value) names += (names.empty() ? "" : ", ") + name;
  }
  return names.empty() ? "format" : names;
}

/// Checks that a folder is new, or belongs to the same generation.
void RequireSameGeneration(const fs::path& out, const Json& key, const Shard& shard) {
  const fs::path file = out / kKeyFile;
  if (!fs::exists(file)) {
    if (fs::is_empty(out)) return;
    throw InputError(
        {out.string(), 0, "", "is not empty and no generation, expected a new folder"});
  }
  const Json found = ReadJsonFile(file);
  if (found != key) {
    throw InputError({out.string(), 0, "",
                      "contains a generation that differs in " + DifferingMembers(key, found) +
                          ", expected the same or a new folder"});
  }
  const std::optional<ShardMark> mark = ReadMark(out);
  const Shard found_shard = mark ? mark->shard : Shard();
  if (found_shard != shard) {
    throw InputError({out.string(), 0, "",
                      "contains shard " + ToString(found_shard) + ", expected " + ToString(shard) +
                          " or a new folder"});
  }
}

class Generator {
 public:
  Generator(const GenerationPlan& plan, const GenerationCallbacks& callbacks)
      : plan_(plan),
        callbacks_(callbacks),
        structure_(task::StructureOf(recording::OpenRecording(plan.demonstration))) {
    // An invalid plan leaves no folder.
    Check(plan, structure_);
    const Json key = KeyOf(plan);
    lock_.emplace(plan.out, "generation");
    RequireSameGeneration(plan.out, key, plan.shard);
    for (std::size_t episode = 0; episode < plan.count; ++episode) {
      if (plan.shard.Contains(episode)) missing_.push_back(episode);
    }
    if (missing_.empty()) {
      throw InputError({plan.out.string(), 0, "",
                        "shard " + ToString(plan.shard) + " has nothing to do: there are only " +
                            std::to_string(plan.count) + " episodes"});
    }
    status_.wanted = missing_.size();
    RequireNoOthers();
    WriteFile(plan.out / kKeyFile, ToText(key, 2) + "\n");
    WriteMark({.kind = "generation", .shard = plan.shard, .whole = {{"count", plan.count}}},
              plan.out);
  }

  GenerationSummary Run() {
    for (std::size_t number = 1; number <= plan_.tries && !missing_.empty(); ++number) {
      TryAll(number);
    }
    Remove(plan_.out / kRunning);
    const GenerationSummary summary = SummaryOf(ended_, status_.wanted);
    WriteManifest(ended_, summary, plan_.out);
    return summary;
  }

 private:
  Attempt AttemptAt(std::size_t episode, std::size_t number) const {
    const std::uint64_t seed = plan_.first_seed + episode + (number - 1) * kSeedsBetweenTries;
    return {.episode = episode,
            .number = number,
            .seed = seed,
            .variation = DrawVariation(plan_.choices, seed)};
  }

  /// Checks that the folder contains no attempts beside those of this plan, as after one for more
  /// episodes: they would belong to none.
  void RequireNoOthers() const {
    std::set<std::string> known;
    for (const std::size_t episode : missing_) {
      for (std::size_t number = 1; number <= plan_.tries; ++number) {
        known.insert(FolderNameOf(AttemptAt(episode, number).seed));
      }
    }
    for (const char* kind : {"episodes", "failures"}) {
      if (!fs::exists(plan_.out / kind)) continue;
      for (const fs::directory_entry& entry : fs::directory_iterator(plan_.out / kind)) {
        if (known.contains(entry.path().filename().string())) continue;
        throw InputError({entry.path().string(), 0, "",
                          "belongs to none of the " + std::to_string(plan_.count) +
                              " episodes, expected a larger count or a new folder"});
      }
    }
  }

  /// Makes the attempts of this number at all episodes that are still missing.
  void TryAll(std::size_t number) {
    std::vector<Attempt> open;
    std::vector<std::size_t> failed;
    for (const std::size_t episode : missing_) {
      const Attempt attempt = AttemptAt(episode, number);
      if (const auto found = FindAttempt(attempt, plan_.out)) {
        Count(*found, &failed);
      } else if (const auto reason = ReasonOfImpossibility(attempt)) {
        Count({.attempt = attempt,
               .outcome = Outcome::kImpossible,
               .cause = task::FailureReason{"impossible", *reason}},
              &failed);
      } else {
        open.push_back(attempt);
      }
      RequireNotCancelled();
    }
    RunAttempts(open, &failed);
    missing_ = failed;
    std::ranges::sort(missing_);
  }

  std::vector<ImitationRun> RunsOf(const std::vector<Attempt>& attempts) const {
    std::vector<ImitationRun> runs;
    for (const Attempt& attempt : attempts) {
      const fs::path folder = plan_.out / kRunning / FolderNameOf(attempt.seed);
      runs.push_back(
          {.seed = attempt.seed, .folder = folder, .arguments = plan_.arguments(attempt, folder)});
    }
    return runs;
  }

  void RunAttempts(const std::vector<Attempt>& open, std::vector<std::size_t>* failed) {
    const std::vector<ImitationRun> runs = RunsOf(open);
    std::set<std::size_t> with_result;
    const auto on_end = [&](std::size_t index, report::EvaluatedRun run) {
      clock_.Count();
      const EndedAttempt ended =
          Keep(open[index], run, runs[index].folder, with_result.contains(index));
      if (ended.cause && callbacks_.on_failure) callbacks_.on_failure(ended);
      Count(ended, failed);
    };
    const bool is_done = RunImitations(
        runs, {.program = plan_.program, .jobs = plan_.jobs, .wall_seconds = plan_.wall_seconds},
        {.on_start =
             [&](std::size_t index) {
               // Remains of a run that was interrupted.
               Remove(runs[index].folder);
               MakeDirectories(runs[index].folder);
             },
         .read =
             [&](std::size_t index) {
               auto run = report::ReadRun(runs[index].folder / "result.json", open[index].seed);
               with_result.insert(index);
               return run;
             },
         .on_end = on_end,
         .on_wait = [&] { ReportStatus(); },
         .is_cancelled = [&] { return callbacks_.common.IsCancelled(); }});
    if (!is_done) ThrowInterrupted();
  }

  /// Moves what a run left to its place among the episodes or the failures.
  EndedAttempt Keep(const Attempt& attempt, const report::EvaluatedRun& run, const fs::path& folder,
                    bool has_result) const {
    EndedAttempt ended{.attempt = attempt,
                       .outcome = run.has_succeeded ? Outcome::kSuccess : Outcome::kFailure,
                       .cause = run.failure_reason,
                       .score = run.score,
                       .seconds = run.seconds};
    const fs::path result_file = folder / "result.json";
    if (has_result) {
      Json result = ReadJsonFile(result_file);
      if (result.contains("replay")) ended.state_hash = result["replay"].value("hash", "");
      // Depends on the machine; without it, equal attempts have equal bytes.
      result.erase("realtime_factor");
      WriteFile(result_file, ToText(result, 2) + "\n");
      // The output of a run without a result is all that there is; otherwise `brain.log` is in the
      // recording.
      Remove(folder / "log.txt");
    } else {
      Remove(result_file);
    }
    ended.has_recording = fs::exists(folder / "imitation");
    if (ended.has_recording) ended.recording_hash = ContentOf(folder / "imitation");
    if (fs::exists(result_file)) ended.result_hash = ContentOf(result_file);
    WriteFile(folder / "attempt.json", ToText(ToJson(ended)) + "\n");
    const fs::path place = plan_.out / ended.folder();
    MakeDirectories(place.parent_path());
    // Damaged remains, of either outcome.
    for (const Outcome outcome : {Outcome::kSuccess, Outcome::kFailure}) {
      Remove(plan_.out / EndedAttempt{.attempt = attempt, .outcome = outcome}.folder());
    }
    std::error_code error;
    fs::rename(folder, place, error);
    if (error) throw std::runtime_error(place.string() + ": cannot be made: " + error.message());
    return ended;
  }

  void Count(const EndedAttempt& ended, std::vector<std::size_t>* failed) {
    if (ended.outcome != Outcome::kImpossible) ++status_.attempts;
    if (ended.outcome == Outcome::kSuccess) {
      ++status_.episodes;
    } else {
      failed->push_back(ended.attempt.episode);
    }
    ended_.push_back(ended);
  }

  /// Lays out the scene: without a layout, or with everything done already, an attempt says nothing
  /// about the brain.
  std::optional<std::string> ReasonOfImpossibility(const Attempt& attempt) const {
    try {
      if (plan_.layout) task::RequireSomethingToDo(structure_, plan_.layout(attempt));
    } catch (const std::invalid_argument& error) {
      return error.what();
    } catch (const InputError& error) {
      return error.what();
    }
    return std::nullopt;
  }

  void ReportStatus() {
    if (!callbacks_.on_status) return;
    const auto missing = static_cast<double>(status_.wanted - status_.episodes);
    // Each missing episode takes as many attempts as those before.
    const double rate = status_.attempts == 0 ? 1
                                              : static_cast<double>(status_.episodes) /
                                                    static_cast<double>(status_.attempts);
    if (rate > 0) status_.seconds_left = clock_.SecondsFor(missing / rate);
    if (const auto seconds = clock_.SecondsFor(1)) status_.attempts_per_hour = 3600 / *seconds;
    callbacks_.on_status(status_);
  }

  void RequireNotCancelled() const {
    if (callbacks_.common.IsCancelled()) ThrowInterrupted();
  }
  [[noreturn]] void ThrowInterrupted() const {
    throw std::runtime_error("interrupted; " + std::to_string(status_.episodes) + " of " +
                             std::to_string(status_.wanted) +
                             " episodes are made and kept; the same command continues");
  }

  /// Deletes a file or folder; one that does not exist is fine.
  static void Remove(const fs::path& path) {
    std::error_code error;
    fs::remove_all(path, error);
    if (error) throw std::runtime_error(path.string() + ": cannot be deleted: " + error.message());
  }

  const GenerationPlan& plan_;
  const GenerationCallbacks& callbacks_;
  task::Structure structure_;
  std::optional<FolderLock> lock_;
  std::vector<std::size_t> missing_;  ///< episodes
  std::vector<EndedAttempt> ended_;
  GenerationStatus status_;
  RunClock clock_;
};

}  // namespace

GenerationSummary Generate(const GenerationPlan& plan, const GenerationCallbacks& callbacks) {
  return Generator(plan, callbacks).Run();
}

}  // namespace smile::experiment
