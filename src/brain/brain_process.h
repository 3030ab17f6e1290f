#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string_view>

#include "brain/brain_values.h"

namespace smile::brain {

/// Connection of an Octave or Matlab program.
enum class BrainTransport {
  kAutomatic,  ///< kMex if it was built, otherwise kPlain
  kMex,        ///< a socket and a small compiled client
  kPlain,      ///< a pair of pipes and a client in plain .m
};

/// Default timeout of a callback [s of wall-clock time]: busy machines are slow.
inline constexpr double kCallbackSeconds = 5;
/// Timeout of the start, up to the end of init, as a multiple of that of a callback.
inline constexpr double kStartFactor = 12;

struct BrainOptions {
  double start_seconds = kStartFactor * kCallbackSeconds;  ///< to the end of init, wall clock
  double callback_seconds = kCallbackSeconds;              ///< for each callback, wall clock
  BrainTransport transport = BrainTransport::kAutomatic;
  /// Called with the program's output, line by line, cleaned for a terminal and limited in rate.
  /// Called on another thread; must not throw.
  std::function<void(std::string_view line)> on_output;
  /// Called about every 50 ms while waiting for the program; returning true stops it.
  std::function<bool()> is_cancelled;
  /// For debuggers: the program is started by a person, after the instructions of `on_waiting`, and
  /// has no timeouts.
  bool is_attached = false;
  /// Called, if attached, with the command to type in another terminal (several lines); then for
  /// each connection that was not a brain.
  std::function<void(std::string_view instructions)> on_waiting;
};

/// Returns options with another timeout of callbacks, and the timeout of the start that follows
/// from it.
inline BrainOptions WithTimeout(double callback_seconds) {
  return {.start_seconds = kStartFactor * callback_seconds, .callback_seconds = callback_seconds};
}

/// Returns true if a brain is the address of a program that serves it: `tcp://HOST:PORT` or
/// `unix:PATH`.
bool IsServedBrain(const std::filesystem::path& brain);

/// Brain in a process of its own, or served by another program.
///
/// A brain is a folder with `agentBehavior.m` (run by GNU Octave or Matlab), a Python file, or an
/// executable file that speaks the protocol of docs/brain-protocol.md (smile::brain_client does,
/// for C++). Its working directory is its folder's parent, it has a process group of its own, and
/// any misbehavior (crash, endless loop, nonsense, floods of output) becomes a BrainError in
/// bounded time. After an error the process is gone; it is never started again by itself. The wall
/// clock is used by the watchdog only: answers do not depend on it.
///
/// A served brain (see IsServedBrain()) is a program that runs already, perhaps on another machine,
/// and speaks the same protocol over a socket. Init() connects to it. Nothing is known of its
/// process, and its output appears where it runs.
///
/// The process ends with the thread that called Init(), so that nothing outlives a crash: call from
/// the thread that runs the simulation, or see BrainThread.
class BrainProcess {
 public:
  /// Checks the brain without starting it.
  /// @throws InputError if the brain does not exist, is of no known kind, or is no valid address.
  /// @throws std::runtime_error if its interpreter is not installed.
  explicit BrainProcess(const std::filesystem::path& brain, BrainOptions options = {});
  BrainProcess(BrainProcess&&) noexcept;
  BrainProcess& operator=(BrainProcess&&) noexcept;
  /// Asks the program to end, waits a second, then kills its whole group.
  ~BrainProcess();

  /// Starts the program and runs its init script.
  /// @throws std::logic_error if it was started before.
  /// @throws std::runtime_error if a process, pipe or folder cannot be made.
  OrError<InitReply> Init(const Aux& aux);

  /// Runs its callback script once.
  /// @throws std::logic_error unless is_running().
  OrError<StepReply> Step(const Sensor& sensor);

  /// Calls Init() or Step(), depending on the question.
  BrainAnswer Answer(const BrainQuestion& question);

  /// Ends the program as the destructor does.
  void Stop();

  /// Returns true from a successful Init() until an error, a step with `exit`, or Stop().
  bool is_running() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace smile::brain
