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

/// Brain that drives a simulation without blocking its session. Belongs to the thread that
/// runs the simulation.
///
/// While it starts or thinks the simulation must not tick, but may be commanded, except to undo or
/// redo: its answer is applied to the world as it is then.
class LiveBrain {
 public:
  /// @param limits  timeouts of start and callbacks; the documented ones unless given.
  explicit LiveBrain(brain::BrainOptions limits = {}) : limits_(std::move(limits)) {}

  const brain::BrainOptions& limits() const { return limits_; }

  /// Starts a program in place of the one before; returns before it is ready.
  /// @throws InputError, std::invalid_argument or std::runtime_error if it cannot be started: see
  ///         brain::BrainProcess and brain::BrainDriver. Describe() reports later errors.
  void Start(const library::BrainChoice& choice, const brain::BrainDriverOptions& options,
             sim::Simulation* simulation);
  /// Checks if the program has started; to be called often, also while time is paused.
  void Attend(sim::Simulation* simulation);
  /// To be called before each tick.
  /// @returns true if the simulation may tick; false while the program is busy.
  bool Drive(sim::Simulation* simulation);
  /// Ends the program and stops the robot.
  void Stop(sim::Simulation* simulation);
  /// Ends the program because its world is replaced.
  void Leave();

  /// Returns true while the program runs or starts.
  bool is_running() const { return is_starting() || HasStatus(brain::BrainStatus::kRunning); }
  /// Returns how long the last program has watched the demonstration [ticks].
  std::uint64_t watched_ticks() const { return watched_ticks_; }
  /// Returns `brain` of a state message.
  Json Describe() const;
  /// Returns the lines printed since the last call.
  std::vector<ConsoleLine> TakeLines() { return console_.Take(); }

 private:
  bool HasStatus(brain::BrainStatus status) const { return driver_ && driver_->status() == status; }
  bool is_starting() const { return HasStatus(brain::BrainStatus::kStarting); }
  void SubmitQuestion(sim::Simulation* simulation);
  /// Returns false if the program has not answered yet.
  bool TakeAnswer(std::chrono::nanoseconds timeout, sim::Simulation* simulation);

  brain::BrainOptions limits_;
  Console console_;  ///< written by the programs' threads, which end first
  std::string name_;
  bool was_stopped_ = false;
  bool is_question_pending_ = false;
  std::uint64_t watched_ticks_ = 0;
  std::unique_ptr<brain::BrainThread> former_;  ///< the program before, which may still be ending
  std::unique_ptr<brain::BrainThread> thread_;
  std::optional<brain::BrainDriver> driver_;
};

}  // namespace smile::studio
