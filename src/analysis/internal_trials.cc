#include "analysis/internal_trials.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "editing/re_simulation.h"
#include "replay/log_player.h"
#include "task/comparison.h"
#include "task/demonstrated_structure.h"
#include "task/failure_reason.h"
#include "task/imitation_result.h"

namespace smile::analysis {

Trials::Trials(const recording::Recording& recording, const AnalysisOptions& options)
    : recording_(recording),
      options_(options),
      demonstration_(DemonstrationOf(recording)),
      subtasks_(SubtasksOf(recording)),
      demonstrated_(task::StructureOf(recording)),
      structure_(
          task::WithoutGoals(demonstrated_, options.ignored, demonstration_.meters_per_unit)) {}

std::vector<GoalFinding> Trials::goals() const {
  std::vector<GoalFinding> findings;
  for (task::Goal& goal : task::GoalsOf(demonstrated_, demonstration_.meters_per_unit)) {
    const bool counts = std::ranges::find(options_.ignored, goal.id) == options_.ignored.end();
    findings.push_back({std::move(goal), counts});
  }
  return findings;
}

std::vector<std::optional<std::string>> Trials::HarmsOf(const std::vector<SubtaskOrder>& orders) {
  std::vector<std::optional<std::string>> harms(orders.size());
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;  // of the next three
  std::condition_variable changed;
  std::size_t num_finished = 0;
  std::exception_ptr error;

  const auto work = [&] {
    for (std::size_t i = next++; i < orders.size(); i = next++) {
      std::exception_ptr problem;
      try {
        harms[i] = HarmOf(orders[i]);
      } catch (...) {
        problem = std::current_exception();
        next = orders.size();
      }
      const std::scoped_lock lock(mutex);
      if (problem) error = problem;
      ++num_finished;
      changed.notify_one();
    }
  };
  {
    std::vector<std::jthread> workers;
    for (std::size_t i = 0; i < std::min(options_.num_threads, orders.size()); ++i) {
      workers.emplace_back(work);
    }
    // The caller's thread reports; an interruption lets the workers finish what they began.
    for (std::size_t seen = 0; seen < orders.size();) {
      std::unique_lock lock(mutex);
      changed.wait(lock, [&] { return num_finished > seen || error; });
      if (error) break;
      seen = num_finished;
      lock.unlock();
      try {
        Report(num_done_ + seen);
      } catch (...) {
        next = orders.size();
        throw;
      }
    }
  }
  if (error) std::rethrow_exception(error);
  num_done_ += orders.size();
  return harms;
}

std::optional<std::string> Trials::HarmOf(const SubtaskOrder& order) const {
  const recording::Demonstration arranged = Arranged(demonstration_, subtasks_, order);
  sim::Simulation simulation(recording_.start_model);
  replay::LogPlayer player(arranged.Schedule(), arranged.start);
  editing::RunToStart(recording_, &player, &simulation);
  const task::EpisodeObserver observer(&simulation);
  const auto skipped = editing::RunFor(arranged.duration(), &player, &simulation);
  // Without a command that is refused, it is another demonstration, whatever it achieves.
  if (!skipped.empty()) {
    return "line " + std::to_string(skipped.front().line) +
           " of the log is refused: " + skipped.front().reason;
  }
  for (int i = 0; i < task::kRestSeconds * sim::kTicksPerSecond; ++i) simulation.Tick();
  const task::Episode episode = observer.episode();
  const auto reason = task::FailureReasonOf(structure_, episode, CompareWith(structure_, episode),
                                            {.status = "exited", .message = ""});
  return reason ? std::optional(reason->text) : std::nullopt;
}

void Trials::Report(std::size_t done) const {
  // The demonstration itself, without each subtask, the same with ever fewer subtasks, and all
  // pairs.
  const std::size_t at_most = 1 + subtasks_.size() * subtasks_.size();
  if (options_.progress && !options_.progress(done, at_most)) {
    throw std::runtime_error("interrupted");
  }
}

}  // namespace smile::analysis
