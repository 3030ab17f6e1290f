#include "studio/watched_simulation.h"

#include <algorithm>
#include <thread>
#include <utility>

#include "studio/event_message.h"
#include "studio/state_message.h"

namespace smile::studio {
namespace {

/// Later events are dropped: no page looks, or the simulation is faster than people read.
constexpr std::size_t kMaxWatchedEvents = 100;

}  // namespace

WatchedSimulation::WatchedSimulation(sim::Simulation* simulation) : simulation_(simulation) {
  Publish(*simulation);
  simulation->AddListener(this);
}

std::unique_lock<std::recursive_mutex> WatchedSimulation::Lock() {
  std::unique_lock lock(in_use_);
  // Whatever the thread does: states may be restored without a notice to listeners.
  may_have_changed_ = true;
  return lock;
}

void WatchedSimulation::Detach() {
  const std::lock_guard use(in_use_);
  if (simulation_ == nullptr) return;
  Publish(*simulation_);
  std::exchange(simulation_, nullptr)->RemoveListener(this);
}

std::shared_ptr<const WatchedMoment> WatchedSimulation::Latest() {
  if (const std::unique_lock use(in_use_, std::try_to_lock); use) {
    if (simulation_ != nullptr && std::exchange(may_have_changed_, false)) Publish(*simulation_);
  } else {
    // A long step publishes at its next tick; otherwise the next call finds the simulation free.
    is_wanted_ = true;
  }
  const std::lock_guard lock(box_);
  return moment_;
}

std::vector<Json> WatchedSimulation::TakeEvents() {
  const std::lock_guard lock(box_);
  return std::exchange(events_, {});
}

void WatchedSimulation::OnEvent(const sim::Simulation& simulation, const sim::Event& event) {
  // The sender of a refused command has its answer.
  if (event.kind == sim::EventKind::kCommandRefused) return;
  Json message = EventMessage(event, simulation.tick(), simulation.model());
  const std::lock_guard lock(box_);
  if (events_.size() < kMaxWatchedEvents) events_.push_back(std::move(message));
}

void WatchedSimulation::OnTick(const sim::Simulation& simulation) {
  if (is_wanted_.exchange(false)) Publish(simulation);
  Pace();
}

void WatchedSimulation::Publish(const sim::Simulation& simulation) {
  auto moment = std::make_shared<const WatchedMoment>(
      WatchedMoment{.model = simulation.shared_model(),
                    .state = simulation.visual_state(),
                    .tick = simulation.tick(),
                    .meters_per_unit = simulation.scene().meters_per_unit,
                    .description = DescribeLive(simulation)});
  const std::lock_guard lock(box_);
  moment_.swap(moment);
}

void WatchedSimulation::Pace() {
  const double speed = speed_;
  if (!(speed > 0)) return;
  // The wall clock only delays ticks; what they compute does not depend on it.
  using std::chrono::steady_clock;
  const std::chrono::duration<double> period(1.0 / (sim::kTicksPerSecond * speed));
  due_ = std::max(due_ + std::chrono::duration_cast<steady_clock::duration>(period),
                  steady_clock::now());
  std::this_thread::sleep_until(due_);
}

}  // namespace smile::studio
