#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "base/json.h"
#include "model/model.h"
#include "scene/visual_model.h"
#include "sim/simulation.h"

namespace smile::studio {

/// What pages draw of a simulation at one moment.
struct WatchedMoment {
  std::shared_ptr<const model::Model> model;
  scene::VisualState state;
  std::uint64_t tick = 0;
  double meters_per_unit = 0;
  Json description;  ///< see DescribeLive()
};

/// Connects a simulation, which one thread advances, with a Viewer, which shows it in another
/// thread. The simulation computes the same bits as without.
///
/// Moments are copied only when the viewer wants one: between two uses of the simulation by the
/// viewer's thread, and during a long use by the simulation's own.
class WatchedSimulation : private sim::Listener {
 public:
  /// Begins to watch. To be called in the thread of the simulation, which must outlive the call of
  /// Detach().
  explicit WatchedSimulation(sim::Simulation* simulation);
  WatchedSimulation(const WatchedSimulation&) = delete;
  WatchedSimulation& operator=(const WatchedSimulation&) = delete;
  ~WatchedSimulation() override { Detach(); }

  // For the thread of the simulation.

  /// Locks the simulation: to be held while the thread uses it.
  [[nodiscard]] std::unique_lock<std::recursive_mutex> Lock();
  /// Slows ticks down to a multiple of real time; 0: as fast as possible.
  void SetSpeed(double speed) { speed_ = speed; }
  /// Ends the connection; the last moment remains. The thread may hold the lock.
  void Detach();

  // For the thread of the viewer.

  /// Returns the present moment, or a recent one while the simulation is in use.
  std::shared_ptr<const WatchedMoment> Latest();
  /// Returns the messages about events since the last call.
  std::vector<Json> TakeEvents();

 private:
  void OnEvent(const sim::Simulation& simulation, const sim::Event& event) override;
  void OnTick(const sim::Simulation& simulation) override;
  void Publish(const sim::Simulation& simulation);
  /// Waits until the next tick is due.
  void Pace();

  std::recursive_mutex in_use_;  ///< held by the thread that uses `simulation_`
  sim::Simulation* simulation_;  ///< nullptr once detached
  bool may_have_changed_ = true;
  std::atomic<bool> is_wanted_ = false;
  std::atomic<double> speed_ = 0;
  std::chrono::steady_clock::time_point due_;

  std::mutex box_;  ///< of what follows
  std::shared_ptr<const WatchedMoment> moment_;
  std::vector<Json> events_;
};

}  // namespace smile::studio
