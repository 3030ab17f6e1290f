#include "recorder/internal_replay_along.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "base/diagnostic.h"

namespace smile::recorder {

void Fail(const recording::Recording& recording, const std::string& message) {
  throw InputError({recording.directory.string(), 0, "", message});
}

ReplayAlong::ReplayAlong(const recording::Recording& recording,
                         std::vector<recording::LoggedCommand> path,
                         const recording::HistoryPoint& until, sim::Simulation* simulation)
    : recording_(recording),
      path_(std::move(path)),
      until_(until),
      simulation_(simulation),
      player_(path_, recording.info.start),
      trace_(recording, until) {
  simulation_->AddListener(&collector_);
}

Reached ReplayAlong::Go(const recording::Progress& progress,
                        const std::function<void()>& on_start) {
  const auto on_tick = [&](std::uint64_t tick) {
    const bool does = !progress || progress(sim::SecondsOf(tick), sim::SecondsOf(until_.tick));
    if (!does) throw std::runtime_error("interrupted");
    return does;
  };
  // Without events the places of actions in the trace are unknown.
  if (!trace_.has_events()) Fail(recording_, "has an older format and cannot be continued");
  if (player_.RunToStart(simulation_, on_tick)) FailAsDifferent();
  collector_.Clear();
  if (on_start) on_start();
  while (Step()) on_tick(simulation_->tick());
  CheckEnd();
  const auto& events = collector_.events();
  const auto num_reported = static_cast<std::ptrdiff_t>(last_->events.size());
  return {trace_.places().back(), {events.begin() + num_reported, events.end()}};
}

void ReplayAlong::FailAsDifferent() const {
  Fail(recording_, "cannot be continued: its replay differs at tick " +
                       std::to_string(simulation_->tick()) + " (it was made by " +
                       recording_.info.program + ")");
}

bool ReplayAlong::Step() {
  auto moment = trace_.Next();
  if (!moment) return false;
  // Events of the tick before, which are complete now.
  if (last_ && last_->events != collector_.events()) FailAsDifferent();
  if (last_) simulation_->Tick();
  // The hash covers everything that determines the future, so the continuation is exact.
  if (simulation_->state_hash() != moment->hash) FailAsDifferent();
  if (player_.ApplyDue(simulation_)) FailAsDifferent();
  num_actions_ += std::ranges::count_if(collector_.events(), &sim::BeginsAction);
  last_ = std::move(moment);
  return true;
}

void ReplayAlong::CheckEnd() const {
  if (!last_ || last_->tick != until_.tick || player_.next() != nullptr) {
    Fail(recording_, "has no moment at tick " + std::to_string(until_.tick) + " after line " +
                         std::to_string(until_.line) + " of its log");
  }
  const auto& events = collector_.events();
  const std::size_t num_reported = last_->events.size();
  if (num_reported > events.size() ||
      !std::equal(last_->events.begin(), last_->events.end(), events.begin())) {
    FailAsDifferent();
  }
  const auto is_action = [this](const recording::LoggedCommand& logged) {
    return logged.line > recording_.info.start.line && IsAction(logged.command);
  };
  if (std::ranges::count_if(path_, is_action) != num_actions_) {
    Fail(recording_, "has different actions in its trace and in its log");
  }
}

}  // namespace smile::recorder
