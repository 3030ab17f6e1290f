#include "analysis/internal_trials.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "analysis/analysis_json.h"
#include "base/version.h"
#include "editing/re_simulation.h"
#include "replay/log_player.h"
#include "task/comparison.h"
#include "task/demonstrated_structure.h"
#include "task/failure_reason.h"
#include "task/imitation_result.h"

namespace smile::analysis {

namespace {

/// Does several pieces of work at the same time.
/// @param do_one   called on any thread with a number from 0 on.
/// @param on_end   called with that number after it, by one thread at a time.
/// @param report   called on this thread with how many have ended; may throw to end the work: what
///                 has begun is finished.
void RunAll(std::size_t count, std::size_t num_threads,
            const std::function<void(std::size_t)>& do_one,
            const std::function<void(std::size_t)>& on_end,
            const std::function<void(std::size_t)>& report) {
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;  // of the next three
  std::condition_variable changed;
  std::size_t num_finished = 0;
  std::exception_ptr error;

  const auto work = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      std::exception_ptr problem;
      try {
        do_one(i);
        const std::scoped_lock lock(mutex);
        on_end(i);
      } catch (...) {
        problem = std::current_exception();
        next = count;
      }
      const std::scoped_lock lock(mutex);
      if (problem) error = problem;
      ++num_finished;
      changed.notify_one();
    }
  };
  {
    std::vector<std::jthread> workers;
    for (std::size_t i = 0; i < std::min(num_threads, count); ++i) workers.emplace_back(work);
    // The caller's thread reports; an interruption lets the workers finish what they began.
    for (std::size_t seen = 0; seen < count;) {
      std::unique_lock lock(mutex);
      changed.wait(lock, [&] { return num_finished > seen || error; });
      if (error) break;
      seen = num_finished;
      lock.unlock();
      try {
        report(seen);
      } catch (...) {
        next = count;
        throw;
      }
    }
  }
  if (error) std::rethrow_exception(error);
}

/// Gives an object its demonstrated color back: what it looks like was changed, not what is wanted.
void RestoreColor(const Repaint& repaint, const recording::Recording& recording,
                  scene::SceneSpec* scene) {
  const auto find = [&](auto& objects) {
    return std::ranges::find(objects, repaint.object, &scene::ObjectSpec::id);
  };
  find(scene->objects)->whole.color = find(recording.start_scene().objects)->whole.color;
}

/// Everything that results of trials depend on.
Json AboutTrials(const recording::Recording& recording, const AnalysisOptions& options) {
  return {{"format", kAnalysisFormat},
          {"program", ProgramName()},
          {"build", options.build},
          {"demonstration", ContentOf(recording)},
          {"ignored", options.ignored}};
}

TrialLog LogFor(const recording::Recording& recording, const AnalysisOptions& options) {
  if (options.progress_file.empty()) return {};
  return {options.progress_file, AboutTrials(recording, options), options.say};
}

}  // namespace

Trials::Trials(const recording::Recording& recording, const AnalysisOptions& options)
    : recording_(recording),
      options_(options),
      demonstration_(DemonstrationOf(recording)),
      subtasks_(SubtasksOf(recording)),
      demonstrated_(task::StructureOf(recording)),
      structure_(
          task::WithoutGoals(demonstrated_, options.ignored, demonstration_.meters_per_unit)),
      log_(LogFor(recording, options)) {}

std::vector<GoalFinding> Trials::goals() const {
  std::vector<GoalFinding> findings;
  for (task::Goal& goal : task::GoalsOf(demonstrated_, demonstration_.meters_per_unit)) {
    const bool counts = std::ranges::find(options_.ignored, goal.id) == options_.ignored.end();
    findings.push_back({std::move(goal), counts});
  }
  return findings;
}

std::vector<Harm> Trials::HarmsOf(const std::vector<SubtaskOrder>& orders) {
  std::vector<Trial> trials;
  trials.reserve(orders.size());
  for (const SubtaskOrder& order : orders) trials.push_back({.order = order});
  return HarmsOf(trials);
}

std::vector<Harm> Trials::HarmsOf(const std::vector<Trial>& trials) {
  std::vector<Harm> harms(trials.size());
  std::vector<std::size_t> unknown;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const auto known = log_.Find(KeyOf(trials[i]));
    if (known) {
      harms[i] = *known;
    } else {
      unknown.push_back(i);
    }
  }
  const std::size_t num_known = num_done_ + trials.size() - unknown.size();
  RunAll(
      unknown.size(), options_.num_threads,
      [&](std::size_t k) { harms[unknown[k]] = HarmOf(trials[unknown[k]]); },
      [&](std::size_t k) { log_.Add(KeyOf(trials[unknown[k]]), harms[unknown[k]]); },
      [&](std::size_t count) { Report(num_known + count); });
  num_done_ += trials.size();
  return harms;
}

Harm Trials::HarmOf(const Trial& trial) const {
  recording::Demonstration arranged = Arranged(demonstration_, subtasks_, trial.order);
  ShiftHands(trial.shift_mm, &arranged);
  sim::Simulation simulation(StartModelOf(trial, recording_));
  replay::LogPlayer player(arranged.Schedule(), arranged.start);
  editing::RunToStart(recording_, &player, &simulation);
  const task::EpisodeObserver observer(&simulation);
  const auto skipped = editing::RunFor(arranged.duration(), &player, &simulation);
  // Without a command that is refused, it is another demonstration, whatever it achieves.
  if (!skipped.empty()) {
    return texts::Say("analysis.isRefused",
                      {{"line", skipped.front().line}, {"reason", skipped.front().reason}});
  }
  for (int i = 0; i < task::kRestSeconds * sim::kTicksPerSecond; ++i) simulation.Tick();
  task::Episode episode = observer.episode();
  if (trial.repaint) RestoreColor(*trial.repaint, recording_, &episode.scene);
  const auto reason = task::FailureReasonOf(structure_, episode, CompareWith(structure_, episode),
                                            {.status = "exited", .message = ""});
  return reason ? Harm(reason->text) : std::nullopt;
}

void Trials::Report(std::size_t done) const {
  // The demonstration itself, without each subtask, the same with ever fewer subtasks, all pairs,
  // all colors, and four places.
  const std::size_t at_most =
      1 + subtasks_.size() * subtasks_.size() + structure_.objects.size() + 4;
  if (options_.progress && !options_.progress(done, at_most)) {
    throw std::runtime_error("interrupted");
  }
}

}  // namespace smile::analysis
