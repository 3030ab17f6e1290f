#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/json.h"
#include "brain/brain_driver.h"
#include "brain/brain_thread.h"
#include "library/brain_choices.h"
#include "studio/console.h"

namespace smile::studio {

/// A robot program at work in a simulation, watched by people, who need not wait for it. Belongs to
/// the thread that runs the simulation.
///
/// While it starts or thinks the simulation must not tick, but may be commanded, except to undo or
/// redo: its answer is applied to the world as it is then.
class LiveBrain {
 public:
  /// @param limits  timeouts of start and callbacks; the documented ones unless given.
  explicit LiveBrain(brain::BrainOptions limits = {}) : limits_(std::move(limits)) {}

  const brain::BrainOptions& limits() const { return limits_; }

  /// Begins to start it, instead of what ran before.
  /// @throws InputError, std::invalid_argument or std::runtime_error if it cannot be started: see
  ///         brain::BrainProcess and brain::BrainDriver. What goes wrong later, Describe() tells.
  void Start(const library::BrainChoice& choice, const brain::BrainDriverOptions& options,
             sim::Simulation* simulation);
  /// Looks whether it has started; to be called often, also while time stands still.
  void Attend(sim::Simulation* simulation);
  /// To be called before each tick.
  /// @returns whether the simulation may tick; false while the program is waited for.
  bool Drive(sim::Simulation* simulation);
  /// The program ends, and the robot stops.
  void Stop(sim::Simulation* simulation);
  /// The program ends with the world it was in.
  void Leave();

  /// Or is about to.
  bool is_running() const { return is_starting() || HasStatus(brain::BrainStatus::kRunning); }
  /// How long the program that was started last has watched the demonstration.
  std::uint64_t watched_ticks() const { return watched_ticks_; }
  /// `brain` of a state message.
  Json Describe() const;
  /// What was printed since this was last asked.
  std::vector<ConsoleLine> TakeLines() { return console_.Take(); }

 private:
  bool HasStatus(brain::BrainStatus status) const { return driver_ && driver_->status() == status; }
  bool is_starting() const { return HasStatus(brain::BrainStatus::kStarting); }
  void Ask(sim::Simulation* simulation);
  /// False if there is no answer yet.
  bool TakeAnswer(std::chrono::nanoseconds patience, sim::Simulation* simulation);

  brain::BrainOptions limits_;
  Console console_;  ///< written to by the programs' threads, which end before it
  std::string name_;
  bool was_stopped_ = false;
  bool is_asked_ = false;
  std::uint64_t watched_ticks_ = 0;
  std::unique_ptr<brain::BrainThread> former_;  ///< left, and maybe about to end
  std::unique_ptr<brain::BrainThread> thread_;
  std::optional<brain::BrainDriver> driver_;
};

}  // namespace smile::studio
